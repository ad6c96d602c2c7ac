/* Shards of a comparison that are put together: rows in the order of the cases, the first difference, the pictures of
 * what differs; and folders that are no shards. */
#include <sys/stat.h>
#include "cli/reports/sharded.h"
#include "model/digest.h"
#include "tests/cli/typed.h"
#include "tests/scratch.h"

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
	" 'shard': {'index': 1, 'of': 2, 'commit': 'x', 'command': 'compare', 'typed': ['r', 'c'],"
	"  'class': 'touchstone.epr', 'cases': ['a', 'b', 'c'], 'status': 1}}",
	"{'verdict': 'different', 'relaxations': '--ulp 1', 'buffers': [{'stage': 'b', 'buffer': 'two'}],"
	" 'first_divergence': 'first in two', 'divergence': {'stage': 'b', 'buffer': 'two'},"
	" 'differences': [{'stage': 'b', 'buffer': 'two'}],"
	" 'stages': [{'stage': 'b', 'verdict': 'known', 'outcome': 'known', 'why': 'so', 'lines': ['it']}],"
	" 'files': ['two.png', 'SHA256SUMS', 'report.json'],"
	" 'shard': {'index': 2, 'of': 2, 'commit': 'x', 'command': 'compare', 'typed': ['r', 'c'],"
	"  'class': 'touchstone.epr', 'cases': ['a', 'b', 'c'], 'status': 1}}",
};
static const char *const times[2] = {"{'seconds': [1, 3]}", "{'seconds': [2]}"};
static const char *const pictures[2][4] = {{"one.png", "three-cube-0.png", "three-cube-2.png"}, {"two.png"}};

static void write_text(const char *path, const char *text)
{
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	for (; *text != 0; text++) fputc(*text == '\'' ? '"' : *text, file);
	assert_int_equal(fclose(file), 0);
}

/* The digests of the pictures and, unless it is NULL, of another file. */
static void write_sums(u32 shard, const char *other)
{
	FILE *sums = fopen(scratch_path("s%u/SHA256SUMS", shard), "w");
	assert_non_null(sums);
	for (u32 i = 0; i < 4; i++) {
		char hex[TS_DIGEST_BYTES];
		const char *name = pictures[shard][i] != NULL ? pictures[shard][i] : other;
		if (name == NULL) break;
		assert_true(ts_sharded_digest(hex, scratch_path("s%u/%s", shard, name)));
		fprintf(sums, "%s  %s\n", hex, name);
		if (pictures[shard][i] == NULL) break;
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
		write_sums(s, "report.json");
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
	write_sums(1, NULL);
	assert_refused("s1: damaged: SHA256SUMS names no report.json; run that shard again");
	write_sums(1, "times.json");
	assert_refused("s1: damaged: SHA256SUMS names no report.json; run that shard again");
	write_text(scratch_path("s1/SHA256SUMS"), "x  report.json\n");
	assert_refused("s1: damaged: SHA256SUMS has a line that is none of its; run that shard again");
	unlink(scratch_path("s1/SHA256SUMS"));
	assert_refused("s1: no SHA256SUMS there; name folders that a command with --shard I/N wrote to -o");
}

/* A report that its digest is of, but that says something else. */
static void forge(const char *text)
{
	write_text(scratch_path("s1/report.json"), text);
	write_sums(1, "report.json");
}

static void forged_reports_are_refused(void **state)
{
	(void)state;
	forge("[]");
	assert_refused("s1: damaged: a report that is no object; run that shard again");
	forge("{}");
	assert_refused("s1: damaged: report.json says of no shard what it is; run that shard again");
	forge(reports[0]);
	assert_refused("both are shard 1; name each once");
	char text[2048];
	snprintf(text, sizeof text, "%s", reports[1]);
	memcpy(strstr(text, "--ulp 1"), "--ulp 2", 7);
	forge(text);
	assert_refused("s1: says something else of \"relaxations\" than the other shards: name shards of one run");
	snprintf(text, sizeof text, "%s", reports[1]);
	memcpy(strstr(text, "'of': 2"), "'of': 3", 7);
	forge(text);
	assert_refused("s1: shard 2 of 3; ");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(shards_merge_in_any_order, write_shards),
		cmocka_unit_test_setup(damaged_shards_are_refused, write_shards),
		cmocka_unit_test_setup(forged_reports_are_refused, write_shards),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
