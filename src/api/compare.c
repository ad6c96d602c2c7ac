/* Verdicts of comparisons and replays, as structs. */
#include "api.h"
#include <touchstone/compare.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>
#include "../compare/line.h"
#include "../replay/forced.h"
#include "../replay/judge.h"
#include "../trace/emit.h"
#include "../trace/item.h"

struct ts_verdicts {
	ts_comparison *comparison;
	ts_verdict_info info[TS_N_BUFFERS];
	u32 n;
	bool different;
	ts_divergence first;
	char where[TS_WHERE_TEXT], field[64], reference[TS_VALUE_TEXT], candidate[TS_VALUE_TEXT];
	char inputs[TS_INPUTS_TEXT], line[TS_LINE_TEXT];
};

static const char *stage_of(const ts_trace *reference, ts_buffer_id id)
{
	const ts_step *step = ts_pipeline_maker(reference->pipeline, id);
	return step != NULL ? step->stage : "scene";
}

static void list(ts_verdicts *v, const ts_trace *reference, ts_buffer_id id)
{
	const ts_verdict *judged = &v->comparison->verdict[id];
	v->info[v->n++] = (ts_verdict_info){.stage = stage_of(reference, id),
	                                    .buffer = ts_buffer_table[id].name,
	                                    .verdict = ts_compare_word(judged->judgement),
	                                    .why = judged->why,
	                                    .n_reference = judged->n_ref,
	                                    .n_candidate = judged->n_cand,
	                                    .n_different = judged->n_different,
	                                    .n_missing = judged->n_missing,
	                                    .n_extra = judged->n_extra,
	                                    .n_relaxed = judged->n_relaxed,
	                                    .n_masked = judged->n_masked,
	                                    .n_undecided = judged->n_undecided};
}

static void tell_element(ts_verdicts *v, ts_buffer_id id, const ts_named *named)
{
	const ts_difference *d = &named->difference;
	memcpy(v->where, named->where, sizeof v->where);
	v->first.how = ts_compare_how(d->how);
	v->first.element = d->element;
	if (d->how != TS_UNEQUAL) return;
	const ts_fields fields = ts_fields_of(id);
	snprintf(v->field, sizeof v->field, "%s", fields.field[d->field].name);
	ts_difference_show(v->reference, id, d, d->ref);
	ts_difference_show(v->candidate, id, d, d->cand);
	v->first.component = d->component;
	v->first.reference_bits = d->ref;
	v->first.candidate_bits = d->cand;
	v->first.ulps = ts_compare_ulps(id, d);
}

static void tell_first(ts_verdicts *v, const ts_trace *reference)
{
	ts_buffer_id id = v->comparison->first;
	if (id == TS_N_BUFFERS) return;
	const ts_verdict *judged = &v->comparison->verdict[id];
	v->different = true;
	v->first = (ts_divergence){.stage = stage_of(reference, id),
	                           .buffer = ts_buffer_table[id].name,
	                           .how = "different",
	                           .where = v->where,
	                           .field = v->field,
	                           .reference = v->reference,
	                           .candidate = v->candidate,
	                           .inputs = v->inputs,
	                           .line = v->line};
	if (judged->list.n > 0) tell_element(v, id, &judged->list.items[0]);
	ts_compare_inputs(v->inputs, v->comparison, reference, id);
	ts_compare_line(v->line, v->comparison, reference, id);
}

/* Takes over what was made in `v`, or releases it. */
static ts_status give(ts_verdicts **verdicts, ts_verdicts *v, ts_status status)
{
	if (status == TS_ERROR) {
		ts_verdicts_free(v);
	} else {
		*verdicts = v;
	}
	return status;
}

static ts_verdicts *make(void)
{
	ts_verdicts *v = ts_alloc_zero(1, sizeof *v, "verdicts");
	if (v == NULL) return NULL;
	v->comparison = ts_comparison_make(1);
	if (v->comparison != NULL) return v;
	free(v);
	return NULL;
}

static ts_status relax(ts_relaxations *r, const ts_compare_options *o)
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

static ts_status compare(const ts_context *context, ts_verdicts *v, const ts_trace *reference,
                         const ts_trace *candidate, const ts_compare_options *o)
{
	ts_relaxations relaxations;
	if (relax(&relaxations, o) != TS_OK) return TS_ERROR;
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_status status = o->forced != 0
	                       ? ts_compare_forced(v->comparison, reference, candidate, &relaxations, context->how.threads)
	                       : ts_compare_traces(v->comparison, reference, candidate, &relaxations);
	ts_emit_order(ids, reference->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS && status != TS_ERROR; i++) {
		if (reference->item[ids[i]].path != NULL) list(v, reference, ids[i]);
	}
	if (status == TS_DIFFERENT) tell_first(v, reference);
	return status;
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
	ts_verdicts *v = make();
	ts_status status = v != NULL ? compare(context, v, reference, candidate, &ours) : TS_ERROR;
	ts_api_leave();
	return give(verdicts, v, status);
}

/* A candidate is judged by what it has alone. */
static ts_status judge_output(ts_verdicts *v, const ts_load *load, ts_buffer_id id, const ts_relaxations *relaxations)
{
	ts_comparison *c = v->comparison;
	ts_judged judged = {.verdict = c->verdict[id]};
	if (load->candidate != NULL && load->candidate->item[id].path == NULL) {
		c->verdict[id].judgement = TS_MISSING;
		return TS_OK;
	}
	if (ts_judge(&judged, load, id, relaxations) == TS_ERROR) return TS_ERROR;
	c->verdict[id] = judged.verdict;
	if (judged.shape_differs) snprintf(c->verdict[id].why, TS_WHY_TEXT, "%s", judged.text);
	c->n_judged += judged.item != NULL;
	c->n_unlike += judged.verdict.judgement == TS_UNLIKE;
	if (judged.verdict.judgement == TS_UNLIKE && c->first == TS_N_BUFFERS) c->first = id;
	return TS_OK;
}

static ts_status judge_outputs(ts_verdicts *v, const ts_load *load, const ts_stage *stage,
                               const ts_relaxations *relaxations)
{
	const ts_comparison *c = v->comparison;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (!load->run.frame.buffer[*id].made) continue;
		if (judge_output(v, load, *id, relaxations) != TS_OK) {
			return ts_fail("stage %s: %s", stage->name, ts_error_message());
		}
		list(v, load->reference, *id);
	}
	if (c->n_judged > 0) return c->n_unlike > 0 ? TS_DIFFERENT : TS_OK;
	return ts_fail("stage %s: %s has none of its outputs to compare with", stage->name,
	               load->candidate != NULL ? load->candidate->dir : load->reference->dir);
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
	if (relax(&relaxations, o) != TS_OK || ts_relax_check(&relaxations) != TS_OK) return TS_ERROR;
	if (run_stage(context, &load, &stage, name, reference, candidate) != TS_OK) return TS_ERROR;
	ts_comparison_begin(v->comparison);
	v->comparison->forced = candidate != NULL;
	ts_status status = judge_outputs(v, load, stage, &relaxations);
	if (status == TS_DIFFERENT) tell_first(v, reference);
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
	ts_verdicts *v = make();
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

const ts_verdict_info *ts_verdicts_at(const ts_verdicts *verdicts, size_t i)
{
	return verdicts != NULL && i < verdicts->n ? &verdicts->info[i] : NULL;
}

const ts_divergence *ts_verdicts_first(const ts_verdicts *verdicts)
{
	return verdicts != NULL && verdicts->different ? &verdicts->first : NULL;
}

void ts_verdicts_free(ts_verdicts *verdicts)
{
	if (verdicts == NULL) return;
	ts_comparison_free(verdicts->comparison);
	free(verdicts);
}
