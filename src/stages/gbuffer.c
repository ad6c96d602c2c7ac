/* The G-buffer, and its depth down-sampled. */
#include <inttypes.h>
#include "stages.h"

ts_status ts_stage_gbuffer(ts_run *run)
{
	u64 width = run->params.width, height = run->params.height;
	ts_gbuffer_args args = {
		.scene = ts_run_arrays(run),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_eye_depth_triangle),
		.pixels = ts_frame_make2(&run->frame, TS_B_gbuffer_pixel, height, width),
	};
	if (args.pixels == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_gbuffer, &args, width * height);
}

ts_status ts_grid_check(const ts_params *params)
{
	u32 grid = params->grid_px;
	if (grid % TS_BLOCK == 0) return TS_OK;
	return ts_fail("grid_px=%" PRIu32 ": a multiple of 32, as %" PRIu32 ", would be right", grid, grid - grid % TS_BLOCK);
}

ts_status ts_stage_nearest(ts_run *run)
{
	u64 grid = run->params.grid_px;
	if (ts_grid_check(&run->params) != TS_OK) return TS_ERROR;
	ts_nearest_args args = {
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.depths = ts_frame_make2(&run->frame, TS_B_nearest_depth, grid, grid),
		.grid = (u32)grid,
		.width = run->params.width,
		.height = run->params.height,
	};
	if (args.depths == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_nearest, &args, grid * grid);
}
