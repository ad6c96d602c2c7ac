/* The eye of this frame, and its depth and triangle. */
#include "kernels/raster/eye.h"
#include "methods/raster/raster.h"
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

u32 ts_eye_samples(const ts_params *params)
{
	return TS_PARAM(params, eye_samples) == TS_EYE_SAMPLES_4 ? TS_N_EYE_SAMPLES : 1;
}

u64 ts_eye_size(const ts_run *run) { return ts_run_size(run, TS_DIM_eye_rows) * TS_PARAM(&run->params, width); }

static const ts_launch launch = TS_LAUNCH(eye, TS_ALL);

static ts_status eye(ts_run *run)
{
	ts_eye_args args = {.scene = ts_run_scene(run), .samples = ts_eye_samples(&run->params)};
	if (TS_RUN(run, &launch, &args, (u64)args.scene.n_triangles * args.samples) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	return TS_OK;
}

const ts_stage ts_stage_eye = {
	.name = "eye",
	.kind = "scatter",
	.paper = "EPR 4.1.3",
	.doc = "standard rasterization of the eye's view",
	.run = eye,
	.launches = TS_LAUNCHES(&launch),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
