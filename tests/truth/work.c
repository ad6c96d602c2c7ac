/* What is said of long work, and that short work says nothing. */
#include "model/core.h"
#include "tests/model/test.h"
#include "truth/work.h"

static char said[256];
static int lines;

static void line(void *user, const char *text)
{
	(void)user;
	lines++;
	strncpy(said, text, sizeof said - 1);
}

/* As if it had begun a second ago. */
static ts_work a_second_old(u64 rays)
{
	ts_work work = ts_work_begin("test", rays);
	work.begin -= 1;
	return work;
}

static void long_work_is_told_once(void **state)
{
	(void)state;
	ts_listen(&(ts_listener){.line = line});
	ts_work work = a_second_old(5000);
	lines = 0;
	ts_work_at(&work, 0, 100);
	assert_int_equal(lines, 0);
	ts_work_at(&work, 5, 100);
	ts_work_at(&work, 6, 100);
	assert_int_equal(lines, 1);
	assert_non_null(strstr(said, "test: 5000 rays, about 2"));
	work = a_second_old(0);
	ts_work_at(&work, 1, 100);
	assert_non_null(strstr(said, "test: about 1"));
}

static void short_work_says_nothing(void **state)
{
	(void)state;
	ts_listen(&(ts_listener){.line = line});
	lines = 0;
	ts_work work = a_second_old(5000), young = ts_work_begin("test", 5000);
	ts_work_at(&work, 50, 100);
	ts_work_at(&young, 1, 1000000);
	ts_work_end(&work);
	assert_int_equal(lines, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(long_work_is_told_once),
	                                   cmocka_unit_test(short_work_says_nothing)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
