/* The reflective pixels, compacted. */
#include "kernels/points/mirror_pixel.h"
#include "methods/raster/raster.h"

static const ts_launch counted = TS_LAUNCH(mirror_pixel_count, TS_BUT(pixels));
static const ts_launch written = TS_LAUNCH(mirror_pixel, TS_IN(offset, mirror_pixel_offset));

static ts_status mirror_pixel(ts_run *run)
{
	u64 total, n = ts_eye_size(run);
	ts_mirror_pixel_args args = {.scene = ts_run_scene(run), .samples = ts_eye_samples(&run->params)};
	if (TS_RUN(run, &counted, &args, n) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &counted, "offset", &total) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &written, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "reflective pixels", (i64)total);
	return TS_OK;
}

const ts_stage ts_stage_mirror_pixel = {
	.name = "mirror_pixel",
	.kind = "emit",
	.paper = "EPR 4.1.3",
	.doc = "reflective pixels with gradients of position and normal",
	.run = mirror_pixel,
	.launches = TS_LAUNCHES(&counted, &written),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
