/* `golden check`: runs cases again and compares. Writes nothing. */
#include <stdio.h>
#include "../output/file.h"
#include "golden.h"

enum { TEXT_BYTES = 512, N_VERDICTS = 4 };
typedef enum { SAME, DIFFERENT, MISSING, UNUSABLE } verdict;
static const char *const words[N_VERDICTS] = {"same", "different", "missing", "unusable"};

static verdict of_status(ts_status status)
{
	return status == TS_OK ? SAME : status == TS_DIFFERENT ? DIFFERENT : UNUSABLE;
}

static verdict compare(char *text, const ts_goldens *goldens, const ts_case *c, const ts_golden_dir *dir)
{
	ts_golden stored, computed;
	ts_status status = ts_case_check_params(text, TEXT_BYTES, c, dir);
	if (status != TS_OK) return of_status(status);
	status = ts_golden_read(&stored, dir, c->pipeline);
	if (status == TS_OK) {
		status = ts_case_compute(&computed, c, &goldens->job->how);
		if (status == TS_OK) status = ts_golden_compare(text, TEXT_BYTES, &stored, &computed, c->pipeline, c->small);
		ts_golden_free(&computed);
	}
	ts_golden_free(&stored);
	return of_status(status);
}

/* The file without which there is no golden; NULL: all are there. */
static const char *missing_file(const ts_golden_dir *dir, bool small)
{
	if (!ts_golden_has(dir, TS_GOLDEN_PARAMS)) return TS_GOLDEN_PARAMS;
	if (!ts_golden_has(dir, TS_GOLDEN_SUMS)) return TS_GOLDEN_SUMS;
	return small && !ts_golden_has(dir, "small") ? "small" : NULL;
}

static verdict check_case(char *text, const ts_goldens *goldens, const ts_case *c)
{
	ts_golden_dir dir;
	text[0] = 0;
	if (!ts_golden_has(&goldens->dir, c->name)) {
		ts_fail("%s/%s: there is no such folder", goldens->dir.path, c->name);
		return MISSING;
	}
	if (ts_golden_dir_open(&dir, &goldens->dir, c->name) != TS_OK) return UNUSABLE;
	const char *missing = missing_file(&dir, c->small);
	if (missing != NULL) ts_fail("%s/%s: there is no such file", dir.path, missing);
	verdict v = missing != NULL ? MISSING : compare(text, goldens, c, &dir);
	ts_golden_dir_close(&dir);
	return v;
}

ts_status ts_golden_check_action(const ts_goldens *goldens, const ts_case *only)
{
	u32 count[N_VERDICTS] = {0};
	char text[TEXT_BYTES], first[TEXT_BYTES] = "";
	for (u32 i = 0; i < goldens->n_cases; i++) {
		const ts_case *c = &goldens->cases[i];
		if (only != NULL && c != only) continue;
		verdict v = check_case(text, goldens, c);
		count[v]++;
		bool failed = v == MISSING || v == UNUSABLE;
		if (failed && first[0] == 0) snprintf(first, sizeof first, "%s", ts_error_message());
		const char *why = failed ? ts_error_message() : text;
		printf("%-10s %s%s%s\n", words[v], c->name, v != SAME ? "  " : "", why);
		if (ts_file_print("", 0) != TS_OK) return TS_ERROR;
	}
	u32 without = count[MISSING] + count[UNUSABLE];
	printf("%u passed, %u failed, 0 skipped\n", (unsigned)count[SAME], (unsigned)(count[DIFFERENT] + without));
	if (without == 0) return count[DIFFERENT] != 0 ? TS_DIFFERENT : TS_OK;
	return ts_fail("golden: %s; \"golden new\" proposes and \"golden bless\" accepts a golden", first);
}
