/* One difference, as a line. */
#include "compare/line.h"
#include <inttypes.h>
#include <stdio.h>
#include "trace/emitted/emit.h"

static const ts_stage *stage_of(const ts_trace *reference, ts_buffer_id id)
{
	const ts_step *step = ts_pipeline_maker(reference->pipeline, id);
	return step != NULL ? ts_stage_find(step->stage) : NULL;
}

/* The scene may be missing: a port reads ours. */
void ts_compare_inputs(char text[TS_INPUTS_TEXT], const ts_comparison *c, const ts_trace *reference, ts_buffer_id of)
{
	const ts_stage *stage = stage_of(reference, of);
	const char *unlike = NULL, *tied = NULL;
	char absent[TS_INPUTS_TEXT - 64] = "";
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
	if (stage == NULL) {
		snprintf(text, TS_INPUTS_TEXT, "of the scene, which no stage makes");
	} else if (c->forced) {
		snprintf(text, TS_INPUTS_TEXT, "given the candidate's inputs");
	} else if (unlike != NULL) {
		snprintf(text, TS_INPUTS_TEXT, "inputs differ: %s", unlike);
	} else if (tied != NULL) {
		snprintf(text, TS_INPUTS_TEXT, "inputs may differ where %s is tied; forced judges by the candidate's own",
		         tied);
	} else if (used == 0) {
		snprintf(text, TS_INPUTS_TEXT, "inputs identical");
	} else if (n_given == 0) {
		snprintf(text, TS_INPUTS_TEXT, "none of its inputs was given");
	} else {
		snprintf(text, TS_INPUTS_TEXT, "inputs identical as far as given; not given: %s", absent);
	}
}

const char *ts_compare_word(ts_judgement judgement)
{
	static const char *const words[] = {
		[TS_NOT_JUDGED] = "not judged", [TS_MISSING] = "missing", [TS_IGNORED] = "ignored",
		[TS_UNABLE] = "not judged",     [TS_SAME] = "same",       [TS_UNLIKE] = "different",
	};
	return words[judgement];
}

const char *ts_compare_how(ts_how_unlike how)
{
	static const char *const words[] = {[TS_UNEQUAL] = "different",
	                                    [TS_LACKED] = "missing",
	                                    [TS_BESIDE] = "not of the reference",
	                                    [TS_TWICE] = "twice"};
	return words[how];
}

i64 ts_compare_ulps(ts_buffer_id id, const ts_difference *d)
{
	const ts_fields fields = ts_fields_of(id);
	return fields.field[d->field].kind == 'f' ? ts_field_ulps(d->ref, d->cand) : 0;
}

void ts_compare_difference(char text[TS_DIFFERENCE_TEXT], ts_buffer_id id, const ts_named *named)
{
	const ts_difference *d = &named->difference;
	char name[64], ref[TS_VALUE_TEXT], cand[TS_VALUE_TEXT], apart[48] = "";
	i64 ulps = ts_compare_ulps(id, d);
	ts_difference_field(name, id, d);
	ts_difference_show(ref, id, d, d->ref);
	ts_difference_show(cand, id, d, d->cand);
	if (ulps == INT64_MAX) snprintf(apart, sizeof apart, " NaN");
	if (ulps != 0 && ulps != INT64_MAX) snprintf(apart, sizeof apart, " %+" PRId64 " ulp", ulps);
	if (d->how == TS_UNEQUAL) {
		snprintf(text, TS_DIFFERENCE_TEXT, "%s, %s%s%sref %s candidate %s%s", named->where,
		         name[0] != 0 ? "field " : "", name, name[0] != 0 ? ": " : "", ref, cand, apart);
	} else {
		snprintf(text, TS_DIFFERENCE_TEXT, "%s: %s", named->where, ts_compare_how(d->how));
	}
}

void ts_compare_first(char text[TS_FIRST_TEXT], ts_buffer_id id, const ts_verdict *v)
{
	char first[TS_DIFFERENCE_TEXT];
	if (v->why[0] != 0) {
		snprintf(text, TS_FIRST_TEXT, "%s", v->why);
		return;
	}
	if (v->list.n == 0) {
		snprintf(text, TS_FIRST_TEXT, "%" PRIu64 " elements, candidate %" PRIu64 "; equal as far as both go", v->n_ref,
		         v->n_cand);
		return;
	}
	ts_how_unlike how = v->list.items[0].difference.how;
	u64 n = how == TS_UNEQUAL ? v->n_different : v->n_extra;
	ts_compare_difference(first, id, &v->list.items[0]);
	if (how == TS_LACKED) {
		snprintf(text, TS_FIRST_TEXT, "%s — first of %" PRIu64 " missing, %" PRIu64 " beside", first, v->n_missing,
		         v->n_extra);
	} else {
		snprintf(text, TS_FIRST_TEXT, "%s — first of %" PRIu64, first, n);
	}
}

bool ts_compare_note(char text[TS_LINE_TEXT], ts_buffer_id id, const ts_verdict *v)
{
	const ts_fields fields = ts_fields_of(id);
	bool sums = ts_sum_of(id) != NULL && !v->by_digest, longer = v->n_ref != v->n_cand;
	const char *apart = ": elements that differ, by field: ";
	int n =
		snprintf(text, TS_LINE_TEXT, "%s%s", ts_buffer_table[id].name, sums ? ": sums, judged by their counts" : "");
	if (longer) {
		n += snprintf(text + n, TS_LINE_TEXT - (size_t)n, ": %" PRIu64 " elements, candidate %" PRIu64, v->n_ref,
		              v->n_cand);
	}
	for (u32 f = 0; f < fields.n && fields.n > 1; f++) {
		if (v->n_field[f] == 0) continue;
		n += snprintf(text + n, TS_LINE_TEXT - (size_t)n, "%s%s %" PRIu64, apart, fields.field[f].name, v->n_field[f]);
		apart = ", ";
	}
	return sums || longer || apart[0] == ',';
}

void ts_compare_line(char text[TS_LINE_TEXT], const ts_comparison *c, const ts_trace *reference, ts_buffer_id id)
{
	char first[TS_FIRST_TEXT], inputs[TS_INPUTS_TEXT];
	const ts_stage *stage = stage_of(reference, id);
	ts_compare_inputs(inputs, c, reference, id);
	ts_compare_first(first, id, &c->verdict[id]);
	snprintf(text, TS_LINE_TEXT, "stage %02u %s, buffer %s, %s; %s", (unsigned)ts_emit_number(reference->pipeline, id),
	         stage != NULL ? stage->name : "scene", ts_buffer_table[id].name, first, inputs);
}
