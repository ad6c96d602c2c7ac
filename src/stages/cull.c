/* Which pieces stay. */
#include "stages.h"

/* Samples a pixel a side; the pixels of iVIR and VIR are samples. */
static f32 cull_unit(const ts_run *run)
{
	bool eye = run->plan.points.rate == TS_RATE_IS_EYE && run->params.cull_unit == TS_CULL_EYE;
	return eye ? ts_samples_a_pixel(&run->params) : 1.0f;
}

ts_cull_args ts_cull_arguments(const ts_run *run)
{
	const ts_params *params = &run->params;
	return (ts_cull_args){
		.pieces = ts_frame_handle(&run->frame, TS_B_split_triangle),
		.scale = ts_frame_handle(&run->frame, TS_B_density_scale),
		.unit = cull_unit(run),
		.seed = params->seed,
		.enabled = params->cull,
	};
}

ts_status ts_stage_cull(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_split_triangle);
	ts_cull_args args = ts_cull_arguments(run);
	args.keep = ts_frame_make1(&run->frame, TS_B_cull_keep, n);
	if (args.keep == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_cull, &args, n) != TS_OK) return TS_ERROR;
	i64 kept = 0;
	const u32 *keep = ts_frame_data(&run->frame, TS_B_cull_keep);
	for (u64 i = 0; i < n; i++) kept += keep[i];
	ts_run_count(run, "pieces kept", kept);
	ts_run_count(run, "pieces culled", (i64)n - kept);
	return TS_OK;
}
