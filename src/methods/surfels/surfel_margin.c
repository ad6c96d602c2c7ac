/* Margins of the decisions about surfels. */
#include "kernels/surfels/surfel_shade_margin.h"
#include "methods/surfels/surfel.h"

static const ts_launch of_depths = TS_LAUNCH(surfel_depth_margin, TS_MIN(margin, surfel_depth_margin));
static const ts_launch of_fragments =
	TS_LAUNCH(surfel_blend_margin, TS_WITH(heaviest), TS_MIN(margin, surfel_blend_margin), TS_BUT(epsilon));

/* For methods that shade before they blend: a second launch judges the shading. */
#define SHADED \
	TS_BUT(of.of.view), TS_BUT(of.of.discs), TS_BUT(of.of.keys), TS_BUT(of.of.sums), TS_BUT(of.of.heaviest), \
		TS_BUT(by.epsilon), TS_MIN(by.margin, surfel_blend_margin)
static const ts_launch of_shading = TS_LAUNCH(surfel_shade_margin, SHADED);
static const ts_launch of_phong = TS_LAUNCH(surfel_shade_margin, SHADED, TS_WITH(of.slopes));

static ts_status measure(ts_run *run, const ts_launch *launch)
{
	ts_surfel_margin_args args = {.filter = ts_surfel_filter(run)};
	return TS_RUN(run, launch, &args, ts_run_size(run, TS_DIM_surfels));
}

static ts_status surfel_depth_margin(ts_run *run) { return measure(run, &of_depths); }

static ts_status surfel_blend_margin(ts_run *run)
{
	ts_surfel_shade_margin_args args = {.of = ts_surfel_shading(run), .by = {.filter = ts_surfel_filter(run)}};
	const ts_launch *launch = args.of.shading == TS_SHADING_PHONG ? &of_phong : &of_shading;
	if (measure(run, &of_fragments) != TS_OK) return TS_ERROR;
	return args.of.shading != 0 ? TS_RUN(run, launch, &args, ts_run_size(run, TS_DIM_surfels)) : TS_OK;
}

const ts_stage ts_stage_surfel_depth_margin = {
	.name = "surfel_depth.margin",
	.kind = "scatter",
	.margin_of = "surfel_depth",
	.paper = "NV40: 3-Pass Deferred Shading",
	.doc = "margins of the nearest surfel of every pixel",
	.run = surfel_depth_margin,
	.launches = TS_LAUNCHES(&of_depths),
};

const ts_stage ts_stage_surfel_blend_margin = {
	.name = "surfel_blend.margin",
	.kind = "scatter",
	.margin_of = "surfel_blend",
	.paper = "NV40: Approximate EWA Filtering",
	.doc = "margins of the fragments of every pixel, and of their light",
	.run = surfel_blend_margin,
	.launches = TS_LAUNCHES(&of_fragments, &of_shading, &of_phong),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
