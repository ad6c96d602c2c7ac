/* From what was judged to what callers read. */
#include "api/verdicts.h"
#include <stdlib.h>
#include <string.h>
#include "compare/line.h"
#include "trace/emitted/emit.h"

typedef struct {
	ts_divergence divergence;
	char field[64], spot[64], reference[TS_VALUE_TEXT], candidate[TS_VALUE_TEXT], line[TS_DIFFERENCE_TEXT];
} difference;

struct ts_verdict_details {
	char first[TS_FIRST_TEXT], line[TS_LINE_TEXT], note[TS_LINE_TEXT], inputs[TS_INPUTS_TEXT];
	ts_field_count fields[TS_MAX_FIELDS];
	u32 n_fields, n;         /* n: differences of the list */
	difference *differences; /* at least one: where the list is empty, as shapes differ, it describes the buffer */
};

ts_verdicts *ts_verdicts_make(u32 most)
{
	ts_verdicts *v = ts_alloc_zero(1, sizeof *v, "verdicts");
	if (v == NULL) return NULL;
	v->comparison = ts_comparison_make(most);
	if (v->comparison != NULL) return v;
	free(v);
	return NULL;
}

static void put_values(difference *to, ts_buffer_id id, const ts_difference *d)
{
	const ts_fields fields = ts_fields_of(id);
	ts_divergence *divergence = &to->divergence;
	snprintf(to->field, sizeof to->field, "%s", fields.field[d->field].name);
	ts_difference_field(to->spot, id, d);
	ts_difference_show(to->reference, id, d, d->ref);
	ts_difference_show(to->candidate, id, d, d->cand);
	divergence->component = d->component;
	divergence->reference_bits = d->ref;
	divergence->candidate_bits = d->cand;
	divergence->ulps = ts_compare_ulps(id, d);
	divergence->bytes = ts_sum_of(id) != NULL ? 0 : fields.field[d->field].bytes;
}

/* Difference i; if the list is empty, the difference of the whole buffer. */
static void put_difference(ts_verdict_details *details, const ts_verdict_info *info, ts_buffer_id id,
                           const ts_verdict *v, u32 i)
{
	difference *to = &details->differences[i];
	to->divergence = (ts_divergence){.stage = info->stage,
	                                 .buffer = info->buffer,
	                                 .how = ts_compare_how(TS_UNEQUAL),
	                                 .where = "",
	                                 .field = to->field,
	                                 .spot = to->spot,
	                                 .reference = to->reference,
	                                 .candidate = to->candidate,
	                                 .inputs = details->inputs,
	                                 .line = i == 0 ? details->line : to->line};
	if (i >= v->list.n) return;
	const ts_named *named = &v->list.items[i];
	to->divergence.how = ts_compare_how(named->difference.how);
	to->divergence.element = named->difference.element;
	to->divergence.where = named->where;
	ts_compare_difference(to->line, id, named);
	if (named->difference.how == TS_UNEQUAL) put_values(to, id, &named->difference);
}

static ts_verdict_details *make_details(const ts_verdicts *v, const ts_verdict_info *info, const ts_trace *reference,
                                        ts_buffer_id id)
{
	const ts_verdict *judged = &v->comparison->verdict[id];
	const ts_fields fields = ts_fields_of(id);
	const u32 n = judged->list.n > 0 ? judged->list.n : 1;
	ts_verdict_details *details = ts_alloc_zero(1, sizeof *details, "verdicts");
	if (details == NULL) return NULL;
	details->differences = ts_alloc_zero(n, sizeof *details->differences, "verdicts");
	if (details->differences == NULL) {
		free(details);
		return NULL;
	}
	ts_compare_inputs(details->inputs, v->comparison, reference, id);
	ts_compare_first(details->first, id, judged);
	ts_compare_line(details->line, v->comparison, reference, id);
	if (!ts_compare_note(details->note, id, judged)) details->note[0] = 0;
	details->n = judged->list.n;
	for (u32 f = 0; f < fields.n && fields.n > 1; f++) {
		if (judged->n_field[f] > 0)
			details->fields[details->n_fields++] = (ts_field_count){fields.field[f].name, judged->n_field[f]};
	}
	for (u32 i = 0; i < n; i++) put_difference(details, info, id, judged, i);
	return details;
}

ts_status ts_verdicts_add(ts_verdicts *v, const ts_trace *reference, ts_buffer_id id)
{
	const ts_verdict *judged = &v->comparison->verdict[id];
	ts_verdict_info *info = &v->info[v->n];
	*info = (ts_verdict_info){.stage = ts_emit_maker(reference->pipeline, id),
	                          .number = ts_emit_number(reference->pipeline, id),
	                          .buffer = ts_buffer_table[id].name,
	                          .judgement = judged->judgement,
	                          .verdict = ts_compare_word(judged->judgement),
	                          .why = judged->why,
	                          .n_reference = judged->n_ref,
	                          .n_candidate = judged->n_cand,
	                          .n_different = judged->n_different,
	                          .n_missing = judged->n_missing,
	                          .n_extra = judged->n_extra,
	                          .n_relaxed = judged->n_relaxed,
	                          .n_masked = judged->n_masked,
	                          .n_undecided = judged->n_undecided,
	                          .n_tied = judged->n_tied,
	                          .by_digest = judged->by_digest,
	                          .by_counts = ts_sum_of(id) != NULL,
	                          .worst_ulps = judged->worst_ulps,
	                          .seconds = judged->seconds,
	                          .has_first = judged->has_first,
	                          .first_element = judged->first.element,
	                          .first = "",
	                          .line = "",
	                          .note = "",
	                          .file = "",
	                          .text = ""};
	if (judged->judgement == TS_UNLIKE) {
		ts_verdict_details *details = v->details[v->n] = make_details(v, info, reference, id);
		if (details == NULL) return TS_ERROR;
		info->first = details->first;
		info->line = details->line;
		info->note = details->note;
		if (id == v->comparison->first) v->first = &details->differences[0].divergence;
	}
	v->n++;
	return TS_OK;
}

ts_status ts_verdicts_add_replay(ts_verdicts *v, const ts_judged *judged)
{
	const u32 b = v->n - 1;
	if (judged->item == NULL) return TS_OK;
	v->file[b] = strdup(judged->item->path);
	v->text[b] = strdup(judged->text);
	if (v->file[b] == NULL || v->text[b] == NULL) return ts_fail_as(TS_KIND_MEMORY, "verdicts: out of memory");
	v->info[b].file = v->file[b];
	v->info[b].text = v->text[b];
	v->info[b].cropped = judged->item->cropped;
	return TS_OK;
}

ts_status ts_verdicts_end(ts_verdicts *v, const ts_trace *reference, const ts_trace *candidate)
{
	v->tree = ts_compare_json(v->comparison, reference, candidate);
	return v->tree != NULL ? TS_OK : ts_fail_as(TS_KIND_MEMORY, "verdicts: out of memory");
}

static const ts_verdict_details *details_at(const ts_verdicts *v, size_t b)
{
	return v != NULL && b < v->n ? v->details[b] : NULL;
}

const ts_verdict_info *ts_verdicts_at(const ts_verdicts *v, size_t i)
{
	return v != NULL && i < v->n ? &v->info[i] : NULL;
}

const ts_divergence *ts_verdicts_first(const ts_verdicts *v) { return v != NULL ? v->first : NULL; }

const ts_divergence *ts_verdicts_difference(const ts_verdicts *v, size_t b, size_t i)
{
	const ts_verdict_details *details = details_at(v, b);
	return details != NULL && i < details->n ? &details->differences[i].divergence : NULL;
}

const ts_field_count *ts_verdicts_field(const ts_verdicts *v, size_t b, size_t i)
{
	const ts_verdict_details *details = details_at(v, b);
	return details != NULL && i < details->n_fields ? &details->fields[i] : NULL;
}

ts_tree *ts_verdicts_tree(const ts_verdicts *v)
{
	json_t *tree = v != NULL ? json_deep_copy(v->tree) : NULL;
	if (v != NULL && tree == NULL) ts_fail_as(TS_KIND_MEMORY, "verdicts: out of memory");
	return (ts_tree *)tree;
}

int ts_float_passes(const ts_compare_options *options, float reference, float candidate)
{
	const ts_compare_options none = {.bytes = sizeof none}, *o = options != NULL ? options : &none;
	const ts_relaxations relaxations = {.ulp = o->ulp, .abs = o->abs, .rel = o->rel};
	ts_floats_hold(1);
	const bool passes = ts_relax_close(&relaxations, ts_f2u(reference), ts_f2u(candidate));
	ts_floats_give();
	return passes;
}

void ts_float_text(char text[TS_FLOAT_TEXT], float value)
{
	static const ts_field field = {.name = "", .kind = 'f', .count = 1, .bytes = 4};
	if (text == NULL) return;
	ts_floats_hold(1);
	ts_field_show(text, &field, ts_f2u(value));
	ts_floats_give();
}

void ts_verdicts_free(ts_verdicts *v)
{
	if (v == NULL) return;
	for (u32 b = 0; b < v->n; b++) {
		if (v->details[b] != NULL) free(v->details[b]->differences);
		free(v->details[b]);
		free(v->file[b]);
		free(v->text[b]);
	}
	json_decref(v->tree);
	ts_comparison_free(v->comparison);
	free(v);
}
