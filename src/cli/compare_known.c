/* Known differences of a comparison. */
#include "compare_known.h"
#include <stdlib.h>
#include <string.h>

static void name_case(char name[TS_COMPARE_CASE], const ts_pipeline *pipeline)
{
	snprintf(name, TS_COMPARE_CASE, "%s/%s", pipeline->effect->name, pipeline->name);
}

static const ts_pipeline *find_case(const void *user, const char *name)
{
	(void)user;
	char own[TS_COMPARE_CASE];
	ts_nearest nearest = ts_nearest_begin(name);
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		name_case(own, *at);
		if (strcmp(own, name) == 0) return *at;
		if (strchr(name, '/') == NULL && strcmp((*at)->name, name) == 0) {
			ts_fail("no case \"%.60s\"; write EFFECT/METHOD, for instance %s", name, own);
			return NULL;
		}
		ts_nearest_offer(&nearest, (*at)->name);
	}
	ts_fail("no case \"%.60s\"; write EFFECT/METHOD, as \"%s list methods\" has them", name, ts_program);
	return NULL;
}

static ts_status check_buffer(const void *user, const char *name)
{
	(void)user;
	ts_nearest nearest = ts_nearest_begin(name);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) ts_nearest_offer(&nearest, ts_buffer_table[id].name);
	if (nearest.distance == 0) return TS_OK;
	return ts_fail("no buffer \"%.60s\"%s", name, ts_nearest_hint(&nearest, NULL));
}

static ts_status join_ignored(ts_compare_lists *lists, const char *ignore)
{
	size_t bytes = ignore != NULL ? strlen(ignore) + 2 : 1, used = 0;
	for (size_t i = 0; i < lists->skips.n; i++) bytes += strlen(lists->skips.entry[i].name) + 1;
	if (bytes == 1) return TS_OK;
	lists->ignore = ts_alloc(bytes, 1, "the names of what is skipped");
	if (lists->ignore == NULL) return TS_ERROR;
	if (ignore != NULL) used = (size_t)snprintf(lists->ignore, bytes, "%s", ignore);
	for (size_t i = 0; i < lists->skips.n; i++) {
		used += (size_t)snprintf(lists->ignore + used, bytes - used, "%s%s", used > 0 ? "," : "",
		                         lists->skips.entry[i].name);
	}
	return TS_OK;
}

ts_status ts_compare_lists_read(ts_compare_lists *lists, const ts_cli *cli, const ts_pipeline *pipeline)
{
	const ts_judging *judging = &cli->judging;
	ts_status status = TS_OK;
	name_case(lists->name, pipeline);
	if (judging->baseline != NULL) status = ts_baseline_read(&lists->known, judging->baseline, find_case, NULL);
	if (judging->skip != NULL && status == TS_OK) {
		status = ts_baseline_skips(&lists->skips, judging->skip, check_buffer, NULL);
	}
	return status == TS_OK ? join_ignored(lists, judging->relaxations.ignore) : status;
}

void ts_compare_lists_free(ts_compare_lists *lists)
{
	ts_baseline_free(&lists->known);
	ts_baseline_free(&lists->skips);
	free(lists->ignore);
	lists->ignore = NULL;
}

const ts_entry *ts_compare_known(const ts_compare_lists *lists, ts_buffer_id id)
{
	return ts_baseline_find(&lists->known, lists->name, id);
}

const char *ts_compare_skipped(const ts_compare_lists *lists, ts_buffer_id id)
{
	const ts_entry *skip = ts_baseline_find(&lists->skips, ts_buffer_table[id].name, TS_N_BUFFERS);
	return skip != NULL ? skip->reason : "";
}

bool ts_compare_stale(char text[TS_LINE_TEXT], const ts_compare_lists *lists, const ts_comparison *c, size_t i)
{
	const ts_entry *e = &lists->known.entry[i];
	ts_judgement judgement = c->verdict[e->buffer].judgement;
	bool other = strcmp(e->name, lists->name) != 0 || (lists->only != NULL && !lists->only[e->buffer]);
	if (other || judgement == TS_UNLIKE) return false;
	const char *now = judgement == TS_SAME      ? "is the same now; remove the line"
	                  : judgement == TS_MISSING ? "is missing; give it, or remove the line"
	                                            : "is not judged; remove the line";
	snprintf(text, TS_LINE_TEXT, "%.1000s:%u: buffer %s of stage %s %s", lists->known.path, (unsigned)e->line,
	         ts_buffer_table[e->buffer].name, e->stage, now);
	return true;
}

void ts_compare_report_known(ts_report *report, const ts_compare_lists *lists, const ts_comparison *c)
{
	char text[TS_LINE_TEXT];
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_verdict *v = &c->verdict[id];
		const ts_entry *e = v->judgement == TS_UNLIKE && !v->aside ? ts_compare_known(lists, (ts_buffer_id)id) : NULL;
		const char *skipped = v->judgement == TS_IGNORED ? ts_compare_skipped(lists, (ts_buffer_id)id) : "";
		if (e != NULL) ts_report_line(report, "known: %s: %s", ts_buffer_table[id].name, e->reason);
		if (skipped[0] != 0) ts_report_line(report, "skipped: %s: %s", ts_buffer_table[id].name, skipped);
	}
	for (size_t i = 0; i < lists->known.n; i++) {
		if (ts_compare_stale(text, lists, c, i)) ts_report_line(report, "%s", text);
	}
}
