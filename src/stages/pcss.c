/* Soft shadows from one depth map a light. */
#include "stages.h"

ts_status ts_stage_pcss(ts_run *run)
{
	ts_pcss_args args = {
		.of = ts_resolve_arguments(run),
		.lamps = ts_frame_handle(&run->frame, TS_B_lamp_shape),
		.near = run->params.pcss_near,
	};
	args.of.lit = ts_resolve_output(run);
	if (args.of.lit == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_pcss, &args, ts_frame_n(&run->frame, TS_B_eye_depth_triangle));
}
