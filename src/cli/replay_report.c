/* Lines and objects of verdicts. */
#include "cli/replay_report.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "output/json/text.h"

enum { LINE = 8192 };

void ts_replay_report_begin(ts_report *report, ts_trace *reference, ts_trace *candidate)
{
	const char *inputs = candidate != NULL ? ts_trace_about(candidate)->folder : NULL;
	ts_report_value(report, "trace", ts_text_json(ts_trace_about(reference)->folder));
	ts_report_value(report, "inputs", inputs != NULL ? ts_text_json(inputs) : json_null());
	ts_report_value(report, "pipeline", json_string(ts_trace_about(reference)->method));
	ts_report_value(report, "stages", json_array());
}

/* Neither side has a file of it. */
static bool is_absent(const ts_verdict_info *v) { return v->judgement == TS_MISSING; }
static bool differs(const ts_verdict_info *v) { return v->why[0] != 0 || v->n_different > 0; }

/* "same, 12 elements", "different in 3 of 12 elements, first element 2: ...", "not compared: ...". */
static void describe(char text[LINE], const ts_verdict_info *v)
{
	if (is_absent(v)) {
		snprintf(text, LINE, "not compared, because there is no file of it");
	} else if (v->why[0] != 0) {
		snprintf(text, LINE, "different, %s in %s", v->text, v->file);
	} else if (v->n_different > 0) {
		snprintf(text, LINE, "different in %" PRIu64 " of %" PRIu64 " elements, first %s in %s", v->n_different,
		         v->n_reference, v->text, v->file);
	} else {
		snprintf(text, LINE, "same, %" PRIu64 " elements%s", v->n_reference, v->cropped ? " of a crop" : "");
	}
}

/* The first element of both that differs; NULL: there is none. */
static const ts_divergence *first_of(const ts_verdicts *verdicts, size_t b)
{
	const ts_divergence *d;
	for (size_t i = 0; (d = ts_verdicts_difference(verdicts, b, i)) != NULL; i++) {
		if (strcmp(d->how, "different") == 0) return d;
	}
	return NULL;
}

static json_t *verdict_json(const ts_verdicts *verdicts, size_t b)
{
	const ts_verdict_info *v = ts_verdicts_at(verdicts, b);
	const char *verdict = is_absent(v) ? "not compared" : differs(v) ? "different" : "same";
	json_t *root = json_pack("{s:s, s:s, s:o, s:I, s:I, s:s}", "buffer", v->buffer, "verdict", verdict, "file",
	                         is_absent(v) ? json_null() : ts_text_json(v->file), "elements", (json_int_t)v->n_reference,
	                         "different", (json_int_t)v->n_different, "text", v->text);
	const ts_divergence *d = first_of(verdicts, b);
	if (d == NULL) return root;
	json_t *first = json_pack("{s:I, s:s, s:i, s:s, s:s}", "element", (json_int_t)d->element, "field", d->field,
	                          "component", (int)d->component, "replayed", d->reference, "found", d->candidate);
	json_object_set_new(root, "first", first);
	return root;
}

static void add_stage(ts_report *report, const ts_replayed *r)
{
	static const char *const verdicts[] = {[TS_OK] = "same", [TS_DIFFERENT] = "different", [TS_ERROR] = "not replayed"};
	json_t *outputs = json_array();
	for (size_t b = 0; ts_verdicts_at(r->verdicts, b) != NULL && r->status != TS_ERROR; b++) {
		json_array_append_new(outputs, verdict_json(r->verdicts, b));
	}
	json_t *stage = json_pack("{s:i, s:s, s:s, s:o, s:o}", "number", (int)r->number, "stage", r->stage, "verdict",
	                          verdicts[r->status], "error",
	                          r->status == TS_ERROR ? ts_text_json(r->error) : json_null(), "outputs", outputs);
	report->failed |= json_array_append_new(json_object_get(report->root, "stages"), stage) != 0;
}

void ts_replay_report_outputs(ts_report *report, const ts_replayed *r)
{
	char text[LINE];
	const ts_verdict_info *v;
	for (size_t b = 0; (v = ts_verdicts_at(r->verdicts, b)) != NULL; b++) {
		describe(text, v);
		(differs(v) ? ts_report_failure : ts_report_line)(report, "stage %02u %s, buffer %s: %s", (unsigned)r->number,
		                                                  r->stage, v->buffer, text);
	}
	add_stage(report, r);
}

void ts_replay_report_stage(ts_report *report, const ts_replayed *r)
{
	char text[LINE] = "same";
	const char *buffer = "";
	const ts_verdict_info *v;
	for (size_t b = 0; (v = ts_verdicts_at(r->verdicts, b)) != NULL && buffer[0] == 0; b++) {
		if (!is_absent(v) && !differs(v)) continue;
		describe(text, v);
		buffer = v->buffer;
	}
	if (r->status == TS_ERROR) {
		char begin[96];
		snprintf(begin, sizeof begin, "stage %s: ", r->stage);
		const char *why = strncmp(r->error, begin, strlen(begin)) == 0 ? r->error + strlen(begin) : r->error;
		ts_report_failure(report, "stage %02u %s: not replayed: %s", (unsigned)r->number, r->stage, why);
	} else {
		(r->status == TS_OK ? ts_report_line : ts_report_failure)(report, "stage %02u %s%s%s: %s", (unsigned)r->number,
		                                                          r->stage, buffer[0] != 0 ? ", buffer " : "", buffer,
		                                                          text);
	}
	add_stage(report, r);
}
