/* The verdicts of stages: as text, as JSON, as TAP and as JUnit XML. */
#include "compare_known.h"
#include "../scene/print.h"
#include "../trace/emit.h"

/* A stage, or first the scene. */
typedef struct {
	const ts_comparison *comparison;
	const ts_trace *reference;
	const ts_step *next; /* NULL: the scene is */
	const char *name;
	u32 number;
	ts_judgement verdict;          /* of its buffer that differs, else whether any was judged */
	const char *why;               /* of what could not be judged, or is skipped; else "" */
	const ts_compare_lists *lists; /* NULL: nothing is skipped */
	ts_buffer_id unlike[TS_N_BUFFERS];
	u32 n_unlike;
	double seconds; /* that judging took */
} stages;

static stages begin(const ts_comparison *comparison, const ts_trace *reference)
{
	return (stages){.comparison = comparison, .reference = reference};
}

static void add_buffer(stages *s, ts_buffer_id id)
{
	const ts_verdict *v = &s->comparison->verdict[id];
	if (v->aside) return;
	if (v->judgement == TS_UNLIKE) s->unlike[s->n_unlike++] = id;
	if (v->judgement == TS_UNABLE) s->why = v->why;
	if (v->judgement == TS_IGNORED && s->lists != NULL) s->why = ts_compare_skipped(s->lists, id);
	s->seconds += v->seconds;
	s->verdict = v->judgement > s->verdict ? v->judgement : s->verdict;
}

static void add_scene(stages *s)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (ts_emit_is_scene((ts_buffer_id)id)) add_buffer(s, (ts_buffer_id)id);
	}
	if (s->verdict < TS_SAME) s->verdict = TS_NOT_JUDGED; /* a port reads ours */
	s->name = "scene";
	s->number = 0;
}

static void add_stage(stages *s, const ts_step *step)
{
	const ts_buffer_id *ids = ts_stage_outputs(ts_stage_find(step->stage));
	s->name = step->stage;
	s->number = ts_emit_number(s->reference->pipeline, ids[0]);
	for (; *ids != TS_N_BUFFERS; ids++) add_buffer(s, *ids);
}

/* Entries of the stage that hold no more; without outcomes they are only counted. */
static u32 put_stale(ts_outcomes *outcomes, const ts_comparison *c, const char *stage, const ts_compare_lists *lists)
{
	char line[TS_LINE_TEXT];
	u32 n = 0;
	for (size_t i = 0; i < lists->known.n; i++) {
		if (strcmp(lists->known.entry[i].stage, stage) != 0 || !ts_compare_stale(line, lists, c, i)) continue;
		if (outcomes != NULL) ts_outcomes_line(outcomes, line);
		n++;
	}
	return n;
}

/* The baseline lists a difference of this stage, which no longer has a verdict. */
static bool is_listed(const stages *s)
{
	return s->lists != NULL && put_stale(NULL, s->comparison, s->name, s->lists) > 0;
}

/* The next one that there is a verdict of; false: there is none. */
static bool next(stages *s)
{
	do {
		s->verdict = TS_NOT_JUDGED;
		s->why = "";
		s->n_unlike = 0;
		s->seconds = 0;
		if (s->next == NULL) {
			s->next = ts_pipeline_steps(s->reference->pipeline);
			add_scene(s);
		} else if (s->next->stage != NULL) {
			add_stage(s, s->next++);
		} else {
			return false;
		}
	} while (s->verdict == TS_NOT_JUDGED && !is_listed(s));
	return true;
}

static void put_lines(ts_report *report, const stages *s)
{
	char text[TS_LINE_TEXT];
	const char *lacks = s->verdict == TS_MISSING ? "the candidate has none of its buffers" : "ignored";
	if (s->verdict >= TS_SAME) {
		ts_report_line(report, "stage %02u %s: %s", (unsigned)s->number, s->name, ts_compare_word(s->verdict));
	} else {
		ts_report_line(report, "stage %02u %s: not judged: %s", (unsigned)s->number, s->name,
		               s->verdict == TS_UNABLE ? s->why : lacks);
	}
	for (u32 i = 0; i < s->n_unlike; i++) {
		const ts_verdict *v = &s->comparison->verdict[s->unlike[i]];
		ts_compare_first(text, s->unlike[i], v);
		ts_report_line(report, "  %s, %s", ts_buffer_table[s->unlike[i]].name, text);
		ts_compare_more(report, s->unlike[i], v, "    ");
	}
}

void ts_compare_stages(ts_report *report, const ts_comparison *c, const ts_trace *reference)
{
	if (!c->forced) return;
	ts_report_line(report, "%s", "");
	ts_report_line(report, "Each stage, given the candidate's inputs:");
	for (stages s = begin(c, reference); next(&s);) put_lines(report, &s);
}

/* Line i of all that is said of a buffer that is unlike; false: there are no more. */
static bool detail(char text[TS_LINE_TEXT], const stages *s, ts_buffer_id id, u32 i)
{
	const ts_verdict *v = &s->comparison->verdict[id];
	if (i == 0) {
		ts_compare_line(text, s->comparison, s->reference, id);
	} else if (i < v->list.n) {
		ts_compare_difference(text, id, &v->list.items[i]);
	} else {
		return i == (v->list.n > 0 ? v->list.n : 1) && ts_compare_note(text, id, v);
	}
	return true;
}

/* Whether all buffers that differ are known; `why` has their reasons. */
static bool are_known(char why[TS_LINE_TEXT], const stages *s, const ts_compare_lists *lists)
{
	size_t used = 0;
	why[0] = 0;
	for (u32 i = 0; i < s->n_unlike; i++) {
		const ts_entry *e = ts_compare_known(lists, s->unlike[i]);
		if (e == NULL) return false;
		if (used >= TS_LINE_TEXT) continue;
		used += (size_t)snprintf(why + used, TS_LINE_TEXT - used, "%s%s", used > 0 ? "; " : "", e->reason);
	}
	return true;
}

static void add_case(ts_outcomes *outcomes, const ts_comparison *c, const stages *s, const ts_compare_lists *lists)
{
	char why[TS_LINE_TEXT];
	bool known = are_known(why, s, lists), stale = put_stale(NULL, c, s->name, lists) > 0;
	if (stale || !known) {
		ts_outcomes_add(outcomes, s->name, ts_compare_word(TS_UNLIKE), TS_FAILED, s->why, s->seconds);
	} else if (s->verdict == TS_UNLIKE) {
		ts_outcomes_add(outcomes, s->name, "known", TS_KNOWN, why, s->seconds);
	} else {
		ts_outcome outcome = s->verdict == TS_SAME ? TS_PASSED : TS_LEFT_OUT;
		ts_outcomes_add(outcomes, s->name, ts_compare_word(s->verdict), outcome, s->why, s->seconds);
	}
	ts_outcomes_value(outcomes, "number", json_integer(s->number));
}

void ts_compare_outcomes(ts_outcomes *outcomes, const ts_comparison *c, const ts_trace *reference,
                         const ts_compare_lists *lists)
{
	char line[TS_LINE_TEXT], inner[TS_LINE_TEXT + 2];
	stages s = begin(c, reference);
	for (s.lists = lists; next(&s);) {
		add_case(outcomes, c, &s, lists);
		for (u32 i = 0; i < s.n_unlike; i++) {
			for (u32 k = 0; detail(line, &s, s.unlike[i], k); k++) {
				snprintf(inner, sizeof inner, "%s%s", k > 0 ? "  " : "", line);
				ts_outcomes_line(outcomes, inner);
			}
		}
		put_stale(outcomes, c, s.name, lists);
	}
}
