/* The eye's depth and triangle. */
#include "stages.h"

ts_status ts_stage_eye(ts_run *run)
{
	u64 width = run->params.width;
	u64 height = run->params.height;
	u64 *texels = ts_frame_make2(&run->frame, TS_B_eye_depth_triangle, height, width);
	if (texels == NULL) return TS_ERROR;
	ts_c_empty(texels, width * height, run->threads);
	ts_eye_args args = {
		.scene = ts_run_arrays(run),
		.view = ts_frame_data(&run->frame, TS_B_eye_view),
		.texels = texels,
	};
	ts_c_launch(TS_KERNEL_eye, &args, args.scene.n_triangles, run->threads);
	ts_run_count(run, "geometry traversals", 1);
	return TS_OK;
}
