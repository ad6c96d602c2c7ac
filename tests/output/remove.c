/* A folder whose files cannot be removed: its lock stays, and the next run removes both; and what a lock says while a
 * folder goes. `remove` here stands in place of the C library's. */
#include <errno.h>
#include <sys/stat.h>
#include "output/file.h"
#include "output/folder.h"
#include "tests/kernels/seeded.h"
#include "tests/scratch.h"
#include "tests/status.h"

static bool denied;
static char lock_path[SCRATCH_PATH], lock_said[64];

int remove(const char *path)
{
	FILE *lock = fopen(lock_path, "r");
	if (lock != NULL) {
		lock_said[fread(lock_said, 1, sizeof lock_said - 1, lock)] = 0;
		fclose(lock);
	}
	errno = EACCES;
	return !denied && (unlink(path) == 0 || rmdir(path) == 0) ? 0 : -1;
}

static char lines[600];

static void hear(void *user, const char *line)
{
	(void)user;
	snprintf(lines, sizeof lines, "%s", line);
}

static ts_status let(const char *dir)
{
	(void)dir;
	return TS_OK;
}

static bool is_there(const char *path)
{
	struct stat info;
	return lstat(path, &info) == 0;
}

static void write_folder(void)
{
	require(ts_folder_begin(scratch_path("dir"), let));
	require(ts_file_write(ts_folder_file("text"), "1", 1));
	require(ts_folder_commit());
}

static bool is_clean(void)
{
	return !is_there(scratch_path("dir.partial")) && !is_there(scratch_path("dir.old")) && !is_there(lock_path);
}

/* The folder that was replaced stays, and so does the lock. */
static void what_cannot_be_removed_keeps_its_lock(void **state)
{
	(void)state;
	ts_listen(&(ts_listener){.line = hear});
	write_folder();
	denied = true;
	write_folder();
	denied = false;
	assert_true(is_there(lock_path) && is_there(scratch_path("dir/text")));
	assert_non_null(strstr(lines, "cannot be removed"));
	assert_non_null(strstr(lines, "the next run that writes"));
	write_folder();
	assert_true(is_clean());
	require(ts_folder_begin(scratch_path("other"), let));
	denied = true;
	ts_folder_discard();
	denied = false;
	assert_true(is_there(scratch_path("other.lock")) && is_there(scratch_path("other.partial")));
	ts_folder_clear(scratch_path("other"), 0);
	assert_false(is_there(scratch_path("other.lock")) || is_there(scratch_path("other.partial")));
	ts_listen(&(ts_listener){.line = NULL});
}

/* While a folder is removed its lock says whose it is, and that it is written. */
static void a_lock_says_who_removes_the_folder(void **state)
{
	(void)state;
	char right[32];
	write_folder();
	lock_said[0] = 0;
	require(ts_folder_remove(scratch_path("dir")));
	snprintf(right, sizeof right, "%-10ld %-8s\n", (long)getpid(), "writing");
	assert_string_equal(lock_said, right);
	assert_true(is_clean() && !is_there(scratch_path("dir")));
}

static int begin(void **state)
{
	int bad = scratch_begin(state);
	snprintf(lock_path, sizeof lock_path, "%s", scratch_path("dir.lock"));
	return bad;
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(what_cannot_be_removed_keeps_its_lock),
	                                   cmocka_unit_test(a_lock_says_who_removes_the_folder)};
	return cmocka_run_group_tests(tests, begin, scratch_end);
}
