/* Cases in Test Anything Protocol, a line each, and in Markdown, whatever texts a shard's report holds. */
#include "cli/reports/outcomes.h"
#include "tests/model/test.h"

static bool in_markdown;

/* What is printed of these rows. */
static char *text_of(const char *rows, size_t n, const char *relaxed)
{
	char *text;
	size_t bytes;
	ts_outcomes outcomes;
	json_t *read = json_loads(rows, 0, NULL), *seconds = json_array();
	for (size_t i = 0; i < n; i++) json_array_append_new(seconds, json_real(1));
	assert_int_equal(ts_outcomes_read(&outcomes, "case", "class", read, seconds), TS_OK);
	FILE *out = open_memstream(&text, &bytes);
	assert_non_null(out);
	if (in_markdown)
		ts_outcomes_markdown(&outcomes, "golden check", relaxed, out);
	else
		ts_outcomes_tap(&outcomes, relaxed, out);
	fclose(out);
	ts_outcomes_end(&outcomes);
	json_decref(read);
	json_decref(seconds);
	return text;
}

static void assert_prints(const char *rows, size_t n, const char *relaxed, const char *right)
{
	char *text = text_of(rows, n, relaxed);
	assert_string_equal(text, right);
	free(text);
}

static void each_outcome_has_its_line(void **state)
{
	(void)state;
	assert_prints(
		"[{\"case\": \"a\", \"verdict\": \"same\", \"outcome\": \"passed\", \"why\": \"\", \"lines\": []},"
		"{\"case\": \"b\", \"verdict\": \"skipped\", \"outcome\": \"skipped\", \"why\": \"slow\", \"lines\": []},"
		"{\"case\": \"c\", \"verdict\": \"known\", \"outcome\": \"known\", \"why\": \"\", \"lines\": [\"at 1\"]},"
		"{\"case\": \"d\", \"verdict\": \"different\", \"outcome\": \"failed\", \"why\": \"x\", "
		" \"lines\": [\"at 2\", \"3\"]},"
		"{\"case\": \"e\", \"verdict\": \"missing\", \"outcome\": \"error\", \"why\": \"\", \"lines\": []}]",
		5, "",
		"ok 1 - a\nok 2 - b # SKIP skipped: slow\nnot ok 3 - c # TO"
		"DO known\n# at 1\nnot ok 4 - d\n# at 2\n# 3\nnot ok 5 - e\n1..5\n");
	assert_prints("[]", 0, "--ulp 1", "# relaxed: --ulp 1\n1..0\n");
}

static void no_text_breaks_its_line(void **state)
{
	(void)state;
	assert_prints(
		"[{\"case\": \"a\\nok 2\", \"verdict\": \"known\", \"outcome\": \"known\", \"why\": \"b\\nok 3\\u001b\","
		"\"lines\": [\"c\\r\\nok 4\\u0085\", \"\\u007fd\"]}]",
		1, "e\nok 5",
		"# relaxed: e?ok 5\nnot ok 1 - a?ok 2 # TO"
		"DO known: b?ok 3?\n# c??ok 4??\n# ?d\n1..1\n");
}

static void a_long_text_ends_within_its_line(void **state)
{
	(void)state;
	static char rows[20000];
	size_t n = (size_t)snprintf(rows, sizeof rows,
	                            "[{\"case\": \"a\", \"verdict\": \"skipped\", \"outcome\": \"skipped\", \"why\": \"");
	memset(rows + n, 'w', 10000);
	strcpy(rows + n + 10000, "\", \"lines\": []}]");
	char *text = text_of(rows, 1, "");
	assert_int_equal(strncmp(text, "ok 1 - a # SKIP skipped: wwww", 28), 0);
	assert_string_equal(strchr(text, '\n'), "\n1..1\n");
	free(text);
}

/* What passed is counted alone; no text ends its cell or is markup. */
static void no_text_is_markup(void **state)
{
	(void)state;
	in_markdown = true;
	assert_prints(
		"[{\"case\": \"a\", \"verdict\": \"same\", \"outcome\": \"passed\", \"why\": \"\", \"lines\": [\"x\"]},"
		"{\"case\": \"b|c\", \"verdict\": \"known\", \"outcome\": \"known\", \"why\": \"*d*\", \"lines\": []},"
		"{\"case\": \"e\", \"verdict\": \"different\", \"outcome\": \"failed\", \"why\": \"\","
		"\"lines\": [\"<b>\\n| [0]\", \"2\"]}]",
		3, "--abs 1",
		"### touchstone golden check\n\n1 passed, 1 failed, 1 known, 0 skipped\n\nRelaxed: --abs 1\n\n"
		"| case | verdict | |\n| --- | --- | --- |\n| b\\|c | known: \\*d\\* |  |\n"
		"| e | different | \\<b\\>?\\| \\[0\\] |\n");
	assert_prints("[]", 0, "", "### touchstone golden check\n\n0 passed, 0 failed, 0 known, 0 skipped\n");
	in_markdown = false;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_outcome_has_its_line),
		cmocka_unit_test(no_text_breaks_its_line),
		cmocka_unit_test(a_long_text_ends_within_its_line),
		cmocka_unit_test(no_text_is_markup),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
