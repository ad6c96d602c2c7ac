/* Points into the cubes. */
#include "stages.h"

/* Without their output. */
static ts_splat_args arguments(ts_run *run)
{
	i64 *tallies = ts_frame_tallies(&run->frame);
	return (ts_splat_args){
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.pieces = ts_frame_handle(&run->frame, TS_B_split_triangle),
		.frames = ts_frame_handle(&run->frame, TS_B_align_frame),
		.bits = ts_frame_handle(&run->frame, TS_B_visibility_bits),
		.points = ts_frame_handle(&run->frame, TS_B_points_record),
		.n_scatters = &tallies[0],
		.n_writes = &tallies[1],
		.n_cubes = ts_run_n_cubes(run),
		.n_words = ts_run_n_words(run),
		.n_pieces = (u32)ts_frame_n(&run->frame, TS_B_split_triangle),
		.clip = run->params.clip,
		.plane_depth = run->params.planedepth,
	};
}

ts_status ts_stage_splat(ts_run *run)
{
	u64 n_texels = ts_run_n_texels(run, 0, ts_run_n_cubes(run));
	ts_splat_args args = arguments(run);
	args.offset = run->arrival ? NULL : ts_frame_handle(&run->frame, TS_B_count_offset);
	args.texels = ts_frame_make1(&run->frame, TS_B_splat_depth_index, n_texels);
	if (args.texels == NULL || ts_run_fill(run, TS_B_splat_depth_index, 0xff) != TS_OK) return TS_ERROR;
	u64 n = ts_frame_n(&run->frame, TS_B_points_record);
	if (ts_run_launch(run, TS_KERNEL_splat, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "point-view scatters", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 1));
	return TS_OK;
}

ts_status ts_stage_tie(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_splat_depth_index);
	ts_splat_args args = arguments(run);
	args.texels = ts_frame_handle(&run->frame, TS_B_splat_depth_index);
	args.tie = ts_frame_make1(&run->frame, TS_B_splat_tie, n);
	args.mark = 1;
	if (args.tie == NULL || ts_run_fill(run, TS_B_splat_tie, 0) != TS_OK) return TS_ERROR;
	u64 n_points = ts_frame_n(&run->frame, TS_B_points_record);
	if (ts_run_launch(run, TS_KERNEL_splat, &args, n_points) != TS_OK) return TS_ERROR;
	const u8 *tie = ts_frame_data(&run->frame, TS_B_splat_tie);
	i64 ties = 0;
	for (u64 i = 0; i < n; i++) ties += tie[i];
	ts_run_count(run, "texels tied", ties);
	return TS_OK;
}
