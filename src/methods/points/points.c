/* Points: counted, then written at their prefix sums. */
#include "methods/points/points.h"
#include "kernels/points/points.h"
#include "kernels/points/view_density.h"

static const ts_launch counted = TS_LAUNCH(points_count, TS_WITH(offset));
static const ts_launch written = TS_LAUNCH(points, TS_IN(offset, points_offset), TS_WITH(keys), TS_WITH(points));
static const ts_launch appended = TS_LAUNCH(points_append, TS_WITH(keys), TS_WITH(points), TS_WITH(n_points));

ts_points_args ts_points_values(const ts_run *run)
{
	static const i32 half_sizes[] = {TS_SAFE_HALF, TS_SUB_CENTRE, 0};
	return (ts_points_args){
		.scene = ts_run_scene(run),
		.half_size = half_sizes[TS_PARAM(&run->params, points_conservative)],
		.paper_splat = TS_PARAM(&run->params, splat_size) == TS_SPLAT_PAPER,
		.snap = run->plan.points.rate != TS_RATE_EYE && TS_PARAM(&run->params, points_snap),
	};
}

bool ts_points_again(const ts_run *run)
{
	return !ts_run_has(run, TS_B_points_record) && ts_run_has(run, TS_B_points_offset);
}

static ts_status points_count(ts_run *run)
{
	u64 total;
	ts_points_args args = ts_points_values(run);
	if (TS_RUN(run, &counted, &args, ts_run_size(run, TS_DIM_pieces)) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &counted, "offset", &total) != TS_OK) return TS_ERROR;
	ts_run_count(run, "points", (i64)total);
	return TS_OK;
}

/* Like the papers' GPUs, without a count: buffers that are too small are made larger, and all is appended again. */
static ts_status append(ts_run *run, ts_points_args *args, u64 n)
{
	u64 total = 2 * n;
	do {
		args->room = total;
		ts_run_set_size(run, TS_DIM_points, total);
		ts_launch_make_again(run, &appended);
		if (TS_RUN(run, &appended, args, n) != TS_OK) return TS_ERROR;
		total = (u64)ts_frame_tally(&run->frame, 0);
	} while (total > args->room && total < TS_NONE);
	if (total >= TS_NONE) return ts_run_too_many(total, "points");
	ts_launch_cut(run, &appended, "keys", args->room - total);
	ts_launch_cut(run, &appended, "points", args->room - total);
	ts_run_set_size(run, TS_DIM_points, total);
	ts_run_count(run, "points", (i64)total);
	return TS_OK;
}

static ts_status points(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_pieces);
	ts_points_args args = ts_points_values(run);
	if (run->arrival) return append(run, &args, n);
	const u32 *before = ts_frame_data(&run->frame, TS_B_points_offset);
	args.room = before[n];
	ts_run_set_size(run, TS_DIM_points, args.room);
	return TS_RUN(run, &written, &args, n);
}

const ts_stage ts_stage_points_count = {
	.name = "points.count",
	.kind = "emit",
	.paper = "EPR 3.3",
	.doc = "number of points of every piece, and their prefix sums",
	.run = points_count,
	.launches = TS_LAUNCHES(&counted),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_points = {
	.name = "points",
	.kind = "emit",
	.paper = "EPR 3.4, eq. 4",
	.doc = "points with splat lengths",
	.run = points,
	.launches = TS_LAUNCHES(&written, &appended),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
