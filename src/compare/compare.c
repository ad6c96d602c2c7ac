/* Comparison of two traces. */
#include "compare/compare.h"
#include <stdio.h>
#include <stdlib.h>
#include "compare/digests.h"
#include "trace/emit.h"

ts_comparison *ts_comparison_make(u32 most)
{
	ts_comparison *c = ts_alloc_zero(1, sizeof *c, "a comparison");
	if (c == NULL) return NULL;
	c->most = most;
	c->named = ts_alloc((size_t)TS_N_BUFFERS * most, sizeof *c->named, "first differences");
	if (c->named != NULL) return c;
	free(c);
	return NULL;
}

void ts_comparison_free(ts_comparison *c)
{
	if (c != NULL) free(c->named);
	free(c);
}

void ts_comparison_begin(ts_comparison *c)
{
	*c = (ts_comparison){.first = TS_N_BUFFERS, .named = c->named, .most = c->most};
	for (u32 id = 0; id < TS_N_BUFFERS && c->named != NULL; id++) {
		c->verdict[id].list = (ts_differences){.items = c->named + (size_t)id * c->most, .most = c->most};
	}
}

static void count(ts_comparison *c, ts_buffer_id id)
{
	ts_judgement judgement = c->verdict[id].judgement;
	c->n_judged += judgement == TS_SAME || judgement == TS_UNLIKE;
	c->n_unlike += judgement == TS_UNLIKE;
	c->n_missing += judgement == TS_MISSING;
	c->n_unable += judgement == TS_UNABLE;
	if (judgement == TS_UNLIKE && c->first == TS_N_BUFFERS) c->first = id;
}

/* Sets with a key other than the points' have their own order. */
static ts_status judge_given(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                             const ts_order *points, const ts_relaxations *relaxations)
{
	ts_order own;
	ts_buffer_id key = ts_order_key_of(id);
	if (key == TS_N_BUFFERS || key == points->key) {
		return ts_compare_buffer(verdict, id, reference, candidate, points, relaxations);
	}
	ts_status status = ts_order_make(&own, key, reference, candidate);
	if (status == TS_OK) status = ts_compare_buffer(verdict, id, reference, candidate, &own, relaxations);
	ts_order_free(&own);
	return status;
}

#define LACKS_ORDER "points in the order of their arrival are told apart by %s, which is not there"
static bool lacks_order(ts_buffer_id id, const ts_trace *candidate, const ts_order *order)
{
	return candidate->arrival && !order->given && ts_order_is_of_points(id);
}

static ts_status judge_one(ts_comparison *c, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                           const ts_order *order, const ts_relaxations *relaxations)
{
	ts_verdict *v = &c->verdict[id];
	ts_status status = TS_OK;
	const ts_trace_item *ref = &reference->item[id], *cand = &candidate->item[id];
	if (!ts_digest_known(ref) || !ts_relax_takes(relaxations, id)) return TS_OK;
	if (ts_relax_ignores(relaxations, ts_buffer_table[id].name)) {
		v->judgement = TS_IGNORED;
	} else if (!ts_digest_known(cand)) {
		v->judgement = TS_MISSING;
	} else if (ref->path == NULL || cand->path == NULL) {
		status = ts_compare_digests(v, id, reference, candidate, relaxations);
	} else if (lacks_order(id, candidate, order)) {
		v->judgement = TS_UNABLE;
		snprintf(v->why, sizeof v->why, LACKS_ORDER, ts_buffer_table[ts_order_key()].name);
	} else {
		double began = ts_seconds();
		status = judge_given(v, id, reference, candidate, order, relaxations);
		v->seconds = ts_seconds() - began;
	}
	count(c, id);
	return status;
}

static ts_status judge_all(ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                           const ts_order *order, const ts_relaxations *relaxations)
{
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_status status = TS_OK;
	ts_emit_order(ids, reference->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS && status == TS_OK; i++) {
		status = judge_one(c, ids[i], reference, candidate, order, relaxations);
	}
	return status;
}

static ts_status match(const ts_trace *reference, const ts_trace *candidate)
{
	if (reference->pipeline != candidate->pipeline) {
		return ts_fail("%s: a trace of %s; the reference's is of %s", candidate->dir, candidate->pipeline->name,
		               reference->pipeline->name);
	}
	return reference->arrival ? ts_fail("%s: in order of arrival, so it is no reference", reference->dir) : TS_OK;
}

ts_status ts_compare_traces(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                            const ts_relaxations *relaxations)
{
	ts_order order;
	ts_comparison_begin(comparison);
	if (match(reference, candidate) != TS_OK || ts_relax_check(relaxations) != TS_OK) return TS_ERROR;
	ts_status status = ts_order_make(&order, ts_order_key(), reference, candidate);
	if (status == TS_OK) status = judge_all(comparison, reference, candidate, &order, relaxations);
	ts_order_free(&order);
	if (status != TS_OK) return status;
	if (comparison->n_judged == 0 && relaxations->only == NULL) {
		return ts_fail("%s: no buffer that the reference has too: nothing to judge", candidate->dir);
	}
	return comparison->n_unlike > 0 ? TS_DIFFERENT : TS_OK;
}

ts_status ts_compare_alone(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                           const ts_relaxations *relaxations)
{
	ts_order order;
	if (match(reference, candidate) != TS_OK || ts_relax_check(relaxations) != TS_OK) return TS_ERROR;
	for (u32 s = 0; s < 2; s++) {
		const ts_trace *side = s == 0 ? reference : candidate;
		if (side->item[id].path == NULL) return ts_fail("%s: there is no %s", side->dir, ts_buffer_table[id].name);
	}
	ts_status status = ts_order_make(&order, ts_order_key(), reference, candidate);
	if (status == TS_OK && lacks_order(id, candidate, &order)) {
		ts_fail("%s: " LACKS_ORDER, candidate->dir, ts_buffer_table[ts_order_key()].name);
		status = TS_SKIPPED;
	}
	if (status == TS_OK) status = judge_given(verdict, id, reference, candidate, &order, relaxations);
	ts_order_free(&order);
	return status;
}
