/* The table of the stages: complete, in an order that makes every buffer before it is read, and true: a stage
 * depends on what it claims to read and on nothing else. */
#include "tests/methods/small.h"

/* Buffers of the scene: there before any stage. */
static bool is_scene(ts_buffer_id id) { return strncmp(ts_buffer_table[id].name, "scene.", 6) == 0; }

/* "look-ups2.point" is written by stage "look-ups2"; some buffers are named for what they hold. */
static bool is_named_for(const char *buffer, const ts_stage *stage)
{
	size_t n = strlen(stage->name);
	return strncmp(buffer, stage->name, n) == 0 && buffer[n] == '.';
}

static void every_row_of_the_stages_is_complete(void **state)
{
	(void)state;
	u32 n = 0;
	for (const ts_stage *const *at = ts_stages(); *at != NULL; at++, n++) {
		const ts_stage *s = *at;
		assert_ptr_equal(ts_stage_find(s->name), s);
		assert_true(strcmp(s->kind, "map") == 0 || strcmp(s->kind, "emit") == 0 || strcmp(s->kind, "scatter") == 0);
		assert_true(s->run != NULL && s->paper[0] != 0 && s->doc[0] != 0);
		assert_true(ts_stage_outputs(s)[0] != TS_N_BUFFERS && ts_stage_inputs(s)[0] != TS_N_BUFFERS);
		for (u32 i = 0; ts_stage_inputs(s)[i] != TS_N_BUFFERS; i++) {
			assert_false(small_in(ts_stage_inputs(s) + i + 1, ts_stage_inputs(s)[i]));
			assert_false(small_in(ts_stage_outputs(s), ts_stage_inputs(s)[i]));
		}
		for (u32 i = 0; ts_stage_outputs(s)[i] != TS_N_BUFFERS; i++) {
			assert_false(small_in(ts_stage_outputs(s) + i + 1, ts_stage_outputs(s)[i]));
			assert_false(is_scene(ts_stage_outputs(s)[i]));
		}
	}
	assert_true(n > 0 && n <= TS_MAX_TIMINGS);
	assert_null(ts_stage_find("no such stage"));
	assert_null(ts_stage_find(""));
}

static bool is_written_once(const ts_pipeline *pipeline, ts_buffer_id id)
{
	u32 n = 0;
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		n += ts_stage_writes(ts_stage_find(step->stage), id);
	}
	return n <= 1;
}

/* Every buffer is written by some stage, by just one of each method, or is the scene's. */
static void every_buffer_has_one_writer_a_method(void **state)
{
	(void)state;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		u32 n = 0, n_named = 0;
		for (const ts_stage *const *at = ts_stages(); *at != NULL; at++) {
			const ts_stage *s = *at;
			if (!small_in(ts_stage_outputs(s), (ts_buffer_id)id)) continue;
			n++;
			n_named += is_named_for(ts_buffer_table[id].name, s);
		}
		if ((n == 0) != is_scene((ts_buffer_id)id)) fail_msg("%s: %u stages", ts_buffer_table[id].name, n);
		for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
			const ts_pipeline *p = *at;
			if (is_written_once(p, (ts_buffer_id)id)) continue;
			fail_msg("%s by %s: %s twice", p->effect->name, p->name, ts_buffer_table[id].name);
		}
		assert_true(n_named <= 1);
	}
}

/* Every buffer that a stage makes, but margins, the pictures and figures, is read by another. */
static void every_buffer_is_read_by_another_stage(void **state)
{
	(void)state;
	static const ts_buffer_id last[] = {TS_B_image_radiance,
	                                    TS_B_image_sample_radiance,
	                                    TS_B_image_srgb,
	                                    TS_B_shade_n_samples,
	                                    TS_B_split_triangle_density,
	                                    TS_B_split_offset,
	                                    TS_B_splat_tie,
	                                    TS_B_shadow_cube_size_least_ratio,
	                                    TS_B_bilateral_filtered_rows,
	                                    TS_B_octree_root_least,
	                                    TS_B_octree_surface,
	                                    TS_B_vpl_offset,
	                                    TS_B_vpl_path,
	                                    TS_B_view_octree_cone_sum,
	                                    TS_B_view_octree_cone_least,
	                                    TS_N_BUFFERS};
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		u32 n = 0;
		for (const ts_stage *const *s = ts_stages(); *s != NULL; s++) {
			n += small_in(ts_stage_inputs(*s), (ts_buffer_id)id);
			n += (*s)->margin_of != NULL && small_in(ts_stage_outputs(*s), (ts_buffer_id)id);
		}
		if (n == 0 && !small_in(last, (ts_buffer_id)id)) fail_msg("nobody reads %s", ts_buffer_table[id].name);
	}
}

typedef struct {
	bool made[TS_N_BUFFERS];
	u32 n_stages;
} progress;

/* A stage reads only buffers that are there, and makes all that it says it writes. */
static ts_status watch(const ts_run *run, const ts_stage *stage, void *user)
{
	progress *p = user;
	p->n_stages++;
	for (const ts_buffer_id *at = ts_stage_inputs(stage); *at != TS_N_BUFFERS; at++) {
		ts_buffer_id id = *at;
		if (!is_scene(id) && !p->made[id]) fail_msg("%s reads %s too early", stage->name, ts_buffer_table[id].name);
	}
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) p->made[*id] = true;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool of_scene = is_scene((ts_buffer_id)id) && (id != TS_B_scene_surfel || run->scene->n_surfels > 0) &&
		                (id != TS_B_scene_stand || run->scene->n_stands > 0) &&
		                (id != TS_B_scene_path || run->scene->n_path > 0) &&
		                (id != TS_B_scene_motion || run->scene->n_motion > 0);
		bool of_samples = id == TS_B_image_sample_radiance && TS_PARAM(&run->params, eye_samples) == TS_EYE_SAMPLES_1;
		bool made = run->frame.buffer[id].made, claimed = (p->made[id] && !of_samples) || of_scene;
		if (made == claimed) continue;
		fail_msg("after %s: %s %s", stage->name, ts_buffer_table[id].name, made ? "unclaimed" : "missing");
	}
	return TS_OK;
}

static void buffers_are_made_before_they_are_read(void **state)
{
	(void)state;
	ts_params params = small_params(64, 64);
	params.lookup_bounces = 3;
	params.reflectors_count = 3;
	params.cube_max_px = 32;
	ts_scene *scene = small_scene(&params);
	static const char *const methods[] = {"epr", "mvr"};
	for (u32 m = 0; m < 2; m++) {
		ts_run run;
		progress p = {.n_stages = 0};
		small_run(&run, scene, &params, methods[m], 2, watch, &p);
		assert_true(p.n_stages >= 9);
		for (u32 i = 0; i < run.n_timings; i++) assert_non_null(ts_stage_find(run.timings[i].stage));
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* Every stage again, alone, from what it claims to read: the same buffers. */
static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	ts_params params = small_params(96, 64);
	params.lookup_bounces = 3;
	params.cube_px = 24;
	static const char *const methods[] = {"epr", "mvr"};
	for (u32 m = 0; m < 2; m++) {
		params.reflectors_count = m == 0 ? 4 : 1;
		params.reflectors_px = 40;
		ts_scene *scene = small_scene(&params);
		ts_run run;
		ts_run_begin(&run, scene, &params, 2);
		run.traced = run.margins = true;
		if (ts_pipeline_run(ts_pipeline_find("reflections", methods[m]), &run) != TS_OK)
			fail_msg("%s", ts_error_message());
		for (u32 i = 0; i < run.n_timings; i++) small_assert_claims(&run, ts_stage_find(run.timings[i].stage));
		if (m == 0) assert_true(ts_frame_n(&run.frame, TS_B_lookup_third_parent) > 0);
		ts_run_end(&run);
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_row_of_the_stages_is_complete),
		cmocka_unit_test(every_buffer_has_one_writer_a_method),
		cmocka_unit_test(every_buffer_is_read_by_another_stage),
		cmocka_unit_test(buffers_are_made_before_they_are_read),
		cmocka_unit_test(stages_read_only_what_they_claim),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
