/* `replay` of one stage: its number is that of its files, its verdict that of its outputs; and what is no stage. */
#include "tests/cli/typed.h"
#include "tests/trace/small.h"

static int begin(void **state)
{
	ts_params params = small_params();
	if (scratch_begin(state) != 0) return -1;
	ts_scene *scene = small_scene(&params);
	small_trace(scratch_path("t"), "epr", scene, &params, (ts_trace_options){.margins = false});
	ts_scene_free(scene);
	return 0;
}

/* Replays a stage of the trace of that name. */
static ts_status replay(json_t **said, const char *dir, const char *stage)
{
	char line[TYPED_LINE];
	snprintf(line, sizeof line, "replay %s --stage %s --json", scratch_path("%s", dir), stage);
	return typed_run(said, line);
}

static const char *text_of(const json_t *object, const char *key)
{
	return json_string_value(json_object_get(object, key));
}

/* The only stage of what was said. */
static const json_t *only(const json_t *said)
{
	assert_int_equal(json_array_size(json_object_get(said, "stages")), 1);
	return json_array_get(json_object_get(said, "stages"), 0);
}

static void one_stage_has_its_number_and_verdict(void **state)
{
	(void)state;
	static const char *const stages[] = {"eye.view", "mirror_pixel", "cube_size", "lookup", "shade", "image"};
	for (u32 i = 0; i < sizeof stages / sizeof *stages; i++) {
		json_t *said;
		assert_int_equal(replay(&said, "t", stages[i]), TS_OK);
		const json_t *stage = only(said), *output = json_array_get(json_object_get(stage, "outputs"), 0);
		assert_string_equal(text_of(stage, "stage"), stages[i]);
		assert_string_equal(text_of(stage, "verdict"), "same");
		assert_string_equal(text_of(output, "verdict"), "same");
		const char *file = strrchr(text_of(output, "file"), '/') + 1;
		assert_int_equal(json_integer_value(json_object_get(stage, "number")), atoi(file));
		json_decref(said);
	}
}

static void a_wrong_output_is_different(void **state)
{
	(void)state;
	json_t *said;
	char path[SCRATCH_PATH];
	size_t bytes;
	small_copy(scratch_path("wrong"), scratch_path("t"));
	assert_int_equal(replay(&said, "wrong", "image"), TS_OK);
	const json_t *outputs = json_object_get(only(said), "outputs");
	snprintf(path, sizeof path, "%s", text_of(json_array_get(outputs, 1), "file"));
	json_decref(said);
	char *data = file_read(path, &bytes);
	data[bytes - 4] ^= 1;
	file_write(path, data, bytes);
	free(data);
	assert_int_equal(replay(&said, "wrong", "image"), TS_DIFFERENT);
	assert_string_equal(text_of(only(said), "verdict"), "different");
	const json_t *output = json_array_get(json_object_get(only(said), "outputs"), 1);
	assert_int_equal(json_integer_value(json_object_get(output, "different")), 1);
	json_decref(said);
	assert_int_equal(replay(&said, "wrong", "shade"), TS_OK);
	json_decref(said);
}

static void what_is_no_stage_is_refused(void **state)
{
	(void)state;
	json_t *said;
	assert_int_equal(replay(&said, "t", "imag"), TS_ERROR);
	assert_null(said);
	assert_non_null(strstr(ts_error_message(), "imag"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(one_stage_has_its_number_and_verdict),
		cmocka_unit_test(a_wrong_output_is_different),
		cmocka_unit_test(what_is_no_stage_is_refused),
	};
	return cmocka_run_group_tests(tests, begin, scratch_remove);
}
