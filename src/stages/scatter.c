/* Points into the off-screen views of the batch: stored ones, or made from the pieces on the spot. */
#include "stages.h"

static bool is_buffered(const ts_run *run)
{
	const ts_buffer *stored = &run->frame.buffer[TS_B_points_record];
	return stored->made && stored->n > 0;
}

/* Without the texels. */
static ts_scatter_args arguments(ts_run *run)
{
	i64 *tallies = ts_frame_tallies(&run->frame);
	ts_scatter_args args = {
		.from = ts_points_arguments(run),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.bits = ts_frame_handle(&run->frame, TS_B_visibility_bits),
		.n_points = &tallies[0],
		.n_scatters = &tallies[1],
		.n_writes = &tallies[2],
		.n_words = ((u32)ts_frame_n(&run->frame, TS_B_offscreen_view) + 63) / 64,
		.exposure = run->params.exposure,
	};
	ts_run_views(run, &args.first_view, &args.n_views);
	if (is_buffered(run)) {
		args.from.keys = ts_frame_handle(&run->frame, TS_B_points_key);
		args.from.points = ts_frame_handle(&run->frame, TS_B_points_record);
	}
	return args;
}

/* By the kernel for points that are stored, or by that for pieces. */
static ts_status launch(ts_run *run, ts_kernel stored, ts_kernel pieces, const void *args)
{
	bool buffered = is_buffered(run);
	u64 n = ts_frame_n(&run->frame, buffered ? TS_B_points_record : TS_B_align_frame);
	if (ts_run_launch(run, buffered ? stored : pieces, args, n) != TS_OK) return TS_ERROR;
	if (!buffered || run->first_unit == 0) ts_run_count(run, "geometry traversals", 1);
	if (!buffered && run->first_unit == 0) ts_run_count(run, "points", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "point-view scatters", ts_frame_tally(&run->frame, 1));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 2));
	return TS_OK;
}

static ts_status scatter(ts_run *run, const ts_scatter_args *args, ts_buffer_id into)
{
	if (args->n_views == 0) return TS_OK;
	if (ts_run_fill(run, into, 0xff) != TS_OK) return TS_ERROR;
	return launch(run, TS_KERNEL_scatter, TS_KERNEL_scatter_pieces, args);
}

static u64 n_texels(const ts_run *run) { return ts_run_n_texels(run, run->first_unit, run->n_units); }

ts_status ts_stage_scatter(ts_run *run)
{
	ts_scatter_args args = arguments(run);
	args.depths = ts_frame_make1(&run->frame, TS_B_scatter_depth, n_texels(run));
	return args.depths != NULL ? scatter(run, &args, TS_B_scatter_depth) : TS_ERROR;
}

ts_status ts_stage_scatter_colour(ts_run *run)
{
	ts_scatter_args args = arguments(run);
	args.colours = ts_frame_make1(&run->frame, TS_B_scatter_colour, n_texels(run));
	return args.colours != NULL ? scatter(run, &args, TS_B_scatter_colour) : TS_ERROR;
}

/* EPR: points smaller than a texel as they are, larger ones as squares. */
ts_status ts_stage_shadow_splat(ts_run *run)
{
	ts_shadow_splat_args args = {
		.of = arguments(run),
		.clip = run->params.clip,
		.plane_depth = run->params.shadow_depth == TS_SHADOW_DEPTH_PLANE,
	};
	args.n_splats = args.of.n_points + 3;
	args.n_texels = args.of.n_points + 4;
	args.of.depths = ts_frame_make1(&run->frame, TS_B_scatter_depth, n_texels(run));
	if (args.of.depths == NULL || ts_run_fill(run, TS_B_scatter_depth, 0xff) != TS_OK) return TS_ERROR;
	if (launch(run, TS_KERNEL_shadow_splat, TS_KERNEL_shadow_splat_pieces, &args) != TS_OK) return TS_ERROR;
	ts_run_count(run, "direct writes", ts_frame_tally(&run->frame, 2));
	ts_run_count(run, "splats", ts_frame_tally(&run->frame, 3));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 4));
	return TS_OK;
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
