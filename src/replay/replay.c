/* One stage alone. */
#include "replay/replay.h"
#include <inttypes.h>
#include "compare/order.h"
#include "trace/emitted/emit.h"

static const ts_step *find_step(const char *name, const ts_pipeline *pipeline)
{
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		if (strcmp(step->stage, name) == 0) return step;
	}
	return NULL;
}

const ts_stage *ts_replay_find(const char *name, const ts_pipeline *pipeline, const ts_params *params)
{
	const ts_step *step = find_step(name, pipeline);
	if (step == NULL) {
		ts_fail("\"%.40s\" is no stage of %s; the table of its stages names all", name, pipeline->name);
		return NULL;
	}
	if (ts_pipeline_takes(step, params, true)) return ts_stage_find(name);
	if (step->only_if != NULL && !step->only_if(params)) {
		ts_fail("stage %s is not run with the parameters of this trace", name);
	} else if (TS_PARAM(params, lookup_bounces) >= step->least_bounces) {
		ts_fail("stage %s is not run where points are not stored; it needs points.buffered=on", name);
	} else {
		ts_fail("stage %s is not run with lookup.bounces=%" PRIu32 "; it needs %" PRIu32, name,
		        TS_PARAM(params, lookup_bounces), step->least_bounces);
	}
	return NULL;
}

bool ts_replay_takes(const ts_step *step, const ts_trace *reference)
{
	const ts_stage *stage = ts_stage_find(step->stage);
	bool margins = !step->only_margins || reference->item[ts_stage_outputs(stage)[0]].path != NULL;
	return margins && ts_pipeline_takes(step, &reference->params, true);
}

void ts_replay_reads(ts_buffer_id ids[TS_N_BUFFERS + 1], const ts_stage *stage, const ts_pipeline *pipeline,
                     const ts_params *params)
{
	u32 n = 0;
	const ts_step *step = find_step(stage->name, pipeline);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_step *maker = ts_pipeline_maker(pipeline, (ts_buffer_id)id);
		bool there = ts_emit_is_scene((ts_buffer_id)id) || (maker != NULL && ts_pipeline_takes(maker, params, true));
		bool read = step != NULL ? ts_pipeline_needs(step, params, (ts_buffer_id)id) : ts_stage_reads(stage, id);
		if (there && read) ids[n++] = (ts_buffer_id)id;
	}
	ids[n] = TS_N_BUFFERS;
}

/* Whether a stage reads records that may be in any order. */
static bool is_given_set(const ts_stage *stage)
{
	bool any = false;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) any |= ts_order_is_set(id) && ts_stage_reads(stage, id);
	return any;
}

ts_status ts_replay_stage(ts_run *run, const ts_stage *stage)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool made = run->frame.buffer[id].made;
		if (ts_stage_writes(stage, (ts_buffer_id)id)) {
			ts_frame_drop(&run->frame, (ts_buffer_id)id);
		} else if (!made) {
			ts_frame_borrow(&run->frame, (ts_buffer_id)id, NULL, 0);
		}
	}
	run->arrival = is_given_set(stage);
	return ts_run_stage(run, stage);
}

/* Names the stage in the message, which may be a refusal. */
static ts_status fail_in(const ts_stage *stage)
{
	if (ts_refused()) return ts_refuse("stage %s: %s", stage->name, ts_error_message());
	return ts_fail("stage %s: %s", stage->name, ts_error_message());
}

ts_status ts_replay_load(ts_load **load, const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate,
                         u32 threads)
{
	ts_buffer_id ids[TS_N_BUFFERS + 1];
	ts_replay_reads(ids, stage, reference->pipeline, &reference->params);
	if (ts_load_begin(load, ids, reference, candidate, threads) != TS_OK) return fail_in(stage);
	if (ts_check(*load, stage) == TS_OK) return TS_OK;
	fail_in(stage);
	ts_load_end(*load);
	*load = NULL;
	return TS_ERROR;
}

ts_status ts_replay_run(ts_load **load, const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate,
                        u32 threads)
{
	if (ts_replay_load(load, stage, reference, candidate, threads) != TS_OK) return TS_ERROR;
	ts_status status = ts_replay_stage(&(*load)->run, stage);
	if (status != TS_OK) {
		ts_load_end(*load);
		*load = NULL;
	}
	return status;
}
