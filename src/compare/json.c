/* Differences as objects. */
#include <inttypes.h>
#include "compare/line.h"
#include "output/json/text.h"
#include "trace/emitted/emit.h"

/* For sums the counted element; -1: none, at their beginning. */
static json_int_t element_of(ts_buffer_id id, const ts_difference *d)
{
	return (json_int_t)d->element - (ts_sum_of(id) != NULL);
}

/* Hexadecimal, as wide as the field; null for a count, which no field holds. */
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

/* A buffer that differs. NULL without memory. */
static json_t *buffer_json(const ts_comparison *c, const ts_trace *reference, ts_buffer_id id)
{
	char line[TS_LINE_TEXT];
	const ts_verdict *v = &c->verdict[id];
	const ts_fields fields = ts_fields_of(id);
	json_t *by_field = json_object(), *first = json_array();
	int failed = 0;
	for (u32 f = 0; f < fields.n && fields.n > 1; f++) {
		if (v->n_field[f] == 0) continue;
		failed |= json_object_set_new(by_field, fields.field[f].name, json_integer((json_int_t)v->n_field[f]));
	}
	for (u32 d = 0; d < v->list.n; d++) {
		failed |= json_array_append_new(first, difference_json(id, &v->list.items[d]));
	}
	const char *by = v->by_digest ? "digest" : ts_sum_of(id) != NULL ? "counts" : "elements";
	ts_compare_line(line, c, reference, id);
	json_t *o = json_pack("{s:s, s:s, s:s, s:s, s:I, s:o, s:o}", "stage", ts_emit_maker(reference->pipeline, id),
	                      "buffer", ts_buffer_table[id].name, "judged_by", by, "line", line, "candidate_elements",
	                      (json_int_t)v->n_cand, "fields", by_field, "first", first);
	if (failed == 0) return o;
	json_decref(o);
	return NULL;
}

static json_t *all_json(const ts_comparison *c, const ts_trace *reference)
{
	ts_buffer_id ids[TS_N_BUFFERS];
	json_t *array = json_array();
	int failed = 0;
	ts_emit_order(ids, reference->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		const ts_verdict *v = &c->verdict[ids[i]];
		if (v->judgement != TS_UNLIKE || v->aside) continue;
		failed |= json_array_append_new(array, buffer_json(c, reference, ids[i]));
	}
	if (failed == 0) return array;
	json_decref(array);
	return NULL;
}

/* The first difference of all, as members. */
static json_t *divergence_json(const ts_comparison *c, const ts_trace *reference)
{
	char inputs[TS_INPUTS_TEXT];
	const ts_verdict *v = &c->verdict[c->first];
	json_t *fields =
		json_pack("{s:s, s:i, s:s}", "stage", ts_emit_maker(reference->pipeline, c->first), "number",
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

json_t *ts_compare_json(const ts_comparison *c, const ts_trace *reference, const ts_trace *candidate)
{
	char line[TS_LINE_TEXT];
	json_t *o =
		json_pack("{s:s, s:I, s:o, s:o, s:o, s:o, s:s}", "verdict", c->n_unlike > 0 ? "different" : "same", "judged",
	              (json_int_t)c->n_judged, "differences", all_json(c, reference), "reference",
	              ts_text_json(reference->dir), "candidate", ts_text_json(candidate->dir), "candidate_producer",
	              ts_text_json(candidate->producer), "candidate_order", candidate->arrival ? "arrival" : "canonical");
	if (o == NULL || c->first == TS_N_BUFFERS) return o;
	ts_compare_line(line, c, reference, c->first);
	int failed = json_object_set_new(o, "first_divergence", json_string(line));
	failed |= json_object_set_new(o, "divergence", divergence_json(c, reference));
	if (failed == 0) return o;
	json_decref(o);
	return NULL;
}
