/* Screen-space approximate Gaussian hulls: indirect light of one bounce (METHODS 11).
 * Meder and Bruederlin, "Screen Space Approximate Gaussian Hulls" (2018).
 *
 * What the lights see in reflective shadow maps is light itself, a triangle a texel. The screen's depth is down-sampled
 * and segmented in blocks; at the corners of each segment's box the light of all triangles is gathered as spherical
 * Gaussians, one a channel. Each pixel interpolates those of its segment and integrates them with the cosine of its own
 * normal. `direct`, the paper's ground truth, gathers at every pixel instead. Neither asks whether something stands
 * between triangle and receiver.
 *
 * Deviations:
 * - what the paper leaves open is in METHODS 11: triangles are equilateral and as large as what their texel sees, the
 *   threshold of segments is a fiftieth of the depth, the box of a pixel is the thinnest that holds it;
 * - the far plane is at infinity, so that thresholds and interpolation know the depth's reciprocal exactly (gbuffer.h);
 * - a pixel that no segment holds takes the nearest; surface=paper leaves it dark;
 * - a corner faces a triangle of light the more, the higher it is above its plane, and not at all on it, however rounding
 *   falls (gather.h);
 * - a corner without light, or with the same from all sides, has no direction, and gives none to those that it is
 *   blended with;
 * - the picture is of indirect light alone. */
#include "../stages.h"
#include "../pipelines.h"

const ts_step ts_hulls_steps[] = {
	{.run = ts_rsm_run},
	{.run = ts_gbuffer_run},
	{.stage = "nearest"},    /* down-sampled depth */
	{.stage = "segment"},
	{.stage = "range"},
	{.stage = "box"},
	{.stage = "gather"},     /* light at the corners of the boxes */
	{.stage = "fit"},
	{.stage = "hull"},       /* interpolation and integration */
	{.stage = "indirect_image"},
	{0},
};

const ts_step ts_direct_steps[] = {
	{.run = ts_rsm_run},
	{.run = ts_gbuffer_run},
	{.stage = "direct"},
	{.stage = "indirect_image"},
	{0},
};

void ts_indirect_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)request;
	plan->lights.taps = 1;
	plan->offscreen.side = TS_PARAM(params, rsm_px);
	plan->units = plan->lights.own ? counts->lights : 1;
}

enum { BOXES_A_BLOCK = 8 };

void ts_hulls_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	bool own = TS_PARAM(params, lamp) == TS_LAMP_SCENE;
	u64 n_lights = own ? scene->n_lights : 1, n_views = 0,
		blocks = (u64)TS_PARAM(params, grid_px) / 32 * (TS_PARAM(params, grid_px) / 32);
	for (u32 i = 0; i < n_lights; i++) n_views += own ? ts_light_views(&scene->lights[i]) : 1;
	u64 *n = expected->sizes.n;
	n[TS_DIM_views] = n_views;
	n[TS_DIM_lamps] = n_lights;
	n[TS_DIM_texels] = n_views * TS_PARAM(params, rsm_px) * TS_PARAM(params, rsm_px);
	n[TS_DIM_boxes] = blocks * BOXES_A_BLOCK;
}
