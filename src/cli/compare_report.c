/* A comparison as text, JSON, TAP and JUnit XML. */
#include "../output/file.h"
#include "compare.h"
#include <inttypes.h>
#include <string.h>
#include "../scene/print.h"
#include "../trace/emit.h"
#include "../trace/where.h"

static const char *const words[] = {"not judged", "missing", "ignored", "same", "different"};

enum { INPUTS_TEXT = 600 };

/* Whether what the stage read was the same. The scene need not be given: a port reads ours. */
static void inputs_of(char text[INPUTS_TEXT], const ts_comparison *c, const ts_trace *reference, const ts_stage *stage)
{
	const char *unlike = NULL, *tied = NULL;
	char absent[INPUTS_TEXT - 64] = "";
	size_t used = 0;
	u32 n_given = 0;
	for (u32 i = 0; stage != NULL && ts_stage_inputs(stage)[i] != TS_N_BUFFERS; i++) {
		ts_buffer_id id = ts_stage_inputs(stage)[i];
		const char *name = ts_buffer_table[id].name;
		ts_judgement judgement = c->verdict[id].judgement;
		bool given = judgement != TS_MISSING && judgement != TS_NOT_JUDGED;
		const ts_step *maker = ts_pipeline_maker(reference->pipeline, id);
		bool made = maker != NULL && (!reference->has_params || ts_pipeline_takes(maker, &reference->params, true));
		n_given += given;
		if (judgement == TS_UNLIKE && unlike == NULL) unlike = name;
		if (c->verdict[id].n_tied != 0) tied = name;
		if (given || !made || ts_emit_is_scene(id) || used >= sizeof absent) continue;
		used += (size_t)snprintf(absent + used, sizeof absent - used, "%s%s", used > 0 ? ", " : "", name);
	}
	if (c->forced) {
		snprintf(text, INPUTS_TEXT, "given the candidate's inputs");
	} else if (unlike != NULL) {
		snprintf(text, INPUTS_TEXT, "inputs differ: %s", unlike);
	} else if (tied != NULL) {
		snprintf(text, INPUTS_TEXT, "inputs may differ where %s is tied: --forced judges by the candidate's own", tied);
	} else if (used == 0) {
		snprintf(text, INPUTS_TEXT, "inputs identical");
	} else if (n_given == 0) {
		snprintf(text, INPUTS_TEXT, "none of its inputs was given");
	} else {
		snprintf(text, INPUTS_TEXT, "inputs identical as far as given; not given: %s", absent);
	}
}

static void values_of(char *text, size_t bytes, const ts_verdict *v, const ts_field *field, const ts_difference *d)
{
	char name[64], ref[TS_VALUE_TEXT], cand[TS_VALUE_TEXT], ulps[48] = "";
	ts_field_name(name, field, d->component);
	ts_field_show(ref, field, d->ref);
	ts_field_show(cand, field, d->cand);
	i64 apart = field->kind == 'f' ? ts_field_ulps(d->ref, d->cand) : 0;
	if (apart == INT64_MAX) snprintf(ulps, sizeof ulps, " NaN");
	if (field->kind == 'f' && apart != INT64_MAX) snprintf(ulps, sizeof ulps, " %+" PRId64 " ulp", apart);
	snprintf(text, bytes, "%s%s%sref %s candidate %s%s — first of %" PRIu64, name[0] != 0 ? "field " : "", name,
	         name[0] != 0 ? ": " : "", ref, cand, ulps, v->n_different);
}

/* Where records have no partner, or rows end early. */
static void lack_of(char *text, size_t bytes, const ts_verdict *v)
{
	char missing[TS_WHERE_TEXT], extra[TS_WHERE_TEXT];
	ts_where_key(missing, v->missing_key);
	ts_where_key(extra, v->extra_key);
	if (v->n_missing + v->n_extra == 0) {
		snprintf(text, bytes, "%" PRIu64 " elements, candidate %" PRIu64 "; equal as far as both go", v->n_ref,
		         v->n_cand);
	} else if (v->n_missing > 0) {
		snprintf(text, bytes, "key (%s): missing — first of %" PRIu64 " missing, %" PRIu64 " beside", missing,
		         v->n_missing, v->n_extra);
	} else {
		snprintf(text, bytes, "key (%s): %s — first of %" PRIu64, extra,
		         v->n_twice > 0 ? "twice" : "not of the reference", v->n_extra);
	}
}

void ts_compare_line(char text[TS_LINE_TEXT], const ts_comparison *c, const ts_trace *reference, ts_buffer_id id)
{
	char what[512], where[TS_WHERE_TEXT], inputs[INPUTS_TEXT], lack[400];
	const ts_verdict *v = &c->verdict[id];
	const ts_step *step = ts_pipeline_maker(reference->pipeline, id);
	const ts_stage *stage = step != NULL ? ts_stage_find(step->stage) : NULL;
	ts_fields fields = ts_fields_of(id);
	inputs_of(inputs, c, reference, stage);
	lack_of(lack, sizeof lack, v);
	ts_where(where, reference, id, v->first.element);
	values_of(what, sizeof what, v, &fields.field[v->first.field], &v->first);
	bool partners = v->n_missing + v->n_extra > 0 || !v->has_first;
	snprintf(text, TS_LINE_TEXT, "stage %02u %s, buffer %s, %s%s%s; %s",
	         (unsigned)ts_emit_number(reference->pipeline, id), stage != NULL ? stage->name : "scene",
	         ts_buffer_table[id].name, partners ? lack : where, partners ? "" : ", ", partners ? "" : what, inputs);
}

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
	ts_table_text(table, words[v->judgement]);
}

/* All of them, as they are typed: they are part of the verdict. */
static void relaxations_of(char *text, size_t bytes, const ts_judging *judging)
{
	const ts_relaxations *r = &judging->relaxations;
	FILE *out = fmemopen(text, bytes, "w");
	text[0] = 0;
	if (out == NULL) return;
	if (r->ulp > 0) fprintf(out, " --ulp %" PRIu64, r->ulp);
	if (r->abs > 0) fprintf(out, " --abs %.17g", r->abs);
	if (r->rel > 0) fprintf(out, " --rel %.17g", r->rel);
	if (r->allow > 0) fprintf(out, " --allow %" PRIu64, r->allow);
	if (r->decided) fprintf(out, " --decided");
	if (r->ignore != NULL) fprintf(out, " --ignore %.200s", r->ignore);
	if (judging->mask != NULL) fprintf(out, " --mask %.200s", judging->mask);
	fclose(out);
}

void ts_compare_report(ts_report *report, const ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                       const ts_judging *judging)
{
	char line[TS_LINE_TEXT], relaxed[600];
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_table table = ts_table_begin("buffers", "", columns);
	ts_emit_order(ids, reference->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		const ts_step *step = ts_pipeline_maker(reference->pipeline, ids[i]);
		if (c->verdict[ids[i]].judgement == TS_NOT_JUDGED) continue;
		row(&table, &c->verdict[ids[i]], step != NULL ? step->stage : "scene", ids[i]);
	}
	relaxations_of(relaxed, sizeof relaxed, judging);
	ts_report_table(report, &table);
	ts_report_line(report, "%s", "");
	ts_report_line(report, "%u buffers judged, %u different, %u missing%s%s", (unsigned)c->n_judged,
	               (unsigned)c->n_unlike, (unsigned)c->n_missing, relaxed[0] != 0 ? "; relaxed:" : "", relaxed);
	ts_report_value(report, "reference", ts_text_json(reference->dir));
	ts_report_value(report, "candidate", ts_text_json(candidate->dir));
	ts_report_value(report, "candidate_producer", ts_text_json(candidate->producer));
	ts_report_value(report, "candidate_order", json_string(candidate->arrival ? "arrival" : "canonical"));
	ts_report_value(report, "relaxations", ts_text_json(relaxed[0] != 0 ? relaxed + 1 : ""));
	ts_report_value(report, "verdict", json_string(c->n_unlike > 0 ? "different" : "same"));
	if (c->first == TS_N_BUFFERS) return;
	ts_compare_line(line, c, reference, c->first);
	ts_report_line(report, "%s", line);
	ts_report_value(report, "first_divergence", json_string(line));
}

/* The verdict of a stage: of its first buffer that is unlike, else whether any was judged. */
static ts_judgement stage_verdict(const ts_comparison *c, const ts_stage *stage, ts_buffer_id *unlike)
{
	ts_judgement verdict = TS_NOT_JUDGED;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		ts_judgement judgement = c->verdict[*id].judgement;
		if (judgement == TS_UNLIKE && verdict != TS_UNLIKE) *unlike = *id;
		verdict = judgement > verdict ? judgement : verdict;
	}
	return verdict;
}

void ts_compare_tap(const ts_comparison *c, const ts_trace *reference, FILE *out)
{
	char line[TS_LINE_TEXT];
	u32 n = 0;
	for (const ts_step *step = ts_pipeline_steps(reference->pipeline); step->stage != NULL; step++) {
		ts_buffer_id unlike = TS_N_BUFFERS;
		ts_judgement verdict = stage_verdict(c, ts_stage_find(step->stage), &unlike);
		if (verdict == TS_NOT_JUDGED) continue;
		bool judged = verdict == TS_SAME || verdict == TS_UNLIKE;
		fprintf(out, "%sok %u - %s%s%s\n", verdict == TS_UNLIKE ? "not " : "", (unsigned)++n, step->stage,
		        judged ? "" : " # SKIP ", judged ? "" : words[verdict]);
		if (verdict != TS_UNLIKE) continue;
		ts_compare_line(line, c, reference, unlike);
		fprintf(out, "# %s\n", line);
	}
	fprintf(out, "1..%u\n", (unsigned)n);
}

static void put_escaped(const char *text, FILE *out)
{
	static const struct {
		char c;
		const char *name;
	} names[] = {
		{'&', "&amp;"},
		{'<', "&lt;"},
		{'>', "&gt;"},
		{'"', "&quot;"},
	};
	for (; *text != 0; text++) {
		const char *name = NULL;
		for (u32 i = 0; i < sizeof names / sizeof *names; i++) name = names[i].c == *text ? names[i].name : name;
		if (name != NULL) {
			fputs(name, out);
		} else {
			fputc(*text, out);
		}
	}
}

static void put_case(const ts_comparison *c, const ts_trace *reference, const ts_step *step, FILE *out)
{
	char line[TS_LINE_TEXT];
	ts_buffer_id unlike = TS_N_BUFFERS;
	ts_judgement verdict = stage_verdict(c, ts_stage_find(step->stage), &unlike);
	if (verdict == TS_NOT_JUDGED) return;
	fprintf(out, "  <testcase classname=\"touchstone.%s\" name=\"%s\">", reference->pipeline->name, step->stage);
	if (verdict == TS_UNLIKE) {
		ts_compare_line(line, c, reference, unlike);
		fputs("<failure message=\"", out);
		put_escaped(line, out);
		fputs("\"/>", out);
	} else if (verdict != TS_SAME) {
		fprintf(out, "<skipped message=\"%s\"/>", words[verdict]);
	}
	fputs("</testcase>\n", out);
}

ts_status ts_compare_junit(const ts_comparison *c, const ts_trace *reference, const char *path)
{
	u32 n = 0, n_unlike = 0, n_skipped = 0;
	for (const ts_step *step = ts_pipeline_steps(reference->pipeline); step->stage != NULL; step++) {
		ts_buffer_id unlike;
		ts_judgement verdict = stage_verdict(c, ts_stage_find(step->stage), &unlike);
		n += verdict != TS_NOT_JUDGED;
		n_unlike += verdict == TS_UNLIKE;
		n_skipped += verdict == TS_MISSING || verdict == TS_IGNORED;
	}
	ts_file_text text;
	if (ts_file_text_begin(&text, path) != TS_OK) return TS_ERROR;
	FILE *out = text.out;
	fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", out);
	fprintf(out, "<testsuite name=\"touchstone compare\" tests=\"%u\" failures=\"%u\" skipped=\"%u\">\n", (unsigned)n,
	        (unsigned)n_unlike, (unsigned)n_skipped);
	for (const ts_step *s = ts_pipeline_steps(reference->pipeline); s->stage != NULL; s++)
		put_case(c, reference, s, out);
	fputs("</testsuite>\n", out);
	return ts_file_text_replace(&text, path);
}
