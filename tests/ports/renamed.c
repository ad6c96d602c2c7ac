/* include/touchstone/candidate.h with a planted row: a port that still uses the old name of a buffer. */
#include "../trace/folder.h"
#define TS_CANDIDATE_RENAMED(ROW) ROW("picture", "image.srgb") ROW("keys", "points.key")
#include <touchstone/candidate.h>
#include "../model/said.h"
#include "../../src/trace/read.h"

static void test_old_name(void **state)
{
	(void)state;
	static const uint64_t shape[] = {2, 4, 3};
	static const u8 pixels[24] = {0};
	ts_candidate c;
	ts_trace *trace;
	const char *folder = folder_path("candidate");
	assert_int_equal(mkdir(folder, 0777), 0);
	assert_int_equal(ts_candidate_begin(&c, folder, "epr", "canonical", "a port", "1"), 0);
	said_begin();
	int failed = ts_candidate_add(&c, "picture", 3, shape, pixels);
	int twice = ts_candidate_end(&c);
	assert_string_equal(said_end(), "picture is now called image.srgb; the old name works until 0.2\n");
	assert_true(failed == 0 && twice == 0);
	assert_int_equal(ts_trace_open(&trace, folder), TS_OK);
	assert_true(trace->item[TS_B_image_srgb].npy.n == 24 && !trace->old_names);
	ts_trace_close(trace);
}

static void test_once(void **state)
{
	(void)state;
	static const uint64_t shape[] = {1};
	static const uint64_t key = 0;
	ts_candidate c;
	const char *folder = folder_path("twice");
	assert_int_equal(mkdir(folder, 0777), 0);
	assert_int_equal(ts_candidate_begin(&c, folder, "epr", "canonical", "a port", "1"), 0);
	assert_int_equal(ts_candidate_add(&c, "points.key", 1, shape, &key), 0);
	assert_int_equal(ts_candidate_add(&c, "keys", 1, shape, &key), 1);
	assert_non_null(strstr(c.message, "was added before"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_old_name), cmocka_unit_test(test_once)};
	return cmocka_run_group_tests(tests, folder_begin, folder_end);
}
