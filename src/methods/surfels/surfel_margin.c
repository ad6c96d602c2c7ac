/* How near the decisions about surfels were. */
#include "../../kernels/surfels/surfel_margin.h"
#include "surfel.h"

static const ts_launch of_depths = TS_LAUNCH(surfel_depth_margin, TS_MIN(margin, surfel_depth_margin));
static const ts_launch of_fragments =
	TS_LAUNCH(surfel_blend_margin, TS_WITH(heaviest), TS_MIN(margin, surfel_blend_margin), TS_BUT(epsilon));

static ts_status measure(ts_run *run, const ts_launch *launch)
{
	ts_surfel_margin_args args = {.filter = ts_surfel_filter(run)};
	return TS_RUN(run, launch, &args, ts_run_size(run, TS_DIM_surfels));
}

static ts_status surfel_depth_margin(ts_run *run) { return measure(run, &of_depths); }
static ts_status surfel_blend_margin(ts_run *run) { return measure(run, &of_fragments); }

const ts_stage ts_stage_surfel_depth_margin = {
	.name = "surfel_depth.margin",
	.kind = "scatter",
	.margin_of = "surfel_depth",
	.paper = "NV40: 3-Pass Deferred Shading",
	.doc = "how near the nearest of every pixel was to another",
	.run = surfel_depth_margin,
	.launches = TS_LAUNCHES(&of_depths),
};

const ts_stage ts_stage_surfel_blend_margin = {
	.name = "surfel_blend.margin",
	.kind = "scatter",
	.margin_of = "surfel_blend",
	.paper = "NV40: Approximate EWA Filtering",
	.doc = "how near fragments were to come or go",
	.run = surfel_blend_margin,
	.launches = TS_LAUNCHES(&of_fragments),
};
