/* Goldens on disk: what was computed and written is what is read, in every file; and damage to the list of digests or
 * beside it is refused by name. */
#include <sys/stat.h>
#include "golden/golden.h"
#include "output/folder.h"
#include "tests/methods/small.h"
#include "tests/scratch.h"
#include "tests/status.h"

enum { MOST = 64 << 10 };

static ts_golden computed, stored, tiny;
static const ts_pipeline *epr;
static char sums[MOST];
static size_t n_sums;

static ts_status judge(const char *dir)
{
	(void)dir;
	return TS_OK;
}

static void make(ts_golden *golden, const char *spec, const char *name)
{
	ts_params params = small_params(24, 16);
	ts_scene *scene;
	params.reflectors_count = 1;
	params.reflectors_px = 12;
	require(ts_scene_load(&scene, spec, &params, NULL));
	const ts_golden_job job = {.pipeline = epr, .scene = scene, .params = &params, .how = {.threads = 1}};
	require(ts_golden_compute(golden, &job));
	ts_scene_free(scene);
	require(ts_folder_begin(scratch_path("%s", name), judge));
	require(ts_golden_write(golden, epr, true));
	require(ts_folder_commit());
}

static int begin(void **state)
{
	if (scratch_begin(state) != 0) return -1;
	epr = ts_pipeline_find("reflections", "epr");
	make(&computed, SMALL_SCENE, "golden");
	make(&tiny, "scenes/triangle.gltf", "tiny");
	FILE *file = fopen(scratch_path("golden/SHA256SUMS"), "r");
	if (file == NULL) return -1;
	n_sums = fread(sums, 1, MOST - 1, file);
	fclose(file);
	return 0;
}

static int end(void **state)
{
	ts_golden_free(&computed);
	ts_golden_free(&stored);
	ts_golden_free(&tiny);
	return scratch_remove(state);
}

static ts_status read_back(const char *path)
{
	ts_golden_dir dir;
	ts_golden_free(&stored);
	require(ts_golden_dir_open(&dir, NULL, path));
	ts_status status = ts_golden_read(&stored, &dir, epr);
	ts_golden_dir_close(&dir);
	return status;
}

/* A kept file has the digest that the run had of it, by another way. */
static void what_was_written_is_read_back(void **state)
{
	(void)state;
	char text[512];
	u32 n_small = 0, n_listed = 0;
	require(read_back(scratch_path("golden")));
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_golden_file *a = &computed.file[id], *b = &stored.file[id];
		assert_string_equal(stored.sums.hex[id], computed.sums.hex[id]);
		n_listed += stored.sums.hex[id][0] != 0;
		if (!ts_golden_is_small(&computed, (ts_buffer_id)id)) continue;
		assert_int_equal(a->taken, a->bytes);
		assert_int_equal(b->bytes, a->bytes);
		assert_memory_equal(b->data, a->data, a->bytes);
		assert_string_equal(b->hex, stored.sums.hex[id]);
		n_small++;
	}
	assert_true(n_small > 10 && n_listed >= n_small);
	assert_int_equal(stored.sums.hex[0][0] != 0, computed.sums.hex[0][0] != 0);
	assert_int_equal(ts_golden_compare(text, sizeof text, &stored, &computed, epr, true), TS_OK);
	assert_string_equal(text, "");
	assert_int_equal(computed.stray, stored.stray);
	assert_int_equal(computed.n_strays, 0);
}

/* Every file of a run on one triangle is small, that of the first buffer too. */
static void a_tiny_golden_keeps_every_file(void **state)
{
	(void)state;
	require(read_back(scratch_path("tiny")));
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_golden_file *a = &tiny.file[id], *b = &stored.file[id];
		assert_int_equal(a->data != NULL, tiny.sums.hex[id][0] != 0);
		assert_int_equal(a->bytes, b->bytes);
		if (a->data != NULL) assert_memory_equal(a->data, b->data, a->bytes);
	}
	assert_non_null(stored.file[0].data);
}

static void write_sums(const char *a, const char *b, size_t n)
{
	mkdir(scratch_path("bad"), 0700);
	FILE *file = fopen(scratch_path("bad/SHA256SUMS"), "w");
	assert_non_null(file);
	fputs(a, file);
	assert_int_equal(fwrite(b, 1, n, file), n);
	fclose(file);
}

static void refuses(const char *a, const char *b, size_t n, const char *words)
{
	write_sums(a, b, n);
	refused(read_back(scratch_path("bad")), words);
}

static void bad_lines_of_digests_are_refused(void **state)
{
	(void)state;
	char twice[512], odd[512];
	size_t line = (size_t)(strchr(sums, '\n') - sums) + 1;
	snprintf(twice, sizeof twice, "%.*s", (int)line, sums);
	refuses(twice, sums, n_sums, "stands there twice");
	snprintf(odd, sizeof odd, "%.64s  nothing.npy\n", sums);
	refuses(odd, sums, n_sums, "epr writes no file \"nothing.npy\"");
	snprintf(odd, sizeof odd, "%.63s  x\n", sums);
	refuses(odd, sums, n_sums, "is not a digest, two blanks and a name");
	snprintf(odd, sizeof odd, "%.64s %.*s", sums, (int)(line - 66), sums + 66);
	refuses(odd, sums + line, n_sums - line, "is not a digest, two blanks and a name");
	refuses("", sums, n_sums - 1, "not lines of text");
	refuses("", sums, 0, "not lines of text");
	refuses("", "\0\n", 2, "not lines of text");
	write_sums("", sums, n_sums);
	require(read_back(scratch_path("bad")));
	remove(scratch_path("bad/SHA256SUMS"));
	assert_int_equal(read_back(scratch_path("bad")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "SHA256SUMS: No such file"));
}

static void put(const char *path)
{
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	fclose(file);
}

static void files_of_strangers_are_refused(void **state)
{
	(void)state;
	require(ts_golden_judge(scratch_path("golden")));
	put(scratch_path("golden/CHANGES"));
	put(scratch_path("golden/params.txt"));
	put(scratch_path("golden/preview.png"));
	require(ts_golden_judge(scratch_path("golden")));
	put(scratch_path("golden/notes"));
	assert_int_equal(ts_golden_judge(scratch_path("golden")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "holds notes, which is no part of a golden"));
	put(scratch_path("golden/small/notes"));
	assert_int_equal(read_back(scratch_path("golden")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "\"notes\" is not a file that SHA256SUMS names"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_was_written_is_read_back),
		cmocka_unit_test(a_tiny_golden_keeps_every_file),
		cmocka_unit_test(bad_lines_of_digests_are_refused),
		cmocka_unit_test(files_of_strangers_are_refused),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
