/* The verdicts of stages: as text, as JSON, as TAP and as JUnit XML. */
#include <string.h>
#include "cli/compare_known.h"

enum { MOST_BUFFERS = 64 };

/* A stage, or the scene, which is first. */
typedef struct {
	const ts_compared *of;
	size_t next; /* the next step of the method, from 0 */
	bool begun;
	const char *name;
	u32 number;
	ts_judgement verdict;          /* of its first different buffer, otherwise whether any was judged */
	const char *word;              /* the verdict as a word */
	const char *why;               /* a buffer is not judged, or is skipped; otherwise "" */
	const ts_compare_lists *lists; /* NULL: nothing is skipped */
	size_t unlike[MOST_BUFFERS];   /* places of buffers */
	u32 n_unlike;
	double seconds; /* spent on judging */
} stages;

static void add_buffer(stages *s, const ts_verdict_info *v, size_t place)
{
	if (v->judgement == TS_UNLIKE && s->n_unlike < MOST_BUFFERS) s->unlike[s->n_unlike++] = place;
	if (v->judgement == TS_UNABLE) s->why = v->why;
	if (v->judgement == TS_IGNORED && s->lists != NULL) s->why = ts_compare_skipped(s->lists, v->buffer);
	s->seconds += v->seconds;
	if (v->judgement > s->verdict) {
		s->verdict = v->judgement;
		s->word = v->verdict;
	}
}

static void add_buffers(stages *s)
{
	const ts_verdict_info *v;
	for (size_t i = 0; (v = ts_verdicts_at(s->of->verdicts, i)) != NULL; i++) {
		if (strcmp(v->stage, s->name) == 0) add_buffer(s, v, i);
	}
}

/* Entries of the stage that are out of date; without outcomes they are only counted. */
static u32 put_stale(ts_outcomes *outcomes, const ts_compared *c, const char *stage, const ts_compare_lists *lists)
{
	char line[TS_KNOWN_TEXT];
	u32 n = 0;
	for (size_t i = 0; i < lists->known.n; i++) {
		if (strcmp(lists->known.entry[i].stage, stage) != 0 || !ts_compare_stale(line, lists, c, i)) continue;
		if (outcomes != NULL) ts_outcomes_line(outcomes, line);
		n++;
	}
	return n;
}

/* The baseline lists a difference of this stage, which no longer has a verdict. */
static bool is_listed(const stages *s) { return s->lists != NULL && put_stale(NULL, s->of, s->name, s->lists) > 0; }

/* The scene, or the next stage of the method; false: there are no more. */
static bool step(stages *s)
{
	const ts_trace_info *of = s->of->of;
	const ts_stage_info *stage = s->begun ? ts_method_stage(of->effect, of->method, s->next) : NULL;
	if (s->begun && stage == NULL) return false;
	s->name = s->begun ? stage->name : "scene";
	s->number = s->begun ? ts_method_stage_number(of->effect, of->method, s->next++) : 0;
	add_buffers(s);
	if (!s->begun && s->verdict < TS_SAME) s->verdict = TS_NOT_JUDGED; /* a port reads our scene */
	s->begun = true;
	return true;
}

/* The next stage with a verdict; false: there is none. */
static bool next(stages *s)
{
	do {
		s->verdict = TS_NOT_JUDGED;
		s->word = "not judged";
		s->why = "";
		s->n_unlike = 0;
		s->seconds = 0;
		if (!step(s)) return false;
	} while (s->verdict == TS_NOT_JUDGED && !is_listed(s));
	return true;
}

static void put_lines(ts_report *report, const stages *s)
{
	const char *lacks = s->verdict == TS_MISSING ? "the candidate has none of its buffers" : "ignored";
	if (s->verdict >= TS_SAME) {
		ts_report_line(report, "stage %02u %s: %s", (unsigned)s->number, s->name, s->word);
	} else {
		ts_report_line(report, "stage %02u %s: not judged: %s", (unsigned)s->number, s->name,
		               s->verdict == TS_UNABLE ? s->why : lacks);
	}
	for (u32 i = 0; i < s->n_unlike; i++) {
		const ts_verdict_info *v = ts_verdicts_at(s->of->verdicts, s->unlike[i]);
		ts_report_line(report, "  %s, %s", v->buffer, v->first);
		ts_compare_more(report, s->of, s->unlike[i], "    ");
	}
}

void ts_compare_stages(ts_report *report, const ts_compared *c)
{
	if (!c->options.forced) return;
	ts_report_line(report, "%s", "");
	ts_report_line(report, "Each stage, given the candidate's inputs:");
	for (stages s = {.of = c}; next(&s);) put_lines(report, &s);
}

/* Whether all different buffers are known; `why` receives the reasons. */
static bool are_known(char why[TS_KNOWN_TEXT], const stages *s, const ts_compare_lists *lists)
{
	size_t used = 0;
	why[0] = 0;
	for (u32 i = 0; i < s->n_unlike; i++) {
		const ts_entry *e = ts_compare_known(lists, ts_verdicts_at(s->of->verdicts, s->unlike[i])->buffer);
		if (e == NULL) return false;
		if (used >= TS_KNOWN_TEXT) continue;
		used += (size_t)snprintf(why + used, TS_KNOWN_TEXT - used, "%s%s", used > 0 ? "; " : "", e->reason);
	}
	return true;
}

static void add_case(ts_outcomes *outcomes, const stages *s, const ts_compare_lists *lists)
{
	char why[TS_KNOWN_TEXT];
	bool known = are_known(why, s, lists), stale = put_stale(NULL, s->of, s->name, lists) > 0;
	if (stale || !known) {
		ts_outcomes_add(outcomes, s->name, "different", TS_FAILED, s->why, s->seconds);
	} else if (s->verdict == TS_UNLIKE) {
		ts_outcomes_add(outcomes, s->name, "known", TS_KNOWN, why, s->seconds);
	} else {
		ts_outcomes_add(outcomes, s->name, s->word, s->verdict == TS_SAME ? TS_PASSED : TS_LEFT_OUT, s->why,
		                s->seconds);
	}
	ts_outcomes_value(outcomes, "number", json_integer(s->number));
}

/* Adds the details of a different buffer. */
static void add_details(ts_outcomes *outcomes, const stages *s, size_t place)
{
	char inner[TS_KNOWN_TEXT + 2];
	const ts_divergence *d;
	const ts_verdict_info *v = ts_verdicts_at(s->of->verdicts, place);
	ts_outcomes_line(outcomes, v->line);
	for (size_t i = 1; (d = ts_verdicts_difference(s->of->verdicts, place, i)) != NULL; i++) {
		snprintf(inner, sizeof inner, "  %s", d->line);
		ts_outcomes_line(outcomes, inner);
	}
	snprintf(inner, sizeof inner, "  %s", v->note);
	if (v->note[0] != 0) ts_outcomes_line(outcomes, inner);
}

void ts_compare_outcomes(ts_outcomes *outcomes, const ts_compared *c, const ts_compare_lists *lists)
{
	stages s = {.of = c};
	for (s.lists = lists; next(&s);) {
		add_case(outcomes, &s, lists);
		for (u32 i = 0; i < s.n_unlike; i++) add_details(outcomes, &s, s.unlike[i]);
		put_stale(outcomes, c, s.name, lists);
	}
}
