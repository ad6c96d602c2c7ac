/* Shards of a comparison that are put together: rows in the order of the cases, the first difference, the pictures of
 * what differs; and folders that are no shards. */
#include <sys/stat.h>
#include "cli/reports/sharded.h"
#include "model/digest.h"
#include "model/input.h"
#include "tests/cli/typed.h"
#include "tests/scratch.h"

enum { FORGED = 4096 };

/* Stages a, b and c, the first and the last of which are in the first shard; a and c differ. */
static const char *const reports[2] = {
	"{'verdict': 'different', 'relaxations': '--ulp 1',"
	" 'buffers': [{'stage': 'a', 'buffer': 'one'}, {'stage': 'a', 'buffer': 'same'},"
	"  {'stage': 'c', 'buffer': 'three'}],"
	" 'first_divergence': 'first in one', 'divergence': {'stage': 'a', 'buffer': 'one'},"
	" 'differences': [{'stage': 'a', 'buffer': 'one'}, {'stage': 'c', 'buffer': 'three'}],"
	" 'stages': [{'stage': 'a', 'verdict': 'different', 'outcome': 'failed', 'why': '', 'lines': []},"
	"  {'stage': 'c', 'verdict': 'different', 'outcome': 'failed', 'why': '', 'lines': []}],"
	" 'files': ['one.png', 'three-cube-0.png', 'three-cube-2.png', 'SHA256SUMS', 'report.json'],"
	" 'shard': {'index': 1, 'of': 2, 'commit': '@', 'command': 'compare', 'typed': ['r', 'c'],"
	"  'class': 'touchstone.epr', 'cases': ['a', 'b', 'c'], 'status': 1}}",
	"{'verdict': 'different', 'relaxations': '--ulp 1', 'buffers': [{'stage': 'b', 'buffer': 'two'}],"
	" 'first_divergence': 'first in two', 'divergence': {'stage': 'b', 'buffer': 'two'},"
	" 'differences': [{'stage': 'b', 'buffer': 'two'}],"
	" 'stages': [{'stage': 'b', 'verdict': 'known', 'outcome': 'known', 'why': 'so', 'lines': ['it']}],"
	" 'files': ['two.png', 'SHA256SUMS', 'report.json'],"
	" 'shard': {'index': 2, 'of': 2, 'commit': '@', 'command': 'compare', 'typed': ['r', 'c'],"
	"  'class': 'touchstone.epr', 'cases': ['a', 'b', 'c'], 'status': 1}}",
};
static const char *const times[2] = {"{'seconds': [1, 3]}", "{'seconds': [2]}"};
static const char *const pictures[2][4] = {{"one.png", "three-cube-0.png", "three-cube-2.png"}, {"two.png"}};

static void write_text(const char *path, const char *text)
{
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	for (; *text != 0; text++) {
		if (*text == '@')
			fputs(ts_commit(), file);
		else
			fputc(*text == '\'' ? '"' : *text, file);
	}
	assert_int_equal(fclose(file), 0);
}

static void put_sum(FILE *sums, const char *dir, const char *name)
{
	char hex[TS_DIGEST_BYTES];
	size_t bytes;
	char *data = ts_sharded_read(&bytes, hex, dir, name, TS_INPUT_ANY);
	assert_non_null(data);
	free(data);
	fprintf(sums, "%s  %s\n", hex, name);
}

/* The digests of all files but one. */
static void write_sums(u32 shard, const char *except)
{
	static const char *const reports_and_times[] = {"report.json", "times.json"};
	char dir[256];
	snprintf(dir, sizeof dir, "%s", scratch_path("s%u", shard));
	FILE *sums = fopen(scratch_path("s%u/SHA256SUMS", shard), "w");
	assert_non_null(sums);
	for (u32 i = 0; i < 6; i++) {
		const char *name = i < 4 ? pictures[shard][i] : reports_and_times[i - 4];
		if (name != NULL && strcmp(name, except) != 0) put_sum(sums, dir, name);
	}
	assert_int_equal(fclose(sums), 0);
}

static int write_shards(void **state)
{
	(void)state;
	for (u32 s = 0; s < 2; s++) {
		mkdir(scratch_path("s%u", s), 0700);
		write_text(scratch_path("s%u/report.json", s), reports[s]);
		write_text(scratch_path("s%u/times.json", s), times[s]);
		for (u32 i = 0; i < 4 && pictures[s][i] != NULL; i++) {
			write_text(scratch_path("s%u/%s", s, pictures[s][i]), pictures[s][i]);
		}
		write_sums(s, "");
	}
	return 0;
}

static ts_status merge(const char *a, const char *b, const char *out)
{
	char line[TYPED_LINE];
	json_t *said;
	snprintf(line, sizeof line, "merge --json -o %s %s %s", scratch_path("%s", out), scratch_path("%s", a),
	         scratch_path("%s", b));
	ts_status status = typed_run(&said, line);
	assert_true((said == NULL) == (status == TS_ERROR));
	json_decref(said);
	return status;
}

static json_t *read_json(const char *path)
{
	json_t *root = json_load_file(path, 0, NULL);
	assert_non_null(root);
	return root;
}

static void assert_keys(const json_t *rows, const char *key, const char *right)
{
	char found[64] = "";
	for (size_t i = 0; i < json_array_size(rows); i++) {
		strcat(found, i > 0 ? " " : "");
		strcat(found, json_string_value(json_object_get(json_array_get(rows, i), key)));
	}
	assert_string_equal(found, right);
}

/* Whatever the order in which the folders are named. */
static void shards_merge_in_any_order(void **state)
{
	(void)state;
	static const char *const files[] = {"one.png", "two.png", "three-cube-0.png", "three-cube-2.png"};
	for (u32 turn = 0; turn < 2; turn++) {
		assert_int_equal(merge(turn == 0 ? "s0" : "s1", turn == 0 ? "s1" : "s0", turn == 0 ? "all" : "again"),
		                 TS_DIFFERENT);
		json_t *report = read_json(scratch_path("%s/report.json", turn == 0 ? "all" : "again"));
		assert_keys(json_object_get(report, "stages"), "stage", "a b c");
		assert_keys(json_object_get(report, "buffers"), "buffer", "one same two three");
		assert_keys(json_object_get(report, "differences"), "buffer", "one two three");
		assert_string_equal(json_string_value(json_object_get(report, "first_divergence")), "first in one");
		assert_string_equal(json_string_value(json_object_get(report, "relaxations")), "--ulp 1");
		assert_null(json_object_get(report, "shard"));
		const json_t *listed = json_object_get(report, "files");
		for (size_t i = 0; i < 4; i++) {
			char text[32] = "";
			assert_string_equal(json_string_value(json_array_get(listed, i)), files[i]);
			FILE *file = fopen(scratch_path("%s/%s", turn == 0 ? "all" : "again", files[i]), "r");
			assert_non_null(file);
			assert_non_null(fgets(text, sizeof text, file));
			assert_string_equal(text, files[i]);
			fclose(file);
		}
		json_decref(report);
	}
}

static void assert_refused(const char *why)
{
	assert_int_equal(merge("s0", "s1", "refused"), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), why));
	assert_int_not_equal(access(scratch_path("refused"), F_OK), 0);
}

static void damaged_shards_are_refused(void **state)
{
	(void)state;
	write_text(scratch_path("s1/two.png"), "two.pnG");
	assert_refused("s1: damaged: two.png is not what SHA256SUMS says; run that shard again");
	static const char *const files[] = {"two.png", "report.json", "times.json"};
	for (u32 i = 0; i < 3; i++) {
		char why[100];
		snprintf(why, sizeof why, "s1: damaged: SHA256SUMS names no %s; run that shard again", files[i]);
		write_sums(1, files[i]);
		assert_refused(why);
	}
	write_text(scratch_path("s1/SHA256SUMS"), "x  report.json\n");
	assert_refused("s1: damaged: SHA256SUMS has a line that is none of its; run that shard again");
	unlink(scratch_path("s1/SHA256SUMS"));
	assert_refused(
		"s1/SHA256SUMS: No such file or directory; name folders that a command with --shard I/N wrote to -o");
}

/* A report that its digest is of, but that says something else. */
static void forge(const char *text)
{
	write_text(scratch_path("s1/report.json"), text);
	write_sums(1, "");
}

static void replace(char text[FORGED], const char *words, const char *others)
{
	char tail[FORGED];
	char *at = strstr(text, words);
	assert_non_null(at);
	snprintf(tail, sizeof tail, "%s", at + strlen(words));
	snprintf(at, (size_t)(text + FORGED - at), "%s%s", others, tail);
}

/* The second shard's report, with other words in place of some. */
static void forge_words(const char *words, const char *others)
{
	char text[FORGED];
	snprintf(text, sizeof text, "%s", reports[1]);
	replace(text, words, others);
	forge(text);
}

static void forged_reports_are_refused(void **state)
{
	(void)state;
	forge("[]");
	assert_refused("s1: damaged: a report that is no object; run that shard again");
	forge("{}");
	assert_refused("s1: damaged: report.json says of no shard what it is; run that shard again");
	forge_words("'index': 2", "'index': 1");
	assert_refused("both are shard 1; name each once");
	forge_words("--ulp 1", "--ulp 2");
	assert_refused("s1: says something else of \"relaxations\" than the other shards: name shards of one run");
	forge_words("'of': 2", "'of': 3");
	assert_refused("s1: shard 2 of 3; ");
	forge_words("'of': 2", "'of': 1e18");
	assert_refused("s1: damaged: report.json says of no shard what it is; run that shard again");
}

/* A line of a first difference in a stage that no shard has. */
static void first_differences_are_of_a_case(void **state)
{
	(void)state;
	for (u32 s = 0; s < 2; s++) {
		char text[FORGED];
		snprintf(text, sizeof text, "%s", reports[s]);
		replace(text, s == 0 ? "'divergence': {'stage': 'a'" : "'divergence': {'stage': 'b'",
		        "'divergence': {'stage': ''");
		write_text(scratch_path("s%u/report.json", s), text);
		write_sums(s, "");
	}
	assert_refused("s0: damaged: it has a first difference in no case; run that shard again");
}

/* A shard whose exit code is better than its rows. */
static void exit_codes_are_those_of_the_rows(void **state)
{
	(void)state;
	static const char *const outcomes[] = {"'outcome': 'known'", "'outcome': 'failed'", "'outcome': 'error'"};
	for (u32 worst = 0; worst < 3; worst++) {
		for (u32 code = 0; code < 2; code++) {
			char text[FORGED], name[16], status[] = "'status': 0";
			status[10] += (char)code;
			snprintf(name, sizeof name, "all-%u-%u", worst, code);
			snprintf(text, sizeof text, "%s", reports[1]);
			replace(text, "'outcome': 'known'", outcomes[worst]);
			replace(text, "'status': 1", status);
			forge(text);
			if (code < worst)
				assert_refused("s1: damaged: its rows are worse than its exit code; run that shard again");
			else
				assert_int_equal(merge("s0", "s1", name), TS_DIFFERENT);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(shards_merge_in_any_order, write_shards),
		cmocka_unit_test_setup(damaged_shards_are_refused, write_shards),
		cmocka_unit_test_setup(forged_reports_are_refused, write_shards),
		cmocka_unit_test_setup(first_differences_are_of_a_case, write_shards),
		cmocka_unit_test_setup(exit_codes_are_those_of_the_rows, write_shards),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
