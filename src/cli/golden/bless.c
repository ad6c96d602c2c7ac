/* `golden bless`: puts a proposal in the place of a golden, with a reason. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/golden/golden.h"
#include "output/file.h"
#include "output/folder.h"

/* Accepts only results of C kernels from a known state of the source. */
static ts_status check_build(const ts_job *job)
{
	const char *commit = ts_commit();
	if (strcmp(commit, "unknown") == 0) {
		return ts_fail("golden bless: this build does not know its commit; build from a git checkout or a release");
	}
	if (strstr(commit, "-dirty") != NULL) {
		return ts_fail("golden bless: this build has changes that are not committed (%s); commit, and build again",
		               commit);
	}
	if (job->backend == ts_backend_kinds[0]) return TS_OK;
	return ts_fail("golden bless: goldens are not made by the backend %s, but by %s", job->backend->name,
	               ts_backend_kinds[0]->name);
}

static ts_status check_values(const ts_case *c, const ts_golden *golden)
{
	char text[TS_CASE_TEXT];
	if (ts_case_strays(text, golden) != TS_OK) return ts_fail("golden bless: %s: %s", c->name, text);
	if (ts_golden_is_constant(golden)) return ts_fail("golden bless: %s: the image is of one colour", c->name);
	return TS_OK;
}

/* The proposal is what this build computes, by the kernels alone. */
static ts_status check_proposal(const ts_goldens *goldens, const ts_case *c, const ts_golden_dir *dir)
{
	ts_golden proposed, computed;
	char text[TS_CASE_TEXT];
	ts_status status = ts_case_check_params(text, sizeof text, c, dir);
	if (status == TS_DIFFERENT) ts_fail("golden bless: %s: %s; run \"golden new %s\"", c->name, text, c->name);
	if (status != TS_OK) return TS_ERROR;
	if (ts_golden_read(&proposed, dir, c->pipeline) != TS_OK) {
		ts_golden_free(&proposed);
		return TS_ERROR;
	}
	ts_how plain = {.threads = goldens->cli->job.how.threads, .no_fast_paths = true};
	status = ts_case_compute(&computed, goldens, c, &plain);
	if (status == TS_OK) status = ts_case_compare(text, c, dir, &proposed, &computed);
	if (status == TS_DIFFERENT) {
		ts_fail("golden bless: %s: this build computes something else: %s; run \"golden new %s\"", c->name, text,
		        c->name);
	}
	if (status == TS_OK) status = check_values(c, &computed);
	ts_golden_free(&computed);
	ts_golden_free(&proposed);
	return status == TS_OK ? TS_OK : TS_ERROR;
}

typedef struct {
	char *data;
	size_t bytes;
} text;

/* Empty if the golden has none. */
static ts_status read_text(text *t, const ts_golden_dir *dir, const char *name)
{
	*t = (text){.data = NULL};
	if (!ts_golden_has(dir, name)) return TS_OK;
	return ts_golden_read_file(&t->data, &t->bytes, dir, name, TS_REASONS_BYTES);
}

static bool ends_with(const text *t, const char *line)
{
	size_t n = strlen(line);
	return t->bytes > n && t->data[t->bytes - 1] == '\n' && memcmp(t->data + t->bytes - 1 - n, line, n) == 0 &&
	       (t->bytes == n + 1 || t->data[t->bytes - 2 - n] == '\n');
}

/* True if an interrupted bless wrote this. */
static bool is_blessed(const text sums[2], const text *changes, const char *reason)
{
	bool same = sums[0].bytes > 0 && sums[0].bytes == sums[1].bytes;
	return same && memcmp(sums[0].data, sums[1].data, sums[0].bytes) == 0 && ends_with(changes, reason);
}

/* Writes the old lines, then the reason. */
static ts_status write_changes(const char *reason, const ts_golden_dir *old, const ts_golden_dir *proposed)
{
	text changes, sums[2] = {{NULL, 0}, {NULL, 0}};
	ts_file_text out;
	ts_status status = read_text(&changes, old, TS_GOLDEN_CHANGES);
	if (status == TS_OK) status = read_text(&sums[0], old, TS_GOLDEN_SUMS);
	if (status == TS_OK) status = read_text(&sums[1], proposed, TS_GOLDEN_SUMS);
	const char *path = status == TS_OK ? ts_folder_file(TS_GOLDEN_CHANGES) : NULL;
	status = path != NULL ? ts_file_text_begin(&out, path) : TS_ERROR;
	if (status == TS_OK) {
		if (changes.bytes > 0) fwrite(changes.data, 1, changes.bytes, out.out);
		if (!is_blessed(sums, &changes, reason)) fprintf(out.out, "%s\n", reason);
		status = ts_file_text_write(&out, path);
	}
	free(changes.data);
	free(sums[0].data);
	free(sums[1].data);
	return status;
}

/* The golden and its reason change in one step. */
static ts_status replace(const ts_goldens *goldens, const ts_case *c, const ts_golden_dir *proposed)
{
	char path[TS_CASE_PATH];
	ts_golden_dir old = {.fd = -1};
	ts_case_path(path, goldens, c, "");
	ts_status status = ts_folder_begin(path, ts_golden_judge);
	if (status != TS_OK) return status;
	if (ts_golden_has(&goldens->dir, c->name)) status = ts_golden_dir_open(&old, &goldens->dir, c->name);
	if (status == TS_OK) status = ts_golden_copy(proposed);
	if (status == TS_OK) status = write_changes(goldens->cli->golden.reason, &old, proposed);
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) ts_folder_discard();
	ts_golden_dir_close(&old);
	return status;
}

static ts_status bless(const ts_goldens *goldens, const ts_case *c, const ts_golden_dir *proposed)
{
	if (!ts_golden_has(proposed, TS_GOLDEN_PREVIEW)) {
		return ts_fail("golden bless: no preview.png in %s; touchstone-core writes none", proposed->path);
	}
	ts_status status = check_proposal(goldens, c, proposed);
	if (status == TS_OK) status = replace(goldens, c, proposed);
	if (status == TS_OK && ts_folder_remove(proposed->path) != TS_OK) {
		ts_say("%s stays, though it is blessed: %s", proposed->path, ts_error_message());
	}
	return status;
}

static ts_status bless_case(const ts_goldens *goldens, const ts_case *c)
{
	ts_golden_dir proposed;
	char name[TS_CASE_NAME + 8], path[TS_CASE_PATH];
	ts_case_path(path, goldens, c, ".new");
	ts_folder_clear(path, 0);
	snprintf(name, sizeof name, "%s.new", c->name);
	if (!ts_golden_has(&goldens->dir, name)) {
		return ts_fail("golden bless: nothing new: run \"golden new %s\" first", c->name);
	}
	if (ts_golden_dir_open(&proposed, &goldens->dir, name) != TS_OK) return TS_ERROR;
	ts_status status = bless(goldens, c, &proposed);
	ts_golden_dir_close(&proposed);
	if (status == TS_OK && !goldens->cli->job.output.quiet) printf("blessed    %s\n", c->name);
	return status;
}

ts_status ts_golden_bless_action(const ts_goldens *goldens)
{
	const char *reason = goldens->cli->golden.reason;
	if (goldens->cli->n_arguments < 2) {
		return ts_fail("golden bless: which case? Write golden bless CASE --reason TEXT");
	}
	if (reason == NULL) return ts_fail("golden bless: no reason; write --reason TEXT");
	if (ts_reason_check(reason) != TS_OK) return ts_fail("golden bless: %s", ts_error_message());
	ts_status status = check_build(&goldens->cli->job);
	for (u32 i = 0; i < goldens->n_chosen && status == TS_OK; i++) status = bless_case(goldens, goldens->chosen[i]);
	return status;
}
