/* `golden bless`: puts what was proposed in the place of a golden, for a reason. */
#include <stdio.h>
#include <string.h>
#include "golden.h"

static const char *const promoted[] = {"params.txt", "preview.png", NULL};

/* A reason is one line that says something. */
static ts_status check_reason(const char *reason)
{
	if (reason == NULL || reason[strspn(reason, " \t")] == 0) {
		return ts_fail("golden bless: no reason; write --reason TEXT");
	}
	char clean[TS_REASON_BYTES + 1];
	if (strlen(reason) > TS_REASON_BYTES) {
		return ts_fail("golden bless: a reason has at most %d bytes", TS_REASON_BYTES);
	}
	strcpy(clean, reason);
	ts_line_clean(clean);
	if (strcmp(clean, reason) == 0) return TS_OK;
	return ts_fail("golden bless: a reason is one line, without control characters");
}

/* Only what a known state of the source computed by the reference is accepted. */
static ts_status check_build(const ts_job *job)
{
	const char *commit = ts_commit();
	if (strcmp(commit, "unknown") == 0) {
		return ts_fail("golden bless: this build does not know its commit; build from a git checkout");
	}
	if (strstr(commit, "-dirty") != NULL) {
		return ts_fail("golden bless: this build has changes that are not committed (%s); commit, and build again",
		               commit);
	}
	if (job->backend == ts_backend_kinds[0]) return TS_OK;
	return ts_fail("golden bless: backend %s is not the reference, %s", job->backend->name, ts_backend_kinds[0]->name);
}

static ts_status check_values(const ts_case *c, const ts_golden *golden)
{
	if (golden->infinite != TS_N_BUFFERS) {
		return ts_fail("golden bless: %s: %llu floats are no numbers or not finite, the first in %s", c->name,
		               (unsigned long long)golden->n_infinite, ts_buffer_table[golden->infinite].name);
	}
	if (ts_golden_is_constant(golden)) return ts_fail("golden bless: %s: the image is of one colour", c->name);
	return TS_OK;
}

/* What was proposed is what this build computes, by the kernels alone. */
static ts_status check_proposal(const ts_goldens *goldens, const ts_case *c, const ts_golden_dir *dir)
{
	ts_golden proposed, computed;
	char text[512];
	ts_status status = ts_case_check_params(text, sizeof text, c, dir, "params.txt.new");
	if (status == TS_DIFFERENT) ts_fail("golden bless: %s: %s; run \"golden new %s\"", c->name, text, c->name);
	if (status != TS_OK) return TS_ERROR;
	if (ts_golden_read(&proposed, dir, c->pipeline, ".new") != TS_OK) {
		ts_golden_free(&proposed);
		return TS_ERROR;
	}
	ts_how plain = {.threads = goldens->job->how.threads, .reference = true};
	status = ts_case_compute(&computed, c, &plain);
	if (status == TS_OK) status = ts_golden_compare(text, sizeof text, &proposed, &computed, c->pipeline, c->small);
	if (status == TS_DIFFERENT) {
		ts_fail("golden bless: %s: this build computes something else: %s; run \"golden new %s\"", c->name, text,
		        c->name);
	}
	if (status == TS_OK) status = check_values(c, &computed);
	ts_golden_free(&computed);
	ts_golden_free(&proposed);
	return status == TS_OK ? TS_OK : TS_ERROR;
}

static ts_status bless(const ts_goldens *goldens, const ts_case *c, const ts_golden_dir *dir)
{
	char line[TS_CASE_NAME + TS_REASON_BYTES + 4];
	if (!ts_golden_has(dir, "SHA256SUMS.new") || !ts_golden_has(dir, "params.txt.new")) {
		return ts_fail("golden bless: nothing new in %s; run \"golden new %s\" first", dir->path, c->name);
	}
	if (!ts_golden_has(dir, "preview.png.new")) {
		return ts_fail("golden bless: no preview.png.new in %s; touchstone-core writes none", dir->path);
	}
	if (check_proposal(goldens, c, dir) != TS_OK) return TS_ERROR;
	snprintf(line, sizeof line, "%s: %s", c->name, goldens->reason);
	ts_status status = ts_golden_add_line(&goldens->dir, "CHANGES", line);
	return status == TS_OK ? ts_golden_promote(dir, promoted) : status;
}

ts_status ts_golden_bless_action(const ts_goldens *goldens, const ts_case *only)
{
	ts_golden_dir dir;
	if (only == NULL) return ts_fail("golden bless: which case? Write golden bless CASE --reason TEXT");
	if (check_reason(goldens->reason) != TS_OK || check_build(goldens->job) != TS_OK) return TS_ERROR;
	if (!ts_golden_has(&goldens->dir, only->name)) {
		return ts_fail("golden bless: nothing new: run \"golden new %s\" first", only->name);
	}
	if (ts_golden_dir_open(&dir, &goldens->dir, only->name) != TS_OK) return TS_ERROR;
	ts_status status = bless(goldens, only, &dir);
	ts_golden_dir_close(&dir);
	if (status == TS_OK) printf("blessed    %s\n", only->name);
	return status;
}
