/* Points into the cubes. */
#include "stages.h"

/* Without their outputs. */
static ts_splat_args arguments(const ts_run *run, i64 *scatters, i64 *writes)
{
	return (ts_splat_args){
		.cubes = ts_frame_data(&run->frame, TS_B_resize_face),
		.pieces = ts_frame_data(&run->frame, TS_B_split_triangle),
		.frames = ts_frame_data(&run->frame, TS_B_align_frame),
		.bits = ts_frame_data(&run->frame, TS_B_visibility_bits),
		.points = ts_frame_data(&run->frame, TS_B_points_record),
		.n_scatters = scatters,
		.n_writes = writes,
		.n_cubes = ts_run_n_cubes(run),
		.n_words = ts_run_n_words(run),
		.clip = run->params.clip,
		.plane_depth = run->params.planedepth,
	};
}

ts_status ts_stage_splat(ts_run *run)
{
	u64 n_texels = ts_run_n_texels(run, 0, ts_run_n_cubes(run));
	i64 scatters = 0;
	i64 writes = 0;
	ts_splat_args args = arguments(run, &scatters, &writes);
	args.texels = ts_frame_make1(&run->frame, TS_B_splat_depth_index, n_texels);
	if (args.texels == NULL) return TS_ERROR;
	ts_c_empty(args.texels, n_texels, run->threads);
	if (run->reference) {
		ts_c_launch(TS_KERNEL_splat, &args, ts_frame_n(&run->frame, TS_B_points_record), run->threads);
	} else {
		ts_c_splat_fast(&args, ts_frame_data(&run->frame, TS_B_count_offset),
		                ts_frame_n(&run->frame, TS_B_split_triangle), run->threads);
	}
	ts_run_count(run, "point-view scatters", scatters);
	ts_run_count(run, "texel writes", writes);
	return TS_OK;
}

ts_status ts_stage_tie(ts_run *run)
{
	i64 scatters = 0;
	i64 writes = 0;
	u64 n = ts_frame_n(&run->frame, TS_B_splat_depth_index);
	ts_splat_args args = arguments(run, &scatters, &writes);
	args.texels = ts_frame_data(&run->frame, TS_B_splat_depth_index);
	args.tie = ts_frame_make1(&run->frame, TS_B_splat_tie, n);
	if (args.tie == NULL) return TS_ERROR;
	memset(args.tie, 0, n);
	ts_c_launch(TS_KERNEL_splat, &args, ts_frame_n(&run->frame, TS_B_points_record), run->threads);
	i64 ties = 0;
	for (u64 i = 0; i < n; i++) ties += args.tie[i];
	ts_run_count(run, "texels tied", ties);
	return TS_OK;
}
