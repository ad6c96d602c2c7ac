/* What items compute. */
#include <string.h>
#include <touchstone/explain.h>
#include "api/api.h"
#include "explain/explain.h"
#include "study/asked/words.h"

enum { LINES = 20000, OUTLINED = 1000000 };

static ts_status take_kernel(ts_question *q, const char *name)
{
	ts_nearest nearest = ts_nearest_begin(name);
	for (u32 k = 0; k < TS_N_KERNELS; k++) {
		ts_nearest_offer(&nearest, ts_kernel_name(k));
		if (strcmp(ts_kernel_name(k), name) == 0) q->kernel = k;
	}
	if (q->kernel != TS_N_KERNELS) return TS_OK;
	return ts_fail("kernel %s: no such kernel%s", name, ts_nearest_hint(&nearest, NULL));
}

static ts_status take_element(ts_question *q, const ts_explain_options *o, const ts_stage *stage)
{
	if (o->item_said != 0 || o->kernel != NULL) {
		return ts_fail("ts_explain_options.buffer: its element finds kernel and item; leave both out");
	}
	q->subject = TS_EXPLAIN_ELEMENT;
	q->element = o->element;
	if (ts_api_buffer(&q->buffer, o->buffer) != TS_OK) return TS_ERROR;
	if (ts_stage_writes(stage, q->buffer)) return TS_OK;
	return ts_fail("stage %s writes no buffer %s; the table of its outputs names all", stage->name, o->buffer);
}

static ts_status take_question(ts_question *q, const ts_explain_options *o, const ts_stage *stage)
{
	u64 most = o->outline != 0 ? OUTLINED : LINES;
	*q = (ts_question){.subject = o->item_said != 0 ? TS_EXPLAIN_ITEM : TS_EXPLAIN_LAUNCHES,
	                   .kernel = TS_N_KERNELS,
	                   .item = o->item,
	                   .buffer = TS_N_BUFFERS,
	                   .primitives = o->primitives != 0,
	                   .most = o->lines != 0 ? o->lines : most};
	if (o->buffer != NULL) return take_element(q, o, stage);
	return o->kernel != NULL ? take_kernel(q, o->kernel) : TS_OK;
}

static ts_status make_answer(json_t **answer, const ts_told_what *what, bool as_text)
{
	size_t number;
	*answer = as_text ? ts_explain_lines(what) : ts_explain_json(what);
	if (*answer == NULL) return ts_fail_as(TS_KIND_MEMORY, "an explanation: out of memory");
	return what->b != NULL && ts_explain_differ(&number, what->a, what->b) ? TS_DIFFERENT : TS_OK;
}

static ts_status explain(json_t **answer, const ts_explain_options *o, const ts_trace *trace, const ts_trace *inputs,
                         const ts_trace *other)
{
	ts_question question;
	ts_explanation a, b = {.load = NULL};
	if (inputs != NULL && other != NULL) return ts_fail("ts_explain_item: inputs or other, not both; NULL for one");
	if (ts_load_match(trace, other) != TS_OK) return TS_ERROR;
	const ts_stage *stage = ts_replay_find(o->stage, trace->pipeline, &trace->params);
	if (stage == NULL || take_question(&question, o, stage) != TS_OK) return TS_ERROR;
	ts_status status = ts_explain(&a, stage, &question, trace, inputs);
	if (status == TS_OK && other != NULL) status = ts_explain(&b, stage, &question, trace, other);
	if (status == TS_OK) {
		const ts_told_what what = {.stage = stage,
		                           .question = &question,
		                           .trace = trace,
		                           .inputs = inputs,
		                           .other = other,
		                           .a = &a,
		                           .b = other != NULL ? &b : NULL,
		                           .outline = o->outline != 0};
		status = make_answer(answer, &what, o->as_text != 0);
	}
	ts_explain_end(&b);
	ts_explain_end(&a);
	return status;
}

ts_status ts_explain_item(ts_context *context, ts_tree **answer, const ts_explain_options *options,
                          const ts_trace *trace, const ts_trace *inputs, const ts_trace *other)
{
	ts_explain_options ours = {0};
	json_t *made = NULL;
	if (TS_LACKS(answer)) return TS_ERROR;
	*answer = NULL;
	if (TS_LACKS(context) || TS_LACKS(options) || TS_LACKS(trace)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_explain_options") != TS_OK) return TS_ERROR;
	const char *stage = ours.stage;
	if (TS_LACKS(stage) || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = explain(&made, &ours, trace, inputs, other);
	ts_api_leave();
	*answer = (ts_tree *)made;
	return status;
}
