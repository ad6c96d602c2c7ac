/* What truths start from: the first steps of a method of their effect. */
#include "../pipelines/pipeline.h"
#include "query.h"

ts_status ts_truth_begin(ts_run *run, const char *effect, const char *method, const char *stage)
{
	const ts_pipeline *pipeline = ts_pipeline_find(effect, method);
	if (pipeline == NULL) return ts_fail("truth of %s: there is no method %s for it", effect, method);
	ts_pipeline_plan(pipeline, run, NULL, NULL);
	for (const ts_step *step = pipeline->steps; strcmp(step->stage, stage) != 0; step++) {
		if (!step->only_margins && ts_run_stage(run, ts_stage_find(step->stage)) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}
