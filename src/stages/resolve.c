/* Shadows from depth maps. */
#include "stages.h"

ts_status ts_resolve_arguments(ts_run *run, ts_resolve_args *args)
{
	u64 width = run->params.width, height = run->params.height;
	u32 n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_shape);
	if (run->first_unit == 0) {
		if (ts_frame_make3(&run->frame, TS_B_resolve_lit, height, width, n_lamps) == NULL) return TS_ERROR;
		if (ts_run_fill(run, TS_B_resolve_lit, 0) != TS_OK) return TS_ERROR;
	}
	*args = (ts_resolve_args){
		.scene = ts_run_arrays(run),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_eye_depth_triangle),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.depths = ts_frame_handle(&run->frame, TS_B_scatter_depth),
		.lit = ts_frame_handle(&run->frame, TS_B_resolve_lit),
		.n_lamps = n_lamps,
		.cubes = ts_run_has_cubes(run),
		.bias = run->params.bias,
		.slope = run->params.bias_slope,
	};
	ts_run_views(run, &args->first_view, &args->n_views);
	return TS_OK;
}

ts_status ts_stage_resolve(ts_run *run)
{
	ts_resolve_args args;
	if (ts_resolve_arguments(run, &args) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_resolve, &args, ts_frame_n(&run->frame, TS_B_eye_depth_triangle));
}
