/* The G-buffer of surfels: sums divided by their weights. */
#include "kernels/surfels/surfel_blend_mean.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(surfel_blend_mean, TS_ALL);

static ts_status surfel_blend_mean(ts_run *run)
{
	ts_surfel_blend_mean_args args;
	return TS_RUN(run, &launch, &args, (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height));
}

const ts_stage ts_stage_surfel_blend_mean = {
	.name = "surfel_blend.mean",
	.kind = "map",
	.paper = "NV40: 3-Pass Deferred Shading",
	.doc = "sums divided by their weights: a G-buffer",
	.run = surfel_blend_mean,
	.launches = TS_LAUNCHES(&launch),
};
