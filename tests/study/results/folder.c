/* What --force may replace: folders of which a report lists every file, and nothing else. */
#include "study/results/folder.h"
#include "tests/trace/folder.h"

/* All names of up to five of these characters, against the rule as it is written: "name" or "sub/name", none hidden. */
static void names_of_ours_follow_their_rule(void **state)
{
	(void)state;
	static const char letters[] = "a./";
	u32 n_good = 0;
	assert_false(ts_ours_is_name(NULL));
	for (u32 i = 0; i < 4 * 4 * 4 * 4 * 4; i++) {
		char name[8] = "";
		for (u32 k = i; k > 0; k /= 4) {
			if (k % 4 > 0) strncat(name, letters + k % 4 - 1, 1);
		}
		u32 parts = 1;
		bool good = true;
		for (const char *part = name; part != NULL; part = strchr(part, '/') ? strchr(part, '/') + 1 : NULL, parts++) {
			good = good && part[0] != 0 && part[0] != '.' && part[0] != '/' && parts <= 2;
		}
		if (ts_ours_is_name(name) != good) fail_msg("\"%s\"", name);
		n_good += good;
	}
	assert_true(n_good > 50);
}

static const char REPORT[] = "{\"program\": \"touchstone\", \"files\": [\"a\", \"sub/b\"]}";

static void put(const char *name, const char *text) { file_write(scratch_path("%s", name), text, strlen(text)); }

static void refuses(const char *words) { refused(ts_ours_judge(scratch_root), words); }

/* Fills the stack, so that a pointer which nobody set is not NULL by luck. */
static void __attribute__((noinline)) spoil_stack(void)
{
	volatile char block[16384];
	for (u32 i = 0; i < sizeof block; i++) block[i] = 0x11;
}

static void remove_all(void)
{
	static const char *const files[] = {"a", "c", "sub/b", "sub/c", "report.json", "vectors.json"};
	for (u32 i = 0; i < sizeof files / sizeof *files; i++) unlink(scratch_path("%s", files[i]));
	rmdir(scratch_path("sub"));
}

static void make(const char *report, const char *text)
{
	remove_all();
	mkdir(scratch_path("sub"), 0777);
	put("a", "1");
	put("sub/b", "2");
	if (report != NULL) put(report, text);
	spoil_stack();
}

static void a_listed_folder_is_ours(void **state)
{
	(void)state;
	make("report.json", REPORT);
	assert_int_equal(ts_ours_judge(scratch_root), TS_OK);
	make("report.json", REPORT);
	unlink(scratch_path("a"));
	assert_int_equal(ts_ours_judge(scratch_root), TS_OK);
	make("vectors.json", "{\"program\": \"touchstone\", \"files\": [\"a\", \"sub/b\", \"vectors.json\"]}");
	assert_int_equal(ts_ours_judge(scratch_root), TS_OK);
	remove_all();
}

static void unlisted_files_are_not_ours(void **state)
{
	(void)state;
	make("report.json", REPORT);
	put("c", "3");
	refuses("holds c, which no render wrote");
	make("report.json", REPORT);
	put("sub/c", "3");
	refuses("holds sub, which no render wrote");
	make("report.json", REPORT);
	unlink(scratch_path("sub/b"));
	refuses("holds sub, which no render wrote");
	make("report.json", REPORT);
	unlink(scratch_path("a"));
	mkdir(scratch_path("a"), 0777);
	refuses("holds a, which no render wrote");
	rmdir(scratch_path("a"));
	make("report.json", REPORT);
	unlink(scratch_path("a"));
	assert_int_equal(symlink(scratch_path("sub/b"), scratch_path("a")), 0);
	refuses("holds a, which no render wrote");
	remove_all();
}

/* A folder that no list of this program is in. */
static void a_folder_without_list_is_foreign(void **state)
{
	(void)state;
	static const char *const lists[] = {"{\"program\": \"other\", \"files\": [\"a\", \"sub/b\"]}",
	                                    "{\"files\": [\"a\", \"sub/b\"]}",
	                                    "{\"program\": \"touchstone\"}",
	                                    "{\"program\": \"touchstone\", \"files\": [\"a\", \"../b\"]}",
	                                    "{\"program\": \"touchstone\", \"files\": [\"a\", 5]}",
	                                    "[",
	                                    ""};
	make(NULL, NULL);
	refuses("no report.json or vectors.json there lists what was written");
	for (u32 i = 0; i < sizeof lists / sizeof *lists; i++) {
		make(i % 2 == 0 ? "report.json" : "vectors.json", lists[i]);
		refuses("no report.json or vectors.json there lists what was written");
	}
	remove_all();
	assert_int_equal(ts_ours_judge(scratch_path("absent")), TS_ERROR);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(names_of_ours_follow_their_rule), cmocka_unit_test(a_listed_folder_is_ours),
		cmocka_unit_test(unlisted_files_are_not_ours), cmocka_unit_test(a_folder_without_list_is_foreign)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
