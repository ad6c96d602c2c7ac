/* Shared by all methods of reflections: how much of the eye's image and of the cubes mirrors are likely to fill. */
#include "methods/raster/pipelines.h"
#include "methods/raster/raster.h"
#include "methods/stages.h"

/* A square about every added reflector, or a quarter of the image. */
static u64 reflective_pixels(const ts_scene *scene, const ts_params *params)
{
	double pixels = (double)TS_PARAM(params, width) * (double)TS_PARAM(params, height);
	double side = (double)TS_PARAM(params, reflectors_px);
	double covered =
		TS_PARAM(params, reflectors_count) != 0 ? side * side * (double)scene->info.n_reflectors : pixels / 4;
	return (u64)(covered < pixels ? covered : pixels) * ts_eye_samples(params);
}

u64 ts_expect_mirrors(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 *n = expected->sizes.n;
	ts_sizes_cubes(&expected->sizes, scene->info.n_reflectors);
	n[TS_DIM_mirror_pixels] = reflective_pixels(scene, params);
	return n[TS_DIM_mirror_pixels];
}

u32 ts_largest_face(const ts_params *params)
{
	u32 half_eye = TS_PARAM(params, height) / 2;
	u32 most = TS_PARAM(params, cube_max_px) < half_eye ? TS_PARAM(params, cube_max_px) : half_eye;
	return most < 16 ? 16 : most;
}

u64 ts_expected_face(const ts_params *params)
{
	u64 largest = ts_largest_face(params), side = (u64)(2 * TS_PARAM(params, reflectors_px));
	if (TS_PARAM(params, cube_px) != 0) return TS_PARAM(params, cube_px);
	return TS_PARAM(params, reflectors_count) == 0 || side > largest ? largest : side;
}

void ts_plan_largest(ts_plan *plan, const ts_params *params)
{
	plan->offscreen.side = TS_PARAM(params, cube_px) != 0 ? TS_PARAM(params, cube_px) : TS_PARAM(params, cube_max_px);
	plan->offscreen.all = true;
}

const ts_effect ts_effect_reflections = {
	.name = "reflections",
	.doc = "reflections in moving mirrors",
	.mirrors = true,
	.seen = TS_B_eye_depth_triangle,
	.difference_scale = 8,
	.lower = "reflectors.count",
};
