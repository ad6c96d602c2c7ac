/* Lists of fragments, and sums in their order. */
#include "stages.h"

static ts_status list(ts_run *run, u32 *surfels)
{
	ts_fragment_list_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.keys = ts_frame_handle(&run->frame, TS_B_surfel_depth_surfel),
		.offset = ts_frame_handle(&run->frame, TS_B_fragment_list_offset),
		.surfels = surfels,
		.filter = ts_surfel_filter(run),
	};
	return ts_run_launch(run, TS_KERNEL_fragment_list, &args, ts_frame_n(&run->frame, TS_B_surfel_setup_disc));
}

ts_status ts_stage_fragment_list(ts_run *run)
{
	u64 total, n_pixels = (u64)run->params.width * run->params.height;
	if (ts_frame_make1(&run->frame, TS_B_fragment_list_offset, n_pixels + 2) == NULL) return TS_ERROR;
	if (ts_run_fill(run, TS_B_fragment_list_offset, 0) != TS_OK || list(run, NULL) != TS_OK) return TS_ERROR;
	if (ts_run_scan(run, TS_B_fragment_list_offset, &total) != TS_OK) return TS_ERROR;
	u32 *surfels = ts_frame_make1(&run->frame, TS_B_fragment_list_surfel, total);
	if (surfels == NULL || list(run, surfels) != TS_OK) return TS_ERROR;
	ts_frame_cut(&run->frame, TS_B_fragment_list_offset, n_pixels + 1);
	ts_sort_args args = {
		.offset = ts_frame_handle(&run->frame, TS_B_fragment_list_offset),
		.entries = ts_frame_handle(&run->frame, TS_B_fragment_list_surfel),
	};
	return ts_run_launch(run, TS_KERNEL_leaf_sort, &args, n_pixels);
}

ts_status ts_blend_in_order(ts_run *run)
{
	ts_blend_order_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.surfels = ts_frame_handle(&run->frame, TS_B_scene_surfel),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.offset = ts_frame_handle(&run->frame, TS_B_fragment_list_offset),
		.list = ts_frame_handle(&run->frame, TS_B_fragment_list_surfel),
		.sums = ts_frame_handle(&run->frame, TS_B_blend_sum),
		.heaviest = ts_frame_handle(&run->frame, TS_B_blend_heaviest),
		.filter = ts_surfel_filter(run),
		.accumulation = run->params.accumulation,
	};
	ts_run_count(run, "fragments", (i64)ts_frame_n(&run->frame, TS_B_fragment_list_surfel));
	return ts_run_launch(run, TS_KERNEL_blend_order, &args, ts_frame_n(&run->frame, TS_B_blend_heaviest));
}

bool ts_accumulates_in_order(const ts_params *params) { return params->accumulation != TS_ACCUMULATION_FIXED; }
