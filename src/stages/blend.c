/* Sums of the attributes of surfels. */
#include "stages.h"

/* CONTRACT rule 30: as many terms as there can be surfels, each the largest that ts_fix gives. */
_Static_assert((u64)TS_NONE * INT32_MAX <= (u64)INT64_MAX, "sums of surfels may overflow");

static ts_status clear_sums(ts_run *run)
{
	const u64 shape[3] = {run->params.height, run->params.width, TS_BLEND_SUMS};
	bool good = ts_run_zeros(run, TS_B_blend_sum, 3, shape) != NULL &&
	            ts_frame_make(&run->frame, TS_B_blend_heaviest, 2, shape) != NULL &&
	            ts_run_fill(run, TS_B_blend_heaviest, 0xff) == TS_OK;
	return good ? TS_OK : TS_ERROR;
}

ts_status ts_stage_blend(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_scene_surfel);
	if (n > TS_NONE) return ts_run_too_many(n, "surfels");
	if (clear_sums(run) != TS_OK) return TS_ERROR;
	if (ts_accumulates_in_order(&run->params)) return ts_blend_in_order(run);
	ts_blend_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.surfels = ts_frame_handle(&run->frame, TS_B_scene_surfel),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.keys = ts_frame_handle(&run->frame, TS_B_surfel_depth_surfel),
		.sums = ts_frame_handle(&run->frame, TS_B_blend_sum),
		.heaviest = ts_frame_handle(&run->frame, TS_B_blend_heaviest),
		.tally = ts_frame_tallies(&run->frame),
		.filter = ts_surfel_filter(run),
	};
	if (args.tally == NULL || ts_run_launch(run, TS_KERNEL_blend, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "fragments", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "pixels of boxes", ts_frame_tally(&run->frame, 1));
	return TS_OK;
}
