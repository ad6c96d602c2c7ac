/* A comparison as text and as JSON. */
#include <inttypes.h>
#include <string.h>
#include "cli/compare.h"
#include "output/json/text.h"

static const ts_column columns[] = {{"stage", "stage", false},        {"buffer", "buffer", false},
                                    {"elements", "elements", true},   {"different", "different", true},
                                    {"tied", "tied", true},           {"relaxed", "relaxed", true},
                                    {"undecided", "undecided", true}, {"worst_ulps", "worst ulps", true},
                                    {"verdict", "verdict", false},    {0}};

static bool is_judged(const ts_verdict_info *v) { return v->judgement == TS_SAME || v->judgement == TS_UNLIKE; }

static void row(ts_table *table, const ts_verdict_info *v)
{
	const i64 figures[] = {(i64)v->n_reference, (i64)v->n_different, (i64)v->n_tied,
	                       (i64)v->n_relaxed,   (i64)v->n_undecided, v->worst_ulps};
	ts_table_text(table, v->stage);
	ts_table_text(table, v->buffer);
	for (u32 i = 0; i < sizeof figures / sizeof *figures; i++) {
		bool counted = !v->by_digest || (i == 0 ? v->n_reference > 0 : v->judgement == TS_SAME);
		if (is_judged(v) && counted && (i < 2 || figures[i] != 0)) {
			ts_table_count(table, figures[i]);
		} else {
			ts_table_none(table);
		}
	}
	ts_table_text(table, v->verdict);
}

void ts_compare_more(ts_report *report, const ts_compared *c, size_t place, const char *indent)
{
	const ts_divergence *d;
	for (size_t i = 1; (d = ts_verdicts_difference(c->verdicts, place, i)) != NULL; i++) {
		ts_report_line(report, "%s%s", indent, d->line);
	}
}

/* Differences as JSON; their notes as text, too. */
static void report_unlike(ts_report *report, const ts_compared *c)
{
	const ts_verdict_info *v;
	const char *key;
	json_t *value, *tree = ts_client_json(ts_verdicts_tree(c->verdicts));
	for (size_t i = 0; (v = ts_verdicts_at(c->verdicts, i)) != NULL; i++) {
		if (v->note[0] != 0) ts_report_line(report, "%s", v->note);
	}
	report->failed |= tree == NULL;
	json_object_foreach (tree, key, value) ts_report_value(report, key, json_incref(value));
	json_decref(tree);
}

/* The stage and the buffer of a verdict, from the tables; NULL: none. */
static const ts_stage_info *stage_of(const ts_compared *c, const ts_verdict_info *v)
{
	const ts_stage_info *stage;
	size_t i = 0;
	while ((stage = ts_method_stage(c->of->effect, c->of->method, i)) != NULL && strcmp(stage->name, v->stage) != 0) {
		i++;
	}
	return stage;
}

static const ts_buffer_info *buffer_of(const ts_verdict_info *v)
{
	const ts_buffer_info *buffer;
	size_t i = 0;
	while ((buffer = ts_buffer_at(i)) != NULL && strcmp(buffer->name, v->buffer) != 0) i++;
	return buffer;
}

/* Prints the command that explains the first different value; for sums, the count before. */
static void advise(ts_report *report, const ts_compared *c, const ts_verdict_info *v)
{
	const ts_stage_info *stage = stage_of(c, v);
	const ts_buffer_info *buffer = buffer_of(v);
	if (!v->has_first || !c->of->has_params || stage == NULL || !stage->has_kernels) return;
	if (strcmp(buffer->key, buffer->name) == 0) return; /* sorted: the writer's element has another place */
	u64 element = v->first_element;
	if (v->by_counts && element > 0) element--;
	ts_report_line(report, "how the reference computes it: %s explain %s --stage %s --element %s:%" PRIu64, ts_program,
	               c->of->folder, v->stage, v->buffer, element);
}

static void sum_up(ts_report *report, const ts_compared *c, const char *relaxed)
{
	const ts_verdict_info *v;
	char unable[48] = "";
	u32 n_judged = 0, n_unlike = 0, n_missing = 0, n_unable = 0;
	for (size_t i = 0; (v = ts_verdicts_at(c->verdicts, i)) != NULL; i++) {
		n_judged += is_judged(v);
		n_unlike += v->judgement == TS_UNLIKE;
		n_missing += v->judgement == TS_MISSING;
		n_unable += v->judgement == TS_UNABLE;
	}
	if (n_unable > 0) snprintf(unable, sizeof unable, ", %u not judged", (unsigned)n_unable);
	ts_report_line(report, "%u buffers judged, %u different, %u missing%s%s%s", (unsigned)n_judged, (unsigned)n_unlike,
	               (unsigned)n_missing, unable, relaxed[0] != 0 ? "; relaxed: " : "", relaxed);
}

void ts_compare_report(ts_report *report, const ts_compared *c, const char *relaxed)
{
	const ts_verdict_info *v;
	const ts_divergence *first = ts_verdicts_first(c->verdicts);
	const bool forced = c->options.forced != 0;
	ts_table table = ts_table_begin("buffers", "", columns);
	for (size_t i = 0; (v = ts_verdicts_at(c->verdicts, i)) != NULL; i++) {
		if (v->judgement != TS_NOT_JUDGED) row(&table, v);
	}
	ts_report_table(report, &table);
	ts_report_line(report, "%s", "");
	report_unlike(report, c);
	size_t place = 0;
	v = first != NULL ? ts_compared_find(c, first->buffer, &place) : NULL;
	if (v != NULL && !forced) advise(report, c, v);
	sum_up(report, c, relaxed);
	ts_report_value(report, "relaxations", ts_text_json(relaxed));
	if (v != NULL) ts_report_line(report, "%s", v->line);
	if (v != NULL && !forced) ts_compare_more(report, c, place, "  ");
	ts_compare_stages(report, c);
}
