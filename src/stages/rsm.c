/* Reflective shadow maps, and their texels as lights. */
#include "stages.h"

ts_status ts_stage_rsm_view(ts_run *run) { return ts_light_views_make(run); }

static ts_rsm_args arguments(const ts_run *run)
{
	return (ts_rsm_args){
		.scene = ts_run_arrays(run),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_rsm_depth_triangle),
		.n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view),
	};
}

ts_status ts_stage_rsm(ts_run *run)
{
	u64 n_texels = ts_run_n_texels(run, 0, (u32)ts_frame_n(&run->frame, TS_B_offscreen_view));
	if (ts_frame_make1(&run->frame, TS_B_rsm_depth_triangle, n_texels) == NULL) return TS_ERROR;
	if (ts_run_fill(run, TS_B_rsm_depth_triangle, 0xff) != TS_OK) return TS_ERROR;
	ts_rsm_args args = arguments(run);
	if (ts_run_launch(run, TS_KERNEL_rsm, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	return TS_OK;
}

ts_status ts_stage_rsm_patch(ts_run *run)
{
	u64 n_texels = ts_frame_n(&run->frame, TS_B_rsm_depth_triangle);
	ts_rsm_args args = arguments(run);
	args.lamps = ts_frame_handle(&run->frame, TS_B_lamp_light);
	args.patches = ts_frame_make1(&run->frame, TS_B_rsm_patch, n_texels);
	if (args.patches == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_rsm_patch, &args, n_texels);
}
