/* Pieces of triangles, each with its density. */
#include "stages.h"

ts_status ts_stage_split(ts_run *run)
{
	u64 n = run->scene->n_triangles;
	ts_density_args args = {
		.scene = ts_run_arrays(run),
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.bits = ts_frame_handle(&run->frame, TS_B_visibility_bits),
		.whole = ts_frame_make1(&run->frame, TS_B_split_scale, n),
		.offset = ts_frame_make1(&run->frame, TS_B_split_offset, n + 1),
		.n_capped = ts_frame_tallies(&run->frame),
		.rho = ts_samples_a_pixel(&run->params),
		.n_cubes = ts_run_n_cubes(run),
		.n_words = ts_run_n_words(run),
		.paper = run->params.density == TS_DENSITY_PAPER,
		.cap = run->params.cap,
		.offaxis = run->params.offaxis,
		.split = run->params.split,
	};
	if (args.whole == NULL || args.offset == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_split_count, &args, n) != TS_OK) return TS_ERROR;
	u64 total;
	if (ts_run_scan(run, TS_B_split_offset, "pieces of triangles", &total) != TS_OK) return TS_ERROR;
	args.pieces = ts_frame_make1(&run->frame, TS_B_split_triangle, total);
	args.scale = ts_frame_make1(&run->frame, TS_B_density_scale, total);
	if (args.pieces == NULL || args.scale == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_split, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pieces", (i64)total);
	ts_run_count(run, "density.capped", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}
