/* Visibility of surfels, from the eye and from lights. */
#include "kernels/surfels/surfel_depth.h"
#include "methods/surfels/surfel.h"

static const ts_launch from_eye = TS_LAUNCH(surfel_depth, TS_ALL);
static const ts_launch from_lights = TS_LAUNCH(surfel_depth_shadow, TS_ALL);

static ts_status surfel_depth(ts_run *run)
{
	ts_surfel_depth_args args;
	return TS_RUN(run, &from_eye, &args, ts_run_size(run, TS_DIM_surfels));
}

static ts_status surfel_depth_shadow(ts_run *run)
{
	ts_surfel_depth_shadow_args args = {.filter = ts_surfel_filter(run),
	                                    .n_views = (u32)ts_run_size(run, TS_DIM_views)};
	return TS_RUN(run, &from_lights, &args, ts_run_size(run, TS_DIM_surfels));
}

const ts_stage ts_stage_surfel_depth = {
	.name = "surfel_depth",
	.kind = "scatter",
	.paper = "NV40: 3-Pass Deferred Shading",
	.doc = "visibility: the nearest surfel of every pixel, moved back by epsilon, by 64-bit minimum",
	.run = surfel_depth,
	.launches = TS_LAUNCHES(&from_eye),
};

const ts_stage ts_stage_surfel_depth_shadow = {
	.name = "surfel_depth.shadow",
	.kind = "scatter",
	.paper = "NV40: Timings & Comparison",
	.doc = "depth maps of surfels for every light",
	.run = surfel_depth_shadow,
	.launches = TS_LAUNCHES(&from_lights),
};
