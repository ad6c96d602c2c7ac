/* Improved view-independent rendering of cube-mapped reflections and of shadows.
 * Paper: "Improving View Independent Rendering for Multiview Effects" (2022), sections 3 to 6.
 *
 * Once per frame each triangle becomes points, as dense as the most demanding off-screen view requires (section 3.1),
 * which are scattered to all views that may see it: no view needs another pass over the geometry. Depth maps take a
 * point's depth, environment maps 13 bits of depth and 19 of colour, and are copied into mip maps (5).
 *
 * Deviations, each with the switch that restores the paper:
 * - the rate gives each texel that sees a triangle one of its samples; the paper's leaves holes (density.rate=paper),
 *   and is unbounded where a triangle is closest beside a view's image: there it takes the rate of the corner;
 * - a sample beside its triangle moves to the triangle's border (points.snap=off), so that it lies on its triangle;
 * - triangles of more than 2^16 samples, and those that need far more of them at one end, are bisected
 *   (points.split=off);
 * - visibility clears a bit only if all corners lie outside one plane (visibility.test=vertex);
 * - the points serve all views at once; without storing them (points.buffered=off) they are made once for every 32
 *   depth maps (lamp.views_a_pass=32), still with the density of all;
 * - the depth code of environment maps is logarithmic, 2^20 from the nearest to the farthest, and their colours are
 *   stored as square roots: the paper names the bits only;
 * - the greatest code of a colour stands for twice display white, because the mirror's tint still multiplies the stored
 *   colour; the paper does not define it (scatter.headroom=1: display white). */
#include "kernels/points/view_density.h"
#include "kernels/raster/mip.h"
#include "methods/points/pipelines.h"

static const ts_step point_run[] = {
	{.stage = "offscreen.visibility"}, /* 3.1: which views may see a triangle */
	{.stage = "split.views"},          /* 3.1: the density of the most demanding one */
	{.stage = "cull"},                 /* 3.3: stochastic culling */
	{.stage = "align"},                /* 3.2: T_align, eq. 1, and S, eq. 4 */
	{0},
};

static const ts_step shadow_run[] = {
	{.run = point_run},
	{.stage = "points.count", .only_ordered = true, .stored = TS_STORED_IF_ASKED},
	{.stage = "points", .stored = TS_STORED_IF_ASKED},
	{.stage = "scatter", .each_batch = true}, /* 4: 32 depth maps per pass */
	{.run = ts_resolve_run},
	{0},
};

const ts_step ts_ivir_reflections_steps[] = {
	{.run = ts_frame_run},
	{.stage = "cube_size"},
	{.stage = "offscreen"},
	{.stage = "eye"},
	{.stage = "mirror_pixel"},
	{.run = point_run},
	{.stage = "points.count", .only_ordered = true, .stored = TS_STORED_BY_DEFAULT},
	{.stage = "points", .stored = TS_STORED_BY_DEFAULT},
	{.stage = "scatter.colour"},                      /* 5: 13 bits of depth, 19 of colour */
	{.stage = "environment_map", .each_batch = true}, /* 5: the copy pass into mip maps */
	{.stage = "mirror", .each_batch = true},          /* the eye's look-ups, as MVR's */
	{.stage = "image"},
	{0},
};

const ts_step ts_ivir_soft_steps[] = {
	{.run = ts_soft_run},
	{.run = shadow_run},
	{0},
};

const ts_step ts_ivir_omni_steps[] = {
	{.run = ts_omni_run},
	{.run = shadow_run},
	{0},
};

static void set_rate(ts_plan *plan, const ts_params *params)
{
	static const u32 rates[] = {[TS_DENSITY_RATE_WATERTIGHT] = TS_RATE_WATERTIGHT,
	                            [TS_DENSITY_RATE_EXACT] = TS_RATE_EXACT,
	                            [TS_DENSITY_RATE_PAPER] = TS_RATE_PAPER};
	plan->points.rate = rates[TS_PARAM(params, density_rate)];
}

static void ivir_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)counts, (void)request;
	set_rate(plan, params);
}

static void ivir_soft_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	set_rate(plan, params);
	ts_soft_plan(plan, params, counts, request);
}

void ts_ivir_omni_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	set_rate(plan, params);
	ts_omni_plan(plan, params, counts, request);
}

/* All cubes' texels at once, one cube's mip chain. */
void ts_expect_cubes(ts_expected *expected, const ts_scene *scene, const ts_params *params, u64 face)
{
	u64 *n = expected->sizes.n, cubes = scene->info.n_reflectors, texels = 6 * face * face * cubes;
	ts_expect_mirrors(expected, scene, params);
	n[TS_DIM_texels] = texels;
	n[TS_DIM_mip_texels] = cubes != 0 ? ts_k_mip_texels((u32)face, TS_NONE) : 0;
	expected->batches = cubes;
	ts_expect_points(expected, scene, texels);
}

static void ivir_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	ts_expect_cubes(expected, scene, params, ts_expected_face(params));
}

const ts_pipeline ts_pipeline_ivir_reflections = {
	.name = "ivir",
	.effect = &ts_effect_reflections,
	.paper = "iVIR 5",
	.doc = "improved view-independent rendering: points as dense as the cubes' texels, for all cubes",
	.steps = ts_ivir_reflections_steps,
	.plan = ivir_plan,
	.expect = ivir_expect,
};

const ts_pipeline ts_pipeline_ivir_soft = {
	.name = "ivir",
	.effect = &ts_effect_soft_shadows,
	.paper = "iVIR 4",
	.doc = "one set of points for the depth maps of all light samples",
	.steps = ts_ivir_soft_steps,
	.plan = ivir_soft_plan,
	.expect = ts_soft_expect,
};

const ts_pipeline ts_pipeline_ivir_omni = {
	.name = "ivir",
	.effect = &ts_effect_omni_shadows,
	.paper = "iVIR 6",
	.doc = "one set of points for the cubes of all light samples",
	.steps = ts_ivir_omni_steps,
	.plan = ts_ivir_omni_plan,
	.expect = ts_omni_expect,
};
