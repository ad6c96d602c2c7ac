/* T_epr of every piece. */
#include "stages.h"

ts_status ts_stage_align(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_split_triangle);
	ts_align_args args = {
		.pieces = ts_frame_handle(&run->frame, TS_B_split_triangle),
		.scale = ts_frame_handle(&run->frame, TS_B_density_scale),
		.keep = ts_frame_handle(&run->frame, TS_B_cull_keep),
		.frames = ts_frame_make1(&run->frame, TS_B_align_frame, n),
	};
	if (args.frames == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_align, &args, n);
}
