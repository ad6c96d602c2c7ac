/* Locks: one holder at a time, who is named; files of killed processes; what cannot be locked. */
#include <errno.h>
#include "output/lock.h"
#include "tests/scratch.h"
#include "tests/status.h"

static void a_lock_has_one_holder(void **state)
{
	(void)state;
	const char *path = scratch_path("one");
	ts_lock lock, other;
	errno = EEXIST; /* of another call */
	assert_int_equal(ts_lock_take(&lock, path, "out"), TS_OK);
	assert_true(lock.descriptor >= 0 && !lock.found);
	assert_int_equal(ts_lock_take(&other, path, "out"), TS_ERROR);
	says("out: process of another run writes it now");
	assert_int_equal(other.descriptor, -1);
	assert_int_equal(write(lock.descriptor, "4711\n", 5), 5);
	assert_int_equal(ts_lock_take(&other, path, "out"), TS_ERROR);
	says("out: process 4711 writes it now");
	close(lock.descriptor);
	assert_int_equal(ts_lock_take(&lock, path, "out"), TS_OK);
	assert_true(lock.found);
	close(lock.descriptor);
	unlink(path);
}

/* A process without standard input is given descriptor 0. */
static void a_lock_may_have_descriptor_0(void **state)
{
	(void)state;
	const char *path = scratch_path("zero");
	const int kept = dup(0);
	ts_lock lock;
	close(0);
	errno = EEXIST;
	ts_status status = ts_lock_take(&lock, path, "out");
	assert_int_equal(status, TS_OK);
	assert_true(lock.descriptor == 0 && !lock.found);
	close(0);
	if (kept >= 0) {
		assert_int_equal(dup2(kept, 0), 0);
		close(kept);
	}
	unlink(path);
}

static void what_cannot_be_locked_is_refused(void **state)
{
	(void)state;
	ts_lock lock;
	assert_int_equal(ts_lock_take(&lock, scratch_path("none/lock"), "out"), TS_ERROR);
	says("out: cannot be written: ");
	says(strerror(ENOENT));
	assert_int_equal(symlink("elsewhere", scratch_path("link")), 0);
	assert_int_equal(ts_lock_take(&lock, scratch_path("link"), "out"), TS_ERROR);
	says(strerror(ELOOP));
	assert_int_equal(access(scratch_path("elsewhere"), F_OK), -1);
	unlink(scratch_path("link"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_lock_has_one_holder),
		cmocka_unit_test(a_lock_may_have_descriptor_0),
		cmocka_unit_test(what_cannot_be_locked_is_refused),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
