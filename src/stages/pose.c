/* Vertices of this frame in world space. */
#include "stages.h"

ts_status ts_stage_pose(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_scene_vertex);
	ts_pose_args args = {
		.vertices = ts_frame_handle(&run->frame, TS_B_scene_vertex),
		.objects = ts_frame_handle(&run->frame, TS_B_scene_object),
		.posed = ts_frame_make1(&run->frame, TS_B_pose_vertex, n),
		.frame = run->params.frame,
	};
	if (args.posed == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_pose, &args, n);
}
