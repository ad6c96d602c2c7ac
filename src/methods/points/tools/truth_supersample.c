/* Truth C: MVR at several times the linear resolution of eye and cubes, box-filtered in linear radiance (METHODS 17;
 * the reference of EPR 4.2). The scene is the same, so reflectors keep their places and sizes. */
#include <stdio.h>
#include <stdlib.h>
#include "kernels/base/num.h"
#include "methods/pipeline.h"
#include "methods/points/tools/tools.h"

enum { MAX_FACTOR = 16, RAYS_A_TEXEL = 8 }; /* as long as a texel takes: 4 us, where a ray takes half of one */

/* The parameter times the factor, within its range in params.def. */
static ts_status enlarge(ts_params *params, const char *name, u32 value, u32 factor)
{
	char text[24];
	snprintf(text, sizeof(text), "%llu", (unsigned long long)value * factor);
	return ts_params_set(params, name, text);
}

static ts_status enlarge_all(ts_params *big, const ts_params *params, u32 factor)
{
	*big = *params;
	if (enlarge(big, "width", TS_PARAM(params, width), factor) ||
	    enlarge(big, "height", TS_PARAM(params, height), factor) ||
	    enlarge(big, "cube.max_px", TS_PARAM(params, cube_max_px), factor) ||
	    enlarge(big, "cube.px", TS_PARAM(params, cube_px), factor) ||
	    enlarge(big, "cube.hysteresis", TS_PARAM(params, cube_hysteresis), factor))
		return TS_ERROR;
	return TS_OK;
}

/* Classic multi-view rendering, which draws triangles into the faces of cubes. */
static const ts_pipeline *find_mvr(void)
{
	return ts_pipeline_making(NULL, (const ts_buffer_id[]){TS_B_cube_face_depth_triangle, TS_N_BUFFERS});
}

static ts_status check_memory(const ts_pipeline *mvr, const ts_scene *scene, const ts_params *big, u32 factor)
{
	u64 limit = ts_memory_limit();
	u64 need = ts_pipeline_estimate(mvr, scene, big, true);
	if (need <= limit) return TS_OK;
	return ts_fail_as(TS_KIND_MEMORY,
	                  "truth C: %u times %u x %u needs about %llu MiB and may use %llu: take a smaller factor or image",
	                  factor, TS_PARAM(big, width) / factor, TS_PARAM(big, height) / factor,
	                  (unsigned long long)(need >> 20), (unsigned long long)(limit >> 20));
}

/* One pixel of `width`: the mean of factor x factor pixels, row by row. */
static void box(f32 *out, const f32 *in, u64 x, u64 y, u64 width, u64 factor)
{
	double sum[3] = {0, 0, 0};
	for (u64 j = 0; j < factor; j++) {
		const f32 *row = in + ((y * factor + j) * width * factor + x * factor) * 3;
		for (u64 i = 0; i < factor * 3; i++) sum[i % 3] += (double)row[i];
	}
	for (u32 i = 0; i < 3; i++) out[i] = ts_put((f32)(sum[i] / (double)(factor * factor)));
}

static ts_status shrink(f32 **radiance, const ts_frame *frame, const ts_params *params, u32 factor, u32 threads)
{
	u32 width = TS_PARAM(params, width), height = TS_PARAM(params, height);
	const f32 *in = ts_frame_data(frame, TS_B_image_radiance);
	f32 *out = ts_alloc((size_t)width * height * 3, sizeof(f32), "truth C");
	if (out == NULL) return TS_ERROR;
#pragma omp parallel for num_threads((int)threads) schedule(static)
	for (u32 y = 0; y < height; y++)
		for (u32 x = 0; x < width; x++) box(out + ((size_t)y * width + x) * 3, in, x, y, width, factor);
	*radiance = out;
	return TS_OK;
}

ts_status ts_truth_c(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 factor, u32 threads)
{
	*radiance = NULL;
	if (factor < 1 || factor > MAX_FACTOR)
		return ts_fail("truth C: factor %u: 1 to %u would be right", factor, (unsigned)MAX_FACTOR);
	ts_params big;
	const ts_pipeline *mvr = find_mvr();
	if (mvr == NULL) return ts_fail("truth C: no method draws triangles into cubes");
	if (enlarge_all(&big, params, factor) || check_memory(mvr, scene, &big, factor)) return TS_ERROR;
	ts_run run;
	ts_run_begin(&run, scene, &big, threads > 0 ? threads : 1);
	run.lean = true;
	ts_status status = ts_pipeline_run(mvr, &run);
	if (status == TS_OK) status = shrink(radiance, &run.frame, params, factor, run.c.threads);
	ts_run_end(&run);
	return status;
}

u64 ts_truth_c_rays(const ts_scene *scene, const ts_params *params)
{
	u64 height = TS_PARAM(params, height), pixels = TS_PARAM(params, width) * height, fixed = TS_PARAM(params, cube_px);
	u64 most = height / 2 < TS_PARAM(params, cube_max_px) ? height / 2 : TS_PARAM(params, cube_max_px);
	u64 side = fixed > 0 ? fixed : most, texels = 6 * side * side * scene->info.n_reflectors;
	return RAYS_A_TEXEL * TS_TRUTH_C_FACTOR * TS_TRUTH_C_FACTOR * (texels + pixels);
}

u64 ts_truth_c_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params)
{
	(void)method;
	const ts_pipeline *mvr = find_mvr();
	ts_params big = *params;
	TS_PARAM_SET(&big, width, TS_PARAM(params, width) * TS_TRUTH_C_FACTOR);
	TS_PARAM_SET(&big, height, TS_PARAM(params, height) * TS_TRUTH_C_FACTOR);
	TS_PARAM_SET(&big, cube_max_px, TS_PARAM(params, cube_max_px) * TS_TRUTH_C_FACTOR);
	TS_PARAM_SET(&big, cube_px, TS_PARAM(params, cube_px) * TS_TRUTH_C_FACTOR);
	return mvr != NULL ? ts_pipeline_estimate(mvr, scene, &big, true) : 0;
}
