/* What a process that was killed leaves, another removes: it sees the notes of processes that are forked, and of no
 * other. */
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include "output/file.h"
#include "output/folder.h"
#include "output/left.h"
#include "tests/kernels/seeded.h"
#include "tests/scratch.h"

static ts_status keep(const char *dir) { return ts_fail("%s: stays", dir); }

static bool is_there(const char *path)
{
	struct stat info;
	return lstat(path, &info) == 0;
}

/* A child that notes a file, begins a folder, and is killed. */
static void leave(const char *file, const char *dir)
{
	int ready[2];
	char byte;
	assert_int_equal(pipe(ready), 0);
	pid_t child = fork();
	if (child == 0) {
		ts_left_file(file);
		if (ts_folder_begin(dir, keep) == TS_OK && write(ready[1], "1", 1) == 1) pause();
		_exit(1);
	}
	close(ready[1]);
	assert_int_equal(read(ready[0], &byte, 1), 1);
	kill(child, SIGKILL);
	assert_int_equal(waitpid(child, NULL, 0), child);
	close(ready[0]);
}

static void only_noted_leftovers_are_removed(void **state)
{
	(void)state;
	char *file = strdup(scratch_path("file.partial")), *dir = strdup(scratch_path("a/b/dir"));
	for (u32 shared = 0; shared < 2; shared++) {
		if (shared == 1) assert_int_equal(ts_left_share(), TS_OK);
		assert_int_equal(ts_file_write(file, "1", 1), TS_OK);
		leave(file, dir);
		assert_true(is_there(scratch_path("a/b/dir.partial")) && is_there(scratch_path("a/b/dir.lock")));
		ts_left_clear();
		assert_int_equal(is_there(file), shared == 0);
		assert_int_equal(is_there(scratch_path("a/b/dir.partial")), shared == 0);
		if (shared == 0) ts_folder_clear(dir, 2);
		assert_false(is_there(scratch_path("a")));
	}
	assert_int_equal(ts_file_write(file, "1", 1), TS_OK);
	ts_left_clear(); /* nothing is noted any more */
	assert_true(is_there(file));
	unlink(file);
	free(file);
	free(dir);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(only_noted_leftovers_are_removed)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
