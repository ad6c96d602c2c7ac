/* Runs of steps that several methods share, and the effect of indirect light. */
#include "methods/raster/pipelines.h"
#include "methods/stages.h"

const ts_step ts_frame_run[] = {
	{.stage = "eye.view"}, /* where the eye is */
	{.stage = "pose"},     /* where everything else is */
	{0},
};

const ts_step ts_soft_run[] = {
	{.run = ts_frame_run}, {.stage = "lamp"}, {.stage = "lamp.view"}, {.stage = "eye"}, {0},
};

const ts_step ts_omni_run[] = {
	{.run = ts_frame_run},  {.stage = "lamp.ball"}, {.stage = "lamp.cube"},
	{.stage = "offscreen"}, {.stage = "eye"},       {0},
};

const ts_step ts_resolve_run[] = {
	{.stage = "shadow_test", .each_batch = true},
	{.stage = "image.shadow"},
	{0},
};

const ts_step ts_rsm_run[] = {
	{.run = ts_frame_run},  {.stage = "lamp"},
	{.stage = "rsm.view"},  {.stage = "rsm"}, /* what each light sees */
	{.stage = "rsm.patch"}, {0},
};

const ts_step ts_gbuffer_run[] = {
	{.stage = "eye"},
	{.stage = "gbuffer"},
	{0},
};

/* A reflective shadow map per light, or for the lamp. */
void ts_indirect_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)request;
	ts_plan_lights(plan, params);
	plan->lights.taps = 1;
	plan->offscreen.side = TS_PARAM(params, rsm_px);
	plan->units = plan->lights.own ? counts->lights : 1;
}

void ts_indirect_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	bool own = TS_PARAM(params, lamp_source) == TS_LAMP_SCENE;
	u64 n_lights = own ? scene->n_lights : 1, n_views = 0;
	for (u32 i = 0; i < n_lights; i++) n_views += own ? ts_light_views(&scene->lights[i]) : 1;
	u64 *n = expected->sizes.n;
	n[TS_DIM_views] = n_views;
	n[TS_DIM_lamps] = n_lights;
	n[TS_DIM_texels] = n_views * TS_PARAM(params, rsm_px) * TS_PARAM(params, rsm_px);
}

const ts_effect ts_effect_indirect = {
	.name = "indirect",
	.doc = "the light of a lamp or of the scene's lights after one bounce",
	.seen = TS_B_eye_depth_triangle,
	.difference_scale = 4,
	.lower = "depth_grid.px or rsm.px",
};
