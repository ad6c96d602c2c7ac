/* Pieces of triangles, each with its density. */
#include "stages.h"

static ts_status split(ts_run *run, ts_density_args args)
{
	u64 n = run->scene->n_triangles;
	args.scene = ts_run_arrays(run);
	args.bits = ts_frame_handle(&run->frame, TS_B_visibility_bits);
	args.whole = ts_frame_make1(&run->frame, TS_B_split_scale, n);
	args.offset = ts_frame_make1(&run->frame, TS_B_split_offset, n + 1);
	args.n_capped = ts_frame_tallies(&run->frame);
	args.split = run->params.split;
	if (args.whole == NULL || args.offset == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_split_count, &args, n) != TS_OK) return TS_ERROR;
	u64 total;
	if (ts_run_scan(run, TS_B_split_offset, &total) != TS_OK) return TS_ERROR;
	args.pieces = ts_frame_make1(&run->frame, TS_B_split_triangle, total);
	args.scale = ts_frame_make1(&run->frame, TS_B_density_scale, total);
	if (args.pieces == NULL || args.scale == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_split, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pieces", (i64)total);
	ts_run_count(run, "density.capped", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

ts_status ts_stage_split(ts_run *run)
{
	ts_density_args args = {
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.rho = ts_samples_a_pixel(&run->params),
		.n_cubes = ts_run_n_cubes(run),
		.n_words = ts_run_n_words(run),
		.paper = run->params.density == TS_DENSITY_PAPER,
		.cap = run->params.cap,
		.offaxis = run->params.offaxis,
		.rate = TS_RATE_IS_EYE,
	};
	return split(run, args);
}

/* iVIR's density; EPR's shadows need less where the eye sees less. */
static ts_status view_split(ts_run *run, u32 shadow)
{
	u32 n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view);
	ts_density_args args = {
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.n_views = n_views,
		.n_words = (n_views + 63) / 64,
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.rate = run->plan.points.rate,
		.shadow = shadow,
	};
	return split(run, args);
}

ts_status ts_stage_view_split(ts_run *run) { return view_split(run, TS_SHADOW_IS_NONE); }

ts_status ts_stage_shadow_split(ts_run *run) { return view_split(run, TS_SHADOW_IS_SAFE + run->params.shadow_rate); }
