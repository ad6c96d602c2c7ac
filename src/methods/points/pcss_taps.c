/* Taps about a pixel, in the one depth map of each light, that let light through. */
#include "kernels/points/pcss.h"
#include "methods/raster/eye.h"
#include "methods/raster/shadow_test.h"

static const ts_launch filtered = TS_LAUNCH(pcss, TS_ALL);

static ts_status pcss(ts_run *run)
{
	ts_pcss_args args = {.of = ts_resolve_values(run), .near = TS_PARAM(&run->params, pcss_near)};
	return TS_RUN(run, &filtered, &args, ts_eye_size(run));
}

const ts_stage ts_stage_pcss = {
	.name = "pcss",
	.kind = "map",
	.paper = "iVIR 4",
	.doc = "number of taps around each pixel that let light through",
	.run = pcss,
	.launches = TS_LAUNCHES(&filtered),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
