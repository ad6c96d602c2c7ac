/* The G-buffer of surfels: sums by their weights. */
#include "stages.h"

ts_status ts_stage_surfel_mean(ts_run *run)
{
	ts_surfel_mean_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.epsilon = ts_frame_handle(&run->frame, TS_B_surfel_setup_epsilon),
		.keys = ts_frame_handle(&run->frame, TS_B_surfel_depth_surfel),
		.sums = ts_frame_handle(&run->frame, TS_B_blend_sum),
		.heaviest = ts_frame_handle(&run->frame, TS_B_blend_heaviest),
		.pixels = ts_frame_make2(&run->frame, TS_B_gbuffer_pixel, run->params.height, run->params.width),
		.tally = ts_frame_tallies(&run->frame),
	};
	if (args.pixels == NULL || args.tally == NULL) return TS_ERROR;
	u64 n = ts_frame_n(&run->frame, TS_B_gbuffer_pixel);
	if (ts_run_launch(run, TS_KERNEL_surfel_mean, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "shading operations", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}
