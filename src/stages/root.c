/* The cube that both octrees divide. */
#include "stages.h"

ts_status ts_stage_root(ts_run *run)
{
	ts_root_args args = {
		.vertices = ts_frame_handle(&run->frame, TS_B_pose_vertex),
		.least = ts_frame_make1(&run->frame, TS_B_root_least, 6),
		.root = ts_frame_make1(&run->frame, TS_B_root_cube, 1),
	};
	if (args.least == NULL || args.root == NULL) return TS_ERROR;
	if (ts_run_fill(run, TS_B_root_least, 0xff) != TS_OK) return TS_ERROR;
	u64 n = ts_frame_n(&run->frame, TS_B_pose_vertex);
	if (ts_run_launch(run, TS_KERNEL_root_least, &args, n) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_root, &args, 1);
}
