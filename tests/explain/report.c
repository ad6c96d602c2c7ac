/* Explanations as lines and as JSON, of what was told by hand: every line, its number, its depth and its mark; every
 * kind of number; and no answer at all where memory ends. */
#include "explain/explain.h"
#include "tests/explain/hand.h"
#include "trace/read.h"

static ts_explanation one, two;
static ts_explained_launch launches[2][2];
static ts_trace *traces[2];
static ts_question question;
static ts_told_what what;

static const hand_record record = {.length = -2,
                                   .step = -7,
                                   .flags = 0x80000000u,
                                   .sum = -5000000000,
                                   .key = 0xabcdef0123456789u,
                                   .level = 200,
                                   .on = true,
                                   .to = &hand_keys[3]};

/* Two launches, of which the second has item 4: seven lines. */
static void add_line(ts_explanation *e, u32 which, u32 n, const hand_record *r)
{
	hand_begin(e);
	e->launch = launches[which];
	e->n_launches = 2;
	launches[which][0] = (ts_explained_launch){.kernel = TS_KERNEL_split_count, .n = 3, .item = 3};
	launches[which][1] = (ts_explained_launch){.kernel = TS_KERNEL_split, .n = 6, .item = 4, .n_lines = 7};
	ts_told_call(&hand_item);
	hand_tell(&hand_n, n);
	ts_told_test(&hand_test, n > 3);
	ts_told(&hand_store, &hand_keys[1]);
	ts_told(&hand_count, &hand_load.run.frame.tally[0]);
	ts_told(&hand_r, r);
	hand_tell(&hand_result, 2);
	ts_told_end();
}

static int begin(void **state)
{
	(void)state;
	add_line(&one, 0, 7, &record);
	add_line(&two, 1, 7, &record);
	for (u32 i = 0; i < 2; i++) {
		traces[i] = ts_trace_new(i == 0 ? "a/trace" : "b/trace");
		assert_non_null(traces[i]);
		traces[i]->pipeline = ts_pipeline_find("reflections", "epr");
	}
	question = (ts_question){.subject = TS_EXPLAIN_ITEM, .kernel = TS_N_KERNELS, .item = 4};
	what = (ts_told_what){
		.stage = ts_stage_find("split"), .question = &question, .trace = traces[0], .a = &one, .b = NULL};
	return 0;
}

static int end(void **state)
{
	(void)state;
	for (u32 i = 0; i < 2; i++) ts_trace_close(traces[i]);
	hand_end(&one);
	hand_end(&two);
	return 0;
}

static void beside(void)
{
	what.other = traces[1];
	what.b = &two;
}

/* All lines, as many as are expected. */
static void prints(const char *const *expected, size_t n)
{
	json_t *lines = ts_explain_lines(&what);
	for (size_t i = 0; i < n && i < json_array_size(lines); i++) {
		assert_string_equal(json_string_value(json_array_get(lines, i)), expected[i]);
	}
	assert_int_equal(json_array_size(lines), n);
	json_decref(lines);
}
#define PRINTS(...) \
	do { \
		static const char *const lines_of[] = {__VA_ARGS__}; \
		prints(lines_of, sizeof lines_of / sizeof *lines_of); \
	} while (0)

#define HEAD "stage 07 split of a/trace"
#define LAUNCH "launch 2 of 2, kernel split, item 4 of 6 items"
#define CALL "     1 points/hand.h:10              ts_k_hand_item()"
#define NUMBER(mark, n) mark "    2 points/hand.h:11                n = " n
#define TEST "     3 points/hand.h:12                n > 3? yes"
#define STORE "     4 points/hand.h:16                at[i], points.key:1 = 11 (b)"
#define COUNT "     5 points/hand.h:17                *n_writes, a counter"
#define LONG(mark) mark "    6 points/hand.h:14                r = "
#define RECORD \
	LONG(" ") \
	".length -2 (c0000000), .step -7, .flags 2147483648 (80000000), .sum -5000000000, " \
	".key 12379813738877118345 (abcdef0123456789), .level 200 (c8), .on yes, .to points.key:3"
#define RESULT(mark) mark "    7 points/hand.h:18                return 2 (2)"
#define NOWHERE "they part in: no paragraph with a title"
#define MIDDLE TEST, STORE, COUNT
#define ALL CALL, NUMBER(" ", "7 (7)"), MIDDLE, RECORD, RESULT(" ")

static void one_explanation_is_printed_line_by_line(void **state)
{
	(void)state;
	PRINTS(HEAD, LAUNCH, ALL);
	question = (ts_question){.subject = TS_EXPLAIN_ELEMENT, .buffer = TS_B_points_key, .element = 1};
	one.telling.stores = 3;
	one.telling.n_more = 12;
	PRINTS(HEAD, "line 4 stores points.key:1", LAUNCH, ALL, "12 more lines; a larger number of lines keeps them");
}

/* Nothing was asked about: all launches. */
static void without_an_item_launches_are_listed(void **state)
{
	(void)state;
	question.subject = TS_EXPLAIN_LAUNCHES;
	one.telling.n_lines = launches[0][1].n_lines = 0;
	launches[0][1].item = 6;
	PRINTS(HEAD, "launch 1 of 2, kernel split_count of 3 items", "launch 2 of 2, kernel split of 6 items");
}

/* The same in both: once. What differs: the first such line on top, and each in its place by either. */
static void lines_the_same_in_both_stand_once(void **state)
{
	(void)state;
	beside();
	PRINTS(HEAD, "the same lines in b/trace", ALL);
	hand_record other = record;
	other.step = 9;
	hand_end(&two);
	add_line(&two, 1, 8, &other);
	PRINTS(HEAD, "< is a/trace, > is b/trace; the first line that differs is", NUMBER("<", "7 (7)"),
	       NUMBER(">", "8 (8)"), NOWHERE, CALL, NUMBER("<", "7 (7)"), NUMBER(">", "8 (8)"), MIDDLE,
	       LONG("<") ".step -7", LONG(">") ".step 9", RESULT(" "));
}

/* Where one ends, or goes on elsewhere, all lines from there on are of one side. */
static void ways_that_part_stay_on_one_side(void **state)
{
	(void)state;
	beside();
	two.telling.n_lines = 6;
	PRINTS(HEAD, "< is a/trace, > is b/trace; the first line that differs is", RESULT("<"), NOWHERE, CALL,
	       NUMBER(" ", "7 (7)"), MIDDLE, RECORD, "from here on they go different ways:", RESULT("<"));
}

/* Two launches, of which the second has an item of one paragraph, that runs `runs` times and leaves a width and stores,
 * and of another, if `more`. */
static void add_paragraphs(ts_explanation *e, u32 which, u32 width, u32 runs, bool more)
{
	hand_end(e);
	hand_begin(e);
	e->launch = launches[which];
	e->n_launches = 2;
	ts_told_call(&hand_item);
	for (u32 i = 0; i < runs; i++) {
		ts_told_title(&hand_bound);
		hand_tell(&hand_n, i);
		hand_tell(&hand_width, width);
		ts_told(&hand_store, &hand_keys[i]);
		ts_told_call(&hand_helper);
		ts_told_title(more ? &hand_find : &hand_offer);
		hand_tell(&hand_to, i);
		ts_told_end();
	}
	ts_told_end();
	launches[which][1].n_lines = e->telling.n_lines;
}
#define TITLE(mark, n, line, space, title) mark "    " n " points/hand.h:" line "              " space "-- " title
#define TO(mark, n, value) mark n " points/hand.h:26                  to->height = " value
#define WIDTH(mark, n, value) mark "    " n " points/hand.h:24                width = " value

static void an_outline_has_titles_and_what_is_left(void **state)
{
	(void)state;
	what.outline = true;
	add_paragraphs(&one, 0, 8, 1, true);
	PRINTS(HEAD, LAUNCH, TITLE(" ", "2", "21", "", "Bound it."), WIDTH(" ", "4", "8 (8)"),
	       "     5 points/hand.h:16                at[i], points.key:0 = 10 (a)",
	       TITLE(" ", "7", "23", "  ", "Find it."), TO(" ", "    8", "0 (0)"));
	add_paragraphs(&one, 0, 8, 2, true);
	one.telling.n_more = 2;
	PRINTS(HEAD, LAUNCH, TITLE(" ", "9", "21", "", "Bound it. (2 times)"),
	       "    11 points/hand.h:24                width = 8 (8)",
	       "    12 points/hand.h:16                at[i], points.key:1 = 11 (b), the last of 2",
	       "    14 points/hand.h:23                -- Find it. (2 times)", TO(" ", "   15", "1 (1)"),
	       "2 more lines; a larger number of lines keeps them");
}

/* The same once; what differs from either side, and titles that one has alone. */
static void outlines_stand_beside_each_other(void **state)
{
	(void)state;
	what.outline = true;
	beside();
	add_paragraphs(&one, 0, 8, 1, true);
	add_paragraphs(&two, 1, 8, 1, true);
	PRINTS(HEAD, "the same lines in b/trace", LAUNCH, TITLE(" ", "2", "21", "", "Bound it."), WIDTH(" ", "4", "8 (8)"),
	       "     5 points/hand.h:16                at[i], points.key:0 = 10 (a)",
	       TITLE(" ", "7", "23", "  ", "Find it."), TO(" ", "    8", "0 (0)"));
	add_paragraphs(&two, 1, 9, 1, false);
	PRINTS(HEAD, "< is a/trace, > is b/trace; the first line that differs is", WIDTH("<", "4", "8 (8)"),
	       WIDTH(">", "4", "9 (9)"), "they part in: Bound it.", LAUNCH, TITLE(" ", "2", "21", "", "Bound it."),
	       WIDTH("<", "4", "8 (8)"), WIDTH(">", "4", "9 (9)"),
	       "     5 points/hand.h:16                at[i], points.key:0 = 10 (a)",
	       TITLE("<", "7", "23", "  ", "Find it."), TO("<", "    8", "0 (0)"), TITLE(">", "7", "22", "  ", "Offer it."),
	       TO(">", "    8", "0 (0)"));
}

/* Twins that stand for other numbers of lines say both, though the last values are the same. */
static void other_numbers_of_lines_differ(void **state)
{
	(void)state;
	what.outline = true;
	beside();
	hand_keys[1] = hand_keys[0];
	add_paragraphs(&one, 0, 8, 1, true);
	add_paragraphs(&two, 1, 8, 2, true);
	hand_keys[1] = 11;
	json_t *lines = ts_explain_lines(&what);
	static const char *const expected[] = {
		TITLE("<", "2", "21", "", "Bound it."),
		TITLE(">", "9", "21", "", "Bound it. (2 times)"),
		WIDTH(" ", "4", "8 (8)"),
		"<    5 points/hand.h:16                at[i], points.key:0 = 10 (a)",
		">   12 points/hand.h:16                at[i], points.key:1 = 10 (a), the last of 2",
		TITLE("<", "7", "23", "  ", "Find it."),
		">   14 points/hand.h:23                -- Find it. (2 times)",
		TO("<", "    8", "0 (0)"),
		TO(">", "   15", "1 (1)"),
	};
	size_t n = sizeof expected / sizeof *expected, first = json_array_size(lines) - n;
	for (size_t i = 0; i < n; i++) {
		assert_string_equal(json_string_value(json_array_get(lines, first + i)), expected[i]);
	}
	json_decref(lines);
}

static json_t *line_of(const json_t *list, size_t launch, size_t number)
{
	return json_array_get(json_object_get(json_array_get(list, launch), "lines"), number);
}

/* The JSON of a part, keys in their order. */
static void holds(const json_t *part, const char *expected)
{
	char *text = json_dumps(part, JSON_COMPACT | JSON_ENCODE_ANY | JSON_SORT_KEYS);
	assert_string_equal(text, expected);
	free(text);
}

static void json_has_every_line(void **state)
{
	(void)state;
	static const char *const lines[] = {
		"{'depth':0,'file':'points/hand.h','how':'call','line':10,'text':'ts_k_hand_item'}",
		"{'depth':1,'file':'points/hand.h','how':'value','line':11,'text':'n','type':'u32','value':{'':7}}",
		"{'depth':1,'file':'points/hand.h','how':'test','line':12,'text':'n > 3','value':true}",
		"{'depth':1,'file':'points/hand.h','how':'store','line':16,'text':'at[i]','to':'points.key:1','type':'u64',"
		"'value':{'':'000000000000000b'}}",
		"{'depth':1,'file':'points/hand.h','how':'store','line':17,'text':'*n_writes','to':'a counter'}",
		"{'depth':1,'file':'points/hand.h','how':'value','line':14,'text':'r','type':'hand_record','value':{"
		"'.flags':2147483648,'.key':'abcdef0123456789','.length':{'bits':'c0000000','value':-2.0},'.level':200,"
		"'.on':true,'.step':-7,'.sum':-5000000000,'.to':'points.key:3'}}",
		"{'depth':1,'file':'points/hand.h','how':'result','line':18,'text':'return','type':'u32','value':{'':2}}",
	};
	json_t *root = ts_explain_json(&what), *list = json_object_get(root, "launches");
	assert_int_equal(json_array_size(json_object_get(json_array_get(list, 1), "lines")), 7);
	for (size_t i = 0; i < 7; i++) {
		char expected[512];
		snprintf(expected, sizeof expected, "%s", lines[i]);
		for (char *c = expected; *c != 0; c++) *c = *c == '\'' ? '"' : *c;
		holds(line_of(list, 1, i), expected);
	}
	holds(json_array_get(list, 0), "{\"item\":null,\"items\":3,\"kernel\":\"split_count\",\"lines\":[]}");
	json_object_del(json_array_get(list, 1), "lines");
	holds(json_array_get(list, 1), "{\"item\":4,\"items\":6,\"kernel\":\"split\"}");
	json_object_del(root, "launches");
	holds(root, "{\"inputs\":null,\"more_lines\":0,\"other\":null,\"stage\":\"split\",\"trace\":\"a/trace\"}");
	json_decref(root);
}

/* What floats are no number, and what is false. */
static void no_number_is_null_in_json(void **state)
{
	(void)state;
	static const u32 bits[] = {0x7f800000u, 0xff800000u, 0x7fc00000u, 0x7f7fffffu, 0};
	for (u32 i = 0; i < sizeof bits / sizeof *bits; i++) {
		char word[16];
		hand_record r = {.length = ts_u2f(bits[i]), .step = INT32_MIN, .sum = INT64_MAX};
		hand_end(&one);
		add_line(&one, 0, 2, &r);
		json_t *root = ts_explain_json(&what), *list = json_object_get(root, "launches");
		const json_t *value = json_object_get(line_of(list, 1, 5), "value"),
					 *length = json_object_get(value, ".length");
		const json_t *number = json_object_get(length, "value");
		snprintf(word, sizeof word, "%08x", (unsigned)bits[i]);
		assert_string_equal(json_string_value(json_object_get(length, "bits")), word);
		assert_int_equal(json_is_null(number), i < 3);
		if (i >= 3) assert_true(ts_f2u((f32)json_real_value(number)) == bits[i]);
		assert_true(json_is_false(json_object_get(value, ".on")) &&
		            json_is_false(json_object_get(line_of(list, 1, 2), "value")));
		assert_int_equal(json_integer_value(json_object_get(value, ".step")), INT32_MIN);
		assert_int_equal(json_integer_value(json_object_get(value, ".sum")), INT64_MAX);
		assert_string_equal(json_string_value(json_object_get(value, ".to")), "NULL");
		json_decref(root);
	}
}

/* The first line that differs, of both; of a side that has none, nothing. */
static void the_first_difference_has_both_sides(void **state)
{
	(void)state;
	beside();
	question.subject = TS_EXPLAIN_ELEMENT;
	one.telling.stores = 3;
	one.telling.n_more = 5;
	two.telling.n_more = 6;
	json_t *root = ts_explain_json(&what);
	assert_true(json_is_null(json_object_get(root, "first_difference")));
	assert_int_equal(json_integer_value(json_object_get(root, "stores")), 4);
	assert_int_equal(json_integer_value(json_object_get(root, "more_lines")), 11);
	assert_true(json_equal(json_object_get(root, "launches"), json_object_get(root, "other_launches")));
	json_decref(root);
	for (u32 k = 0; k < 2; k++) {
		one.telling.n_lines = k == 0 ? 6 : 7;
		two.telling.n_lines = k == 0 ? 7 : 6;
		root = ts_explain_json(&what);
		const json_t *first = json_object_get(root, "first_difference");
		assert_int_equal(json_integer_value(json_object_get(first, "line")), 7);
		assert_true(json_is_null(json_object_get(first, "title")));
		assert_true(json_is_null(json_object_get(first, k == 0 ? "trace" : "other")));
		assert_string_equal(
			json_string_value(json_object_get(json_object_get(first, k == 0 ? "other" : "trace"), "text")), "return");
		json_decref(root);
	}
}

/* Of an outline the numbers of its lines, and how many they stand for; of two the paragraph in which they part. */
static void json_outlines_have_numbers_and_times(void **state)
{
	(void)state;
	what.outline = true;
	beside();
	add_paragraphs(&one, 0, 8, 2, true);
	add_paragraphs(&two, 1, 9, 2, true);
	json_t *root = ts_explain_json(&what);
	for (u32 other = 0; other < 2; other++) {
		const json_t *list = json_object_get(root, other ? "other_launches" : "launches");
		static const struct {
			const char *how, *text;
			int number;
		} lines[] = {{"title", "Bound it.", 9},
		             {"value", "width", 11},
		             {"store", "at[i]", 12},
		             {"title", "Find it.", 14},
		             {"value", "to->height", 15}};
		assert_int_equal(json_array_size(json_object_get(json_array_get(list, 0), "lines")), 0);
		assert_int_equal(json_array_size(json_object_get(json_array_get(list, 1), "lines")), 5);
		for (size_t i = 0; i < 5; i++) {
			const json_t *line = line_of(list, 1, i);
			assert_string_equal(json_string_value(json_object_get(line, "how")), lines[i].how);
			assert_string_equal(json_string_value(json_object_get(line, "text")), lines[i].text);
			assert_int_equal(json_integer_value(json_object_get(line, "number")), lines[i].number);
			assert_int_equal(json_integer_value(json_object_get(line, "times")), 2);
		}
		holds(json_object_get(line_of(list, 1, 1), "value"), other ? "{\"\":9}" : "{\"\":8}");
	}
	holds(json_object_get(json_object_get(root, "first_difference"), "title"), "\"Bound it.\"");
	json_decref(root);
}

static size_t turn, missing, n_held;

static void *scarce(size_t bytes)
{
	if (turn++ == missing) return NULL;
	n_held++;
	return malloc(bytes);
}

static void release(void *memory)
{
	n_held -= memory != NULL;
	free(memory);
}

/* Without any one of the pieces of memory that an answer takes it is there as a whole or not at all, and nothing is
 * kept. Returns without how many it was not there. */
static size_t starve(json_t *make(const ts_told_what *what))
{
	turn = n_held = 0;
	missing = SIZE_MAX;
	json_t *all = make(&what);
	size_t pieces = turn, held = n_held, n_none = 0;
	for (size_t piece = 0; piece < pieces; piece++) {
		turn = 0;
		missing = piece;
		json_t *some = make(&what);
		missing = SIZE_MAX;
		n_none += some == NULL;
		if (some != NULL && !json_equal(some, all))
			fail_msg("without piece %zu of %zu a part is missing", piece, pieces);
		json_decref(some);
		if (n_held != held) fail_msg("without piece %zu %zu others are kept", piece, n_held - held);
	}
	json_decref(all);
	return n_none;
}

static void without_memory_there_is_no_answer(void **state)
{
	(void)state;
	json_malloc_t usual;
	json_free_t usual_free;
	json_get_alloc_funcs(&usual, &usual_free);
	beside();
	two.telling.n_lines = 6;
	question.subject = TS_EXPLAIN_ELEMENT;
	json_set_alloc_funcs(scarce, release);
	size_t lines = starve(ts_explain_lines), objects = starve(ts_explain_json);
	what.outline = true;
	add_paragraphs(&one, 0, 8, 2, true);
	add_paragraphs(&two, 1, 9, 1, false);
	size_t of_outline = starve(ts_explain_lines), in_outline = starve(ts_explain_json);
	json_set_alloc_funcs(usual, usual_free);
	assert_true(lines > 0 && objects > 100 && of_outline > 0 && in_outline > 100);
}

#define told_test(f) cmocka_unit_test_setup_teardown(f, begin, end)

int main(void)
{
	const struct CMUnitTest tests[] = {
		told_test(one_explanation_is_printed_line_by_line),
		told_test(without_an_item_launches_are_listed),
		told_test(lines_the_same_in_both_stand_once),
		told_test(ways_that_part_stay_on_one_side),
		told_test(an_outline_has_titles_and_what_is_left),
		told_test(outlines_stand_beside_each_other),
		told_test(other_numbers_of_lines_differ),
		told_test(json_has_every_line),
		told_test(no_number_is_null_in_json),
		told_test(the_first_difference_has_both_sides),
		told_test(json_outlines_have_numbers_and_times),
		told_test(without_memory_there_is_no_answer),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
