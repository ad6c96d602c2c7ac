/* The start of truths: the first steps of a method of their effect. */
#include "methods/pipeline.h"
#include "truth/truth.h"

static bool has_made(const ts_run *run, const ts_buffer_id *ids)
{
	while (*ids != TS_N_BUFFERS && run->frame.buffer[*ids].made) ids++;
	return *ids == TS_N_BUFFERS;
}

ts_status ts_truth_begin(ts_run *run, const char *effect, const ts_buffer_id *needs)
{
	const ts_pipeline *pipeline = ts_pipeline_making(effect, needs);
	if (pipeline == NULL) return ts_fail("truth: no method makes what it starts from");
	ts_pipeline_plan(pipeline, run, NULL, NULL);
	for (const ts_step *step = ts_pipeline_steps(pipeline); !has_made(run, needs); step++) {
		if (!step->only_margins && ts_run_stage(run, ts_stage_find(step->stage)) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

ts_status ts_truth_make(ts_run *run, ts_buffer_id id)
{
	const ts_pipeline *pipeline = ts_pipeline_making(NULL, (const ts_buffer_id[]){id, TS_N_BUFFERS});
	if (pipeline == NULL) return ts_fail("truth: no method makes %s", ts_buffer_table[id].name);
	return ts_run_stage(run, ts_stage_find(ts_pipeline_maker(pipeline, id)->stage));
}
