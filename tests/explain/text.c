/* What was told, in words: each kind of number, each kind of line, and what two lines at the same place differ in. */
#include "kernels/base/compat.h"
#include "tests/explain/hand.h"

static ts_explanation one, two;

static int begin(void **state)
{
	(void)state;
	hand_begin(&two);
	hand_begin(&one);
	return 0;
}

static int end(void **state)
{
	(void)state;
	hand_end(&one);
	hand_end(&two);
	return 0;
}

static void add_line(ts_explanation *e, const ts_told_site *site, const void *value)
{
	ts_told_to(&e->telling);
	ts_told(site, value);
}

static void reads(const ts_explanation *e, size_t number, const ts_explanation *other, const char *expected)
{
	char text[TS_TOLD_TEXT];
	ts_explain_text(text, e, number, other);
	assert_string_equal(text, expected);
}

static const hand_record record = {.length = 1.5f,
                                   .step = -7,
                                   .flags = 300,
                                   .sum = -5000000000,
                                   .key = UINT64_MAX,
                                   .level = 200,
                                   .on = true,
                                   .to = &hand_keys[3]};

/* The number of a leaf of the record. */
static void shows(u32 leaf, const hand_record *r, const char *expected)
{
	char text[TS_VALUE_TEXT];
	size_t number = one.telling.n_lines;
	add_line(&one, &hand_r, r);
	ts_explain_number(text, &one, &one.telling.lines[number], &hand_leaves[leaf]);
	assert_string_equal(text, expected);
}

static void each_kind_of_number_has_its_words(void **state)
{
	(void)state;
	static const char *const full[] = {
		"1.5 (3fc00000)", "-7",  "300 (12c)",    "-5000000000", "18446744073709551615 (ffffffffffffffff)",
		"200 (c8)",       "yes", "points.key:3",
	};
	hand_record other = {.length = ts_u2f(0x80000000u), .sum = INT64_MIN, .key = 1ull << 40};
	for (u32 leaf = 0; leaf < 8; leaf++) shows(leaf, &record, full[leaf]);
	static const char *const bare[] = {
		"-0 (80000000)", "0", "0 (0)", "-9223372036854775808", "1099511627776 (10000000000)", "0 (00)", "no", "NULL"};
	for (u32 leaf = 0; leaf < 8; leaf++) shows(leaf, &other, bare[leaf]);
	other.length = ts_u2f(1);
	other.step = INT32_MIN;
	shows(0, &other, "1.40129846e-45 (00000001)");
	shows(1, &other, "-2147483648");
}

/* Pointers by the element that any byte of it is in, up to the buffer's end. */
static void pointers_name_the_element_they_are_in(void **state)
{
	(void)state;
	ts_frame *frame = &hand_load.run.frame;
	const u8 *begin_of = (const u8 *)hand_keys;
	for (u32 byte = 0; byte < sizeof hand_keys; byte++) {
		char expected[32];
		snprintf(expected, sizeof expected, "points.key:%u", byte / 8);
		shows(7, &(hand_record){.to = begin_of + byte}, expected);
	}
	const void *const others[] = {begin_of - 1, begin_of + sizeof hand_keys, (const u8 *)frame->tally - 1,
	                              frame->tally + TS_TALLIES};
	for (u32 i = 0; i < 4; i++) shows(7, &(hand_record){.to = others[i]}, "memory of the stage");
	for (u32 i = 0; i < TS_TALLIES; i++) shows(7, &(hand_record){.to = &frame->tally[i]}, "a counter");
	frame->buffer[TS_B_points_key].made = false;
	shows(7, &record, "memory of the stage");
}

static void each_kind_of_line_has_its_words(void **state)
{
	(void)state;
	const u32 n = 300, xy[2] = {1, 2};
	const void *nowhere = NULL;
	ts_told_call(&hand_item);
	ts_told_test(&hand_test, true);
	ts_told_test(&hand_test, false);
	add_line(&one, &hand_n, &n);
	add_line(&one, &hand_result, &n);
	add_line(&one, &hand_c, xy);
	add_line(&one, &hand_store, &hand_keys[4]);
	add_line(&one, &hand_count, &hand_load.run.frame.tally[1]);
	add_line(&one, &hand_p, &nowhere);
	ts_told_title(&hand_bound);
	static const struct {
		const char *text, *place;
		bool has_value;
	} lines[] = {
		{"ts_k_hand_item()", "", false},
		{"n > 3? yes", "", false},
		{"n > 3? no", "", false},
		{"n = 300 (12c)", "", true},
		{"return 300 (12c)", "", true},
		{"c = .x 1 (1), .y 2 (2)", "", true},
		{"at[i], points.key:4 = 14 (e)", "points.key:4", true},
		{"*n_writes, a counter", "a counter", false},
		{"p = NULL", "", true},
		{"-- Bound it.", "", false},
	};
	for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
		char place[TS_VALUE_TEXT];
		const ts_told_line *line = &one.telling.lines[i];
		reads(&one, i, NULL, lines[i].text);
		ts_explain_place(place, &one, line);
		assert_string_equal(place, lines[i].place);
		assert_int_equal(ts_explain_has_value(&one, line), lines[i].has_value);
	}
}

/* Long values that were told before say where; pointers to nothing are left out of them. */
static void long_values_say_where_they_were_told(void **state)
{
	(void)state;
	const char *head = "r = .length 1.5 (3fc00000), .step -7, .flags 300 (12c), .sum -5000000000, "
					   ".key 18446744073709551615 (ffffffffffffffff), .level 200 (c8), ";
	char expected[TS_TOLD_TEXT];
	hand_record r = record;
	const u32 xy[2] = {1, 2};
	for (u32 twice = 0; twice < 2; twice++) add_line(&one, &hand_c, xy);
	for (u32 twice = 0; twice < 2; twice++) add_line(&one, &hand_r, &r);
	r.on = false;
	r.to = NULL;
	for (u32 twice = 0; twice < 2; twice++) add_line(&one, &hand_r, &r);
	add_line(&one, &hand_r, &record);
	for (size_t i = 0; i < 2; i++) reads(&one, i, NULL, "c = .x 1 (1), .y 2 (2)");
	snprintf(expected, sizeof expected, "%s.on yes, .to points.key:3", head);
	reads(&one, 2, NULL, expected);
	reads(&one, 3, NULL, "r as in line 3");
	snprintf(expected, sizeof expected, "%s.on no", head);
	reads(&one, 4, NULL, expected);
	reads(&one, 5, NULL, "r as in line 5");
	reads(&one, 6, NULL, "r as in line 3");
	char text[TS_TOLD_TEXT];
	ts_explain_full_text(text, &one, 3, NULL, 0);
	snprintf(expected, sizeof expected, "%s.on yes, .to points.key:3", head);
	assert_string_equal(text, expected);
}

/* More numbers than a text can hold: as many as fit with room for one more. */
static void an_endless_value_is_cut(void **state)
{
	(void)state;
	enum { MANY = 1000 };
	static u32 numbers[MANY];
	static ts_told_leaf leaves[MANY];
	for (u32 i = 0; i < MANY; i++) leaves[i] = (ts_told_leaf){".name", 4 * i, TS_TOLD_u32};
	const ts_told_type many = {"ts_many", sizeof numbers, MANY, leaves};
	const ts_told_site site = {TS_TOLD_VALUE, "points/hand.h", 30, false, "many", &many};
	add_line(&one, &site, numbers);
	char text[TS_TOLD_TEXT];
	ts_explain_text(text, &one, 0, NULL);
	size_t n = strlen(text), entry = strlen(" .name 0 (0),");
	assert_true(n >= TS_TOLD_TEXT - 2 * TS_VALUE_TEXT && n < TS_TOLD_TEXT - 2 * TS_VALUE_TEXT + entry);
	assert_string_equal(text + n - 6, " 0 (0)");
}

/* A thousand lines back, and no farther. */
static void a_thousand_lines_back_is_far_enough(void **state)
{
	(void)state;
	const u32 n = 0;
	add_line(&one, &hand_r, &record);
	for (u32 i = 1; i < 1000; i++) add_line(&one, &hand_n, &n);
	add_line(&one, &hand_r, &record);
	reads(&one, 1000, NULL, "r as in line 1");
	one.telling.n_lines = 1000;
	add_line(&one, &hand_n, &n);
	add_line(&one, &hand_r, &record);
	char text[TS_TOLD_TEXT];
	ts_explain_text(text, &one, 1001, NULL);
	assert_non_null(strstr(text, "r = .length 1.5 "));
}

/* Two lines of the same place: what differs, by either's values, also of what was told before. */
static void lines_beside_each_other_tell_what_differs(void **state)
{
	(void)state;
	hand_record r = record;
	size_t number;
	add_line(&one, &hand_r, &record);
	add_line(&two, &hand_r, &record);
	add_line(&one, &hand_r, &record);
	r.step = 8;
	r.on = false;
	add_line(&two, &hand_r, &r);
	assert_true(ts_explain_is_beside(&one, &two, 0) && ts_explain_is_same(&one, &two, 0));
	assert_true(ts_explain_is_beside(&one, &two, 1) && !ts_explain_is_same(&one, &two, 1));
	reads(&one, 0, &two, "r =");
	reads(&one, 1, &two, "r = .step -7, .on yes");
	reads(&two, 1, &one, "r = .step 8, .on no");
	assert_true(ts_explain_differ(&number, &one, &two) && number == 1);
	char text[TS_TOLD_TEXT];
	ts_explain_full_text(text, &two, 1, &one, 0);
	assert_string_equal(text, "r = .step 8, .on no");
}

/* Lines differ that only one has, or that stand elsewhere or deeper; a decision by its outcome. */
static void lines_that_only_one_has_differ(void **state)
{
	(void)state;
	size_t number;
	const u32 n = 1;
	assert_false(ts_explain_differ(&number, &one, &two));
	add_line(&one, &hand_n, &n);
	for (u32 swapped = 0; swapped < 2; swapped++) {
		assert_true(ts_explain_differ(&number, swapped ? &two : &one, swapped ? &one : &two) && number == 0);
		assert_false(ts_explain_is_beside(swapped ? &two : &one, swapped ? &one : &two, 0));
	}
	add_line(&two, &hand_n, &n);
	assert_false(ts_explain_differ(&number, &one, &two));
	assert_int_equal(number, 1);
	add_line(&one, &hand_n, &n);
	two.telling.depth = 1;
	add_line(&two, &hand_n, &n);
	assert_true(!ts_explain_is_beside(&one, &two, 1) && !ts_explain_is_same(&one, &two, 1));
	two.telling.depth = 0;
	two.telling.n_lines = 1;
	add_line(&two, &hand_result, &n);
	assert_true(!ts_explain_is_beside(&one, &two, 1) && !ts_explain_is_same(&one, &two, 1));
	one.telling.n_lines = two.telling.n_lines = 1;
	for (u32 k = 0; k < 2; k++) {
		ts_told_to(k == 0 ? &one.telling : &two.telling);
		ts_told_test(&hand_test, k == 0);
	}
	assert_true(ts_explain_is_beside(&one, &two, 1) && !ts_explain_is_same(&one, &two, 1));
}

/* What an item tells: a parameter, then two paragraphs, of which the first calls a function without and the second one
 * with a title. */
static void tell_paragraphs(ts_explanation *e, u32 given, u32 bound, u32 found, bool yes)
{
	ts_told_to(&e->telling);
	e->telling.n_lines = 0;
	ts_told_call(&hand_item);
	hand_tell(&hand_n, given);
	ts_told_title(&hand_bound);
	ts_told_call(&hand_helper);
	hand_tell(&hand_n, given);
	hand_tell(&hand_to, bound);
	ts_told_end();
	ts_told_title(&hand_offer);
	ts_told_call(&hand_helper);
	ts_told_title(&hand_find);
	hand_tell(&hand_width, found);
	ts_told_end();
	ts_told_test(&hand_test, yes);
	ts_told_end();
}

static void parts_in(const char *title)
{
	const ts_told_site *site = ts_explain_parting(&one, &two);
	assert_int_equal(site != NULL, title != NULL);
	if (site != NULL) assert_string_equal(site->text, title);
}

/* Two part in the first paragraph that leaves something else or decides otherwise, whatever they were given. */
static void the_paragraph_that_two_part_in_is_named(void **state)
{
	(void)state;
	tell_paragraphs(&one, 1, 2, 3, true);
	tell_paragraphs(&two, 1, 2, 3, true);
	parts_in(NULL);
	tell_paragraphs(&two, 7, 2, 3, true);
	parts_in(NULL);
	tell_paragraphs(&two, 7, 8, 3, false);
	parts_in("Bound it.");
	tell_paragraphs(&two, 7, 2, 8, false);
	parts_in("Find it.");
	tell_paragraphs(&two, 7, 2, 3, false);
	parts_in("Offer it.");
}

/* Where one ends or goes on elsewhere, they part in the paragraph that has the line. */
static void ways_part_in_the_paragraph_of_the_line(void **state)
{
	(void)state;
	tell_paragraphs(&one, 1, 2, 3, true);
	tell_paragraphs(&two, 1, 2, 3, true);
	two.telling.n_lines -= 2;
	parts_in("Find it.");
	two.telling.n_lines -= 2;
	parts_in("Offer it.");
	one.telling.lines[6].site = &hand_find;
	parts_in("Bound it.");
	one.telling.n_lines = two.telling.n_lines = 1;
	parts_in(NULL);
	two.telling.n_lines = 2;
	parts_in(NULL);
}

#define listening_test(f) cmocka_unit_test_setup_teardown(f, begin, end)

int main(void)
{
	const struct CMUnitTest tests[] = {
		listening_test(each_kind_of_number_has_its_words),
		listening_test(pointers_name_the_element_they_are_in),
		listening_test(each_kind_of_line_has_its_words),
		listening_test(long_values_say_where_they_were_told),
		listening_test(an_endless_value_is_cut),
		listening_test(a_thousand_lines_back_is_far_enough),
		listening_test(lines_beside_each_other_tell_what_differs),
		listening_test(lines_that_only_one_has_differ),
		listening_test(the_paragraph_that_two_part_in_is_named),
		listening_test(ways_part_in_the_paragraph_of_the_line),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
