/* View-independent rendering: the method that iVIR improves on, as iVIR's sections 3 to 6 compare with it (VIR; METHODS
 * 9). Marrs, Watson and Healey, "Real-Time View Independent Rasterization for Multi-View Rendering" (2017).
 *
 * The stages are iVIR's, with a rate by distance alone: pixels per world unit at the least depth that the nearest point
 * may have in half the field of view, for any orientation of the triangle; off-screen buffers keep their largest size.
 *
 * Deviations: the rate is a reconstruction, the reading of iVIR 3.1 that iVIR's own table 3 allows (METHODS 9): the
 * paper of VIR was not at hand. */
#include "kernels/points/view_density.h"
#include "methods/points/pipelines.h"

static void vir_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)counts, (void)request;
	plan->points.rate = TS_RATE_VIR;
	ts_plan_largest(plan, params);
}

static void vir_soft_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	plan->points.rate = TS_RATE_VIR;
	ts_soft_plan(plan, params, counts, request);
}

static void vir_omni_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	plan->points.rate = TS_RATE_VIR;
	ts_omni_plan(plan, params, counts, request);
}

/* Two points per texel: the rate at a face's border, the root of 2, squared. */
static void vir_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 face = TS_PARAM(params, cube_px) != 0 ? TS_PARAM(params, cube_px) : TS_PARAM(params, cube_max_px);
	ts_expect_cubes(expected, scene, params, face);
	expected->sizes.n[TS_DIM_points] = 2 * (u64)scene->n_triangles + 2 * 6 * face * face * scene->info.n_reflectors;
}

static void vir_omni_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	ts_omni_expect(expected, scene, params);
	expected->sizes.n[TS_DIM_points] =
		2 * (u64)scene->n_triangles + 2 * 6 * (u64)TS_PARAM(params, depth_map_px) * TS_PARAM(params, depth_map_px);
}

const ts_pipeline ts_pipeline_vir_reflections = {
	.name = "vir",
	.effect = &ts_effect_reflections,
	.paper = "iVIR 5",
	.doc = "view-independent rendering: points as dense as the nearest cube demands, by distance alone",
	.steps = ts_ivir_reflections_steps,
	.plan = vir_plan,
	.expect = vir_expect,
	.only_named = true,
};

const ts_pipeline ts_pipeline_vir_soft = {
	.name = "vir",
	.effect = &ts_effect_soft_shadows,
	.paper = "iVIR 4",
	.doc = "the same with the density of view-independent rendering",
	.steps = ts_ivir_soft_steps,
	.plan = vir_soft_plan,
	.expect = ts_soft_expect,
	.only_named = true,
};

const ts_pipeline ts_pipeline_vir_omni = {
	.name = "vir",
	.effect = &ts_effect_omni_shadows,
	.paper = "iVIR 6",
	.doc = "the same with the density of view-independent rendering",
	.steps = ts_ivir_omni_steps,
	.plan = vir_omni_plan,
	.expect = vir_omni_expect,
	.only_named = true,
};
