/* Visibility of surfels, from the eye and from lights. */
#include "stages.h"

ts_status ts_stage_surfel_depth(ts_run *run)
{
	ts_surfel_depth_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.epsilon = ts_frame_handle(&run->frame, TS_B_surfel_setup_epsilon),
		.keys = ts_frame_make2(&run->frame, TS_B_surfel_depth_surfel, run->params.height, run->params.width),
	};
	if (args.keys == NULL || ts_run_fill(run, TS_B_surfel_depth_surfel, 0xff) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_surfel_depth, &args, ts_frame_n(&run->frame, TS_B_surfel_setup_disc));
}

ts_status ts_stage_surfel_shadow(ts_run *run)
{
	u32 n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view);
	if (ts_frame_make1(&run->frame, TS_B_scatter_depth, ts_run_n_texels(run, 0, n_views)) == NULL) return TS_ERROR;
	if (ts_run_fill(run, TS_B_scatter_depth, 0xff) != TS_OK) return TS_ERROR;
	ts_surfel_shadow_args args = {
		.surfels = ts_frame_handle(&run->frame, TS_B_scene_surfel),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.epsilon = ts_frame_handle(&run->frame, TS_B_surfel_setup_epsilon),
		.depths = ts_frame_handle(&run->frame, TS_B_scatter_depth),
		.filter = ts_surfel_filter(run),
		.n_views = n_views,
	};
	return ts_run_launch(run, TS_KERNEL_surfel_shadow, &args, ts_frame_n(&run->frame, TS_B_scene_surfel));
}
