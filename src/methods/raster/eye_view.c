/* The eye of this frame. */
#include "methods/stages.h"
#include "scene/view.h"

static ts_status eye_view(ts_run *run)
{
	ts_view *eye = ts_run_make(run, TS_B_eye_view);
	if (eye == NULL) return TS_ERROR;
	ts_view_on_path(eye, ts_run_info(run), run->scene->path, run->scene->n_path, &run->params);
	return TS_OK;
}

const ts_stage ts_stage_eye_view = {
	.name = "eye.view",
	.kind = "map",
	.paper = "EPR 4.2",
	.doc = "the eye: circling the scene, on a path, or the file's camera",
	.run = eye_view,
	.looks_at = TS_BUFFERS(TS_B_scene_path, TS_B_scene_info),
	.makes = TS_BUFFERS(TS_B_eye_view),
};
