/* What a process that was killed leaves: another removes it, once. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <sys/wait.h>
#include "../scratch.h"
#include "../../src/output/file.h"
#include "../../src/output/left.h"

static void test_file(void **state)
{
	(void)state;
	const char *path = scratch_path("out.partial");
	ts_left_clear(); /* nothing yet */
	assert_int_equal(ts_left_share(), TS_OK);
	assert_int_equal(ts_file_write(path, "a", 1), TS_OK);
	const pid_t child = fork();
	assert_true(child >= 0);
	if (child == 0) {
		ts_left_file(path);
		_exit(0);
	}
	assert_int_equal(waitpid(child, NULL, 0), child);
	assert_int_equal(access(path, F_OK), 0);
	ts_left_clear();
	assert_int_equal(access(path, F_OK), -1);
	assert_int_equal(ts_file_write(path, "a", 1), TS_OK);
	ts_left_clear();
	assert_int_equal(access(path, F_OK), 0);
	unlink(path);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_file),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
