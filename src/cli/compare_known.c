/* Known differences of a comparison. */
#include "cli/compare_known.h"
#include <stdlib.h>
#include <string.h>

static void name_case(char name[TS_COMPARE_CASE], const char *effect, const char *method)
{
	snprintf(name, TS_COMPARE_CASE, "%s/%s", effect, method);
}

static ts_status find_case(const void *user, const char *name, const char **effect, const char **method)
{
	(void)user;
	const ts_method_info *m;
	char own[TS_COMPARE_CASE];
	for (size_t i = 0; (m = ts_method_at(i)) != NULL; i++) {
		name_case(own, m->effect, m->name);
		*effect = m->effect;
		*method = m->name;
		if (strcmp(own, name) == 0) return TS_OK;
		if (strchr(name, '/') == NULL && strcmp(m->name, name) == 0) {
			return ts_fail("no case \"%.60s\"; write EFFECT/METHOD, for instance %s", name, own);
		}
	}
	return ts_fail("no case \"%.60s\"; write EFFECT/METHOD, as \"%s list methods\" has them", name, ts_program);
}

static ts_status check_buffer(const void *user, const char *name)
{
	(void)user;
	const ts_buffer_info *buffer;
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; (buffer = ts_buffer_at(i)) != NULL; i++) ts_nearest_offer(&nearest, buffer->name);
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

ts_status ts_compare_lists_read(ts_compare_lists *lists, const ts_cli *cli, const ts_trace_info *of)
{
	const ts_judging *judging = &cli->judging;
	ts_status status = TS_OK;
	name_case(lists->name, of->effect, of->method);
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

const ts_entry *ts_compare_known(const ts_compare_lists *lists, const char *buffer)
{
	return ts_baseline_find(&lists->known, lists->name, buffer);
}

const char *ts_compare_skipped(const ts_compare_lists *lists, const char *buffer)
{
	const ts_entry *skip = ts_baseline_find(&lists->skips, buffer, NULL);
	return skip != NULL ? skip->reason : "";
}

bool ts_compare_stale(char text[TS_KNOWN_TEXT], const ts_compare_lists *lists, const ts_compared *c, size_t i)
{
	size_t place;
	const ts_entry *e = &lists->known.entry[i];
	const ts_verdict_info *v = ts_compared_find(c, e->buffer, &place);
	const ts_judgement judgement = v != NULL ? v->judgement : TS_NOT_JUDGED;
	const bool own = lists->stages == NULL || ts_words_listed(lists->stages, e->stage);
	if (strcmp(e->name, lists->name) != 0 || !own || judgement == TS_UNLIKE) return false;
	const char *now = judgement == TS_SAME      ? "is the same now; remove the line"
	                  : judgement == TS_MISSING ? "is missing; give it, or remove the line"
	                                            : "is not judged; remove the line";
	snprintf(text, TS_KNOWN_TEXT, "%.1000s:%u: buffer %s of stage %s %s", lists->known.path, (unsigned)e->line,
	         e->buffer, e->stage, now);
	return true;
}

void ts_compare_report_known(ts_report *report, const ts_compare_lists *lists, const ts_compared *c)
{
	char text[TS_KNOWN_TEXT];
	const ts_verdict_info *v;
	for (size_t i = 0; (v = ts_verdicts_at(c->verdicts, i)) != NULL; i++) {
		const ts_entry *e = v->judgement == TS_UNLIKE ? ts_compare_known(lists, v->buffer) : NULL;
		const char *skipped = v->judgement == TS_IGNORED ? ts_compare_skipped(lists, v->buffer) : "";
		if (e != NULL) ts_report_line(report, "known: %s: %s", v->buffer, e->reason);
		if (skipped[0] != 0) ts_report_line(report, "skipped: %s: %s", v->buffer, skipped);
	}
	for (size_t i = 0; i < lists->known.n; i++) {
		if (ts_compare_stale(text, lists, c, i)) ts_report_line(report, "%s", text);
	}
}
