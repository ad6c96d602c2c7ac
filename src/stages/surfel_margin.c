/* How near the decisions about surfels were. */
#include "stages.h"

static ts_status margin_of_surfels(ts_run *run, ts_buffer_id margin, ts_buffer_id heaviest, ts_kernel kernel)
{
	ts_surfel_margin_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.surfels = ts_frame_handle(&run->frame, TS_B_scene_surfel),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.epsilon = ts_frame_handle(&run->frame, TS_B_surfel_setup_epsilon),
		.keys = ts_frame_handle(&run->frame, TS_B_surfel_depth_surfel),
		.heaviest = heaviest != TS_N_BUFFERS ? ts_frame_handle(&run->frame, heaviest) : NULL,
		.margin = ts_frame_make3(&run->frame, margin, run->params.height, run->params.width, 2),
		.filter = ts_surfel_filter(run),
	};
	if (args.margin == NULL || ts_run_fill(run, margin, 0xff) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, kernel, &args, ts_frame_n(&run->frame, TS_B_scene_surfel));
}

ts_status ts_stage_surfel_depth_margin(ts_run *run)
{
	return margin_of_surfels(run, TS_B_surfel_depth_margin, TS_N_BUFFERS, TS_KERNEL_surfel_depth_margin);
}

ts_status ts_stage_blend_margin(ts_run *run)
{
	return margin_of_surfels(run, TS_B_blend_margin, TS_B_blend_heaviest, TS_KERNEL_blend_margin);
}

ts_status ts_stage_deferred_lit_margin(ts_run *run)
{
	const u64 shape[] = {run->params.height, run->params.width, ts_frame_n(&run->frame, TS_B_lamp_shape), 2};
	ts_deferred_lit_margin_args args = {
		.of = ts_deferred_lit_arguments(run),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.margin = ts_frame_make(&run->frame, TS_B_resolve_margin, 4, shape),
	};
	if (args.margin == NULL || ts_run_fill(run, TS_B_resolve_margin, 0xff) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_deferred_lit_margin, &args, ts_frame_n(&run->frame, TS_B_gbuffer_pixel));
}

ts_status ts_stage_deferred_margin(ts_run *run)
{
	ts_deferred_margin_args args = {
		.of = ts_deferred_arguments(run),
		.margin = ts_frame_make2(&run->frame, TS_B_deferred_margin, run->params.height, run->params.width),
	};
	if (args.margin == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_deferred_margin, &args, ts_frame_n(&run->frame, TS_B_gbuffer_pixel));
}
