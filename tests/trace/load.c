/* Loading: the candidate's buffers first, and what cannot be loaded refused before anything is read. */
#include "tests/replay/traces.h"

static const ts_buffer_id splat_reads[] = {TS_B_cube_size_face, TS_B_align_frame, TS_B_points_record, TS_N_BUFFERS};

static ts_status load(const ts_buffer_id *ids, const ts_trace *reference, const ts_trace *candidate)
{
	ts_load *made;
	ts_status status = ts_load_begin(&made, ids, reference, candidate, 1);
	assert_true((status == TS_OK) == (made != NULL));
	ts_load_end(made);
	return status;
}

static void assert_reported(const char *text)
{
	const char *message = ts_error_message();
	if (strstr(message, text) == NULL || strchr(message, '\n') != NULL) fail_msg("%s", message);
}

static void just_what_is_read_is_loaded(void **state)
{
	(void)state;
	ts_load *made;
	assert_int_equal(ts_load_begin(&made, splat_reads, traces[0], NULL, 2), TS_OK);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool wanted =
			id == TS_B_scene_info || id == TS_B_cube_size_face || id == TS_B_align_frame || id == TS_B_points_record;
		assert_true((made->item[id] != NULL) == wanted);
		if (!wanted) continue;
		ts_buffer file;
		void *data = traces_read(&file, traces[0], (ts_buffer_id)id);
		const ts_buffer *buffer = &made->run.frame.buffer[id];
		assert_int_equal(buffer->n, file.n);
		assert_memory_equal(buffer->shape, file.shape, sizeof file.shape);
		assert_memory_equal(buffer->data, data, file.n * ts_buffer_table[id].element_bytes);
		free(data);
	}
	assert_int_equal(made->scene.info.n_reflectors, 2);
	assert_int_equal(made->run.params.width, 32);
	ts_load_end(made);
	ts_load_end(NULL);
}

static void buffers_of_the_candidate_come_first(void **state)
{
	(void)state;
	ts_buffer buffer;
	ts_point *points = traces_read(&buffer, traces[0], TS_B_points_record);
	points[3].length = 42;
	ts_trace *candidate = traces_plant(0, &(planted){TS_B_points_record, &buffer}, 1, "canonical", "");
	ts_load *made;
	assert_int_equal(ts_load_begin(&made, splat_reads, traces[0], candidate, 1), TS_OK);
	assert_ptr_equal(made->item[TS_B_points_record], &candidate->item[TS_B_points_record]);
	assert_ptr_equal(made->item[TS_B_align_frame], &traces[0]->item[TS_B_align_frame]);
	assert_true(((const ts_point *)ts_frame_data(&made->run.frame, TS_B_points_record))[3].length == 42);
	ts_load_end(made);
	traces_drop(candidate);
	free(points);
}

static void missing_files_are_named(void **state)
{
	(void)state;
	char *key = traces[0]->item[TS_B_points_record].path, *frame = traces[0]->item[TS_B_align_frame].path;
	traces[0]->item[TS_B_points_record].path = traces[0]->item[TS_B_align_frame].path = NULL;
	assert_int_equal(load(splat_reads, traces[0], NULL), TS_ERROR);
	assert_reported("no file of align.frame, points.record");
	traces[0]->item[TS_B_points_record].path = key;
	traces[0]->item[TS_B_align_frame].path = frame;
	assert_int_equal(load(splat_reads, traces[0], NULL), TS_OK);
}

static void a_cropped_buffer_is_not_loaded(void **state)
{
	(void)state;
	u64 texels[6] = {0};
	const ts_buffer part = {.data = texels, .n = 6, .n_dims = 2, .shape = {2, 3}};
	static const ts_buffer_id ids[] = {TS_B_eye_depth_triangle, TS_N_BUFFERS};
	ts_trace *candidate =
		traces_plant(0, &(planted){TS_B_eye_depth_triangle, &part}, 1, "canonical", ", \"crop\": [0, 0, 3, 2]");
	assert_int_equal(load(ids, traces[0], candidate), TS_ERROR);
	assert_reported("cropped");
	traces_drop(candidate);
}

/* Sizes that headers might tell: nothing is read or allocated. */
static void a_size_beyond_memory_is_refused(void **state)
{
	(void)state;
	u64 none = 0;
	const ts_buffer empty = {.data = &none, .n = 0, .n_dims = 2, .shape = {0, 1}};
	static const ts_buffer_id ids[] = {TS_B_visibility_bits, TS_N_BUFFERS};
	ts_trace *candidate = traces_plant(0, &(planted){TS_B_visibility_bits, &empty}, 1, "canonical", "");
	ts_trace_item *item = &candidate->item[TS_B_visibility_bits];
	item->npy.shape[0] = item->npy.n = ts_memory_limit() / 8 + 1;
	assert_int_equal(load(ids, traces[0], candidate), TS_ERROR);
	assert_reported("a run may use");
	item->npy.n = UINT64_MAX / 8;
	assert_int_equal(load(ids, traces[0], candidate), TS_ERROR);
	assert_reported("a run may use");
	traces_drop(candidate);
	static const ts_buffer_id keeps[] = {TS_B_cull_keep, TS_N_BUFFERS};
	const ts_buffer row = {.data = &none, .n = 0, .n_dims = 1, .shape = {0}};
	candidate = traces_plant(0, &(planted){TS_B_cull_keep, &row}, 1, "canonical", "");
	candidate->item[TS_B_cull_keep].npy.shape[0] = candidate->item[TS_B_cull_keep].npy.n = 1ull << 32;
	assert_int_equal(load(keeps, traces[0], candidate), TS_ERROR);
	assert_reported("32-bit");
	traces_drop(candidate);
}

/* A file that has become shorter since its header was read. */
static void a_file_that_has_shrunk_is_refused(void **state)
{
	(void)state;
	ts_buffer buffer;
	void *data = traces_read(&buffer, traces[0], TS_B_align_frame);
	ts_trace *candidate = traces_plant(0, &(planted){TS_B_align_frame, &buffer}, 1, "canonical", "");
	assert_int_equal(truncate(candidate->item[TS_B_align_frame].path, 4096), 0);
	assert_int_equal(load(splat_reads, traces[0], candidate), TS_ERROR);
	assert_reported("shorter");
	traces_drop(candidate);
	free(data);
}

static void traces_of_other_parameters_do_not_match(void **state)
{
	(void)state;
	u32 keep = 1;
	const ts_buffer buffer = {.data = &keep, .n = 1, .n_dims = 1, .shape = {1}};
	ts_trace *candidate = traces_plant(0, &(planted){TS_B_cull_keep, &buffer}, 1, "canonical", "");
	assert_int_equal(ts_load_match(traces[0], candidate), TS_OK);
	assert_int_equal(ts_load_match(candidate, NULL), TS_ERROR);
	assert_reported("no params");
	assert_int_equal(ts_load_match(traces[1], candidate), TS_ERROR);
	assert_reported("of method epr");
	candidate->has_params = true;
	candidate->params = traces[0]->params;
	assert_int_equal(ts_load_match(traces[0], candidate), TS_OK);
	candidate->params.seed++;
	assert_int_equal(ts_load_match(traces[0], candidate), TS_ERROR);
	assert_reported("parameter seed is 1; 0 would be right");
	traces_drop(candidate);
}

/* Surfels are lit by the scene's lights, whatever is typed, or told by an old trace or a port. */
static void what_a_method_sets_is_loaded(void **state)
{
	(void)state;
	const char *dir = scratch_path("typed");
	char path[MAX_TEXT];
	assert_int_equal(traces[TRACES_SURFELS]->params.lamp_source, TS_LAMP_SCENE);
	assert_int_equal(mkdir(dir, 0700), 0);
	snprintf(path, sizeof path, "%s/trace.json", dir);
	FILE *json = fopen(path, "w");
	fprintf(
		json,
		"{\"format\": \"touchstone-trace\", \"version\": 1, \"contract\": 1, \"pipeline\": \"deferred\", \"effect\": "
		"\"surfels\", \"order\": \"canonical\", \"params\": {\"lamp.source\": \"lamp\"}, \"buffers\": []}\n");
	assert_int_equal(fclose(json), 0);
	ts_trace *typed;
	if (ts_trace_open_folder(&typed, dir) != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(typed->params.lamp_source, TS_LAMP_SCENE);
	traces_drop(typed);
	ts_trace reference = *traces[TRACES_PCSS], candidate = reference;
	candidate.params.lamp_source = TS_LAMP_LAMP;
	assert_int_equal(ts_load_match(&reference, &candidate), TS_ERROR);
	assert_reported("parameter lamp.source");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(just_what_is_read_is_loaded),
		cmocka_unit_test(buffers_of_the_candidate_come_first),
		cmocka_unit_test(missing_files_are_named),
		cmocka_unit_test(a_cropped_buffer_is_not_loaded),
		cmocka_unit_test(a_size_beyond_memory_is_refused),
		cmocka_unit_test(a_file_that_has_shrunk_is_refused),
		cmocka_unit_test(traces_of_other_parameters_do_not_match),
		cmocka_unit_test(what_a_method_sets_is_loaded),
	};
	return cmocka_run_group_tests(tests, traces_begin, traces_end);
}
