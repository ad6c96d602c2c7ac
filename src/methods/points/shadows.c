/* Shared by all methods of soft and omnidirectional shadows: batches of depth maps, and their expected sizes. */
#include "methods/points/pipelines.h"

/* One view per sample, for all lights together. */
void ts_soft_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	ts_plan_lights(plan, params);
	u32 n_lights = plan->lights.own ? counts->lights : 1;
	plan->units = plan->lights.samples =
		request->samples != 0 ? request->samples * n_lights : TS_PARAM(params, lamp_views);
	plan->batch = TS_PARAM(params, lamp_views_a_pass);
	plan->offscreen.side = TS_PARAM(params, depth_map_px);
}

/* Whole cubes in one pass over the geometry. */
static u32 cubes_a_pass(const ts_params *params)
{
	return TS_PARAM(params, lamp_views_a_pass) < 12 ? 1 : TS_PARAM(params, lamp_views_a_pass) / 6;
}

void ts_omni_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)counts;
	plan->units = plan->lights.samples = request->samples != 0 ? request->samples : TS_PARAM(params, lamp_cubes);
	plan->batch = cubes_a_pass(params);
	plan->offscreen.side = TS_PARAM(params, depth_map_px);
}

/* Two points for each small triangle, and four for each texel of the few views that determine a triangle's density. */
void ts_expect_points(ts_expected *expected, const ts_scene *scene, u64 texels)
{
	u64 *n = expected->sizes.n, triangles = scene->n_triangles;
	n[TS_DIM_pieces] = triangles + triangles / 4;
	n[TS_DIM_points] = 2 * triangles + 4 * texels;
}

void ts_soft_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 map = (u64)TS_PARAM(params, depth_map_px) * TS_PARAM(params, depth_map_px),
		batch = TS_PARAM(params, lamp_views_a_pass) < TS_PARAM(params, lamp_views) ? TS_PARAM(params, lamp_views_a_pass)
	                                                                               : TS_PARAM(params, lamp_views);
	u64 *n = expected->sizes.n;
	n[TS_DIM_cubes] = 0;
	n[TS_DIM_views] = TS_PARAM(params, lamp_views);
	n[TS_DIM_lamps] = TS_PARAM(params, lamp_source) == TS_LAMP_SCENE ? scene->n_lights : 1;
	n[TS_DIM_texels] = map * batch;
	expected->batches = (TS_PARAM(params, lamp_views) + batch - 1) / batch;
	ts_expect_points(expected, scene, map);
}

void ts_omni_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 map = 6 * (u64)TS_PARAM(params, depth_map_px) * TS_PARAM(params, depth_map_px), batch = cubes_a_pass(params);
	u64 *n = expected->sizes.n;
	ts_sizes_cubes(&expected->sizes, TS_PARAM(params, lamp_cubes));
	n[TS_DIM_lamps] = 1;
	n[TS_DIM_texels] = map * (batch < TS_PARAM(params, lamp_cubes) ? batch : TS_PARAM(params, lamp_cubes));
	expected->batches = (TS_PARAM(params, lamp_cubes) + batch - 1) / batch;
	ts_expect_points(expected, scene, map);
}

const ts_effect ts_effect_soft_shadows = {
	.name = "soft-shadows",
	.doc = "shadows of a lamp or of the scene's lights",
	.seen = TS_B_eye_depth_triangle,
	.difference_scale = 8,
	.lower = "depth_map.px or lamp.views_a_pass",
};

const ts_effect ts_effect_omni_shadows = {
	.name = "omni-shadows",
	.doc = "shadows of a ball of light in the middle",
	.seen = TS_B_eye_depth_triangle,
	.difference_scale = 8,
	.lower = "depth_map.px or lamp.views_a_pass",
};
