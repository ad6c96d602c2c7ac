/* Traces on disk. */
#include <string.h>
#include <touchstone/trace.h>
#include "api/api.h"
#include "output/folder.h"
#include "replay/replay.h"
#include "study/measure.h"
#include "study/trace.h"
#include "trace/write.h"

static ts_status refuse(const char *folder)
{
	return ts_fail("%s: not empty; an absent or empty folder would be right", folder);
}

static const char *place(void *user, const char *name)
{
	(void)user;
	return ts_folder_file(name);
}

static ts_status write_trace(const char *folder, const ts_pipeline *pipeline, const ts_scene *scene,
                             const ts_params *params, const ts_how *how, const ts_write_options *o)
{
	const ts_tracing tracing = {.options = {.place = place, .margins = o->margins != 0, .compress = o->compress != 0}};
	ts_measure measure = {.trace = &tracing.options};
	if (ts_tracing_check(&tracing, &pipeline, 1, scene, params, folder) != TS_OK) return TS_ERROR;
	if (ts_folder_begin(folder, refuse) != TS_OK) return TS_ERROR;
	ts_status status = ts_measure_run(&measure, pipeline, scene, params, how, NULL, NULL);
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) ts_folder_discard();
	return status;
}

ts_status ts_trace_write(ts_context *context, const char *folder, const ts_scene *scene, const ts_params *params,
                         const char *effect, const char *method, const ts_write_options *options)
{
	ts_write_options ours = {0};
	if (TS_LACKS(context) || TS_LACKS(folder) || TS_LACKS(scene) || TS_LACKS(params)) return TS_ERROR;
	if (TS_LACKS(effect) || TS_LACKS(method)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_write_options") != TS_OK) return TS_ERROR;
	const ts_pipeline *pipeline = ts_api_method(effect, method);
	if (pipeline == NULL || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_how how = context->how;
	how.arrival = ours.arrival != 0;
	ts_status status = write_trace(folder, pipeline, scene, params, &how, &ours);
	ts_api_leave();
	return status;
}

static ts_status save(const ts_trace *trace, const char *folder, const char *producer)
{
	if (ts_folder_begin(folder, refuse) != TS_OK) return TS_ERROR;
	ts_status status = ts_trace_save_files(trace, producer, place, NULL);
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) ts_folder_discard();
	return status;
}

ts_status ts_trace_save(ts_context *context, const ts_trace *trace, const char *folder, const char *producer)
{
	if (TS_LACKS(context) || TS_LACKS(trace) || TS_LACKS(folder) || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = save(trace, folder, producer);
	ts_api_leave();
	return status;
}

ts_status ts_trace_match(const ts_trace *reference, const ts_trace *candidate)
{
	return TS_LACKS(reference) ? TS_ERROR : ts_load_match(reference, candidate);
}

int ts_trace_takes(const ts_trace *trace, const char *stage)
{
	if (trace == NULL || stage == NULL) return 0;
	for (const ts_step *step = ts_pipeline_steps(trace->pipeline); step->stage != NULL; step++) {
		if (strcmp(step->stage, stage) == 0) return ts_replay_takes(step, trace);
	}
	return 0;
}
