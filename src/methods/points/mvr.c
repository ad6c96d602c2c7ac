/* Classic multi-view rendering: the baseline of EPR section 4.2 and of iVIR sections 4 to 6 (METHODS 3).
 *
 * For every reflector the whole scene is rasterized into the six faces of its cube, every texel is shaded, a mip chain
 * is made, and the eye's reflective pixels look it up. For shadows the scene is rasterized into every depth map.
 *
 * Deviations: deferred shading by the same kernels as EPR's, so that only the method differs; one reflector at a time,
 * so that memory does not grow with their number; always one bounce. */
#include "kernels/raster/mip.h"
#include "methods/points/pipelines.h"

static const ts_step mvr_steps[] = {
	{.run = ts_frame_run},
	{.stage = "cube_size"},
	{.stage = "eye"},
	{.stage = "mirror_pixel"},
	{.stage = "cube_face", .each_batch = true},  /* geometry into six faces */
	{.stage = "illuminate", .each_batch = true}, /* shading of every texel; mip-mapping */
	{.stage = "mirror", .each_batch = true},     /* the eye's look-ups */
	{.stage = "image"},
	{0},
};

static void mvr_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)counts, (void)request;
	if (TS_PARAM(params, mvr_faces) == TS_MVR_FACES_FIXED) ts_plan_largest(plan, params);
}

static const ts_step mvr_soft_steps[] = {
	{.run = ts_soft_run},
	{.stage = "depth_map", .each_batch = true}, /* geometry into every depth map */
	{.run = ts_resolve_run},
	{0},
};

static const ts_step mvr_omni_steps[] = {
	{.run = ts_omni_run},
	{.stage = "depth_map", .each_batch = true},
	{.run = ts_resolve_run},
	{0},
};

/* The cubes of one reflector at a time. */
static void mvr_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 face = TS_PARAM(params, cube_px) != 0 ? TS_PARAM(params, cube_px) : TS_PARAM(params, cube_max_px);
	u64 cubes = scene->info.n_reflectors != 0 ? 1 : 0;
	u64 *n = expected->sizes.n;
	ts_expect_mirrors(expected, scene, params);
	expected->batches = scene->info.n_reflectors;
	n[TS_DIM_texels] = cubes * 6 * face * face;
	n[TS_DIM_mip_texels] = cubes * ts_k_mip_texels((u32)face, TS_NONE);
}

const ts_pipeline ts_pipeline_mvr_reflections = {
	.name = "mvr",
	.effect = &ts_effect_reflections,
	.paper = "EPR 4.2",
	.doc = "multi-view rendering: one pass over the geometry for every cube",
	.steps = mvr_steps,
	.plan = mvr_plan,
	.expect = mvr_expect,
};

const ts_pipeline ts_pipeline_mvr_soft = {
	.name = "mvr",
	.effect = &ts_effect_soft_shadows,
	.paper = "iVIR 4",
	.doc = "one pass over the geometry for every depth map",
	.steps = mvr_soft_steps,
	.plan = ts_soft_plan,
	.expect = ts_soft_expect,
};

const ts_pipeline ts_pipeline_mvr_omni = {
	.name = "mvr",
	.effect = &ts_effect_omni_shadows,
	.paper = "iVIR 6",
	.doc = "one pass over the geometry for every face of every cube",
	.steps = mvr_omni_steps,
	.plan = ts_omni_plan,
	.expect = ts_omni_expect,
};
