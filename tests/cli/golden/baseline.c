/* Lists of what is known: each line is read and checked by itself, and found by its case and buffer. */
#include "cli/golden/baseline.h"
#include "model/core.h"
#include "tests/model/test.h"
#include "tests/scratch.h"

static const int user = 7;

/* Cases of MVR are called "case-...". */
static ts_status find_case(const void *given, const char *name, const char **effect, const char **method)
{
	assert_ptr_equal(given, &user);
	*effect = "reflections";
	*method = "mvr";
	return strncmp(name, "case-", 5) == 0 ? TS_OK : ts_fail("no case \"%s\"", name);
}

static ts_status check_name(const void *given, const char *name)
{
	assert_ptr_equal(given, &user);
	return name[0] == 'n' ? TS_OK : ts_fail("no name \"%s\"", name);
}

static const char *path;

/* Reads a list of that text, of differences or of names. */
static ts_status read_text(ts_baseline *b, const char *text, bool names)
{
	path = scratch_path("list");
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	fputs(text, file);
	assert_int_equal(fclose(file), 0);
	ts_status status =
		names ? ts_baseline_skips(b, path, check_name, &user) : ts_baseline_read(b, path, find_case, &user);
	unlink(path);
	return status;
}

static void assert_refused(const char *text, bool names, const char *why)
{
	ts_baseline b;
	char right[SCRATCH_PATH + 200];
	assert_int_equal(read_text(&b, text, names), TS_ERROR);
	ts_baseline_free(&b);
	snprintf(right, sizeof right, "%s:%s", path, why);
	assert_string_equal(ts_error_message(), right);
}

static void assert_entry(const ts_entry *e, u32 line, const char *name, const char *reason)
{
	assert_non_null(e);
	assert_int_equal(e->line, line);
	assert_string_equal(e->name, name);
	assert_string_equal(e->reason, reason);
}

static void known_differences_are_found_by_case(void **state)
{
	(void)state;
	ts_baseline b;
	const char *text = "# a comment\n\n \t\r\ncase-1 image image.radiance a driver  rounds\r\n"
					   "\tcase-1\t image  image.srgb\tso\ncase-2 scene scene.vertex the last\x1b one";
	assert_int_equal(read_text(&b, text, false), TS_OK);
	assert_int_equal(b.n, 3);
	assert_entry(ts_baseline_find(&b, "case-1", "image.radiance"), 4, "case-1", "a driver  rounds");
	assert_entry(ts_baseline_find(&b, "case-1", "image.srgb"), 5, "case-1", "so");
	assert_entry(ts_baseline_find(&b, "case-2", "scene.vertex"), 6, "case-2", "the last? one");
	assert_entry(ts_baseline_find(&b, "case-1", NULL), 4, "case-1", "a driver  rounds");
	assert_string_equal(b.entry[1].stage, "image");
	assert_null(ts_baseline_find(&b, "case-2", "image.srgb"));
	assert_null(ts_baseline_find(&b, "case-3", NULL));
	ts_baseline_free(&b);
	assert_null(ts_baseline_find(&b, "case-1", NULL));
}

static void known_names_are_found(void **state)
{
	(void)state;
	ts_baseline b;
	assert_int_equal(read_text(&b, "n1 slow\n#n2 no\nn3  of another\n", true), TS_OK);
	assert_int_equal(b.n, 2);
	assert_entry(ts_baseline_find(&b, "n1", NULL), 1, "n1", "slow");
	assert_entry(ts_baseline_find(&b, "n3", NULL), 3, "n3", "of another");
	assert_null(ts_baseline_find(&b, "n2", NULL));
	ts_baseline_free(&b);
	assert_int_equal(read_text(&b, "", true), TS_OK);
	assert_int_equal(b.n, 0);
	ts_baseline_free(&b);
}

static void wrong_lines_are_refused_by_number(void **state)
{
	(void)state;
	const char *good = "case-1 image image.srgb why\n";
	char text[200];
	assert_refused("other image image.srgb why", false, "1: no case \"other\"");
	assert_refused("\ncase-1 image", false, "2: no buffer \"\"");
	assert_refused("case-1 image image.srg why", false, "1: no buffer \"image.srg\"; the nearest is image.srgb");
	assert_refused("case-1 imag image.srgb why", false, "1: no stage \"imag\" of mvr; the nearest is image");
	assert_refused("case-1 eye image.srgb why", false, "1: image.srgb is made by the stage image, not by eye");
	assert_refused("case-1 image image.srgb  ", false, "1: no reason; write CASE STAGE BUFFER REASON");
	snprintf(text, sizeof text, "%s# \n%s", good, good);
	assert_refused(text, false, "3: case-1 again; line 1 has it");
	assert_refused("n1", true, "1: no reason; write NAME REASON");
	assert_refused("m1 why", true, "1: no name \"m1\"");
	assert_refused("n1 why\nn1 so", true, "2: n1 again; line 1 has it");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(known_differences_are_found_by_case),
		cmocka_unit_test(known_names_are_found),
		cmocka_unit_test(wrong_lines_are_refused_by_number),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
