/* Answers: of a trace in memory they are those of the same trace in a folder, which the command prints. */
#include <inttypes.h>
#include "tests/api/run.h"

static void memory_and_folder_give_the_same_answers(void **state)
{
	(void)state;
	const uint64_t *keys = ts_trace_buffer(reference, "eye.depth_triangle")->data;
	ts_tree *answer;
	uint32_t n_seen = 0;
	for (uint32_t i = 0; i < 64 * 36; i += 37) {
		done(ts_probe_pixel(context, &answer, reference, i % 64, i / 64, NULL));
		const ts_tree *pixel = ts_tree_get(answer, "pixel");
		assert_int_equal(ts_tree_kind_of(pixel), TS_TREE_LIST);
		assert_int_equal(ts_tree_integer(ts_tree_at(pixel, 0)), i % 64);
		assert_int_equal(ts_tree_integer(ts_tree_at(pixel, 1)), i / 64);
		assert_string_equal(ts_tree_text(ts_tree_get(answer, "method")), "epr");
		n_seen += keys[i] != UINT64_MAX;
		ts_tree_free(answer);
	}
	assert_true(n_seen > 10);
	done(ts_probe_triangle(context, &answer, reference, 5));
	assert_int_equal(ts_tree_integer(ts_tree_get(answer, "triangle")), 5);
	ts_tree_free(answer);
	done(ts_probe_point(context, &answer, reference, 0));
	ts_tree_free(answer);
	/* By its key a point is the same. */
	int64_t key[3];
	done(ts_probe_point(context, &answer, reference, 3));
	char *by_index = ts_tree_json(answer), *by_key;
	const char *text = ts_tree_text(ts_tree_get(answer, "key"));
	assert_int_equal(sscanf(text, "%" SCNd64 ",%" SCNd64 ",%" SCNd64, &key[0], &key[1], &key[2]), 3);
	ts_tree_free(answer);
	done(ts_probe_point_key(context, &answer, reference, key));
	by_key = ts_tree_json(answer);
	assert_string_equal(by_index, by_key);
	ts_tree_free(answer);
	free(by_index);
	free(by_key);
	key[0] = 4000000;
	refused(ts_probe_point_key(context, &answer, reference, key), "4000000");
	refused(ts_probe_pixel(context, &answer, reference, 64, 0, NULL), "64");
	assert_null(answer);
	refused(ts_probe_pixel(context, &answer, reference, 0, 0, "window"), "window");
	refused(ts_probe_triangle(context, &answer, reference, 1u << 30), "triangle");
}

/* Each row is of an option of the command, and all rows of one stand together. */
static void rows_of_one_option_stand_together(void **state)
{
	(void)state;
	static const char *const options[] = {"--pixel X,Y", "--pixel X,Y --view VIEW", "--triangle T", "--point P"};
	const ts_probe_info *row;
	size_t n = 0, option = 0;
	for (; (row = ts_probe_at(n)) != NULL; n++) {
		while (option < 4 && strcmp(row->option, options[option]) != 0) option++;
		assert_true(option < 4 && row->answer[0] != 0 && strstr(row->methods, " by ") != NULL);
		assert_int_equal(row->view[0] != 0, option == 1);
	}
	assert_int_equal(option, 3);
	assert_true(n > 8);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(memory_and_folder_give_the_same_answers),
	                                   cmocka_unit_test(rows_of_one_option_stand_together)};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}
