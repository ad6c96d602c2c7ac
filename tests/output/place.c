/* Folders that take the place of others, and what takes that back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <string.h>
#include <sys/stat.h>
#include "../scratch.h"
#include "../../src/output/file.h"
#include "../../src/output/place.h"

static char dir[SCRATCH_PATH], partial[SCRATCH_PATH], old[SCRATCH_PATH];
static const ts_place place = {dir, partial, old};

static int begin(void **state)
{
	if (scratch_begin(state) != 0) return -1;
	strcpy(dir, scratch_path("out"));
	strcpy(partial, scratch_path("out.partial"));
	strcpy(old, scratch_path("out.old"));
	return 0;
}

/* A folder with one file, which is named as the folder's first path was. */
static void put(const char *path, const char *file)
{
	char name[2 * SCRATCH_PATH];
	assert_int_equal(mkdir(path, 0777), 0);
	snprintf(name, sizeof name, "%s/%s", path, file);
	assert_int_equal(ts_file_write(name, "", 0), TS_OK);
}

static bool has(const char *path, const char *file)
{
	char name[2 * SCRATCH_PATH];
	snprintf(name, sizeof name, "%s/%s", path, file);
	return ts_place_has(name);
}

/* Removes a folder of `put`. */
static void drop(const char *path, const char *file)
{
	char name[2 * SCRATCH_PATH];
	snprintf(name, sizeof name, "%s/%s", path, file);
	assert_int_equal(unlink(name), 0);
	assert_int_equal(rmdir(path), 0);
}

static void test_has(void **state)
{
	(void)state;
	assert_false(ts_place_has(dir));
	assert_int_equal(symlink("nowhere", dir), 0);
	assert_true(ts_place_has(dir));
	unlink(dir);
}

static void test_take(void **state)
{
	(void)state;
	assert_int_equal(ts_place_take(&place), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "out.partial: cannot be renamed to "));
	put(partial, "new");
	assert_int_equal(ts_place_take(&place), TS_OK);
	assert_true(has(dir, "new") && !ts_place_has(partial));
	put(partial, "newer");
	assert_int_equal(ts_place_take(&place), TS_DIFFERENT);
	assert_true(has(dir, "new") && has(partial, "newer"));
	drop(dir, "new");
	assert_int_equal(mkdir(dir, 0777), 0);
	assert_int_equal(ts_place_take(&place), TS_OK);
	assert_true(has(dir, "newer"));
	drop(dir, "newer");
}

/* Where the file system cannot do it, nothing has moved. */
static void test_exchange(void **state)
{
	(void)state;
	put(dir, "old");
	put(partial, "new");
	const ts_status status = ts_place_exchange(&place);
	const bool can = status == TS_OK;
	assert_true(can || status == TS_DIFFERENT);
	assert_true(has(dir, can ? "new" : "old") && has(partial, can ? "old" : "new"));
	if (can) assert_int_equal(ts_place_undo(&place, TS_PLACE_EXCHANGED), TS_OK);
	assert_true(has(dir, "old") && has(partial, "new"));
	drop(dir, "old");
	drop(partial, "new");
	assert_int_not_equal(ts_place_exchange(&place), TS_OK);
}

static void test_move(void **state)
{
	(void)state;
	put(dir, "old");
	assert_int_equal(ts_place_move(&place), TS_ERROR); /* nothing takes the place: what was there is there again */
	assert_true(has(dir, "old") && !ts_place_has(old));
	put(partial, "new");
	assert_int_equal(ts_place_move(&place), TS_OK);
	assert_true(has(dir, "new") && has(old, "old") && !ts_place_has(partial));
	assert_int_equal(ts_place_undo(&place, TS_PLACE_MOVED), TS_OK);
	assert_true(has(dir, "old") && has(partial, "new") && !ts_place_has(old));
	drop(dir, "old");
	drop(partial, "new");
}

/* Only what was moved comes back from DIR.old, and only to a free place. */
static void test_undo(void **state)
{
	(void)state;
	put(dir, "new");
	put(old, "other");
	assert_int_equal(ts_place_undo(&place, TS_PLACE_FREE), TS_OK);
	assert_true(has(partial, "new") && has(old, "other") && !ts_place_has(dir));
	assert_int_equal(ts_place_undo(&place, TS_PLACE_MOVED), TS_ERROR);
	assert_true(has(old, "other") && !ts_place_has(dir));
	drop(partial, "new");
	drop(old, "other");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_has),  cmocka_unit_test(test_take), cmocka_unit_test(test_exchange),
		cmocka_unit_test(test_move), cmocka_unit_test(test_undo),
	};
	return cmocka_run_group_tests(tests, begin, scratch_end);
}
