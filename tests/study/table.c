/* Tables: as text they are aligned and at most 120 columns wide, as JSON they have a row an object; and lines that only
 * some want. */
#include "../../src/study/table.h"
#include "../lcg.h"
#include "../model/test.h"
#include <math.h>

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

static void test_aligned(void **state)
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
static void test_widest(void **state)
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
static void test_wrapped(void **state)
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

static void test_cells(void **state)
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

static void test_json(void **state)
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
static void test_lines(void **state)
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
static void test_reported(void **state)
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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_aligned),  cmocka_unit_test(test_widest), cmocka_unit_test(test_wrapped),
		cmocka_unit_test(test_cells),    cmocka_unit_test(test_json),   cmocka_unit_test(test_lines),
		cmocka_unit_test(test_reported),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
