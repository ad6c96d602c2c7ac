/* Points: counted, then written where the prefix sums say. */
#include "stages.h"

static ts_points_args arguments(const ts_run *run)
{
	return (ts_points_args){
		.scene = ts_run_arrays(run),
		.pieces = ts_frame_handle(&run->frame, TS_B_split_triangle),
		.frames = ts_frame_handle(&run->frame, TS_B_align_frame),
		.half_size = run->params.conservative == TS_CONSERVATIVE_SAFE ? 129 : 128,
		.paper_splat = run->params.splat == TS_SPLAT_PAPER,
	};
}

ts_status ts_stage_count(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_align_frame);
	ts_points_args args = arguments(run);
	args.offset = ts_frame_make1(&run->frame, TS_B_count_offset, n + 1);
	if (args.offset == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_count, &args, n) != TS_OK) return TS_ERROR;
	u64 total;
	if (ts_run_scan(run, TS_B_count_offset, "points", &total) != TS_OK) return TS_ERROR;
	ts_run_count(run, "points", (i64)total);
	return TS_OK;
}

ts_status ts_stage_points(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_align_frame);
	ts_points_args args = arguments(run);
	args.offset = ts_frame_handle(&run->frame, TS_B_count_offset);
	const u32 *before = ts_frame_data(&run->frame, TS_B_count_offset);
	args.keys = ts_frame_make1(&run->frame, TS_B_points_key, before[n]);
	args.points = ts_frame_make1(&run->frame, TS_B_points_record, before[n]);
	if (args.keys == NULL || args.points == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_points, &args, n);
}
