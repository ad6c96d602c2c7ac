/* Outlines of what was told by hand: titles once, the last value of each name, and what was called under its caller. */
#include "explain/outline.h"
#include "tests/explain/hand.h"

static ts_explanation told;
static ts_explained_launch launches[2];
static ts_outline outline;

static int begin(void **state)
{
	(void)state;
	hand_begin(&told);
	told.launch = launches;
	told.n_launches = 1;
	outline = (ts_outline){.n = 0};
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_outline_end(&outline);
	assert_true(outline.n == 0 && outline.entry == NULL);
	hand_end(&told);
	return 0;
}

/* Of one launch with all lines. */
static void outlined(void)
{
	launches[0] = (ts_explained_launch){.kernel = TS_KERNEL_split, .n = 1, .n_lines = told.telling.n_lines};
	assert_int_equal(ts_outline_make(&outline, &told), TS_OK);
}

/* What stands under an entry, values before titles: "(NUMBER TIMES TEXT ...)" each, with what stands under it. */
static void show(char *text, size_t size, size_t launch, size_t under)
{
	for (u32 titles = 0; titles < 2; titles++) {
		size_t i = ts_outline_next(&outline, launch, under, titles, TS_OUTLINE_ROOT);
		for (; i != TS_OUTLINE_NONE; i = ts_outline_next(&outline, launch, under, titles, i)) {
			const ts_outlined *entry = &outline.entry[i];
			size_t used = strlen(text);
			snprintf(text + used, size - used, "(%u %u %s", (unsigned)entry->number, (unsigned)entry->times,
			         ts_outline_line(&outline, i)->site->text);
			assert_int_equal(ts_outline_is_title(&outline, i), titles);
			show(text, size, launch, i);
			strncat(text, ")", size - strlen(text) - 1);
		}
	}
}

static void is(size_t launch, const char *expected)
{
	char text[512] = "";
	show(text, sizeof text, launch, TS_OUTLINE_ROOT);
	assert_string_equal(text, expected);
}

/* Two runs of a paragraph are one; a value's name counts, not its place in the text. */
static void the_last_value_of_each_name_stands_under_its_title(void **state)
{
	(void)state;
	ts_told_call(&hand_item);
	hand_tell(&hand_width, 1);
	ts_told_title(&hand_bound);
	hand_tell(&hand_width, 2);
	hand_tell(&hand_to, 3);
	ts_told_title(&hand_offer);
	hand_tell(&hand_width, 4);
	ts_told_title(&hand_bound);
	hand_tell(&hand_width_again, 5);
	ts_told_end();
	outlined();
	is(0, "(7 2 Bound it.(8 2 width)(4 1 to->height))(5 1 Offer it.(6 1 width))");
}

/* Stores, results of functions with titles, and values that are left; no call, no decision, no counter. */
static void only_what_is_left_has_a_line(void **state)
{
	(void)state;
	ts_told_call(&hand_item);
	ts_told_title(&hand_bound);
	hand_tell(&hand_n, 1);
	assert_true(ts_told_test(&hand_test, true));
	ts_told(&hand_store, &hand_keys[1]);
	ts_told(&hand_count, &hand_load.run.frame.tally[0]);
	ts_told_call(&hand_helper);
	hand_tell(&hand_result, 2);
	ts_told_end();
	hand_tell(&hand_result, 3);
	ts_told_end();
	outlined();
	is(0, "(1 1 Bound it.(4 1 at[i])(8 1 return))");
}

/* A function without titles leaves what it does to its caller's paragraph; one with titles has its own under it, but
 * for what it does before the first. */
static void what_is_called_stands_under_its_caller(void **state)
{
	(void)state;
	ts_told_call(&hand_item);
	ts_told_title(&hand_bound);
	for (u32 twice = 0; twice < 2; twice++) {
		ts_told_call(&hand_helper);
		hand_tell(&hand_to, 1);
		ts_told_title(&hand_find);
		hand_tell(&hand_to, 2);
		ts_told_end();
		ts_told_call(&hand_helper);
		ts_told(&hand_store, &hand_keys[twice]);
		ts_told_end();
	}
	hand_tell(&hand_width, 3);
	ts_told_title(&hand_offer);
	ts_told_call(&hand_helper);
	ts_told_title(&hand_find);
	ts_told_end();
	ts_told_end();
	outlined();
	is(0, "(1 1 Bound it.(9 2 to->height)(13 2 at[i])(14 1 width)(10 2 Find it.(11 2 to->height)))"
	      "(15 1 Offer it.(17 1 Find it.))");
}

static void without_titles_only_stores_are_left(void **state)
{
	(void)state;
	ts_told_call(&hand_item);
	hand_tell(&hand_width, 1);
	ts_told(&hand_store, &hand_keys[1]);
	ts_told_end();
	outlined();
	is(0, "(2 1 at[i])");
}

static void each_launch_has_an_outline_of_its_own(void **state)
{
	(void)state;
	for (u32 twice = 0; twice < 2; twice++) {
		ts_told_call(&hand_item);
		ts_told_title(&hand_bound);
		hand_tell(&hand_width, twice);
		ts_told_end();
	}
	told.n_launches = 2;
	launches[0] = (ts_explained_launch){.kernel = TS_KERNEL_split_count, .n = 1, .n_lines = 3};
	launches[1] = (ts_explained_launch){.kernel = TS_KERNEL_split, .n = 1, .first_line = 3, .n_lines = 3};
	assert_int_equal(ts_outline_make(&outline, &told), TS_OK);
	is(0, "(1 1 Bound it.(2 1 width))");
	is(1, "(4 1 Bound it.(5 1 width))");
	const ts_told_line *line = &told.telling.lines[2];
	size_t title = ts_outline_find(&outline, 1, TS_OUTLINE_ROOT, &told.telling.lines[1]);
	assert_true(outline.entry[title].number == 4);
	assert_true(outline.entry[ts_outline_find(&outline, 1, title, line)].number == 5);
	assert_true(ts_outline_find(&outline, 0, title, line) == TS_OUTLINE_NONE);
	assert_true(ts_outline_find(&outline, 1, TS_OUTLINE_ROOT, line) == TS_OUTLINE_NONE);
	assert_true(ts_outline_find(&outline, 1, TS_OUTLINE_NONE, line) == TS_OUTLINE_NONE);
}

#define told_test(f) cmocka_unit_test_setup_teardown(f, begin, end)

int main(void)
{
	const struct CMUnitTest tests[] = {
		told_test(the_last_value_of_each_name_stands_under_its_title),
		told_test(only_what_is_left_has_a_line),
		told_test(what_is_called_stands_under_its_caller),
		told_test(without_titles_only_stores_are_left),
		told_test(each_launch_has_an_outline_of_its_own),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
