/* Answers: of a trace in memory they are those of the same trace in a folder, which the command prints. */
#include "api.h"

static void test_answers(void **state)
{
	(void)state;
	ts_context *context = open_context(2);
	ts_params *params = small_params();
	ts_scene *scene = small_scene(context, params);
	ts_trace *trace = small_trace(context, scene, params, "epr");
	const uint64_t *keys = ts_trace_buffer(trace, "eye.depth_triangle")->data;
	ts_tree *answer;
	uint32_t n_seen = 0;
	for (uint32_t i = 0; i < 64 * 36; i += 37) {
		done(ts_probe_pixel(context, &answer, trace, i % 64, i / 64, NULL));
		const ts_tree *pixel = ts_tree_get(answer, "pixel");
		assert_int_equal(ts_tree_kind_of(pixel), TS_TREE_LIST);
		assert_int_equal(ts_tree_integer(ts_tree_at(pixel, 0)), i % 64);
		assert_int_equal(ts_tree_integer(ts_tree_at(pixel, 1)), i / 64);
		assert_string_equal(ts_tree_text(ts_tree_get(answer, "method")), "epr");
		n_seen += keys[i] != UINT64_MAX;
		ts_tree_free(answer);
	}
	assert_true(n_seen > 10);
	done(ts_probe_triangle(context, &answer, trace, 5));
	assert_int_equal(ts_tree_integer(ts_tree_get(answer, "triangle")), 5);
	ts_tree_free(answer);
	done(ts_probe_point(context, &answer, trace, 0));
	ts_tree_free(answer);
	refused(ts_probe_pixel(context, &answer, trace, 64, 0, NULL), "64");
	assert_null(answer);
	refused(ts_probe_pixel(context, &answer, trace, 0, 0, "window"), "window");
	refused(ts_probe_triangle(context, &answer, trace, 1u << 30), "triangle");
	ts_trace_close(trace);
	ts_scene_free(scene);
	ts_params_free(params);
	ts_context_close(context);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_answers)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
