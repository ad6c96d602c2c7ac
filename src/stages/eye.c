/* The eye's depth and triangle. */
#include "stages.h"

ts_status ts_stage_eye(ts_run *run)
{
	u64 width = run->params.width;
	u64 height = run->params.height;
	u64 *texels = ts_frame_make2(&run->frame, TS_B_eye_depth_triangle, height, width);
	if (texels == NULL || ts_run_fill(run, TS_B_eye_depth_triangle, 0xff) != TS_OK) return TS_ERROR;
	ts_eye_args args = {
		.scene = ts_run_arrays(run),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.texels = texels,
	};
	if (ts_run_launch(run, TS_KERNEL_eye, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	return TS_OK;
}
