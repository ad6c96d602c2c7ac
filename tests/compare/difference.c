/* Differences in words, and lists that are full. */
#include "compare/difference.h"
#include "tests/model/test.h"

static void says_where(ts_buffer_id id, ts_difference d, const char *right)
{
	char text[TS_WHERE_TEXT];
	ts_difference_where(text, NULL, id, &d);
	assert_string_equal(text, right);
}

static void a_place_is_told_in_words(void **state)
{
	(void)state;
	says_where(TS_B_align_frame, (ts_difference){.element = 12}, "element 12");
	says_where(TS_B_points_offset, (ts_difference){.element = 18}, "count of element 17 (element 18 less element 17)");
	says_where(TS_B_points_offset, (ts_difference){.element = 0}, "element 0, where the sums begin");
	says_where(TS_B_octree_offset, (ts_difference){.element = UINT32_MAX},
	           "count of element 4294967294 (element 4294967295 less element 4294967294)");
	const u64 key = (u64)7 << 32 | 32769u << 16 | 32766u;
	says_where(TS_B_points_record, (ts_difference){.how = TS_TWICE, .cand = key}, "key (piece 7, x -2, y 1)");
	says_where(TS_B_points_key, (ts_difference){.how = TS_BESIDE, .cand = key}, "key (piece 7, x -2, y 1)");
	says_where(TS_B_points_key, (ts_difference){.how = TS_LACKED, .element = 3}, "element 3");
	says_where(TS_B_traverse_rendered, (ts_difference){.how = TS_BESIDE, .cand = (u64)7 << 32 | 9},
	           "pair (node 7, node of views 9)");
}

/* Counts may be negative, and have no bits of their own. */
static void counts_may_be_negative(void **state)
{
	(void)state;
	char text[TS_VALUE_TEXT], field[64];
	const ts_difference count = {.ref = 4, .cand = (u64)(i64)-4294967295}, normal = {.field = 2, .component = 1};
	ts_difference_show(text, TS_B_split_offset, &count, count.ref);
	assert_string_equal(text, "4");
	ts_difference_show(text, TS_B_split_offset, &count, count.cand);
	assert_string_equal(text, "-4294967295");
	ts_difference_show(text, TS_B_mirror_pixel_record, &normal, 0x3f800000);
	assert_string_equal(text, "1 = 0x1p+0 (3f800000)");
	ts_difference_field(field, TS_B_mirror_pixel_record, &normal);
	assert_string_equal(field, "normal[1]");
	ts_difference_field(field, TS_B_split_offset, &count);
	assert_string_equal(field, "");
}

static void a_full_list_takes_no_more(void **state)
{
	(void)state;
	ts_named room[3] = {{.where = "kept"}, {.where = "kept"}, {.where = "kept"}};
	ts_differences list = {.items = room, .most = 2}, none = {.n = 0};
	for (u64 i = 0; i < 5; i++) {
		const ts_difference d = {.element = 10 + i};
		assert_int_equal(ts_differences_add(&list, NULL, TS_B_align_frame, &d), TS_OK);
		assert_int_equal(ts_differences_add(&none, NULL, TS_B_align_frame, &d), TS_OK);
	}
	assert_true(list.n == 2 && none.n == 0);
	assert_string_equal(room[0].where, "element 10");
	assert_string_equal(room[1].where, "element 11");
	assert_string_equal(room[2].where, "kept");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_place_is_told_in_words),
		cmocka_unit_test(counts_may_be_negative),
		cmocka_unit_test(a_full_list_takes_no_more),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
