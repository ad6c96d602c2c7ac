/* The picture. */
#include "stages.h"

ts_status ts_stage_image(ts_run *run)
{
	u64 width = run->params.width;
	u64 height = run->params.height;
	ts_image_args args = {
		.scene = ts_run_arrays(run),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_eye_depth_triangle),
		.offset = ts_frame_handle(&run->frame, TS_B_pixel_offset),
		.reflected = ts_frame_handle(&run->frame, TS_B_shade_radiance),
		.radiance = ts_frame_make3(&run->frame, TS_B_image_radiance, height, width, 3),
		.srgb = ts_frame_make3(&run->frame, TS_B_image_srgb, height, width, 3),
		.exposure = run->params.exposure,
	};
	if (args.radiance == NULL || args.srgb == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_image, &args, width * height);
}
