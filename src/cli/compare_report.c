/* A comparison as text and as JSON. */
#include "compare.h"
#include <inttypes.h>
#include "../scene/print.h"
#include "../trace/emit.h"

static const ts_column columns[] = {{"stage", "stage", false},        {"buffer", "buffer", false},
                                    {"elements", "elements", true},   {"different", "different", true},
                                    {"tied", "tied", true},           {"relaxed", "relaxed", true},
                                    {"undecided", "undecided", true}, {"worst_ulps", "worst ulps", true},
                                    {"verdict", "verdict", false},    {0}};

static void row(ts_table *table, const ts_verdict *v, const char *stage, ts_buffer_id id)
{
	bool judged = v->judgement == TS_SAME || v->judgement == TS_UNLIKE;
	const i64 figures[] = {(i64)v->n_ref,     (i64)v->n_different, (i64)v->n_tied,
	                       (i64)v->n_relaxed, (i64)v->n_undecided, v->worst_ulps};
	ts_table_text(table, stage);
	ts_table_text(table, ts_buffer_table[id].name);
	for (u32 i = 0; i < sizeof figures / sizeof *figures; i++) {
		if (judged && (i < 2 || figures[i] != 0)) {
			ts_table_count(table, figures[i]);
		} else {
			ts_table_none(table);
		}
	}
	ts_table_text(table, ts_compare_word(v->judgement));
}

void ts_compare_more(ts_report *report, ts_buffer_id id, const ts_verdict *v, const char *indent)
{
	char text[TS_DIFFERENCE_TEXT];
	for (u32 i = 1; i < v->list.n; i++) {
		ts_compare_difference(text, id, &v->list.items[i]);
		ts_report_line(report, "%s%s", indent, text);
	}
}

void ts_compare_relaxed(char text[TS_RELAXED_TEXT], const ts_cli *cli)
{
	const ts_judging *judging = &cli->judging;
	const ts_relaxations *r = &judging->relaxations;
	const ts_tolerances *t = &judging->tolerances;
	FILE *out = fmemopen(text, TS_RELAXED_TEXT, "w");
	text[0] = 0;
	if (out == NULL) return;
	if (r->ulp > 0) fprintf(out, " --ulp %" PRIu64, r->ulp);
	if (r->abs > 0) fprintf(out, " --abs %.17g", r->abs);
	if (r->rel > 0) fprintf(out, " --rel %.17g", r->rel);
	if (cli->given[TS_OPTION_ALLOW]) fprintf(out, " --allow %" PRIu64, r->allow);
	if (cli->given[TS_OPTION_PERCENT]) fprintf(out, " --percent %.17g", t->percent);
	if (cli->given[TS_OPTION_HARDFAIL]) fprintf(out, " --hardfail %.17g", t->hardfail);
	if (cli->given[TS_OPTION_RMSE]) fprintf(out, " --rmse %.17g", t->rmse);
	if (cli->given[TS_OPTION_EXPOSURE]) {
		fprintf(out, " --exposure %.9g", (double)TS_PARAM(&cli->job.params, image_exposure));
	}
	if (r->decided) fprintf(out, " --decided");
	if (r->ignore != NULL) fprintf(out, " --ignore %.200s", r->ignore);
	if (judging->mask != NULL) fprintf(out, " --mask %.200s", judging->mask);
	if (judging->baseline != NULL) fprintf(out, " --baseline %.200s", judging->baseline);
	if (judging->skip != NULL) fprintf(out, " --skip %.200s", judging->skip);
	fclose(out);
	if (text[0] != 0) memmove(text, text + 1, strlen(text));
	ts_line_clean(text);
}

/* Of sums the thing whose count it is; -1: there is none, where they begin. */
static json_int_t element_of(ts_buffer_id id, const ts_difference *d)
{
	return (json_int_t)d->element - (ts_sum_of(id) != NULL);
}

/* Hexadecimal, as wide as the field; of a count, which no field holds, null. */
static json_t *bits_json(ts_buffer_id id, const ts_difference *d, u64 bits)
{
	const ts_fields fields = ts_fields_of(id);
	if (ts_sum_of(id) != NULL) return json_null();
	return json_sprintf("%0*" PRIx64, (int)(2 * fields.field[d->field].bytes), bits);
}

static json_t *difference_json(ts_buffer_id id, const ts_named *named)
{
	const ts_difference *d = &named->difference;
	static const char *const how[] = {"unequal", "missing", "beside", "twice"};
	char field[64], ref[TS_VALUE_TEXT], cand[TS_VALUE_TEXT];
	i64 ulps = ts_compare_ulps(id, d);
	if (d->how != TS_UNEQUAL) return json_pack("{s:s, s:s}", "how", how[d->how], "where", named->where);
	ts_difference_field(field, id, d);
	ts_difference_show(ref, id, d, d->ref);
	ts_difference_show(cand, id, d, d->cand);
	json_t *apart = ulps != 0 && ulps != INT64_MAX ? json_integer(ulps) : json_null();
	return json_pack("{s:s, s:s, s:I, s:s, s:s, s:s, s:o, s:o, s:o}", "how", how[d->how], "where", named->where,
	                 "element", element_of(id, d), "field", field, "reference", ref, "candidate", cand,
	                 "reference_bits", bits_json(id, d, d->ref), "candidate_bits", bits_json(id, d, d->cand), "ulps",
	                 apart);
}

static const char *stage_of(const ts_trace *reference, ts_buffer_id id)
{
	const ts_step *step = ts_pipeline_maker(reference->pipeline, id);
	return step != NULL ? step->stage : "scene";
}

/* A buffer that is unlike. */
static json_t *buffer_json(ts_report *report, const ts_comparison *c, const ts_trace *reference, ts_buffer_id id)
{
	char line[TS_LINE_TEXT];
	const ts_verdict *v = &c->verdict[id];
	const ts_fields fields = ts_fields_of(id);
	json_t *by_field = json_object(), *first = json_array();
	for (u32 f = 0; f < fields.n && fields.n > 1; f++) {
		if (v->n_field[f] == 0) continue;
		report->failed |=
			json_object_set_new(by_field, fields.field[f].name, json_integer((json_int_t)v->n_field[f])) != 0;
	}
	for (u32 d = 0; d < v->list.n; d++) {
		report->failed |= json_array_append_new(first, difference_json(id, &v->list.items[d])) != 0;
	}
	ts_compare_line(line, c, reference, id);
	return json_pack("{s:s, s:s, s:s, s:s, s:I, s:o, s:o}", "stage", stage_of(reference, id), "buffer",
	                 ts_buffer_table[id].name, "judged_by", ts_sum_of(id) != NULL ? "counts" : "elements", "line", line,
	                 "candidate_elements", (json_int_t)v->n_cand, "fields", by_field, "first", first);
}

/* All that is said of buffers that are unlike but the line of the first: notes as text, the rest as JSON. */
static void tell_unlike(ts_report *report, const ts_comparison *c, const ts_trace *reference, const ts_buffer_id *ids)
{
	char note[TS_LINE_TEXT];
	json_t *array = json_array();
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		const ts_verdict *v = &c->verdict[ids[i]];
		if (v->judgement != TS_UNLIKE || v->aside) continue;
		if (ts_compare_note(note, ids[i], v)) ts_report_line(report, "%s", note);
		report->failed |= json_array_append_new(array, buffer_json(report, c, reference, ids[i])) != 0;
	}
	ts_report_value(report, "differences", array);
}

/* The command that explains the first value that differs; of sums, the count before. */
static void advise(ts_report *report, const ts_comparison *c, const ts_trace *reference)
{
	if (c->first == TS_N_BUFFERS || !c->verdict[c->first].has_first || !reference->has_params) return;
	const ts_step *step = ts_pipeline_maker(reference->pipeline, c->first);
	u64 element = c->verdict[c->first].first.element;
	if (ts_sum_of(c->first) != NULL && element > 0) element--;
	const ts_buffer_info *info = &ts_buffer_table[c->first];
	bool sorted = strcmp(info->key, info->name) == 0; /* what an item writes stands elsewhere then */
	if (step == NULL || sorted || ts_stage_find(step->stage)->launches == NULL) return;
	ts_report_line(report, "how the reference computes it: %s explain %s --stage %s --element %s:%" PRIu64, ts_program,
	               reference->dir, step->stage, ts_buffer_table[c->first].name, element);
}

/* The first difference of all, in fields. */
static json_t *divergence_json(const ts_comparison *c, const ts_trace *reference)
{
	char inputs[TS_INPUTS_TEXT];
	const ts_verdict *v = &c->verdict[c->first];
	json_t *fields =
		json_pack("{s:s, s:i, s:s}", "stage", stage_of(reference, c->first), "number",
	              (int)ts_emit_number(reference->pipeline, c->first), "buffer", ts_buffer_table[c->first].name);
	json_t *first = v->list.n > 0 ? difference_json(c->first, &v->list.items[0]) : json_object();
	bool failed = json_object_update(fields, first) != 0;
	json_decref(first);
	ts_compare_inputs(inputs, c, reference, c->first);
	failed |= json_object_set_new(fields, "inputs", json_string(inputs)) != 0;
	if (!failed) return fields;
	json_decref(fields);
	return NULL;
}

void ts_compare_report(ts_report *report, const ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                       const ts_cli *cli)
{
	char line[TS_LINE_TEXT], relaxed[TS_RELAXED_TEXT], unable[48] = "";
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_table table = ts_table_begin("buffers", "", columns);
	ts_emit_order(ids, reference->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		if (c->verdict[ids[i]].judgement == TS_NOT_JUDGED || c->verdict[ids[i]].aside) continue;
		row(&table, &c->verdict[ids[i]], stage_of(reference, ids[i]), ids[i]);
	}
	ts_compare_relaxed(relaxed, cli);
	ts_report_table(report, &table);
	ts_report_line(report, "%s", "");
	tell_unlike(report, c, reference, ids);
	if (!c->forced) advise(report, c, reference);
	if (c->n_unable > 0) snprintf(unable, sizeof unable, ", %u not judged", (unsigned)c->n_unable);
	ts_report_line(report, "%u buffers judged, %u different, %u missing%s%s%s", (unsigned)c->n_judged,
	               (unsigned)c->n_unlike, (unsigned)c->n_missing, unable, relaxed[0] != 0 ? "; relaxed: " : "",
	               relaxed);
	ts_report_value(report, "reference", ts_text_json(reference->dir));
	ts_report_value(report, "candidate", ts_text_json(candidate->dir));
	ts_report_value(report, "candidate_producer", ts_text_json(candidate->producer));
	ts_report_value(report, "candidate_order", json_string(candidate->arrival ? "arrival" : "canonical"));
	ts_report_value(report, "relaxations", ts_text_json(relaxed));
	if (c->first != TS_N_BUFFERS) {
		ts_compare_line(line, c, reference, c->first);
		ts_report_line(report, "%s", line);
		ts_report_value(report, "first_divergence", json_string(line));
		ts_report_value(report, "divergence", divergence_json(c, reference));
		if (!c->forced) ts_compare_more(report, c->first, &c->verdict[c->first], "  ");
	}
	ts_compare_stages(report, c, reference);
}
