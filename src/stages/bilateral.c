/* Gathered light, filtered. */
#include "stages.h"

ts_status ts_stage_bilateral(ts_run *run)
{
	u64 width = run->params.width, height = run->params.height;
	f32 *rows = ts_frame_make3(&run->frame, TS_B_bilateral_row, height, width, 3);
	f32 *irradiance = ts_frame_make3(&run->frame, TS_B_indirect_irradiance, height, width, 3);
	ts_bilateral_args args = {
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.from = ts_frame_handle(&run->frame, TS_B_vpl_gather_irradiance),
		.to = rows,
		.width = (u32)width,
		.height = (u32)height,
		.radius = run->params.filter_px,
	};
	if (rows == NULL || irradiance == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_bilateral, &args, width * height) != TS_OK) return TS_ERROR;
	args.from = rows;
	args.to = irradiance;
	args.columns = 1;
	return ts_run_launch(run, TS_KERNEL_bilateral, &args, width * height);
}
