/* The folder that is written: whole or not there, in the place of what may be replaced alone, and never in that of
 * strangers; what a process that was killed has left goes, what one that lives writes stays. */
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include "output/file.h"
#include "output/folder.h"
#include "tests/kernels/seeded.h"
#include "tests/scratch.h"
#include "tests/status.h"

static u32 n_judged;

static ts_status let(const char *dir)
{
	(void)dir;
	n_judged++;
	return TS_OK;
}

static ts_status keep(const char *dir) { return ts_fail("%s: stays", dir); }

static bool is_there(const char *path)
{
	struct stat info;
	return lstat(path, &info) == 0;
}

static void put(const char *path, const char *text) { require(ts_file_write(path, text, strlen(text))); }

static void holds(const char *path, const char *text)
{
	char found[64] = "";
	FILE *file = fopen(path, "r");
	assert_non_null(file);
	assert_int_equal(fread(found, 1, sizeof found - 1, file), strlen(text));
	fclose(file);
	assert_string_equal(found, text);
}

/* Nothing beside the folder tells of the writing. */
static void assert_clean(const char *dir)
{
	char path[SCRATCH_PATH];
	static const char *const ends[] = {".partial", ".old", ".lock"};
	for (u32 i = 0; i < 3; i++) {
		snprintf(path, sizeof path, "%.480s%s", dir, ends[i]);
		if (is_there(path)) fail_msg("%s is left", path);
	}
}

static void make(const char *dir, const char *text)
{
	require(ts_folder_begin(dir, keep));
	put(ts_folder_file("text"), text);
	require(ts_folder_commit());
	assert_clean(dir);
}

static void a_new_folder_appears_whole(void **state)
{
	(void)state;
	const char *dir = scratch_path("a/b/new");
	require(ts_folder_begin(dir, keep));
	assert_string_equal(ts_folder_path(), scratch_path("a/b/new.partial"));
	assert_true(is_there(scratch_path("a/b/new.lock")) && !is_there(dir));
	const char *first = ts_folder_file("first");
	put(first, "1");
	put(ts_folder_file("sub/second"), "2");
	put(ts_folder_file("sub/third"), "3");
	assert_string_equal(first, scratch_path("a/b/new.partial/first"));
	assert_string_equal(ts_folder_name(0), "first");
	assert_string_equal(ts_folder_name(2), "sub/third");
	assert_null(ts_folder_name(3));
	require(ts_folder_commit());
	holds(scratch_path("a/b/new/first"), "1");
	holds(scratch_path("a/b/new/sub/second"), "2");
	holds(scratch_path("a/b/new/sub/third"), "3");
	assert_clean(dir);
	assert_null(ts_folder_name(0));
}

/* More paths than one piece of memory holds, and one longer than that. */
static void many_and_long_names_are_kept(void **state)
{
	(void)state;
	enum { N = 3000, LONG = 70000 };
	char name[24];
	const char *paths[N];
	require(ts_folder_begin(scratch_path("many"), keep));
	for (u32 i = 0; i < N; i++) {
		snprintf(name, sizeof name, "name-%u", i);
		assert_non_null(paths[i] = ts_folder_file(name));
		if (i != N / 2) continue;
		char *large = malloc(LONG + 1);
		memset(large, 'x', LONG);
		large[LONG] = 0;
		const char *kept = ts_folder_file(large);
		assert_non_null(kept);
		assert_string_equal(strrchr(kept, '/') + 1, large);
		free(large);
	}
	for (u32 i = 0; i < N; i++) {
		snprintf(name, sizeof name, "name-%u", i);
		assert_string_equal(strrchr(paths[i], '/') + 1, name);
		assert_string_equal(ts_folder_name(i + (i > N / 2)), name);
	}
	ts_folder_discard();
	assert_clean(scratch_path("many"));
	assert_false(is_there(scratch_path("many")));
}

/* A discarded folder leaves the message, and none of the folders that were made for it. */
static void a_discarded_folder_leaves_nothing(void **state)
{
	(void)state;
	ts_folder_discard();
	mkdir(scratch_path("kept"), 0700);
	require(ts_folder_begin(scratch_path("kept/x/y/z"), keep));
	put(ts_folder_file("text"), "1");
	assert_true(is_there(scratch_path("kept/x/y/z.partial/text")));
	ts_fail("why");
	ts_folder_discard();
	assert_string_equal(ts_error_message(), "why");
	assert_false(is_there(scratch_path("kept/x")));
	assert_true(is_there(scratch_path("kept")));
}

static void only_what_may_be_replaced_is(void **state)
{
	(void)state;
	const char *dir = scratch_path("replaced");
	make(dir, "before");
	put(scratch_path("replaced/more"), "before");
	refused(ts_folder_begin(dir, keep), "replaced: stays");
	assert_clean(dir);
	holds(scratch_path("replaced/text"), "before");
	n_judged = 0;
	require(ts_folder_begin(dir, let));
	assert_int_equal(n_judged, 1);
	put(ts_folder_file("text"), "after");
	holds(scratch_path("replaced/text"), "before");
	require(ts_folder_commit());
	assert_int_equal(n_judged, 3);
	holds(scratch_path("replaced/text"), "after");
	assert_false(is_there(scratch_path("replaced/more")));
	assert_clean(dir);
}

/* An empty folder, whose name may end with slashes, is no one's. */
static void an_empty_folder_is_no_ones(void **state)
{
	(void)state;
	mkdir(scratch_path("empty"), 0700);
	n_judged = 0;
	require(ts_folder_begin(scratch_path("empty//"), let));
	put(ts_folder_file("text"), "1");
	require(ts_folder_commit());
	assert_int_equal(n_judged, 0);
	holds(scratch_path("empty/text"), "1");
	assert_clean(scratch_path("empty"));
}

static ts_status late;
static ts_status turn(const char *dir)
{
	(void)dir;
	return late == TS_OK ? TS_OK : ts_fail("too late");
}

/* A folder that came to hold something of a stranger while the new one was written stays. */
static void a_folder_that_changed_too_late_stays(void **state)
{
	(void)state;
	const char *dir = scratch_path("late");
	make(dir, "before");
	late = TS_OK;
	require(ts_folder_begin(dir, turn));
	put(ts_folder_file("text"), "after");
	late = TS_ERROR;
	refused(ts_folder_commit(), "too late");
	ts_folder_discard();
	holds(scratch_path("late/text"), "before");
	assert_clean(dir);
}

static u32 n_asked;
static ts_status third(const char *dir)
{
	(void)dir;
	return ++n_asked < 3 ? TS_OK : ts_fail("at the last moment");
}

/* What is found in the old folder when it has left its place brings it back. */
static void a_late_objection_restores_the_folder(void **state)
{
	(void)state;
	const char *dir = scratch_path("back");
	make(dir, "before");
	n_asked = 0;
	require(ts_folder_begin(dir, third));
	put(ts_folder_file("text"), "after");
	refused(ts_folder_commit(), "at the last moment");
	assert_int_equal(n_asked, 3);
	holds(scratch_path("back/text"), "before");
	ts_folder_discard();
	holds(scratch_path("back/text"), "before");
	assert_clean(dir);
}

/* A process without standard input, whose lock has its number. */
static void a_lock_of_descriptor_0_works(void **state)
{
	(void)state;
	const char *dir = scratch_path("zero");
	int kept = dup(STDIN_FILENO);
	for (u32 turn = 0; turn < 2; turn++) {
		close(STDIN_FILENO);
		require(ts_folder_begin(dir, let));
		put(ts_folder_file("text"), "1");
		assert_true(is_there(scratch_path("zero.lock")));
		if (turn == 0) ts_folder_discard();
		if (turn == 1) require(ts_folder_commit());
		assert_clean(dir);
		assert_int_equal(fcntl(STDIN_FILENO, F_GETFD), -1);
		assert_int_equal(is_there(dir), turn == 1);
	}
	dup2(kept, STDIN_FILENO);
	close(kept);
}

static void impossible_names_are_refused(void **state)
{
	(void)state;
	char longest[4200];
	memset(longest, 'f', sizeof longest);
	longest[3797] = 0;
	refused(ts_folder_begin("", keep), "a folder's name has 1 to 3796 characters, this one has 0");
	refused(ts_folder_begin(longest, keep), "this one has 3797");
	longest[3796] = 0;
	refused(ts_folder_begin(longest, keep), "fff");
	assert_null(strstr(ts_error_message(), "this one has"));
	refused(ts_folder_begin("/", keep), "cannot be replaced as a whole");
	refused(ts_folder_begin(scratch_path("."), keep), "cannot be replaced as a whole");
	refused(ts_folder_begin("..", keep), "cannot be replaced as a whole");
	put(scratch_path("file"), "1");
	refused(ts_folder_begin(scratch_path("file"), let), "exists and is not a folder");
	assert_clean(scratch_path("file"));
}

/* What is called as ours, and is not, is not touched. */
static void what_is_not_ours_is_not_touched(void **state)
{
	(void)state;
	mkdir(scratch_path("mine.partial"), 0700);
	refused(ts_folder_begin(scratch_path("mine"), let), "no run that was killed has left it");
	assert_true(is_there(scratch_path("mine.partial")));
	assert_false(is_there(scratch_path("mine.lock")));
	refused(ts_folder_remove(scratch_path("nothing")), "cannot be removed");
	assert_clean(scratch_path("nothing"));
}

static void a_removed_folder_is_gone(void **state)
{
	(void)state;
	make(scratch_path("gone"), "1");
	require(ts_folder_remove(scratch_path("gone")));
	assert_false(is_there(scratch_path("gone")));
	assert_clean(scratch_path("gone"));
}

/* A child writes the folder until it is killed; meanwhile another cannot. */
static void killed(const char *dir, bool commits)
{
	int ready[2];
	char byte;
	assert_int_equal(pipe(ready), 0);
	pid_t child = fork();
	if (child == 0) {
		if (ts_folder_begin(dir, let) == TS_OK && write(ready[1], "1", 1) == 1) pause();
		_exit(1);
	}
	close(ready[1]);
	assert_int_equal(read(ready[0], &byte, 1), 1);
	ts_status status = commits ? ts_folder_begin(dir, let) : TS_ERROR;
	kill(child, SIGKILL);
	assert_int_equal(waitpid(child, NULL, 0), child);
	assert_int_equal(status, TS_ERROR);
	close(ready[0]);
}

static void what_a_killed_process_left_goes(void **state)
{
	(void)state;
	const char *dir = scratch_path("p/q/killed");
	killed(dir, true);
	assert_true(is_there(scratch_path("p/q/killed.partial")) && is_there(scratch_path("p/q/killed.lock")));
	make(dir, "1");
	holds(scratch_path("p/q/killed/text"), "1");
	killed(scratch_path("r/s/cleared"), false);
	ts_folder_clear(scratch_path("r/s/cleared"), 1);
	assert_clean(scratch_path("r/s/cleared"));
	assert_true(is_there(scratch_path("r")) && !is_there(scratch_path("r/s")));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_new_folder_appears_whole),
		cmocka_unit_test(many_and_long_names_are_kept),
		cmocka_unit_test(a_discarded_folder_leaves_nothing),
		cmocka_unit_test(only_what_may_be_replaced_is),
		cmocka_unit_test(an_empty_folder_is_no_ones),
		cmocka_unit_test(a_folder_that_changed_too_late_stays),
		cmocka_unit_test(impossible_names_are_refused),
		cmocka_unit_test(what_is_not_ours_is_not_touched),
		cmocka_unit_test(a_removed_folder_is_gone),
		cmocka_unit_test(what_a_killed_process_left_goes),
		cmocka_unit_test(a_late_objection_restores_the_folder),
		cmocka_unit_test(a_lock_of_descriptor_0_works),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
