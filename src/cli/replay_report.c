/* Lines and objects of verdicts. */
#include "replay_report.h"
#include <inttypes.h>
#include <stdio.h>
#include "../scene/print.h"
#include "../trace/emit.h"

enum { LINE = 8192 };

void ts_replay_report_begin(ts_report *report, const ts_trace *reference, const ts_trace *candidate)
{
	ts_report_value(report, "trace", ts_text_json(reference->dir));
	ts_report_value(report, "inputs", candidate != NULL ? ts_text_json(candidate->dir) : json_null());
	ts_report_value(report, "pipeline", json_string(reference->pipeline->name));
	ts_report_value(report, "stages", json_array());
}

/* "same, 12 elements", "different in 3 of 12 elements, first element 2: ...", "not compared: ...". */
static void describe(char text[LINE], const ts_judged *v)
{
	if (v->item == NULL) {
		snprintf(text, LINE, "not compared, because there is no file of it");
	} else if (v->shape_differs) {
		snprintf(text, LINE, "different, %s in %s", v->text, v->item->path);
	} else if (v->verdict.n_different > 0) {
		snprintf(text, LINE, "different in %" PRIu64 " of %" PRIu64 " elements, first %s in %s", v->verdict.n_different,
		         v->verdict.n_ref, v->text, v->item->path);
	} else {
		snprintf(text, LINE, "same, %" PRIu64 " elements%s", v->verdict.n_ref, v->item->cropped ? " of a crop" : "");
	}
}

static json_t *verdict_json(const ts_judged *v)
{
	bool different = v->shape_differs || v->verdict.n_different > 0;
	const char *verdict = v->item == NULL ? "not compared" : different ? "different" : "same";
	json_t *root =
		json_pack("{s:s, s:s, s:o, s:I, s:I, s:s}", "buffer", ts_buffer_table[v->id].name, "verdict", verdict, "file",
	              v->item != NULL ? ts_text_json(v->item->path) : json_null(), "elements", (json_int_t)v->verdict.n_ref,
	              "different", (json_int_t)v->verdict.n_different, "text", v->text);
	if (!v->verdict.has_first) return root;
	const ts_difference *d = &v->verdict.first;
	const ts_fields fields = ts_fields_of(v->id);
	char right[TS_VALUE_TEXT], found[TS_VALUE_TEXT];
	ts_field_show(right, &fields.field[d->field], d->ref);
	ts_field_show(found, &fields.field[d->field], d->cand);
	json_t *first =
		json_pack("{s:I, s:s, s:i, s:s, s:s}", "element", (json_int_t)d->element, "field", fields.field[d->field].name,
	              "component", (int)d->component, "replayed", right, "found", found);
	json_object_set_new(root, "first", first);
	return root;
}

static void add_stage(ts_report *report, const ts_replayed *r, u32 number)
{
	static const char *const verdicts[] = {[TS_OK] = "same", [TS_DIFFERENT] = "different", [TS_ERROR] = "not replayed"};
	json_t *outputs = json_array();
	for (u32 i = 0; i < r->n_judged && r->status != TS_ERROR; i++) {
		json_array_append_new(outputs, verdict_json(&r->judged[i]));
	}
	json_t *stage = json_pack("{s:i, s:s, s:s, s:o, s:o}", "number", (int)number, "stage", r->stage->name, "verdict",
	                          verdicts[r->status], "error",
	                          r->status == TS_ERROR ? ts_text_json(r->error) : json_null(), "outputs", outputs);
	report->failed |= json_array_append_new(json_object_get(report->root, "stages"), stage) != 0;
}

void ts_replay_report_outputs(ts_report *report, const ts_replayed *r, const ts_pipeline *pipeline)
{
	char text[LINE];
	u32 number = ts_emit_number(pipeline, ts_stage_outputs(r->stage)[0]);
	for (u32 i = 0; i < r->n_judged; i++) {
		const ts_judged *v = &r->judged[i];
		bool failed = v->shape_differs || v->verdict.n_different > 0;
		describe(text, v);
		(failed ? ts_report_failure : ts_report_line)(report, "stage %02u %s, buffer %s: %s", (unsigned)number,
		                                              r->stage->name, ts_buffer_table[v->id].name, text);
	}
	add_stage(report, r, number);
}

void ts_replay_report_stage(ts_report *report, const ts_replayed *r, const ts_pipeline *pipeline)
{
	char text[LINE] = "same";
	const char *buffer = "";
	u32 number = ts_emit_number(pipeline, ts_stage_outputs(r->stage)[0]);
	for (u32 i = r->n_judged; i-- > 0;) {
		const ts_judged *v = &r->judged[i];
		if (v->item != NULL && !v->shape_differs && v->verdict.n_different == 0) continue;
		describe(text, v);
		buffer = ts_buffer_table[v->id].name;
	}
	if (r->status == TS_ERROR) {
		size_t name = strlen("stage : ") + strlen(r->stage->name); /* that the message begins with */
		const char *why = strlen(r->error) > name ? r->error + name : r->error;
		ts_report_failure(report, "stage %02u %s: not replayed: %s", (unsigned)number, r->stage->name, why);
	} else {
		(r->status == TS_OK ? ts_report_line : ts_report_failure)(report, "stage %02u %s%s%s: %s", (unsigned)number,
		                                                          r->stage->name, buffer[0] != 0 ? ", buffer " : "",
		                                                          buffer, text);
	}
	add_stage(report, r, number);
}
