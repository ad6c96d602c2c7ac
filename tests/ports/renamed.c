/* include/touchstone/candidate.h with a planted row: a port that still uses the old name of a buffer. */
#include "../trace/folder.h"
#define TS_CANDIDATE_RENAMED(ROW) ROW("picture", "image.srgb") ROW("keys", "points.key")
#include <touchstone/candidate.h>
#include "../../src/trace/read.h"

/* What a port prints on standard error. */
static FILE *printed_file;
static int printed_before;

static inline void printed_begin(void)
{
	printed_file = tmpfile();
	assert_non_null(printed_file);
	fflush(stderr);
	printed_before = dup(STDERR_FILENO);
	assert_true(printed_before >= 0 && dup2(fileno(printed_file), STDERR_FILENO) >= 0);
}

/* And from here on no more. */
static inline const char *printed_end(void)
{
	static char text[4096];
	fflush(stderr);
	assert_true(dup2(printed_before, STDERR_FILENO) >= 0);
	close(printed_before);
	rewind(printed_file);
	size_t n = fread(text, 1, sizeof text - 1, printed_file);
	fclose(printed_file);
	text[n] = 0;
	return text;
}

static void an_old_name_works_and_is_said(void **state)
{
	(void)state;
	static const uint64_t shape[] = {2, 4, 3};
	static const u8 pixels[24] = {0};
	ts_candidate c;
	ts_trace *trace;
	const char *folder = scratch_path("candidate");
	assert_int_equal(mkdir(folder, 0777), 0);
	assert_int_equal(ts_candidate_begin(&c, folder, "epr", "canonical", "a port", "1"), 0);
	printed_begin();
	int failed = ts_candidate_add(&c, "picture", 3, shape, pixels);
	int twice = ts_candidate_end(&c);
	assert_string_equal(printed_end(), "picture is now called image.srgb; the old name works until 0.2\n");
	assert_true(failed == 0 && twice == 0);
	assert_int_equal(ts_trace_open_folder(&trace, folder), TS_OK);
	assert_true(trace->item[TS_B_image_srgb].npy.n == 24 && !trace->old_names);
	ts_trace_close(trace);
}

static void either_name_adds_a_buffer_once(void **state)
{
	(void)state;
	static const uint64_t shape[] = {1};
	static const uint64_t key = 0;
	ts_candidate c;
	const char *folder = scratch_path("twice");
	assert_int_equal(mkdir(folder, 0777), 0);
	assert_int_equal(ts_candidate_begin(&c, folder, "epr", "canonical", "a port", "1"), 0);
	assert_int_equal(ts_candidate_add(&c, "points.key", 1, shape, &key), 0);
	assert_int_equal(ts_candidate_add(&c, "keys", 1, shape, &key), 1);
	assert_non_null(strstr(c.message, "was added before"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(an_old_name_works_and_is_said),
	                                   cmocka_unit_test(either_name_adds_a_buffer_once)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
