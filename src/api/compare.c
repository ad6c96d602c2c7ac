/* Comparing and replaying. */
#include <float.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "api/verdicts.h"
#include "compare/compare.h"
#include "replay/judge.h"
#include "trace/emitted/emit.h"
#include "trace/item.h"

/* Gives the caller `v`, or releases it after a failure. */
static ts_status give(ts_verdicts **verdicts, ts_verdicts *v, ts_status status)
{
	if (status == TS_ERROR) {
		ts_verdicts_free(v);
	} else {
		*verdicts = v;
	}
	return status;
}

ts_status ts_api_relax(ts_relaxations *r, const ts_compare_options *o)
{
	const double numbers[] = {o->abs, o->rel};
	for (u32 i = 0; i < 2; i++) {
		if (!(numbers[i] >= 0) || numbers[i] > DBL_MAX) {
			return ts_fail("ts_compare_options.%s: %g; a number from 0 on is right", i == 0 ? "abs" : "rel",
			               numbers[i]);
		}
	}
	if (o->mask == NULL && (o->mask_width != 0 || o->mask_height != 0)) {
		return ts_fail("ts_compare_options.mask: is NULL; its width and height are not 0");
	}
	*r = (ts_relaxations){.ulp = o->ulp,
	                      .abs = o->abs,
	                      .rel = o->rel,
	                      .decided = o->decided != 0,
	                      .allow = o->allow,
	                      .ignore = o->ignore,
	                      .mask = o->mask,
	                      .mask_width = o->mask_width,
	                      .mask_height = o->mask_height};
	return TS_OK;
}

static ts_status judge(const ts_context *context, ts_verdicts *v, const ts_trace *reference, const ts_trace *candidate,
                       const ts_compare_options *o)
{
	ts_relaxations relaxations;
	bool part[TS_N_BUFFERS];
	if (ts_api_relax(&relaxations, o) != TS_OK) return TS_ERROR;
	if (o->stages != NULL) {
		if (ts_part_make(part, o->stages, reference, candidate, &relaxations) != TS_OK) return TS_ERROR;
		relaxations.only = part;
	}
	if (o->forced != 0) {
		return ts_compare_forced(v->comparison, reference, candidate, &relaxations, context->how.threads);
	}
	ts_status status = ts_compare_traces(v->comparison, reference, candidate, &relaxations);
	if (status != TS_DIFFERENT || o->stages == NULL) return status;
	return ts_part_inputs(v->comparison, reference, candidate, &relaxations) == TS_OK ? status : TS_ERROR;
}

static ts_status compare(const ts_context *context, ts_verdicts *v, const ts_trace *reference,
                         const ts_trace *candidate, const ts_compare_options *o)
{
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_status status = judge(context, v, reference, candidate, o);
	ts_emit_order(ids, reference->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS && status != TS_ERROR; i++) {
		const ts_verdict *judged = &v->comparison->verdict[ids[i]];
		bool none = reference->item[ids[i]].path == NULL && judged->judgement == TS_NOT_JUDGED;
		if (none || judged->aside) continue;
		if (ts_verdicts_add(v, reference, ids[i]) != TS_OK) status = TS_ERROR;
	}
	return status != TS_ERROR && ts_verdicts_end(v, reference, candidate) != TS_OK ? TS_ERROR : status;
}

ts_status ts_compare(ts_context *context, ts_verdicts **verdicts, const ts_trace *reference, const ts_trace *candidate,
                     const ts_compare_options *options)
{
	ts_compare_options ours = {0};
	if (TS_LACKS(verdicts)) return TS_ERROR;
	*verdicts = NULL;
	if (TS_LACKS(context) || TS_LACKS(reference) || TS_LACKS(candidate)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_compare_options") != TS_OK) return TS_ERROR;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_verdicts *v = ts_verdicts_make(ours.first > 0 ? ours.first : 1);
	ts_status status = v != NULL ? compare(context, v, reference, candidate, &ours) : TS_ERROR;
	ts_api_leave();
	return give(verdicts, v, status);
}

static ts_status mark(u8 *marks, size_t n, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                      const ts_compare_options *o)
{
	ts_relaxations relaxations;
	ts_verdict verdict = {.marks = marks};
	const u64 elements = reference->item[id].npy.n;
	if (ts_api_relax(&relaxations, o) != TS_OK) return TS_ERROR;
	if (reference->item[id].path != NULL && n != elements) {
		return ts_fail("%s: %zu marks; %" PRIu64 ", one an element, are right", ts_buffer_table[id].name, n, elements);
	}
	memset(marks, 0, n);
	ts_status status = ts_compare_alone(&verdict, id, reference, candidate, &relaxations);
	if (status != TS_OK) return status;
	return verdict.judgement == TS_UNLIKE ? TS_DIFFERENT : TS_OK;
}

ts_status ts_compare_marks(ts_context *context, uint8_t *marks, size_t n, const char *buffer, const ts_trace *reference,
                           const ts_trace *candidate, const ts_compare_options *options)
{
	ts_compare_options ours = {0};
	ts_buffer_id id;
	if (TS_LACKS(context) || TS_LACKS(marks) || TS_LACKS(buffer) || TS_LACKS(reference) || TS_LACKS(candidate)) {
		return TS_ERROR;
	}
	if (ts_api_options(&ours, sizeof ours, options, "ts_compare_options") != TS_OK) return TS_ERROR;
	if (ts_api_buffer(&id, buffer) != TS_OK || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = mark(marks, n, id, reference, candidate, &ours);
	ts_api_leave();
	return status;
}

/* Outputs of a stage, and how each was judged. */
typedef struct {
	ts_verdicts *verdicts;
	const ts_load *load;
	const ts_relaxations *relaxations;
	bool lent;
	ts_judged judged[TS_N_BUFFERS];
} outputs;

/* A candidate is judged by its own buffers, unless the reference lends it some. */
static ts_status judge_output(outputs *o, ts_buffer_id id)
{
	ts_comparison *c = o->verdicts->comparison;
	const ts_trace *candidate = o->load->candidate;
	ts_judged *judged = &o->judged[id];
	*judged = (ts_judged){.verdict = c->verdict[id]};
	const bool own = o->lent || candidate == NULL || candidate->item[id].path != NULL;
	if (own && ts_judge(judged, o->load, id, o->relaxations) == TS_ERROR) return TS_ERROR;
	if (judged->item == NULL) {
		c->verdict[id].judgement = TS_MISSING;
		return TS_OK;
	}
	c->verdict[id] = judged->verdict;
	if (judged->shape_differs) snprintf(c->verdict[id].why, TS_WHY_TEXT, "%s", judged->text);
	c->n_judged++;
	c->n_unlike += judged->verdict.judgement == TS_UNLIKE;
	if (judged->verdict.judgement == TS_UNLIKE && c->first == TS_N_BUFFERS) c->first = id;
	return TS_OK;
}

static ts_status judge_outputs(outputs *o, const ts_stage *stage)
{
	const ts_comparison *c = o->verdicts->comparison;
	const ts_load *load = o->load;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (!load->run.frame.buffer[*id].made || judge_output(o, *id) == TS_OK) continue;
		return ts_fail("stage %s: %s", stage->name, ts_error_message());
	}
	if (c->n_judged > 0 || o->lent) return c->n_unlike > 0 ? TS_DIFFERENT : TS_OK;
	return ts_fail("stage %s: %s has none of its outputs to compare with", stage->name,
	               load->candidate != NULL ? load->candidate->dir : load->reference->dir);
}

static ts_status list_outputs(const outputs *o, const ts_stage *stage)
{
	ts_verdicts *v = o->verdicts;
	const ts_trace *reference = o->load->reference, *candidate = o->load->candidate;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (!o->load->run.frame.buffer[*id].made) continue;
		if (ts_verdicts_add(v, reference, *id) != TS_OK) return TS_ERROR;
		if (ts_verdicts_add_replay(v, &o->judged[*id]) != TS_OK) return TS_ERROR;
	}
	return ts_verdicts_end(v, reference, candidate != NULL ? candidate : reference);
}

/* Runs the stage of that name on the inputs of both. */
static ts_status run_stage(const ts_context *context, ts_load **load, const ts_stage **stage, const char *name,
                           const ts_trace *reference, const ts_trace *candidate)
{
	if (ts_load_match(reference, candidate) != TS_OK) return TS_ERROR;
	*stage = ts_replay_find(name, reference->pipeline, &reference->params);
	if (*stage == NULL) return TS_ERROR;
	ts_buffer_id other = candidate != NULL ? ts_forced_mixed(*stage, reference, candidate) : TS_N_BUFFERS;
	if (other != TS_N_BUFFERS) {
		return ts_fail("stage %s: the candidate has no %s, and the reference's names points in another order",
		               (*stage)->name, ts_buffer_table[other].name);
	}
	return ts_replay_run(load, *stage, reference, candidate, context->how.threads);
}

static ts_status replay(const ts_context *context, ts_verdicts *v, const char *name, const ts_trace *reference,
                        const ts_trace *candidate, const ts_compare_options *o)
{
	ts_load *load;
	const ts_stage *stage;
	ts_relaxations relaxations;
	if (ts_api_relax(&relaxations, o) != TS_OK || ts_relax_check(&relaxations) != TS_OK) return TS_ERROR;
	if (run_stage(context, &load, &stage, name, reference, candidate) != TS_OK) return TS_ERROR;
	ts_comparison_begin(v->comparison);
	v->comparison->forced = candidate != NULL;
	outputs *outs = ts_alloc(1, sizeof *outs, "verdicts");
	ts_status status = outs != NULL ? TS_OK : TS_ERROR;
	if (status == TS_OK) {
		*outs = (outputs){.verdicts = v, .load = load, .relaxations = &relaxations, .lent = o->lent != 0};
		status = judge_outputs(outs, stage);
	}
	if (status != TS_ERROR && list_outputs(outs, stage) != TS_OK) status = TS_ERROR;
	free(outs);
	ts_load_end(load);
	return status;
}

ts_status ts_replay(ts_context *context, ts_verdicts **verdicts, const char *stage, const ts_trace *reference,
                    const ts_trace *candidate, const ts_compare_options *options)
{
	ts_compare_options ours = {0};
	if (TS_LACKS(verdicts)) return TS_ERROR;
	*verdicts = NULL;
	if (TS_LACKS(context) || TS_LACKS(stage) || TS_LACKS(reference)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_compare_options") != TS_OK) return TS_ERROR;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_verdicts *v = ts_verdicts_make(ours.first > 0 ? ours.first : 1);
	ts_status status = v != NULL ? replay(context, v, stage, reference, candidate, &ours) : TS_ERROR;
	ts_api_leave();
	return give(verdicts, v, status);
}

static ts_status keep_outputs(ts_trace **trace, const ts_load *load, const ts_stage *stage)
{
	ts_status status = TS_OK;
	ts_trace *made = ts_trace_new("the replayed stage");
	if (made == NULL) return TS_ERROR;
	made->pipeline = load->pipeline;
	made->has_params = true;
	made->params = load->run.params;
	made->replayed = stage;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS && status == TS_OK; id++) {
		const ts_buffer *buffer = &load->run.frame.buffer[*id];
		ts_npy npy = {.n_dims = buffer->n_dims, .n = buffer->n};
		memcpy(npy.shape, buffer->shape, sizeof npy.shape);
		if (buffer->made) status = ts_item_keep(made, *id, &npy, buffer->data);
	}
	if (status == TS_OK) *trace = made;
	if (status != TS_OK) ts_trace_close(made);
	return status;
}

ts_status ts_trace_replay(ts_context *context, ts_trace **trace, const char *stage, const ts_trace *reference,
                          const ts_trace *candidate)
{
	ts_load *load;
	const ts_stage *found;
	if (TS_LACKS(trace)) return TS_ERROR;
	*trace = NULL;
	if (TS_LACKS(context) || TS_LACKS(stage) || TS_LACKS(reference) || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = run_stage(context, &load, &found, stage, reference, candidate);
	if (status == TS_OK) {
		status = keep_outputs(trace, load, found);
		ts_load_end(load);
	}
	ts_api_leave();
	return status;
}
