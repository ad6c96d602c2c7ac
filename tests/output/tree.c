/* Folders that are removed, and given to the disk; links in them are not followed. */
#include <sys/stat.h>
#include "output/file.h"
#include "output/tree.h"
#include "tests/model/test.h"
#include "tests/scratch.h"

static void fails(ts_status status, const char *path)
{
	assert_int_equal(status, TS_ERROR);
	assert_non_null(strstr(ts_error_message(), path));
}

static void removing_a_tree_follows_no_links(void **state)
{
	(void)state;
	fails(ts_tree_remove(scratch_path("tree")), "/tree");
	assert_int_equal(ts_file_write(scratch_path("kept"), "a", 1), TS_OK);
	assert_int_equal(mkdir(scratch_path("outside"), 0777), 0);
	assert_int_equal(ts_file_write(scratch_path("outside/file"), "a", 1), TS_OK);
	assert_int_equal(mkdir(scratch_path("tree"), 0777), 0);
	assert_int_equal(mkdir(scratch_path("tree/inner"), 0777), 0);
	assert_int_equal(ts_file_write(scratch_path("tree/inner/file"), "a", 1), TS_OK);
	assert_int_equal(symlink("../outside", scratch_path("tree/link")), 0);
	assert_int_equal(ts_tree_sync(scratch_path("tree")), TS_OK);
	assert_int_equal(ts_tree_remove(scratch_path("tree")), TS_OK);
	assert_int_equal(access(scratch_path("tree"), F_OK), -1);
	assert_int_equal(access(scratch_path("kept"), F_OK), 0);
	assert_int_equal(access(scratch_path("outside/file"), F_OK), 0);
	unlink(scratch_path("kept"));
	unlink(scratch_path("outside/file"));
	rmdir(scratch_path("outside"));
}

static void trees_are_given_to_the_disk(void **state)
{
	(void)state;
	assert_int_equal(ts_file_write(scratch_path("file"), "a", 1), TS_OK);
	assert_int_equal(ts_folder_sync(scratch_path(".")), TS_OK);
	assert_int_equal(ts_parent_sync(scratch_path("file")), TS_OK);
	assert_int_equal(ts_parent_sync(scratch_path("absent")), TS_OK);
	assert_int_equal(ts_parent_sync("name"), TS_OK);
	assert_int_equal(ts_parent_sync("/name"), TS_OK);
	fails(ts_folder_sync(scratch_path("file")), "/file: cannot be given to the disk: ");
	fails(ts_folder_sync(scratch_path("absent")), "/absent: cannot be given to the disk: ");
	fails(ts_parent_sync(scratch_path("absent/file")), "/absent: cannot be given to the disk: ");
	fails(ts_tree_sync(scratch_path("absent")), "/absent");
	unlink(scratch_path("file"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(removing_a_tree_follows_no_links),
		cmocka_unit_test(trees_are_given_to_the_disk),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
