/* Depth segments of the blocks of the grid, and their boxes. */
#include "stages.h"

ts_status ts_stage_segment(ts_run *run)
{
	u32 grid = run->params.grid_px;
	u64 texels = (u64)grid * grid;
	ts_segment_args args = {
		.depths = ts_frame_handle(&run->frame, TS_B_nearest_depth),
		.labels = ts_frame_make2(&run->frame, TS_B_segment_label, grid, grid),
		.grid = grid,
		.step = run->params.segment_step,
	};
	if (args.labels == NULL) return TS_ERROR;
	if (run->params.segmentation == TS_SEGMENTATION_COMPONENTS) {
		return ts_run_launch(run, TS_KERNEL_segment_components, &args, texels / TS_BLOCK_TEXELS);
	}
	for (args.sweep = 0; args.sweep < 4; args.sweep++) {
		if (ts_run_launch(run, TS_KERNEL_segment, &args, texels / TS_BLOCK) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

ts_status ts_stage_range(ts_run *run)
{
	u64 texels = ts_frame_n(&run->frame, TS_B_nearest_depth);
	ts_range_args args = {
		.depths = ts_frame_handle(&run->frame, TS_B_nearest_depth),
		.labels = ts_frame_handle(&run->frame, TS_B_segment_label),
		.least = ts_frame_make2(&run->frame, TS_B_range_least, texels, TS_RANGE),
		.grid = run->params.grid_px,
	};
	if (args.least == NULL || ts_run_fill(run, TS_B_range_least, 0xff) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_range, &args, texels);
}

ts_status ts_stage_box(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_range_least) / TS_RANGE, total;
	ts_box_args args = {
		.least = ts_frame_handle(&run->frame, TS_B_range_least),
		.offset = ts_frame_make1(&run->frame, TS_B_box_offset, n + 1),
		.n_labels = ts_frame_tallies(&run->frame),
	};
	if (args.offset == NULL || ts_run_launch(run, TS_KERNEL_box_count, &args, n) != TS_OK) return TS_ERROR;
	if (ts_run_scan(run, TS_B_box_offset, &total) != TS_OK) return TS_ERROR;
	args.boxes = ts_frame_make1(&run->frame, TS_B_box_record, total);
	if (args.boxes == NULL || ts_run_launch(run, TS_KERNEL_box, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "blocks", (i64)(n / TS_BLOCK_TEXELS));
	ts_run_count(run, "labels", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "boxes", (i64)total);
	return TS_OK;
}
