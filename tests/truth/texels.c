/* The rule of a buffer is found in whichever list it stands. */
#include "tests/model/test.h"
#include "truth/texels.h"

static ts_status judge(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id buffer)
{
	(void)counts;
	(void)truth;
	(void)run;
	(void)buffer;
	return TS_OK;
}

static void rules_are_found_in_any_list(void **state)
{
	(void)state;
	static const ts_texel_rule one[] = {
		{.buffer = TS_B_eye_view, .judge = judge}, {.buffer = TS_B_points_key, .judge = judge}, {.judge = NULL}};
	static const ts_texel_rule none[] = {{.judge = NULL}};
	static const ts_texel_rule two[] = {{.buffer = TS_B_scene_light, .judge = judge}, {.judge = NULL}};
	static const ts_texel_rule *const lists[] = {one, none, two, NULL}, *const empty[] = {NULL};
	ts_texels_use(lists);
	assert_ptr_equal(ts_texels_find(TS_B_eye_view), &one[0]);
	assert_ptr_equal(ts_texels_find(TS_B_points_key), &one[1]);
	assert_ptr_equal(ts_texels_find(TS_B_scene_light), &two[0]);
	assert_null(ts_texels_find(TS_B_scene_vertex));
	assert_null(ts_texels_find(0));
	ts_texels_use(empty);
	assert_null(ts_texels_find(TS_B_eye_view));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(rules_are_found_in_any_list)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
