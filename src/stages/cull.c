/* Which pieces stay. */
#include "stages.h"

ts_status ts_stage_cull(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_split_triangle);
	const ts_params *params = &run->params;
	ts_cull_args args = {
		.pieces = ts_frame_data(&run->frame, TS_B_split_triangle),
		.scale = ts_frame_data(&run->frame, TS_B_density_scale),
		.keep = ts_frame_make1(&run->frame, TS_B_cull_keep, n),
		.unit = params->cull_unit == TS_CULL_EYE ? ts_samples_a_pixel(params) : 1.0f,
		.seed = params->seed,
		.enabled = params->cull,
	};
	if (args.keep == NULL) return TS_ERROR;
	ts_c_launch(TS_KERNEL_cull, &args, n, run->threads);
	i64 kept = 0;
	for (u64 i = 0; i < n; i++) kept += args.keep[i];
	ts_run_count(run, "pieces kept", kept);
	ts_run_count(run, "pieces culled", (i64)n - kept);
	return TS_OK;
}
