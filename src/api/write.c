/* Traces on disk. */
#include "api.h"
#include <touchstone/trace.h>
#include <pthread.h>
#include "../study/folder.h"
#include "../study/measure.h"
#include "../study/trace.h"

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
	if (ts_results_begin(folder, false) != TS_OK) return TS_ERROR;
	ts_status status = ts_measure_run(&measure, pipeline, scene, params, how, NULL, NULL);
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) ts_folder_discard();
	return status;
}

ts_status ts_trace_write(ts_context *context, const char *folder, const ts_scene *scene, const ts_params *params,
                         const char *effect, const char *method, const ts_write_options *options)
{
	static pthread_mutex_t one = PTHREAD_MUTEX_INITIALIZER; /* folder at a time */
	ts_write_options ours = {0};
	if (TS_LACKS(context) || TS_LACKS(folder) || TS_LACKS(scene) || TS_LACKS(params)) return TS_ERROR;
	if (TS_LACKS(effect) || TS_LACKS(method)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_write_options") != TS_OK) return TS_ERROR;
	const ts_pipeline *pipeline = ts_api_method(effect, method);
	if (pipeline == NULL || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_how how = context->how;
	how.arrival = ours.arrival != 0;
	pthread_mutex_lock(&one);
	ts_status status = write_trace(folder, pipeline, scene, params, &how, &ours);
	pthread_mutex_unlock(&one);
	ts_api_leave();
	return status;
}
