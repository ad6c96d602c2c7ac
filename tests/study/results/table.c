/* Tables: as text they are aligned and at most 120 columns wide, as JSON they have a row an object; and lines that only
 * some want. */
#include <math.h>
#include "study/results/table.h"
#include "tests/lcg.h"
#include "tests/model/said.h"
#include "tests/model/test.h"

enum { LINE = 120 };

static char *printed(const ts_table *table)
{
	char *text;
	size_t bytes;
	FILE *out = open_memstream(&text, &bytes);
	assert_non_null(out);
	ts_table_print(table, out);
	fclose(out);
	return text;
}

static void assert_prints(ts_table *table, const char *right)
{
	char *text = printed(table);
	assert_string_equal(text, right);
	free(text);
	ts_table_end(table);
}

static void columns_are_aligned(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "name", false}, {"b", "figure", true}, {0}};
	ts_table table = ts_table_begin("key", "A title", columns);
	ts_table_text(&table, "one");
	ts_table_count(&table, 1234567);
	ts_table_text(&table, "another");
	ts_table_real(&table, 0.125, 2);
	ts_table_text(&table, "");
	ts_table_none(&table);
	assert_prints(&table,
	              "\nA title\nname        figure\none      1,234,567\nanother       0.12\n                 -\n");
}

/* A table of one text as wide as the line is printed in one line, and one that is wider on two. */
static void a_text_as_wide_as_lines_fits(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "a", false}, {"b", "b", false}, {0}};
	for (u32 n = 100; n < 130; n++) {
		char long_text[200] = "";
		while (strlen(long_text) + 5 < n) strcat(long_text, "word ");
		memset(long_text + strlen(long_text), 'x', n - strlen(long_text));
		ts_table table = ts_table_begin("key", "", columns);
		ts_table_text(&table, "0123456789");
		ts_table_text(&table, long_text);
		char *text = printed(&table);
		u32 lines = 0;
		for (const char *at = text; *at != 0; lines++) {
			assert_true(strcspn(at, "\n") <= LINE);
			at += strcspn(at, "\n") + 1;
		}
		assert_int_equal(lines, 10 + 2 + n <= LINE ? 2 : 3);
		free(text);
		ts_table_end(&table);
	}
}

/* Wide tables of words keep every word, in order, within the line. */
static void wrapped_tables_keep_every_word(void **state)
{
	(void)state;
	static const ts_column columns[] = {
		{"a", "first", false}, {"b", "second", false}, {"c", "third", true}, {"d", "last", false}, {0}};
	u32 seed = 3;
	for (u32 round = 0; round < 50; round++) {
		ts_table table = ts_table_begin("key", "", columns);
		u32 n_words = 0, n_found = 0;
		for (u32 i = 0; i < 8; i++) {
			char cell[400] = "";
			for (u32 k = 0; k < 1 + (round + i) % 9; k++) {
				snprintf(cell + strlen(cell), 20, "%sw%0*u", k > 0 ? " " : "", 2 + (int)(lcg_next(&seed) >> 16) % 9,
				         (unsigned)n_words++);
			}
			ts_table_text(&table, cell);
		}
		char *text = printed(&table);
		for (const char *at = text; *at != 0; at += strcspn(at, "\n") + 1) assert_true(strcspn(at, "\n") <= LINE);
		for (char *word = strtok(text, " \n"); word != NULL; word = strtok(NULL, " \n")) n_found += word[0] == 'w';
		assert_int_equal(n_found, n_words);
		free(text);
		ts_table_end(&table);
	}
}

/* One row, n times the same cell under heads of one letter: no line is wider than a page, or ends with a blank. Returns
 * the width of the widest. */
static size_t widest_of(u32 n, const char *cell, bool right)
{
	ts_column columns[TS_MAX_COLUMNS + 1] = {{0}};
	for (u32 c = 0; c < n; c++) columns[c] = (ts_column){"key", "h", right};
	ts_table table = ts_table_begin("key", "", columns);
	for (u32 c = 0; c < n; c++) ts_table_text(&table, cell);
	char *text = printed(&table);
	size_t widest = 0;
	for (const char *at = text; *at != 0; at += strcspn(at, "\n") + 1) {
		size_t bytes = strcspn(at, "\n");
		assert_true(bytes <= LINE && (bytes == 0 || at[bytes - 1] != ' '));
		widest = bytes > widest ? bytes : widest;
	}
	free(text);
	ts_table_end(&table);
	return widest;
}

/* Nine columns of 13 characters are 133 wide: text is wrapped down to 12, figures to 10; text alone takes what is
 * left. */
static void narrow_columns_wrap_down_to_their_least(void **state)
{
	(void)state;
	widest_of(9, "aaaaaaa bbbbb", false);
	assert_int_equal(widest_of(9, "aaaaaaa bbbbb", true), 9 * 7 + 8 * 2);
	assert_int_equal(widest_of(8, "aaaaaaa bbbbb", true), 8 * 13 + 7 * 2);
	widest_of(3, "", true);
	widest_of(3, "", false);
}

/* A line may end behind a bar or an asterisk, as it may before a blank. */
static void a_line_may_end_behind_a_bar(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "a", false}, {0}};
	for (const char *mark = "|*"; *mark != 0; mark++) {
		char cell[400] = "";
		for (u32 i = 0; i < 200; i++) cell[i] = i % 7 == 6 ? *mark : 'x';
		ts_table table = ts_table_begin("key", "", columns);
		ts_table_text(&table, cell);
		char *text = printed(&table), *at = strchr(text, '\n') + 1;
		for (u32 found = 0; found < 200; at += strcspn(at, "\n") + 1) {
			size_t bytes = strcspn(at, "\n");
			found += (u32)bytes;
			assert_true(bytes > 0 && bytes <= LINE && (at[bytes - 1] == *mark || found == 200));
		}
		assert_int_equal(*at, 0);
		free(text);
		ts_table_end(&table);
	}
}

/* A head that is wider than its cells has its room. */
static void a_wide_head_has_its_room(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "wide head", false}, {"b", "b", false}, {0}};
	ts_table table = ts_table_begin("key", "", columns);
	ts_table_text(&table, "x");
	ts_table_text(&table, "y");
	assert_prints(&table, "wide head  b\nx          y\n");
}

static void a_row_is_said_in_a_line(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "first", false}, {"b", "second", true}, {0}};
	ts_table table = ts_table_begin("key", "", columns);
	for (u32 row = 1; row <= 2; row++) {
		ts_table_text(&table, row == 1 ? "one" : "two");
		ts_table_count(&table, row);
	}
	said_begin();
	ts_table_say(&table);
	assert_string_equal(said_end(), "a two, b 2\n");
	ts_table_end(&table);
}

static void assert_cell(void (*put)(ts_table *table, i64 value), i64 value, const char *text)
{
	static const ts_column columns[] = {{"a", "a", true}, {0}};
	ts_table table = ts_table_begin("key", "", columns);
	put(&table, value);
	assert_string_equal(table.cells[0].text, text);
	assert_int_equal(json_integer_value(table.cells[0].value), value);
	ts_table_end(&table);
}

static void put_bytes(ts_table *table, i64 value) { ts_table_bytes(table, (u64)value); }

static void cells_print_counts_and_bytes(void **state)
{
	(void)state;
	static const struct {
		i64 value;
		const char *count, *bytes;
	} right[] = {{0, "0", "0 B"},
	             {999, "999", "999 B"},
	             {1000, "1,000", "1.00 kB"},
	             {12345, "12,345", "12.35 kB"},
	             {999994, "999,994", "999.99 kB"},
	             {999996, "999,996", "1.00 MB"},
	             {1234567890, "1,234,567,890", "1.23 GB"},
	             {5000000000000000, "5,000,000,000,000,000", "5000.00 TB"}};
	for (u32 i = 0; i < sizeof right / sizeof *right; i++) {
		assert_cell(ts_table_count, right[i].value, right[i].count);
		assert_cell(put_bytes, right[i].value, right[i].bytes);
	}
	assert_cell(ts_table_count, -1, "-1");
	assert_cell(ts_table_count, -123, "-123");
	assert_cell(ts_table_count, -1234, "-1,234");
}

static void rows_become_objects_in_json(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "", false}, {"b", "", true}, {"c", "", true}, {0}};
	ts_table table = ts_table_begin("key", "", columns);
	ts_table_text(&table, "x\ny");
	ts_table_known(&table, NAN, 1);
	ts_table_known(&table, 2.5, 1);
	ts_table_text(&table, "z");
	ts_table_real(&table, INFINITY, 1);
	ts_table_count(&table, 7);
	json_t *found = ts_table_json(&table),
		   *right = json_pack("[{s:s, s:n, s:f}, {s:s, s:n, s:i}]", "a", "x\ny", "b", "c", 2.5, "a", "z", "b", "c", 7);
	assert_true(json_equal(found, right));
	assert_string_equal(table.cells[0].text, "x?y");
	assert_string_equal(table.cells[1].text, "-");
	assert_string_equal(table.cells[4].text, "equal");
	json_decref(found);
	json_decref(right);
	ts_table_end(&table);
	assert_true(table.cells == NULL && table.n_cells == 0);
}

static void assert_text(ts_report *report, const char *right)
{
	assert_int_equal(ts_report_check(report), TS_OK);
	assert_int_equal(report->text.bytes, strlen(right));
	if (right[0] != 0) assert_memory_equal(report->text.text, right, strlen(right));
	ts_report_discard(report);
}

static void say_both(ts_report *report)
{
	ts_report_line(report, "a %s", "line\t1");
	ts_report_failure(report, "a %s", "failure");
}

/* Lines are told unless the report is quiet, failures always, in JSON neither. */
static void quiet_reports_tell_failures_only(void **state)
{
	(void)state;
	ts_report report;
	ts_report_begin(&report, false);
	say_both(&report);
	assert_text(&report, "a line?1\na failure\n");
	ts_report_begin(&report, false);
	report.quiet = true;
	say_both(&report);
	assert_text(&report, "a failure\n");
	ts_report_begin(&report, true);
	say_both(&report);
	ts_report_value(&report, "x", json_integer(1));
	ts_report_timed(&report, "y", json_integer(2));
	assert_true(!ts_report_is_timed(&report, "x") && ts_report_is_timed(&report, "y"));
	assert_int_equal(json_object_size(report.root), 2);
	assert_text(&report, "");
}

/* A table is in the text, unless it is silent, and in the object in any case. */
static void a_silent_table_is_not_in_text(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "head", false}, {0}};
	for (u32 silent = 0; silent < 2; silent++) {
		ts_report report;
		ts_report_begin(&report, false);
		ts_table table = ts_table_begin("key", "", columns);
		table.silent = silent;
		table.timed = silent;
		ts_table_text(&table, "cell");
		ts_report_table(&report, &table);
		assert_int_equal(json_array_size(json_object_get(report.root, "key")), 1);
		assert_true(ts_report_is_timed(&report, "key") == (silent == 1));
		assert_text(&report, silent ? "" : "head\ncell\n");
	}
}

/* A table that failed is a report that failed; one that is quiet has no table in its text. */
static void a_failed_table_fails_its_report(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "head", false}, {0}};
	for (u32 failed = 0; failed < 2; failed++) {
		ts_report report;
		ts_report_begin(&report, false);
		report.quiet = true;
		ts_table table = ts_table_begin("key", "", columns);
		ts_table_text(&table, "cell");
		table.failed = failed;
		ts_report_table(&report, &table);
		assert_int_equal(ts_report_check(&report), failed ? TS_ERROR : TS_OK);
		if (!failed) assert_int_equal(report.text.bytes, 0);
		ts_report_discard(&report);
	}
}

/* Figures have nine digits; what is no number is null, and no failure. */
static void figures_have_nine_digits(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "", true}, {0}};
	char text[64] = "";
	FILE *out = fmemopen(text, sizeof text, "w");
	json_t *figure = json_pack("[f]", 0.1234567891);
	assert_true(out != NULL && figure != NULL);
	ts_report_write(figure, out);
	fclose(out);
	assert_string_equal(text, "[\n  0.123456789\n]\n");
	json_decref(figure);
	ts_table table = ts_table_begin("key", "", columns);
	ts_table_real(&table, NAN, 1);
	assert_true(!table.failed && table.n_cells == 1 && json_is_null(table.cells[0].value));
	ts_table_end(&table);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(columns_are_aligned),
		cmocka_unit_test(a_text_as_wide_as_lines_fits),
		cmocka_unit_test(wrapped_tables_keep_every_word),
		cmocka_unit_test(cells_print_counts_and_bytes),
		cmocka_unit_test(rows_become_objects_in_json),
		cmocka_unit_test(quiet_reports_tell_failures_only),
		cmocka_unit_test(a_silent_table_is_not_in_text),
		cmocka_unit_test(narrow_columns_wrap_down_to_their_least),
		cmocka_unit_test(a_line_may_end_behind_a_bar),
		cmocka_unit_test(a_wide_head_has_its_room),
		cmocka_unit_test(a_row_is_said_in_a_line),
		cmocka_unit_test(a_failed_table_fails_its_report),
		cmocka_unit_test(figures_have_nine_digits),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
