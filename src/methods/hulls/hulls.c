/* Screen-space approximate Gaussian hulls: indirect light of one bounce, and the light of lamps (METHODS 11).
 * Meder and Bruederlin, "Screen Space Approximate Gaussian Hulls" (2018).
 *
 * Each texel of a reflective shadow map becomes a triangle of light. The screen's depth is down-sampled and segmented
 * in blocks; at the corners of each segment's box the light of all triangles is gathered as spherical Gaussians, one
 * per channel. Each pixel interpolates those of its segment and integrates them with the cosine of its own normal.
 * `direct`, the paper's ground truth, gathers at every pixel instead. Both ignore occluders between triangle and
 * receiver. Effect `area-light` applies the same to lamps as triangles, since any source of light will do (sections 3
 * and 5).
 *
 * Deviations:
 * - details missing in the paper are in METHODS 11: triangles are equilateral and as large as their texel's footprint,
 *   the threshold of segments is a fiftieth of the depth, the box of a pixel is the thinnest that holds it;
 * - the far plane is at infinity, so that the depth's reciprocal is exact in thresholds and interpolation (gbuffer.h);
 * - a pixel outside all segments takes the nearest; hull.surface=paper leaves it dark;
 * - a corner receives more of a triangle of light the higher it is above the triangle's plane, and none on the plane,
 *   however rounding falls (corner.h); corner.facing=paper is the paper;
 * - corners of a box gather at pixels within the box; hull.corners=rectangle is the paper;
 * - a corner without light, or with equal light from all sides, has no direction, and does not affect the blended one;
 * - the picture shows only indirect light, or only that of the lamps; gloss.lobe adds their specular reflection, for
 *   which the paper names lobes and no formula (gloss.h). */
#include "methods/hulls/gloss.h"
#include "methods/raster/pipelines.h"

static const ts_step hull_run[] = {
	{.run = ts_gbuffer_run},
	{.stage = "depth_grid"}, /* down-sampled depth */
	{.stage = "segment"},
	{.stage = "segment.extent"},
	{.stage = "segment.box"},
	{.stage = "corner"}, /* light at the corners of the boxes */
	{.stage = "corner.lobes"},
	{.stage = "hull"}, /* interpolation and integration */
	{.stage = "gloss", .only_if = ts_gloss_is_asked, .unnumbered = true},
	{.stage = "gloss.hull", .only_if = ts_gloss_is_asked, .unnumbered = true},
	{.stage = "image.indirect"},
	{0},
};

static const ts_step direct_run[] = {
	{.run = ts_gbuffer_run},
	{.stage = "direct"},
	{.stage = "gloss", .only_if = ts_gloss_is_asked, .unnumbered = true},
	{.stage = "gloss.direct", .only_if = ts_gloss_is_asked, .unnumbered = true},
	{.stage = "image.indirect"},
	{0},
};

/* Lamps, and their triangles of light. */
static const ts_step polygon_run[] = {
	{.run = ts_frame_run},
	{.stage = "lamp"},
	{.stage = "polygon"},
	{0},
};

static const ts_step hulls_steps[] = {{.run = ts_rsm_run}, {.run = hull_run}, {0}};
static const ts_step direct_steps[] = {{.run = ts_rsm_run}, {.run = direct_run}, {0}};
static const ts_step hulls_lamps_steps[] = {{.run = polygon_run}, {.run = hull_run}, {0}};
static const ts_step direct_lamps_steps[] = {{.run = polygon_run}, {.run = direct_run}, {0}};

enum { BOXES_A_BLOCK = 8 };

static void expect_boxes(ts_expected *expected, const ts_params *params)
{
	u64 side = TS_PARAM(params, depth_grid_px) / 32;
	expected->sizes.n[TS_DIM_segment_boxes] = side * side * BOXES_A_BLOCK;
}

static void hulls_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	ts_indirect_expect(expected, scene, params);
	expect_boxes(expected, params);
}

static void lamps_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)request;
	ts_plan_lights(plan, params);
	plan->lights.taps = 1;
	plan->lights.straight = 1;
	plan->units = plan->lights.own ? counts->lights : 1;
}

static void lamps_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect_boxes(expected, params);
	expected->sizes.n[TS_DIM_lamps] = TS_PARAM(params, lamp_source) == TS_LAMP_SCENE ? scene->n_lights : 1;
}

static const ts_effect area_light = {
	.name = "area-light",
	.doc = "the light of a lamp or of the scene's lights with their whole extent, without shadows",
	.seen = TS_B_eye_depth_triangle,
	.difference_scale = 4,
	.lower = "depth_grid.px",
};

const ts_pipeline ts_pipeline_hulls_lamps = {
	.name = "hulls",
	.effect = &area_light,
	.paper = "SSAGH 3 to 5",
	.doc = "screen-space approximate Gaussian hulls: light gathered at the corners of depth segments",
	.steps = hulls_lamps_steps,
	.plan = lamps_plan,
	.expect = lamps_expect,
};

const ts_pipeline ts_pipeline_direct_lamps = {
	.name = "direct",
	.effect = &area_light,
	.paper = "SSAGH 5",
	.doc = "light gathered at every pixel",
	.steps = direct_lamps_steps,
	.plan = lamps_plan,
	.expect = lamps_expect,
};

const ts_pipeline ts_pipeline_hulls = {
	.name = "hulls",
	.effect = &ts_effect_indirect,
	.paper = "SSAGH 3 and 4",
	.doc = "screen-space approximate Gaussian hulls: light gathered at the corners of depth segments",
	.steps = hulls_steps,
	.plan = ts_indirect_plan,
	.expect = hulls_expect,
};

const ts_pipeline ts_pipeline_direct = {
	.name = "direct",
	.effect = &ts_effect_indirect,
	.paper = "SSAGH 5",
	.doc = "light gathered at every pixel",
	.steps = direct_steps,
	.plan = ts_indirect_plan,
	.expect = hulls_expect,
};
