/* Comparison of two traces: buffer by buffer, by digests where files were left out, and by the stages that were asked
 * for. */
#include "compare/compare.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "trace/emitted/emit.h"

bool ts_digest_known(const ts_trace_item *item) { return item->path != NULL || item->sha256[0] != 0; }

static bool is_exact(const ts_relaxations *r)
{
	return r->ulp == 0 && r->abs == 0 && r->rel == 0 && !r->decided && r->allow == 0 && r->ignore == NULL &&
	       r->mask == NULL;
}

/* Judges a buffer that one side or both know by its digest alone. */
static ts_status judge_digests(ts_verdict *v, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                               const ts_relaxations *relaxations)
{
	const ts_trace_item *sides[2] = {&reference->item[id], &candidate->item[id]};
	char hex[2][TS_DIGEST_BYTES];
	for (u32 s = 0; s < 2; s++) {
		if (ts_trace_sha256(hex[s], sides[s], id) != TS_OK) return TS_ERROR;
	}
	*v = (ts_verdict){.judgement = TS_SAME, .n_ref = sides[0]->npy.n, .n_cand = sides[1]->npy.n, .by_digest = true};
	if (strcmp(hex[0], hex[1]) == 0) return TS_OK;
	const char *left = sides[1]->path == NULL ? candidate->dir : reference->dir;
	if (sides[0]->path == NULL && sides[1]->path == NULL) left = "each side";
	const char *why = candidate->arrival ? "points in the order of their arrival" : "a relaxed comparison";
	v->judgement = !candidate->arrival && is_exact(relaxations) ? TS_UNLIKE : TS_UNABLE;
	if (v->judgement == TS_UNABLE) {
		snprintf(v->why, sizeof v->why, "%s needs its file, which %.400s leaves out", why, left);
	} else {
		snprintf(v->why, sizeof v->why, "SHA-256 ref %.16s... candidate %.16s..., as %.400s leaves its file out",
		         hex[0], hex[1], left);
	}
	return TS_OK;
}

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
		status = judge_digests(v, id, reference, candidate, relaxations);
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

/* Whether the first n bytes of `text` are that name. */
static bool is_name(const char *name, const char *text, size_t n)
{
	return strlen(name) == n && memcmp(name, text, n) == 0;
}

static ts_status take_stage(bool part[TS_N_BUFFERS], const ts_pipeline *pipeline, const char *text, size_t n)
{
	bool known = is_name("scene", text, n);
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		known |= is_name(step->stage, text, n);
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) part[id] |= is_name(ts_emit_maker(pipeline, (ts_buffer_id)id), text, n);
	if (known) return TS_OK;
	return ts_fail("stages: \"%.*s\" is no stage of %s", (int)(n < 80 ? n : 80), text, pipeline->name);
}

ts_status ts_part_make(bool part[TS_N_BUFFERS], const char *stages, const ts_trace *reference,
                       const ts_trace *candidate, const ts_relaxations *relaxations)
{
	bool any = false;
	memset(part, 0, TS_N_BUFFERS * sizeof *part);
	for (const char *at = stages; *at != 0; at += *at == ',') {
		size_t length = strcspn(at, ",");
		if (take_stage(part, reference->pipeline, at, length) != TS_OK) return TS_ERROR;
		at += length;
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool both = ts_digest_known(&reference->item[id]) && ts_digest_known(&candidate->item[id]);
		any |= both && !ts_relax_ignores(relaxations, ts_buffer_table[id].name);
	}
	return any ? TS_OK : ts_fail("%s: no buffer that the reference has too: nothing to judge", candidate->dir);
}

ts_status ts_part_inputs(ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                         const ts_relaxations *relaxations)
{
	bool wanted[TS_N_BUFFERS] = {false};
	ts_relaxations others = *relaxations;
	ts_comparison *aside = ts_comparison_make(1);
	if (aside == NULL) return TS_ERROR;
	others.only = wanted;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_step *step = ts_pipeline_maker(reference->pipeline, (ts_buffer_id)id);
		if (c->verdict[id].judgement != TS_UNLIKE || step == NULL) continue;
		const ts_buffer_id *input = ts_stage_inputs(ts_stage_find(step->stage));
		for (; *input != TS_N_BUFFERS; input++) wanted[*input] = !relaxations->only[*input];
	}
	ts_status status = ts_compare_traces(aside, reference, candidate, &others);
	for (u32 id = 0; id < TS_N_BUFFERS && status != TS_ERROR; id++) {
		if (!wanted[id]) continue;
		c->verdict[id] = aside->verdict[id];
		c->verdict[id].list = (ts_differences){.n = 0};
		c->verdict[id].aside = true;
	}
	ts_comparison_free(aside);
	return status == TS_ERROR ? TS_ERROR : TS_OK;
}
