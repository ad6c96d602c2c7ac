/* The eye's depth and triangle. */
#include "../../kernels/raster/eye.h"
#include "../stages.h"

static const ts_launch launch = TS_LAUNCH(eye, TS_ALL);

static ts_status eye(ts_run *run)
{
	ts_eye_args args = {.scene = ts_run_scene(run)};
	if (TS_RUN(run, &launch, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
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
