/* Cubes of the light samples at the resolution that the eye needs. */
#include <stdlib.h>
#include "kernels/points/shadow_cube_size.h"
#include "methods/raster/raster.h"
#include "scene/lamp.h"

static const ts_launch launch = TS_LAUNCH(shadow_cube_size, TS_BUT_SURFACES, TS_WORK(cubes, other));

/* The kernel works on a copy: the cubes have no size before it is done. */
static ts_status find_least(ts_run *run, ts_face *cubes, u32 n)
{
	ts_shadow_cube_size_args args = {
		.scene.n_triangles = (u32)ts_run_size(run, TS_DIM_triangles),
		.cubes = cubes,
		.n_cubes = n,
	};
	ts_frame_lend(&run->frame, TS_WORK_other, cubes, n * sizeof *cubes);
	ts_status status = TS_RUN(run, &launch, &args, ts_eye_size(run));
	ts_status recalled = ts_frame_recall(&run->frame, TS_WORK_other);
	return status == TS_OK ? recalled : status;
}

/* The next whole number above Res_max / least, at most Res_max and a multiple of the hysteresis. */
static u32 side(const ts_params *params, u32 least)
{
	if (!TS_PARAM(params, shadow_splat_resize)) return TS_PARAM(params, depth_map_px);
	f32 ratio = least != TS_NONE ? ts_u2f(least) : (f32)TS_PARAM(params, depth_map_px);
	u32 wanted = (u32)ts_floor_i32((f32)TS_PARAM(params, depth_map_px) / ts_max(ratio, 1.0f)) + 1;
	u32 step = TS_PARAM(params, cube_hysteresis) != 0 ? TS_PARAM(params, cube_hysteresis) : 1;
	wanted = (wanted + step - 1) / step * step;
	wanted = wanted < 16 ? 16 : wanted;
	return wanted < TS_PARAM(params, depth_map_px) ? wanted : TS_PARAM(params, depth_map_px);
}

static ts_status shadow_cube_size(ts_run *run)
{
	u32 n = run->plan.units;
	const ts_light *light = ts_frame_data(&run->frame, TS_B_lamp_light);
	const ts_lamp *lamp = ts_frame_data(&run->frame, TS_B_lamp_shape);
	ts_sizes_cubes(&run->sizes, n);
	ts_face *cubes = ts_run_make(run, TS_B_cube_size_face), *copy = ts_alloc(n, sizeof *copy, "cubes");
	ts_status status = cubes != NULL && copy != NULL ? TS_OK : TS_ERROR;
	for (u32 k = 0; k < n && status == TS_OK; k++) {
		ts_lamp_cube(&cubes[k], light, lamp->radius, k, n, ts_run_info(run), run->plan.offscreen.side);
		copy[k] = cubes[k];
	}
	if (status == TS_OK) status = find_least(run, copy, n);
	free(copy);
	if (status != TS_OK) return TS_ERROR;
	const u32 *least = ts_frame_data(&run->frame, TS_B_shadow_cube_size_least_ratio);
	for (u32 k = 0; k < n; k++) {
		cubes[k].n = side(&run->params, *least);
		cubes[k].offset = (u64)k * 6 * cubes[k].n * cubes[k].n;
	}
	ts_run_count(run, "cube texels", (i64)n * 6 * cubes[0].n * cubes[0].n);
	return TS_OK;
}

const ts_stage ts_stage_shadow_cube_size = {
	.name = "shadow_cube_size",
	.kind = "scatter",
	.paper = "EPR 5.1, eq. 6",
	.doc = "a cube for each sample of the light, of the size that the eye needs",
	.run = shadow_cube_size,
	.launches = TS_LAUNCHES(&launch),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_lamp_light, TS_B_lamp_shape),
	.makes = TS_BUFFERS(TS_B_cube_size_face),
};
