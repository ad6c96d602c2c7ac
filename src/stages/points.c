/* Points: counted, then written where the prefix sums say. */
#include "stages.h"

ts_points_args ts_points_arguments(const ts_run *run)
{
	static const i32 half_sizes[] = {129, 128, 0};
	return (ts_points_args){
		.scene = ts_run_arrays(run),
		.pieces = ts_frame_handle(&run->frame, TS_B_split_triangle),
		.frames = ts_frame_handle(&run->frame, TS_B_align_frame),
		.half_size = half_sizes[run->params.conservative],
		.paper_splat = run->params.splat == TS_SPLAT_PAPER,
		.snap = run->plan.points.rate != TS_RATE_IS_EYE && run->params.snap,
	};
}

ts_status ts_stage_count(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_align_frame);
	ts_points_args args = ts_points_arguments(run);
	args.offset = ts_frame_make1(&run->frame, TS_B_count_offset, n + 1);
	if (args.offset == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_count, &args, n) != TS_OK) return TS_ERROR;
	u64 total;
	if (ts_run_scan(run, TS_B_count_offset, &total) != TS_OK) return TS_ERROR;
	ts_run_count(run, "points", (i64)total);
	return TS_OK;
}

static ts_status make_room(ts_run *run, ts_points_args *args, u64 n)
{
	args->room = n;
	args->keys = ts_frame_make1(&run->frame, TS_B_points_key, n);
	args->points = ts_frame_make1(&run->frame, TS_B_points_record, n);
	return args->keys != NULL && args->points != NULL ? TS_OK : TS_ERROR;
}

/* As the papers' GPUs do it, without a count: buffers that are too small are made larger, and all is appended again. */
static ts_status append(ts_run *run, ts_points_args *args, u64 n)
{
	u64 total = 2 * n;
	do {
		if (make_room(run, args, total) != TS_OK) return TS_ERROR;
		args->n_points = ts_frame_tallies(&run->frame);
		if (ts_run_launch(run, TS_KERNEL_points_append, args, n) != TS_OK) return TS_ERROR;
		total = (u64)ts_frame_tally(&run->frame, 0);
	} while (total > args->room && total < TS_NONE);
	if (total >= TS_NONE) return ts_run_too_many(total, "points");
	ts_frame_cut(&run->frame, TS_B_points_key, total);
	ts_frame_cut(&run->frame, TS_B_points_record, total);
	ts_run_count(run, "points", (i64)total);
	return TS_OK;
}

ts_status ts_stage_points(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_align_frame);
	ts_points_args args = ts_points_arguments(run);
	if (run->arrival) return append(run, &args, n);
	args.offset = ts_frame_handle(&run->frame, TS_B_count_offset);
	const u32 *before = ts_frame_data(&run->frame, TS_B_count_offset);
	if (make_room(run, &args, before[n]) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_points, &args, n);
}
