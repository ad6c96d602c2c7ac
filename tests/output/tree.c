/* Whole folders: removed and given to the disk, where links in them are not followed; and folders that take the place
 * of others, each step and what takes it back. */
#include <fcntl.h>
#include <sys/stat.h>
#include "output/file.h"
#include "output/tree.h"
#include "tests/kernels/seeded.h"
#include "tests/model/test.h"
#include "tests/scratch.h"
#include "tests/status.h"

static char dir[SCRATCH_PATH], partial[SCRATCH_PATH], old[SCRATCH_PATH];
static const ts_place place = {dir, partial, old};

/* A folder with one file, whose name says what it was made as. */
static void make(const char *folder, const char *as)
{
	char path[2 * SCRATCH_PATH];
	assert_int_equal(mkdir(folder, 0700), 0);
	snprintf(path, sizeof path, "%s/%s", folder, as);
	require(ts_file_write(path, "", 0));
}

static bool was(const char *folder, const char *as)
{
	char path[2 * SCRATCH_PATH];
	snprintf(path, sizeof path, "%s/%s", folder, as);
	return ts_place_has(path);
}

static void clean(void)
{
	const char *const all[] = {dir, partial, old};
	for (u32 i = 0; i < 3; i++) {
		if (ts_place_has(all[i])) require(ts_tree_remove(all[i]));
	}
}

static int begin(void **state)
{
	int bad = scratch_begin(state);
	strcpy(dir, scratch_path("dir"));
	strcpy(partial, scratch_path("dir.partial"));
	strcpy(old, scratch_path("dir.old"));
	return bad;
}

static void a_new_folder_takes_a_free_place(void **state)
{
	(void)state;
	make(partial, "new");
	require(ts_place_take(&place));
	assert_true(was(dir, "new") && !ts_place_has(partial));
	make(partial, "newer");
	assert_int_equal(ts_place_take(&place), TS_DIFFERENT);
	clean();
	mkdir(dir, 0700);
	make(partial, "new");
	require(ts_place_take(&place));
	assert_true(was(dir, "new"));
	make(old, "stranger");
	require(ts_place_undo(&place, TS_PLACE_FREE));
	assert_true(was(partial, "new") && !ts_place_has(dir) && was(old, "stranger"));
	clean();
	refused(ts_place_take(&place), "cannot be renamed to");
}

static void two_folders_exchange_their_places(void **state)
{
	(void)state;
	make(dir, "before");
	make(partial, "new");
	ts_status status = ts_place_exchange(&place);
	if (status == TS_DIFFERENT) { /* the file system cannot */
		clean();
		skip();
	}
	require(status);
	assert_true(was(dir, "new") && was(partial, "before"));
	require(ts_place_undo(&place, TS_PLACE_EXCHANGED));
	assert_true(was(dir, "before") && was(partial, "new"));
	clean();
}

static void a_moved_folder_can_be_brought_back(void **state)
{
	(void)state;
	make(dir, "before");
	make(partial, "new");
	require(ts_place_move(&place));
	assert_true(was(dir, "new") && was(old, "before") && !ts_place_has(partial));
	require(ts_place_undo(&place, TS_PLACE_MOVED));
	assert_true(was(dir, "before") && was(partial, "new") && !ts_place_has(old));
	require(ts_tree_remove(partial));
	refused(ts_place_move(&place), "cannot be renamed to");
	assert_true(was(dir, "before") && !ts_place_has(old));
	clean();
}

static void folders_are_given_to_the_disk(void **state)
{
	(void)state;
	make(dir, "file");
	require(ts_folder_sync(dir));
	require(ts_tree_sync(dir));
	require(ts_parent_sync(dir));
	require(ts_parent_sync("here"));
	require(ts_parent_sync("/root-of-all"));
	refused(ts_folder_sync(scratch_path("dir/file")), "cannot be given to the disk: Not a directory");
	refused(ts_folder_sync(partial), "cannot be given to the disk: No such file");
	refused(ts_parent_sync(scratch_path("none/file")), "cannot be given to the disk");
	refused(ts_tree_sync(partial), "dir.partial: ");
	refused(ts_tree_remove(partial), "dir.partial: ");
	assert_false(ts_place_has(partial));
	clean();
}

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
		cmocka_unit_test(a_new_folder_takes_a_free_place),    cmocka_unit_test(two_folders_exchange_their_places),
		cmocka_unit_test(a_moved_folder_can_be_brought_back), cmocka_unit_test(folders_are_given_to_the_disk),
		cmocka_unit_test(removing_a_tree_follows_no_links),   cmocka_unit_test(trees_are_given_to_the_disk),
	};
	return cmocka_run_group_tests(tests, begin, scratch_end);
}
