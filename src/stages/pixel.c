/* The reflective pixels, compacted. */
#include "stages.h"

ts_status ts_stage_pixel(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_eye_depth_triangle);
	ts_pixel_args args = {
		.scene = ts_run_arrays(run),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_eye_depth_triangle),
		.offset = ts_frame_make1(&run->frame, TS_B_pixel_offset, n + 1),
	};
	if (args.offset == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_pixel_count, &args, n) != TS_OK) return TS_ERROR;
	u64 total;
	if (ts_run_scan(run, TS_B_pixel_offset, &total) != TS_OK) return TS_ERROR;
	args.pixels = ts_frame_make1(&run->frame, TS_B_pixel_record, total);
	if (args.pixels == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_pixel, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "reflective pixels", (i64)total);
	return TS_OK;
}
