/* Replays of a candidate's stages, judged one by one. */
#include <stdio.h>
#include "replay/judge.h"

ts_buffer_id ts_forced_mixed(const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate)
{
	bool own = false;
	ts_buffer_id other = TS_N_BUFFERS;
	for (u32 id = 0; candidate->arrival && id < TS_N_BUFFERS; id++) {
		bool touched = ts_stage_reads(stage, (ts_buffer_id)id) || ts_stage_writes(stage, (ts_buffer_id)id);
		if (!touched || !ts_order_is_of_points((ts_buffer_id)id)) continue;
		own |= candidate->item[id].path != NULL;
		if (candidate->item[id].path == NULL && reference->item[id].path != NULL) other = (ts_buffer_id)id;
	}
	return own ? other : TS_N_BUFFERS;
}

static bool is_judged(ts_buffer_id id, const ts_trace *candidate, const ts_relaxations *relaxations)
{
	return candidate->item[id].path != NULL && ts_relax_takes(relaxations, id) &&
	       !ts_relax_ignores(relaxations, ts_buffer_table[id].name);
}

static bool has_output(const ts_stage *stage, const ts_trace *candidate, const ts_relaxations *relaxations)
{
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (is_judged(*id, candidate, relaxations)) return true;
	}
	return false;
}

/* Sets why none of a stage's outputs is judged. */
static void pass_over(ts_comparison *c, const ts_stage *stage, const ts_trace *candidate,
                      const ts_relaxations *relaxations, const char *why)
{
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (!is_judged(*id, candidate, relaxations)) continue;
		c->verdict[*id].judgement = TS_UNABLE;
		snprintf(c->verdict[*id].why, TS_WHY_TEXT, "%s", why);
	}
}

static ts_status judge_output(ts_verdict *verdict, const ts_load *load, ts_buffer_id id,
                              const ts_relaxations *relaxations)
{
	ts_judged judged = {.verdict = *verdict};
	ts_status status = ts_judge(&judged, load, id, relaxations);
	*verdict = judged.verdict;
	if (judged.shape_differs) snprintf(verdict->why, TS_WHY_TEXT, "%s", judged.text);
	return status == TS_ERROR ? TS_ERROR : TS_OK;
}

/* A refusal of one stage's inputs does not prevent judging others. */
static ts_status take_refusal(ts_comparison *c, const ts_stage *stage, const ts_trace *candidate,
                              const ts_relaxations *relaxations)
{
	if (c->refusal[0] == 0) snprintf(c->refusal, sizeof c->refusal, "%s", ts_error_message());
	pass_over(c, stage, candidate, relaxations, strchr(ts_error_message(), ':') + 2);
	return TS_OK;
}

static ts_status judge_stage(ts_comparison *c, const ts_stage *stage, const ts_trace *reference,
                             const ts_trace *candidate, const ts_relaxations *relaxations, u32 threads)
{
	ts_load *load;
	double began = ts_seconds();
	ts_status status = ts_replay_run(&load, stage, reference, candidate, threads);
	if (status != TS_OK && ts_refused()) return take_refusal(c, stage, candidate, relaxations);
	for (u32 i = 0; status == TS_OK && ts_stage_outputs(stage)[i] != TS_N_BUFFERS; i++) {
		ts_buffer_id id = ts_stage_outputs(stage)[i];
		if (is_judged(id, candidate, relaxations)) status = judge_output(&c->verdict[id], load, id, relaxations);
	}
	ts_load_end(load);
	c->verdict[ts_stage_outputs(stage)[0]].seconds = ts_seconds() - began;
	return status;
}

/* Marks buffers that were not replayed as ignored or missing. */
static void settle(ts_comparison *c, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                   const ts_relaxations *relaxations)
{
	ts_verdict *v = &c->verdict[id];
	bool there = reference->item[id].path != NULL && ts_relax_takes(relaxations, id);
	if (there && v->judgement == TS_NOT_JUDGED && candidate->item[id].path == NULL) v->judgement = TS_MISSING;
	if (there && ts_relax_ignores(relaxations, ts_buffer_table[id].name)) v->judgement = TS_IGNORED;
	c->n_judged += v->judgement == TS_SAME || v->judgement == TS_UNLIKE;
	c->n_unlike += v->judgement == TS_UNLIKE;
	c->n_missing += v->judgement == TS_MISSING;
	c->n_unable += v->judgement == TS_UNABLE;
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

/* Judges the outputs of a step, or sets why not. */
static ts_status judge_step(ts_comparison *c, const ts_step *step, const ts_trace *reference, const ts_trace *candidate,
                            const ts_relaxations *relaxations, u32 threads)
{
	char why[TS_WHY_TEXT];
	const ts_stage *stage = ts_stage_find(step->stage);
	if (!ts_replay_takes(step, reference) || !has_output(stage, candidate, relaxations)) return TS_OK;
	ts_buffer_id other = ts_forced_mixed(stage, reference, candidate);
	if (other == TS_N_BUFFERS) return judge_stage(c, stage, reference, candidate, relaxations, threads);
	snprintf(why, sizeof why, "the candidate has no %s, and the reference's names points in another order",
	         ts_buffer_table[other].name);
	pass_over(c, stage, candidate, relaxations, why);
	return TS_OK;
}

ts_status ts_compare_forced(ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                            const ts_relaxations *relaxations, u32 threads)
{
	ts_comparison_begin(c);
	c->forced = true;
	if (ts_load_match(reference, candidate) != TS_OK || ts_relax_check(relaxations) != TS_OK) return TS_ERROR;
	for (const ts_step *step = ts_pipeline_steps(reference->pipeline); step->stage != NULL; step++) {
		if (judge_step(c, step, reference, candidate, relaxations, threads) != TS_OK) return TS_ERROR;
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) settle(c, (ts_buffer_id)id, reference, candidate, relaxations);
	find_first(c, reference->pipeline);
	if (c->n_unlike > 0) return TS_DIFFERENT;
	if (c->refusal[0] != 0) return ts_refuse("%s", c->refusal);
	if (c->n_judged > 0 || relaxations->only != NULL) return TS_OK;
	return ts_fail("%s: no stage whose outputs could be replayed: nothing to judge", candidate->dir);
}
