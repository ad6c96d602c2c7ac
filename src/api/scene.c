/* Scenes. */
#include "api/api.h"
#include "scene/sources.h"

ts_status ts_scene_open(ts_context *context, ts_scene **scene, const char *spec, const ts_params *params,
                        const ts_scene_options *options)
{
	ts_scene_options ours = {0};
	if (TS_LACKS(scene)) return TS_ERROR;
	*scene = NULL;
	if (TS_LACKS(context) || TS_LACKS(spec) || TS_LACKS(params)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_scene_options") != TS_OK) return TS_ERROR;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_scene_load(scene, spec, params, &ours);
	ts_api_leave();
	return status;
}

ts_status ts_scene_open_bytes(ts_context *context, ts_scene **scene, const void *file, size_t file_bytes,
                              const char *name, const ts_params *params, const ts_scene_options *options)
{
	ts_scene_options ours = {0};
	if (TS_LACKS(scene)) return TS_ERROR;
	*scene = NULL;
	if (TS_LACKS(context) || TS_LACKS(file) || TS_LACKS(name) || TS_LACKS(params)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_scene_options") != TS_OK) return TS_ERROR;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_scene_of_bytes(scene, &(ts_scene_file){name, file, file_bytes}, params, &ours);
	ts_api_leave();
	return status;
}

ts_status ts_scene_make(ts_context *context, ts_scene **scene, const ts_scene_arrays *arrays, const ts_params *params,
                        const ts_scene_options *options)
{
	ts_scene_options ours = {0};
	ts_scene_arrays given = {0};
	if (TS_LACKS(scene)) return TS_ERROR;
	*scene = NULL;
	if (TS_LACKS(context) || TS_LACKS(arrays) || TS_LACKS(params)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_scene_options") != TS_OK) return TS_ERROR;
	if (ts_api_options(&given, sizeof given, arrays, "ts_scene_arrays") != TS_OK) return TS_ERROR;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_scene_of_arrays(scene, &given, params, &ours);
	ts_api_leave();
	return status;
}
