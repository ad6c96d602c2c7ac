/* Shadows from depth maps. */
#include "stages.h"

u32 *ts_resolve_output(ts_run *run)
{
	u32 n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_shape);
	if (run->first_unit == 0) {
		u32 *lit = ts_frame_make3(&run->frame, TS_B_resolve_lit, run->params.height, run->params.width, n_lamps);
		if (lit == NULL || ts_run_fill(run, TS_B_resolve_lit, 0) != TS_OK) return NULL;
	}
	return ts_frame_handle(&run->frame, TS_B_resolve_lit);
}

ts_resolve_args ts_resolve_arguments(const ts_run *run)
{
	ts_resolve_args args = {
		.scene = ts_run_arrays(run),
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_eye_depth_triangle),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.depths = ts_frame_handle(&run->frame, TS_B_scatter_depth),
		.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_shape),
		.cubes = ts_run_has_cubes(run),
		.bias = run->params.bias,
		.slope = run->params.bias_slope,
	};
	ts_run_views(run, &args.first_view, &args.n_views);
	return args;
}

ts_status ts_stage_resolve(ts_run *run)
{
	ts_resolve_args args = ts_resolve_arguments(run);
	args.lit = ts_resolve_output(run);
	if (args.lit == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_resolve, &args, ts_frame_n(&run->frame, TS_B_eye_depth_triangle));
}
