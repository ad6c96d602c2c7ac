/* Whole runs: the same bits on any number of threads, what the counters count, the sizes that were expected, and
 * switches that must agree. */
#include "methods/stages.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

/* Name and digest of every buffer, a line each; by free(). */
static char *digests_of(const ts_scene *scene, const ts_params *params, const char *method, u32 threads,
                        bool no_fast_paths)
{
	ts_sums sums;
	const ts_pipeline *pipeline = ts_pipeline_find("reflections", method);
	ts_status status =
		ts_sums_of(&sums, pipeline, scene, params, &(ts_how){.threads = threads, .no_fast_paths = no_fast_paths});
	if (status != TS_OK) fail_msg("%s: %s", method, ts_error_message());
	char *text = calloc(TS_N_BUFFERS, 128);
	assert_non_null(text);
	FILE *out = fmemopen(text, TS_N_BUFFERS * 128, "w");
	assert_non_null(out);
	ts_sums_print(&sums, pipeline, out);
	assert_int_equal(fclose(out), 0);
	return text;
}

/* Names the first line that differs. */
static void assert_same_digests(const char *a, const char *b, const char *what)
{
	for (; *a != 0 || *b != 0; a = strchr(a, '\n') + 1, b = strchr(b, '\n') + 1) {
		size_t n = strcspn(a, "\n");
		if (strncmp(a, b, n + 1) != 0) fail_msg("%s: %.*s", what, (int)n, a);
	}
}

static void assert_same_runs(const ts_scene *scene, const ts_params *p, const ts_params *q, const char *what)
{
	char *a = digests_of(scene, p, "epr", 2, false), *b = digests_of(scene, q, "epr", 2, false);
	assert_same_digests(a, b, what);
	free(a);
	free(b);
}

static void threads_and_fast_paths_change_no_bit(void **state)
{
	(void)state;
	static const u32 threads[] = {2, 5, 7};
	static const char *const methods[] = {"epr", "mvr"};
	ts_params params = small_params(80, 45);
	params.lookup_bounces = 3;
	params.cube_max_px = 32;
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < 2; m++) {
		char *one = digests_of(scene, &params, methods[m], 1, false);
		assert_true(strlen(one) > 12 * 66);
		for (u32 i = 0; i < 3; i++) {
			char *more = digests_of(scene, &params, methods[m], threads[i], false);
			assert_same_digests(one, more, methods[m]);
			free(more);
		}
		char *reference = digests_of(scene, &params, methods[m], 2, true);
		assert_same_digests(one, reference, "without fast paths");
		free(reference);
		free(one);
	}
	ts_scene_free(scene);
}

/* A density of 1/4 an area is one of 1/2 a side. */
static void density_per_area_is_per_side_squared(void **state)
{
	(void)state;
	ts_params side = small_params(120, 68), area = side;
	area.density_per_area = 1;
	area.density_scale = 0.25f;
	ts_scene *scene = small_scene(&side);
	assert_same_runs(scene, &side, &area, "density.per_area");
	ts_scene_free(scene);
}

static i64 count_none(const ts_run *run, ts_buffer_id id)
{
	const u32 *found = ts_frame_data(&run->frame, id);
	i64 n = 0;
	for (u64 i = 0; i < ts_frame_n(&run->frame, id); i++) n += found[i] == TS_NONE;
	return n;
}

/* EPR shades 25 samples a reflective pixel and 4 for each sample that is followed; all look-ups are counted. */
static void epr_counts_its_samples_and_look_ups(void **state)
{
	(void)state;
	for (u32 bounces = 1; bounces <= 3; bounces++) {
		ts_params params = small_params(120, 68);
		params.lookup_bounces = bounces;
		params.reflectors_count = 20;
		params.points_cull = 0;
		ts_scene *scene = small_scene(&params);
		ts_run run;
		small_run(&run, scene, &params, "epr", 2, NULL, NULL);
		i64 pixels = (i64)ts_frame_n(&run.frame, TS_B_mirror_pixel_record), later = 0,
			empty = count_none(&run, TS_B_lookup_point);
		if (bounces > 1) later += (i64)ts_frame_n(&run.frame, TS_B_lookup_second_parent);
		if (bounces > 2) later += (i64)ts_frame_n(&run.frame, TS_B_lookup_third_parent);
		if (bounces > 1) empty += count_none(&run, TS_B_lookup_second_point);
		if (bounces > 2) empty += count_none(&run, TS_B_lookup_third_point);
		assert_true(pixels > 100 && (bounces == 1) == (later == 0));
		assert_int_equal(ts_run_counter(&run, "reflective pixels"), pixels);
		assert_int_equal(ts_run_counter(&run, "later look-ups"), later);
		assert_int_equal(ts_run_counter(&run, "look-ups"), 25 * pixels + 4 * later);
		assert_int_equal(ts_run_counter(&run, "shading operations"), 25 * pixels + 4 * later);
		assert_int_equal(ts_run_counter(&run, "empty look-ups"), empty);
		assert_true(ts_run_counter(&run, "distinct points shaded") <= 25 * pixels + 4 * later);
		assert_int_equal(ts_run_counter(&run, "points"), (i64)ts_frame_n(&run.frame, TS_B_points_record));
		assert_int_equal(ts_run_counter(&run, "pieces"), (i64)ts_frame_n(&run.frame, TS_B_split_piece));
		assert_int_equal(ts_run_counter(&run, "pieces culled"),
		                 ts_run_counter(&run, "pieces") - ts_run_counter(&run, "pieces kept"));
		assert_int_equal(ts_run_counter(&run, "cube texels"), (i64)ts_frame_n(&run.frame, TS_B_splat_depth_index));
		assert_int_equal(ts_run_counter(&run, "no such counter"), 0);
		ts_run_end(&run);
		ts_scene_free(scene);
	}
}

/* Adaptively: as many as the pixels say, never more than 25, in batches of four. */
static void adaptive_shading_counts_what_pixels_say(void **state)
{
	(void)state;
	ts_params params = small_params(120, 68);
	params.lookup_samples = TS_SAMPLES_ADAPTIVE;
	ts_scene *scene = small_scene(&params);
	ts_run run;
	small_run(&run, scene, &params, "epr", 2, NULL, NULL);
	const u32 *used = ts_frame_data(&run.frame, TS_B_shade_n_samples);
	u64 n = ts_frame_n(&run.frame, TS_B_shade_n_samples);
	i64 sum = 0;
	for (u64 i = 0; i < n; i++) {
		assert_true(used[i] == 25 || (used[i] >= 8 && used[i] < 25 && used[i] % 4 == 0));
		sum += used[i];
	}
	assert_int_equal(ts_run_counter(&run, "shading operations"), sum);
	assert_true(sum < 25 * (i64)n);
	ts_run_end(&run);
	ts_scene_free(scene);
}

static ts_status count_texels(const ts_run *run, const ts_stage *stage, void *user)
{
	if (strcmp(stage->name, "cube_face") != 0) return TS_OK;
	const u64 *texels = ts_frame_data(&run->frame, TS_B_cube_face_depth_triangle);
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_cube_face_depth_triangle); i++)
		*(i64 *)user += texels[i] != UINT64_MAX;
	return TS_OK;
}

/* MVR shades every texel that shows something, and draws the scene once a cube. */
static void mvr_counts_the_texels_that_show_something(void **state)
{
	(void)state;
	for (u32 faces = 0; faces < 2; faces++) {
		ts_params params = small_params(120, 68);
		params.mvr_faces = faces;
		params.cube_max_px = 32;
		ts_scene *scene = small_scene(&params);
		ts_run run;
		i64 texels = 0;
		small_run(&run, scene, &params, "mvr", 2, count_texels, &texels);
		assert_true(texels > 0);
		assert_int_equal(ts_run_counter(&run, "shading operations"), texels);
		assert_int_equal(ts_run_counter(&run, "geometry traversals"), 1 + scene->info.n_reflectors);
		if (faces == TS_MVR_FACES_FIXED) {
			assert_int_equal(ts_run_counter(&run, "cube texels"), 6 * 32 * 32 * (i64)scene->info.n_reflectors);
		}
		ts_run_end(&run);
		ts_scene_free(scene);
	}
}

/* Nothing that a stage stores is NaN, infinite, denormal or -0. */
static ts_status check_floats(const ts_run *run, const ts_stage *stage, void *user)
{
	(void)user;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		const ts_buffer *b = &run->frame.buffer[*id];
		if (strcmp(ts_buffer_table[*id].element, "f32") != 0) continue;
		const f32 *x = b->data;
		for (u64 k = 0; k < b->n; k++) {
			u32 bits = ts_f2u(x[k]), magnitude = bits & 0x7fffffff;
			bool bad = magnitude >= 0x7f800000 || (magnitude < 0x00800000 && bits != 0);
			if (bad) fail_msg("%s[%llu] is %a", ts_buffer_table[*id].name, (unsigned long long)k, (double)x[k]);
		}
	}
	return TS_OK;
}

static void every_stored_float_is_sound(void **state)
{
	(void)state;
	static const char *const methods[] = {"epr", "mvr"};
	ts_params params = small_params(120, 68);
	params.lookup_bounces = 3;
	params.cube_max_px = 32;
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < 2; m++) {
		ts_run run;
		small_run(&run, scene, &params, methods[m], 2, check_floats, NULL);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* What was counted is the first dimension of a buffer. */
static void count(ts_sizes *sizes, const ts_frame *frame)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_dim dim = ts_buffer_gives((ts_buffer_id)id);
		if (frame->buffer[id].made && dim != TS_DIM_none) sizes->n[dim] = frame->buffer[id].shape[0];
	}
	if (sizes->n[TS_DIM_cubes] != TS_UNKNOWN) ts_sizes_cubes(sizes, sizes->n[TS_DIM_cubes]);
}

/* Every buffer has the shape that records.def gives it; what is batched is of the batch. */
static ts_status check_shapes(const ts_run *run, const ts_stage *stage, void *user)
{
	ts_sizes sizes = run->sizes;
	count(&sizes, &run->frame);
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) {
		if (ts_dim_table[dim].how == TS_IS_batched) sizes.n[dim] = ts_run_size(run, (ts_dim)dim);
	}
	ts_sizes_give(&sizes, run);
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		const ts_buffer *buffer = &run->frame.buffer[*id];
		const ts_buffer_info *info = &ts_buffer_table[*id];
		const ts_shape *shape = ts_buffer_shape(*id);
		u64 dims[TS_MAX_DIMS];
		if (*id == TS_B_image_sample_radiance && !buffer->made) continue; /* of several samples a pixel alone */
		if (!ts_shape_dims(shape, &sizes, dims)) fail_msg("%s: shape %s", info->name, info->shape);
		assert_int_equal(shape->n, buffer->n_dims);
		assert_memory_equal(dims, buffer->shape, shape->n * sizeof *dims);
		++*(u32 *)user;
	}
	return TS_OK;
}

static void every_buffer_has_its_records_shape(void **state)
{
	(void)state;
	u32 checked = 0;
	ts_params params = small_params(64, 64);
	params.lookup_bounces = 3;
	params.cube_max_px = 32;
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < 2; m++) {
		ts_run run;
		small_run(&run, scene, &params, m == 0 ? "epr" : "mvr", 2, check_shapes, &checked);
		ts_run_end(&run);
	}
	assert_true(checked > 50);
	ts_scene_free(scene);
}

/* A lean run forgets what nobody reads any more, needs less memory, and gives the same picture. */
static void a_lean_run_gives_the_same_picture(void **state)
{
	(void)state;
	ts_params params = small_params(120, 68);
	params.lookup_bounces = 2;
	params.cube_max_px = 32;
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < 2; m++) {
		ts_run whole, lean;
		const char *method = m == 0 ? "epr" : "mvr";
		small_run(&whole, scene, &params, method, 2, NULL, NULL);
		ts_run_begin(&lean, scene, &params, 2);
		lean.lean = true;
		lean.keep[TS_B_eye_view] = true;
		assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", method), &lean), TS_OK);
		u64 n = ts_frame_n(&whole.frame, TS_B_image_radiance);
		assert_memory_equal(ts_frame_data(&whole.frame, TS_B_image_radiance),
		                    ts_frame_data(&lean.frame, TS_B_image_radiance), n * sizeof(f32));
		assert_true(lean.frame.buffer[TS_B_eye_view].made && whole.frame.buffer[TS_B_pose_vertex].made);
		assert_false(lean.frame.buffer[TS_B_pose_vertex].made);
		assert_true(lean.frame.bytes < whole.frame.bytes / 2);
		assert_true(lean.frame.peak_bytes <= whole.frame.peak_bytes);
		assert_true(lean.frame.buffer[TS_B_scene_vertex].made);
		ts_run_end(&whole);
		ts_run_end(&lean);
	}
	ts_scene_free(scene);
}

/* A hook's failure ends the run. */
static ts_status stop_at_cull(const ts_run *run, const ts_stage *stage, void *user)
{
	(void)run;
	++*(u32 *)user;
	return strcmp(stage->name, "cull") == 0 ? TS_ERROR : TS_OK;
}

static void a_failing_hook_ends_the_run(void **state)
{
	(void)state;
	ts_params params = small_params(64, 64);
	ts_scene *scene = small_scene(&params);
	u32 n = 0;
	ts_run run;
	ts_run_begin(&run, scene, &params, 0);
	run.hook = stop_at_cull;
	run.hook_user = &n;
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", "epr"), &run), TS_ERROR);
	assert_int_equal(n, 8);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* 32-bit indices name what they can; more is refused with one line. */
static void more_than_indices_name_is_refused(void **state)
{
	(void)state;
	ts_run run = {.n_counters = 0};
	u64 total;
	ts_c_begin(&run.c, 1);
	u32 *counts = ts_frame_make1(&run.frame, TS_B_points_offset, 3);
	memcpy(counts, (u32[3]){0xfffffff0, 14, 0}, 12);
	assert_int_equal(ts_run_scan(&run, TS_B_points_offset, &total), TS_OK);
	assert_true(total == 0xfffffffe && counts[2] == 0xfffffffe && counts[1] == 0xfffffff0 && counts[0] == 0);
	memcpy(counts, (u32[3]){0xfffffff0, 15, 0}, 12);
	assert_int_equal(ts_run_scan(&run, TS_B_points_offset, &total), TS_ERROR);
	ts_frame_clear(&run.frame);
	assert_non_null(strstr(ts_error_message(), "points"));
}

static void is_expected(const ts_pipeline *method, ts_dim dim, const ts_expected *expected, u64 made)
{
	const ts_dim_info *info = &ts_dim_table[dim];
	bool batched = info->how == TS_IS_batched, given = info->how == TS_IS_fixed || info->how == TS_IS_given;
	u64 n = expected->sizes.n[dim], all = batched ? n * expected->batches : n;
	if (n == TS_UNKNOWN || made == TS_UNKNOWN || n == made || all == made) return;
	if (given || batched || made > 3 * n || (made != 0 && n > 8 * made))
		fail_msg("%s %s: %llu %s expected, %llu made", method->effect->name, method->name, (unsigned long long)all,
		         info->name, (unsigned long long)made);
}

static void sizes_of_a_run_are_expected(const ts_pipeline *method, const ts_scene *scene, const ts_params *params)
{
	ts_run run;
	ts_expected expected = ts_pipeline_expect(method, scene, params);
	ts_run_begin(&run, scene, params, 2);
	if (ts_pipeline_run(method, &run) != TS_OK) fail_msg("%s: %s", method->name, ts_error_message());
	for (ts_dim d = 0; d < TS_N_DIMS; d++) is_expected(method, d, &expected, ts_run_size(&run, d));
	ts_run_end(&run);
}

/* Sizes that are given are expected as they are; others are at most three times of what is expected, and at least an
 * eighth, where there are any. The scene has three lights. */
static void sizes_are_as_each_method_expects(void **state)
{
	(void)state;
	ts_scene *scene = NULL;
	ts_params params = small_params_of_all();
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		small_scene_of(&scene, *at, &params);
		ts_scene lit = *scene;
		ts_light lights[3] = {scene->lights[0], scene->lights[0], scene->lights[0]};
		lit.lights = lights;
		lit.n_lights = 3;
		for (u32 source = TS_LAMP_LAMP; source <= TS_LAMP_SCENE; source++) {
			params.lamp_source = source;
			sizes_of_a_run_are_expected(*at, &lit, &params);
		}
	}
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_and_fast_paths_change_no_bit),
		cmocka_unit_test(density_per_area_is_per_side_squared),
		cmocka_unit_test(epr_counts_its_samples_and_look_ups),
		cmocka_unit_test(adaptive_shading_counts_what_pixels_say),
		cmocka_unit_test(mvr_counts_the_texels_that_show_something),
		cmocka_unit_test(every_stored_float_is_sound),
		cmocka_unit_test(a_failing_hook_ends_the_run),
		cmocka_unit_test(more_than_indices_name_is_refused),
		cmocka_unit_test(every_buffer_has_its_records_shape),
		cmocka_unit_test(a_lean_run_gives_the_same_picture),
		cmocka_unit_test(sizes_are_as_each_method_expects),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
