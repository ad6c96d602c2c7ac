/* Replays of a candidate's stages, judged one by one. */
#include "forced.h"
#include "judge.h"

/* Buffers of points and of indices into them. */
static bool is_of_points(ts_buffer_id id)
{
	const ts_fields fields = ts_fields_of(id);
	if (ts_order_is_set(id)) return true;
	for (u32 f = 0; f < fields.n; f++) {
		if (ts_field_names(&fields.field[f], ts_order_of())) return true;
	}
	return false;
}

/* Whether a stage would mix points in two orders. */
static bool mixes(const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate)
{
	bool own = false, other = false;
	for (u32 id = 0; candidate->arrival && id < TS_N_BUFFERS; id++) {
		bool touched = ts_stage_reads(stage, (ts_buffer_id)id) || ts_stage_writes(stage, (ts_buffer_id)id);
		if (!touched || !is_of_points((ts_buffer_id)id)) continue;
		own |= candidate->item[id].path != NULL;
		other |= candidate->item[id].path == NULL && reference->item[id].path != NULL;
	}
	return own && other;
}

static bool has_output(const ts_stage *stage, const ts_trace *candidate, const ts_relaxations *relaxations)
{
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		bool ignored = ts_relax_ignores(relaxations, ts_buffer_table[*id].name);
		if (candidate->item[*id].path != NULL && !ignored) return true;
	}
	return false;
}

static ts_status judge_stage(ts_comparison *c, const ts_stage *stage, const ts_trace *reference,
                             const ts_trace *candidate, const ts_relaxations *relaxations, u32 threads)
{
	ts_load *load;
	ts_status status = ts_replay(&load, stage, reference, candidate, threads);
	for (u32 i = 0; status == TS_OK && ts_stage_outputs(stage)[i] != TS_N_BUFFERS; i++) {
		ts_buffer_id id = ts_stage_outputs(stage)[i];
		ts_judged judged;
		bool ignored = ts_relax_ignores(relaxations, ts_buffer_table[id].name);
		if (candidate->item[id].path == NULL || ignored) continue;
		status = ts_judge(&judged, load, id, relaxations) == TS_ERROR ? TS_ERROR : TS_OK;
		c->verdict[id] = judged.verdict;
	}
	ts_load_end(load);
	return status;
}

/* What was not replayed was ignored, or is missing. */
static void settle(ts_comparison *c, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                   const ts_relaxations *relaxations)
{
	ts_verdict *v = &c->verdict[id];
	bool there = reference->item[id].path != NULL;
	if (there && v->judgement == TS_NOT_JUDGED && candidate->item[id].path == NULL) v->judgement = TS_MISSING;
	if (there && ts_relax_ignores(relaxations, ts_buffer_table[id].name)) v->judgement = TS_IGNORED;
	c->n_judged += v->judgement == TS_SAME || v->judgement == TS_UNLIKE;
	c->n_unlike += v->judgement == TS_UNLIKE;
	c->n_missing += v->judgement == TS_MISSING;
}

static void find_first(ts_comparison *c, const ts_pipeline *pipeline)
{
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL && c->first == TS_N_BUFFERS; step++) {
		const ts_stage *stage = ts_stage_find(step->stage);
		for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
			bool unlike = c->verdict[*id].judgement == TS_UNLIKE;
			if (unlike && c->first == TS_N_BUFFERS) c->first = *id;
		}
	}
}

ts_status ts_compare_forced(ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                            const ts_relaxations *relaxations, u32 threads)
{
	*c = (ts_comparison){.first = TS_N_BUFFERS, .forced = true};
	if (ts_load_match(reference, candidate) != TS_OK || ts_relax_check(relaxations) != TS_OK) return TS_ERROR;
	for (const ts_step *step = ts_pipeline_steps(reference->pipeline); step->stage != NULL; step++) {
		const ts_stage *stage = ts_stage_find(step->stage);
		bool judged = ts_replay_takes(step, reference) && has_output(stage, candidate, relaxations);
		if (!judged || mixes(stage, reference, candidate)) continue;
		if (judge_stage(c, stage, reference, candidate, relaxations, threads) != TS_OK) return TS_ERROR;
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) settle(c, (ts_buffer_id)id, reference, candidate, relaxations);
	find_first(c, reference->pipeline);
	if (c->n_judged == 0)
		return ts_fail("%s: no stage whose outputs could be replayed: nothing to judge", candidate->dir);
	return c->n_unlike > 0 ? TS_DIFFERENT : TS_OK;
}
