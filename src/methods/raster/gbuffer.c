/* The G-buffer. */
#include "kernels/raster/gbuffer.h"
#include "methods/raster/raster.h"

static const ts_launch surfaces = TS_LAUNCH(gbuffer, TS_ALL);

static ts_status gbuffer(ts_run *run)
{
	ts_gbuffer_args args = {.scene = ts_run_scene(run), .samples = ts_eye_samples(&run->params)};
	return TS_RUN(run, &surfaces, &args, ts_eye_size(run));
}

const ts_stage ts_stage_gbuffer = {
	.name = "gbuffer",
	.kind = "map",
	.paper = "SSAGH 3",
	.doc = "position, normal and albedo of every pixel",
	.run = gbuffer,
	.launches = TS_LAUNCHES(&surfaces),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
