/* What the tests of the stages share: small runs of both methods on the atrium; and one stage alone. */
#ifndef TS_TESTS_METHODS_SMALL_H
#define TS_TESTS_METHODS_SMALL_H
#include "kernels/points/samples.h"
#include "methods/pipeline.h"
#include "tests/model/test.h"

#define SMALL_SCENE "atrium:triangles=10000:texels=32"

static inline ts_params small_params(u32 width, u32 height)
{
	ts_params params;
	ts_params_default(&params);
	params.width = width;
	params.height = height;
	return params;
}

/* Little of each effect. */
static inline ts_params small_params_of_all(void)
{
	ts_params params = small_params(32, 18);
	params.reflectors_count = 2;
	params.reflectors_px = 8;
	params.cube_max_px = 16;
	params.depth_map_px = 16;
	params.lamp_views = 3;
	params.octree_levels = 4;
	params.vpl_paths = 20;
	params.rsm_px = 16;
	params.particle_count = 10;
	return params;
}

static inline ts_scene *small_scene(const ts_params *params)
{
	ts_scene *scene;
	if (ts_scene_load(&scene, SMALL_SCENE, params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

/* Makes *scene, NULL at first, what the method draws of it: triangles, or surfels. */
static inline void small_scene_of(ts_scene **scene, const ts_pipeline *method, ts_params *params)
{
	u32 n_surfels = ts_pipeline_reads(method, TS_B_scene_surfel) ? 500 : 0;
	if (*scene != NULL && n_surfels == params->surfels_from_mesh) return;
	ts_scene_free(*scene);
	params->surfels_from_mesh = n_surfels;
	*scene = small_scene(params);
}

/* Runs a method to its end; the frame stays until ts_run_end. */
static inline void small_run(ts_run *run, const ts_scene *scene, const ts_params *params, const char *method,
                             u32 threads, ts_stage_hook hook, void *user)
{
	ts_run_begin(run, scene, params, threads);
	run->hook = hook;
	run->hook_user = user;
	ts_status status = ts_pipeline_run(ts_pipeline_find("reflections", method), run);
	if (status != TS_OK) fail_msg("%s: %s", method, ts_error_message());
}

static inline bool small_in(const ts_buffer_id *list, ts_buffer_id id)
{
	for (; *list != TS_N_BUFFERS; list++) {
		if (*list == id) return true;
	}
	return false;
}

/* A copy of the frame for one stage: what it does not claim to read is all zero, what it writes is not there. */
static inline void small_blind(ts_run *copy, const ts_run *run, const ts_stage *stage)
{
	*copy = *run;
	copy->hook = NULL;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_buffer *b = &copy->frame.buffer[id];
		if (!b->made || small_in(ts_stage_inputs(stage), (ts_buffer_id)id)) continue;
		if (small_in(ts_stage_outputs(stage), (ts_buffer_id)id)) {
			*b = (ts_buffer){.made = false};
			continue;
		}
		b->data = calloc(b->n + 1, ts_buffer_table[id].element_bytes);
		assert_non_null(b->data);
	}
}

static inline void small_release_blind(ts_run *copy, const ts_run *run)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (copy->frame.buffer[id].data != run->frame.buffer[id].data) free(copy->frame.buffer[id].data);
	}
}

static inline void small_assert_same_outputs(const ts_run *copy, const ts_run *run, const ts_stage *stage)
{
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		const ts_buffer *a = &run->frame.buffer[*id], *b = &copy->frame.buffer[*id];
		const ts_buffer_info *info = &ts_buffer_table[*id];
		if (a->n != b->n || memcmp(a->data, b->data, a->n * info->element_bytes) != 0) {
			fail_msg("%s: %s depends on a buffer that the stage does not claim to read", stage->name, info->name);
		}
	}
}

/* The stage again, alone, from what it claims to read. */
static inline void small_assert_claims(const ts_run *run, const ts_stage *stage)
{
	ts_run copy;
	small_blind(&copy, run, stage);
	if (ts_run_stage(&copy, stage) != TS_OK) fail_msg("%s", ts_error_message());
	small_assert_same_outputs(&copy, run, stage);
	small_release_blind(&copy, run);
}

#endif
