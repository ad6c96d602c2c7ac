/* A pipeline of tests: the two octrees of MegaViews, from the scene to the cones of the views. */
#ifndef TS_TESTS_METHODS_VIEWS_OCTREES_H
#define TS_TESTS_METHODS_VIEWS_OCTREES_H
#include "methods/stages.h"
#include "methods/views/pipelines.h"
#include "methods/views/views.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

static const ts_step octrees_steps[] = {
	{.stage = "pose"},
	{.stage = "lamp"},
	{.stage = "rsm.view"},
	{.stage = "rsm"},
	{.stage = "rsm.patch"},
	{.stage = "octree.root"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree.surface"},
	{.stage = "vpl.area", .only_if = ts_vpl_at_random},
	{.stage = "vpl"},
	{.stage = "view_octree.voxel"},
	{.stage = "view_octree"},
	{.stage = "view_octree.cone"},
	{0},
};
static const ts_pipeline octrees_pipeline = {
	.name = "octrees",
	.effect = &ts_effect_indirect,
	.steps = octrees_steps,
	.plan = ts_views_plan,
	.expect = ts_indirect_expect,
};

static inline ts_params octrees_params(u32 levels, u32 vpls)
{
	ts_params params = small_params(96, 64);
	params.reflectors_count = 0;
	params.rsm_px = 24;
	params.octree_levels = levels;
	params.vpl_paths = vpls;
	return params;
}

static inline void octrees_run(ts_run *run, const ts_scene *scene, const ts_params *params)
{
	ts_run_begin(run, scene, params, 2);
	if (ts_pipeline_run(&octrees_pipeline, run) != TS_OK) fail_msg("%s", ts_error_message());
}

/* The digests of all that the pipeline makes. */
static inline void octrees_sums(ts_sums *sums, const ts_scene *scene, const ts_params *params, u32 threads,
                                ts_backend *backend)
{
	const ts_how how = {.threads = threads, .backend = backend};
	if (ts_sums_of(sums, &octrees_pipeline, scene, params, &how) != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(strlen(sums->hex[TS_B_view_octree_cone]), 64);
}

static inline void octrees_assert_same(const ts_sums *a, const ts_sums *b)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (strcmp(a->hex[id], b->hex[id]) != 0) fail_msg("%s differs", ts_buffer_table[id].name);
	}
}

#endif
