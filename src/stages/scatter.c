/* Points into the off-screen views of the batch: stored ones, or made from the pieces on the spot. */
#include "stages.h"

static ts_status scatter(ts_run *run, ts_scatter_args args, ts_buffer_id into)
{
	i64 *tallies = ts_frame_tallies(&run->frame);
	const ts_buffer *stored = &run->frame.buffer[TS_B_points_record];
	ts_run_views(run, &args.first_view, &args.n_views);
	args.from = ts_points_arguments(run);
	args.views = ts_frame_handle(&run->frame, TS_B_offscreen_view);
	args.bits = ts_frame_handle(&run->frame, TS_B_visibility_bits);
	args.n_points = &tallies[0];
	args.n_scatters = &tallies[1];
	args.n_writes = &tallies[2];
	args.n_words = ((u32)ts_frame_n(&run->frame, TS_B_offscreen_view) + 63) / 64;
	args.exposure = run->params.exposure;
	if (args.n_views == 0) return TS_OK;
	if (ts_run_fill(run, into, 0xff) != TS_OK) return TS_ERROR;
	bool buffered = stored->made && stored->n > 0;
	if (buffered) {
		args.from.keys = ts_frame_handle(&run->frame, TS_B_points_key);
		args.from.points = ts_frame_handle(&run->frame, TS_B_points_record);
	}
	u64 n = ts_frame_n(&run->frame, TS_B_align_frame);
	ts_status status = buffered ? ts_run_launch(run, TS_KERNEL_scatter, &args, stored->n)
	                            : ts_run_launch(run, TS_KERNEL_scatter_pieces, &args, n);
	if (status != TS_OK) return TS_ERROR;
	if (!buffered || run->first_unit == 0) ts_run_count(run, "geometry traversals", 1);
	if (!buffered && run->first_unit == 0) ts_run_count(run, "points", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "point-view scatters", ts_frame_tally(&run->frame, 1));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 2));
	return TS_OK;
}

static u64 n_texels(const ts_run *run) { return ts_run_n_texels(run, run->first_unit, run->n_units); }

ts_status ts_stage_scatter(ts_run *run)
{
	ts_scatter_args args = {.depths = ts_frame_make1(&run->frame, TS_B_scatter_depth, n_texels(run))};
	return args.depths != NULL ? scatter(run, args, TS_B_scatter_depth) : TS_ERROR;
}

ts_status ts_stage_scatter_colour(ts_run *run)
{
	ts_scatter_args args = {.colours = ts_frame_make1(&run->frame, TS_B_scatter_colour, n_texels(run))};
	return args.colours != NULL ? scatter(run, args, TS_B_scatter_colour) : TS_ERROR;
}

/* MVR: every triangle into every view of the batch. */
ts_status ts_stage_depth(ts_run *run)
{
	ts_depth_args args = {
		.scene = ts_run_arrays(run),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.depths = ts_frame_make1(&run->frame, TS_B_scatter_depth, n_texels(run)),
	};
	ts_run_views(run, &args.first_view, &args.n_views);
	if (args.depths == NULL || ts_run_fill(run, TS_B_scatter_depth, 0xff) != TS_OK) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_depth, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", args.n_views);
	ts_run_count(run, "triangles processed", (i64)args.scene.n_triangles * args.n_views);
	return TS_OK;
}
