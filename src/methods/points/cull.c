/* Which pieces stay. */
#include "kernels/points/cull_margin.h"
#include "kernels/points/view_density.h"
#include "methods/points/points.h"

static const ts_launch launch = TS_LAUNCH(cull, TS_ALL);
static const ts_launch measured = TS_LAUNCH(cull_margin, TS_BUT(cull.keep));

f32 ts_samples_a_pixel(const ts_params *params)
{
	return TS_PARAM(params, density_per_area) ? ts_sqrt(TS_PARAM(params, density_scale))
	                                          : TS_PARAM(params, density_scale);
}

f32 ts_cull_unit(const ts_params *params)
{
	bool eye = TS_PARAM(params, points_cull_unit) == TS_CULL_EYE;
	return eye ? ts_min(ts_samples_a_pixel(params), 1.0f) : 1.0f;
}

/* The pixels of iVIR and VIR are samples. */
static f32 unit_of(const ts_run *run)
{
	return run->plan.points.rate == TS_RATE_EYE ? ts_cull_unit(&run->params) : 1.0f;
}

static ts_cull_args values(const ts_run *run)
{
	return (ts_cull_args){
		.unit = unit_of(run), .seed = TS_PARAM(&run->params, seed), .enabled = TS_PARAM(&run->params, points_cull)};
}

static ts_status cull(ts_run *run)
{
	ts_cull_args args = values(run);
	if (TS_RUN(run, &launch, &args, ts_run_size(run, TS_DIM_pieces)) != TS_OK) return TS_ERROR;
	const u32 *keep = ts_frame_data(&run->frame, TS_B_cull_keep);
	u64 n = ts_frame_n(&run->frame, TS_B_cull_keep);
	i64 kept = 0;
	for (u64 i = 0; i < n; i++) kept += keep[i];
	ts_run_count(run, "pieces kept", kept);
	ts_run_count(run, "pieces culled", (i64)n - kept);
	return TS_OK;
}

static ts_status cull_margin(ts_run *run)
{
	ts_cull_margin_args args = {.cull = values(run)};
	return TS_RUN(run, &measured, &args, ts_run_size(run, TS_DIM_pieces));
}

const ts_stage ts_stage_cull = {
	.name = "cull",
	.kind = "map",
	.paper = "EPR 3.2",
	.doc = "stochastic culling of sub-pixel pieces",
	.run = cull,
	.launches = TS_LAUNCHES(&launch),
};

const ts_stage ts_stage_cull_margin = {
	.name = "cull.margin",
	.kind = "map",
	.margin_of = "cull",
	.paper = "EPR 3.2",
	.doc = "margins of the random numbers of culling",
	.run = cull_margin,
	.launches = TS_LAUNCHES(&measured),
};
