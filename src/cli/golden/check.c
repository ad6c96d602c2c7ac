/* `golden check`: runs cases again and compares. Writes nothing. */
#include <stdio.h>
#include "cli/golden/golden.h"
#include "output/file.h"
#include "trace/emitted/emit.h"

const char *ts_case_word(ts_case_end end)
{
	static const char *const words[TS_N_CASE_ENDS] = {"same",    "skipped",  "known", "different",
	                                                  "missing", "unusable", "lost"};
	return words[end];
}

const char *ts_checked_stage(const ts_checked *checked) { return ts_emit_maker(checked->of->pipeline, checked->first); }

static ts_case_end of_status(ts_status status)
{
	return status == TS_OK ? TS_CASE_SAME : status == TS_DIFFERENT ? TS_CASE_DIFFERENT : TS_CASE_UNUSABLE;
}

/* Computes the case a second time. If the runs differ, the difference is not a known one, and `text` reports that. */
static ts_status compute_again(char *text, const ts_goldens *goldens, const ts_case *c, const ts_golden *computed)
{
	ts_golden again;
	char name[TS_EMIT_NAME];
	ts_status status = ts_case_compute(&again, goldens, c, &goldens->cli->job.how);
	for (u32 id = 0; id < TS_N_BUFFERS && status == TS_OK; id++) {
		if (strcmp(computed->sums.hex[id], again.sums.hex[id]) == 0) continue;
		ts_emit_name(name, c->pipeline, (ts_buffer_id)id);
		snprintf(text, TS_CASE_TEXT, "two equal runs differ: %s", name);
		break;
	}
	ts_golden_free(&again);
	return status == TS_ERROR ? TS_ERROR : TS_DIFFERENT;
}

ts_status ts_case_strays(char *text, const ts_golden *computed)
{
	if (computed->n_strays == 0) return TS_OK;
	snprintf(text, TS_CASE_TEXT, "%llu numbers that no stage may store (CONTRACT rules 12 and 24), the first in %s",
	         (unsigned long long)computed->n_strays, ts_buffer_table[computed->stray].name);
	return TS_DIFFERENT;
}

/* Compares the buffers, then the preview if the program reads PNG. */
ts_status ts_case_compare(char *text, const ts_case *c, const ts_golden_dir *dir, const ts_golden *stored,
                          const ts_golden *computed)
{
	ts_status status = ts_golden_compare(text, TS_CASE_TEXT, stored, computed, c->pipeline, c->small);
	if (status != TS_OK || ts_golden_by.read == NULL) return status;
	return ts_golden_check_preview(text, dir, computed, ts_golden_by.read);
}

static ts_case_end compare(char *text, const ts_goldens *goldens, const ts_case *c, const ts_golden_dir *dir)
{
	ts_golden stored, computed;
	ts_status status = ts_case_check_params(text, TS_CASE_TEXT, c, dir);
	if (status != TS_OK) return of_status(status);
	status = ts_golden_read(&stored, dir, c->pipeline);
	if (status == TS_OK) status = ts_golden_check_changes(dir);
	if (status == TS_OK) {
		bool listed = ts_baseline_find(&goldens->known, c->name, NULL) != NULL;
		status = ts_case_compute(&computed, goldens, c, &goldens->cli->job.how);
		if (status == TS_OK) status = ts_case_compare(text, c, dir, &stored, &computed);
		if (status == TS_OK) status = ts_case_strays(text, &computed);
		if (status == TS_DIFFERENT && listed) status = compute_again(text, goldens, c, &computed);
		ts_golden_free(&computed);
	}
	ts_golden_free(&stored);
	return of_status(status);
}

/* The first missing file of a golden; NULL: none. */
static const char *missing_file(const ts_golden_dir *dir, bool small)
{
	static const char *const names[] = {TS_GOLDEN_PARAMS, TS_GOLDEN_SUMS, TS_GOLDEN_PREVIEW, TS_GOLDEN_CHANGES};
	for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
		if (!ts_golden_has(dir, names[i])) return names[i];
	}
	return small && !ts_golden_has(dir, "small") ? "small" : NULL;
}

static ts_case_end check_case(char *text, const ts_goldens *goldens, const ts_case *c)
{
	ts_golden_dir dir;
	if (!ts_golden_has(&goldens->dir, c->name)) {
		ts_fail("%s/%s: there is no such folder", goldens->dir.path, c->name);
		return TS_CASE_MISSING;
	}
	if (ts_golden_dir_open(&dir, &goldens->dir, c->name) != TS_OK) return TS_CASE_UNUSABLE;
	const char *missing = missing_file(&dir, c->small);
	if (missing != NULL) ts_fail("%s/%s: there is no such file", dir.path, missing);
	ts_case_end end = missing != NULL ? TS_CASE_MISSING : compare(text, goldens, c, &dir);
	ts_golden_dir_close(&dir);
	return end;
}

/* How to correct an entry whose case does not differ first in the listed buffer. */
static void put_wrong_entry(ts_checked *checked, const ts_baseline *known, const ts_entry *e)
{
	char text[TS_CASE_TEXT], where[TS_CASE_TEXT];
	snprintf(text, sizeof text, "%s", checked->text);
	snprintf(where, sizeof where, "%.150s:%u: the case", known->path, (unsigned)e->line);
	if (checked->end == TS_CASE_SAME) {
		snprintf(checked->text, sizeof checked->text, "%.180s is the same now; remove the line", where);
	} else if (checked->first == TS_N_BUFFERS) {
		snprintf(checked->text, sizeof checked->text, "%.180s differs elsewhere: %.300s", where, text);
	} else {
		snprintf(checked->text, sizeof checked->text,
		         "%.180s differs first in stage %s, buffer %s; correct the line if that is known: %.150s", where,
		         ts_checked_stage(checked), ts_buffer_table[checked->first].name, text);
	}
}

/* A listed case passes if it differs first where the baseline expects that. */
static void judge_known(ts_checked *checked, const ts_goldens *goldens)
{
	const ts_entry *e = ts_baseline_find(&goldens->known, checked->of->name, NULL);
	if (e == NULL || checked->end > TS_CASE_DIFFERENT) return;
	const bool known = checked->first != TS_N_BUFFERS && strcmp(ts_buffer_table[checked->first].name, e->buffer) == 0;
	if (!known) put_wrong_entry(checked, &goldens->known, e);
	if (known) checked->why = e->reason;
	checked->end = known ? TS_CASE_KNOWN : TS_CASE_DIFFERENT;
}

/* NULL: the case is not skipped. */
static const char *why_skipped(const ts_goldens *goldens, const ts_case *c)
{
	const ts_entry *skip = ts_baseline_find(&goldens->skips, c->name, NULL);
	if (skip != NULL) return skip->reason;
	return goldens->cli->no_device[0] != 0 ? goldens->cli->no_device : NULL;
}

static void check(ts_checked *checked, const ts_goldens *goldens, const ts_case *c)
{
	double began = ts_seconds();
	*checked = (ts_checked){.of = c, .end = TS_CASE_SKIPPED, .first = TS_N_BUFFERS, .why = why_skipped(goldens, c)};
	if (checked->why != NULL) return;
	checked->why = "";
	checked->end = check_case(checked->text, goldens, c);
	if (checked->end >= TS_CASE_MISSING) snprintf(checked->text, sizeof checked->text, "%s", ts_error_message());
	checked->first = ts_golden_named(checked->text, c->pipeline);
	judge_known(checked, goldens);
	checked->seconds = ts_seconds() - began;
}

/* Adds the texts to an earlier worker's result. */
static void recall(ts_checked *checked, const ts_goldens *goldens, const ts_case *c)
{
	checked->of = c;
	checked->why = "";
	if (checked->end == TS_CASE_SKIPPED) checked->why = why_skipped(goldens, c);
	if (checked->end == TS_CASE_KNOWN) checked->why = ts_baseline_find(&goldens->known, c->name, NULL)->reason;
}

/* Records the case that an earlier worker died on. */
static void lose(ts_checked *checked, const ts_steps *steps, const ts_case *c)
{
	*checked = (ts_checked){.of = c, .end = TS_CASE_LOST, .first = TS_N_BUFFERS, .why = ""};
	snprintf(checked->text, sizeof checked->text, "%s: %s", c->name, steps->why);
	checked->seconds = steps->lost_s;
}

/* Runs the next case, unless an earlier worker died on it. */
static void take_step(ts_golden_kept *kept, const ts_goldens *goldens, const ts_case *c)
{
	ts_steps *steps = &kept->steps;
	ts_checked *checked = &kept->checked[steps->n];
	steps->began = ts_seconds();
	steps->at_work = true;
	if (steps->why[0] != 0)
		lose(checked, steps, c);
	else
		check(checked, goldens, c);
	steps->why[0] = 0;
	steps->n++;
	steps->at_work = false;
	steps->began = ts_seconds();
}

static ts_status print_line(const ts_checked *checked, bool quiet)
{
	if (quiet && checked->end < TS_CASE_DIFFERENT) return TS_OK;
	printf("%-10s %s%s%s%s%s\n", ts_case_word(checked->end), checked->of->name, checked->why[0] != 0 ? "  " : "",
	       checked->why, checked->text[0] != 0 ? "  " : "", checked->text);
	return ts_file_print("", 0);
}

/* Prints the counts, and returns how the command ends. */
static ts_status sum_up(const ts_cli *cli, const ts_checked *checked, u32 n, bool print)
{
	u32 count[TS_N_CASE_ENDS] = {0};
	const ts_checked *first = NULL;
	for (u32 i = 0; i < n; i++) {
		count[checked[i].end]++;
		if (first == NULL && checked[i].end >= TS_CASE_MISSING) first = &checked[i];
	}
	u32 passed = count[TS_CASE_SAME] + count[TS_CASE_KNOWN], skipped = count[TS_CASE_SKIPPED];
	if (print) {
		printf("%u passed, %u failed, %u skipped\n", (unsigned)passed, (unsigned)(n - passed - skipped),
		       (unsigned)skipped);
	}
	if (first == NULL && cli->no_device[0] == 0) return count[TS_CASE_DIFFERENT] != 0 ? TS_DIFFERENT : TS_OK;
	if (first == NULL) {
		ts_fail("%s", cli->no_device);
		return TS_SKIPPED;
	}
	if (first->end != TS_CASE_MISSING) return ts_fail("golden: %s", first->text);
	return ts_fail("golden: %s; \"golden new\" proposes and \"golden bless\" accepts a golden", first->text);
}

ts_status ts_golden_check_action(const ts_goldens *goldens)
{
	static ts_golden_kept alone;
	const ts_cli *cli = goldens->cli;
	ts_golden_kept *kept = cli->steps != NULL ? (ts_golden_kept *)cli->steps : &alone;
	ts_checked *checked = kept->checked;
	bool print = !cli->job.output.json && !cli->judging.tap;
	u32 n = 0;
	for (u32 i = 0; i < goldens->n_chosen; i++) {
		if (!ts_shard_has(cli->job.shard, i)) continue;
		bool printed = n < kept->steps.n;
		if (printed)
			recall(&checked[n], goldens, goldens->chosen[i]);
		else
			take_step(kept, goldens, goldens->chosen[i]);
		if (!printed && print && print_line(&checked[n], cli->job.output.quiet) != TS_OK) return TS_ERROR;
		n++;
	}
	if (cli->job.shard.of > 0 && n == 0) ts_shard_say_empty(cli->job.shard, goldens->n_chosen);
	ts_status status = sum_up(cli, checked, n, print && !cli->job.output.quiet);
	if (ts_golden_report != NULL && ts_golden_report(goldens, checked, n, status) != TS_OK) return TS_ERROR;
	if (status != TS_OK && status != TS_DIFFERENT) return sum_up(cli, checked, n, false);
	return status;
}
