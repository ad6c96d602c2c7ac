/* Percentage-closer soft shadows: the single-view baseline of iVIR section 4 (PCSS; METHODS 10).
 * Fernando, "Percentage-Closer Soft Shadows" (SIGGRAPH 2005 sketches).
 *
 * The scene is rasterized into one depth map per light, from its middle. About each receiver 32 taps search for
 * blockers; their mean depth gives the width of the penumbra, over which 64 more are filtered.
 *
 * Deviations:
 * - the search needs a plane that the light is projected onto, which the sketch calls the light's near plane. The depth
 *   maps' own is so near that the width on it is many maps. A plane at half the receiver's depth finds all blockers in
 *   the farther half of the way, and those nearer ones that reach into it (pcss.near);
 * - a tap is compared with the depth of the receiver's plane at the tap, not of the receiver, so that a slanted surface
 *   does not block itself; the bias beyond that is the one of all methods;
 * - lights are discs, not squares, and the taps a sunflower's seeds;
 * - parallel light needs no projection: its widths grow with the distance from the receiver. */
#include "kernels/points/pcss.h"
#include "methods/points/pipelines.h"
#include "methods/raster/raster.h"

/* Taps about a pixel, in the one depth map of each light, that let light through. */

static const ts_launch filtered = TS_LAUNCH(pcss, TS_ALL);

static ts_status pcss(ts_run *run)
{
	ts_pcss_args args = {.of = ts_resolve_values(run), .near = TS_PARAM(&run->params, pcss_near)};
	return TS_RUN(run, &filtered, &args, ts_eye_size(run));
}

const ts_stage ts_stage_pcss = {
	.name = "pcss",
	.kind = "map",
	.paper = "iVIR 4",
	.doc = "number of taps around each pixel that let light through",
	.run = pcss,
	.launches = TS_LAUNCHES(&filtered),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

static const ts_step pcss_steps[] = {
	{.run = ts_soft_run},                       /* a view from the middle of each light */
	{.stage = "depth_map", .each_batch = true}, /* MVR's raster */
	{.stage = "pcss", .each_batch = true},      /* blockers, penumbra, filter */
	{.stage = "image.shadow"},
	{0},
};

static u32 n_lights(const ts_scene *scene, const ts_params *params)
{
	return TS_PARAM(params, lamp_source) == TS_LAMP_SCENE ? scene->n_lights : 1;
}

static void pcss_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)request;
	ts_plan_lights(plan, params);
	plan->lights.taps = TS_N_FILTER;
	plan->offscreen.side = TS_PARAM(params, depth_map_px);
	plan->units = plan->lights.own ? counts->lights : 1;
	plan->batch = TS_PARAM(params, lamp_views_a_pass);
}

static void pcss_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 *n = expected->sizes.n, lights = n_lights(scene, params),
		batch = TS_PARAM(params, lamp_views_a_pass) < lights ? TS_PARAM(params, lamp_views_a_pass) : lights;
	n[TS_DIM_views] = lights;
	n[TS_DIM_lamps] = lights;
	n[TS_DIM_texels] = (u64)TS_PARAM(params, depth_map_px) * TS_PARAM(params, depth_map_px) * batch;
	expected->batches = batch != 0 ? (lights + batch - 1) / batch : 0;
}

const ts_pipeline ts_pipeline_pcss = {
	.name = "pcss",
	.effect = &ts_effect_soft_shadows,
	.paper = "iVIR 4",
	.doc = "percentage-closer soft shadows: one depth map per light, filtered over the width of the penumbra",
	.steps = pcss_steps,
	.plan = pcss_plan,
	.expect = pcss_expect,
};
