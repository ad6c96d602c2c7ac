/* Sums of the attributes of surfels, or of their shaded colours; and the G-buffer, sums divided by their weights. */
#include "kernels/surfels/surfel_blend_mean.h"
#include "kernels/surfels/surfel_blend_order.h"
#include "methods/stages.h"
#include "methods/surfels/surfel.h"

static const ts_launch in_any_order = TS_LAUNCH(surfel_blend, TS_ALL);
static const ts_launch in_order = TS_LAUNCH(surfel_blend_order, TS_ALL);
static const ts_launch shaded_once = TS_LAUNCH(surfel_shade, TS_ALL);
static const ts_launch shaded_each = TS_LAUNCH(surfel_shade, TS_WITH(slopes));

/* CONTRACT rule 30: at most one term per surfel, each at most the largest of ts_fix. */
_Static_assert((u64)TS_NONE *INT32_MAX <= (u64)INT64_MAX, "sums of surfels may overflow");

static ts_status blend_in_order(ts_run *run)
{
	ts_surfel_blend_order_args args = {.filter = ts_surfel_filter(run),
	                                   .accumulation = TS_PARAM(&run->params, surfel_blend_accumulation)};
	ts_run_count(run, "fragments", (i64)ts_run_size(run, TS_DIM_fragments));
	return TS_RUN(run, &in_order, &args, (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height));
}

static ts_status blend_shaded(ts_run *run, u64 n)
{
	ts_surfel_shade_args args = ts_surfel_shading(run);
	bool each = args.shading == TS_SHADING_PHONG;
	if (TS_RUN(run, each ? &shaded_each : &shaded_once, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "shading operations", ts_frame_tally(&run->frame, 2));
	return TS_OK;
}

static ts_status blend_attributes(ts_run *run, u64 n)
{
	ts_surfel_blend_args args = {.filter = ts_surfel_filter(run)};
	return TS_RUN(run, &in_any_order, &args, n);
}

static ts_status surfel_blend(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_surfels);
	bool shaded = run->plan.surfels.shading != 0;
	if (n > TS_NONE) return ts_run_too_many(n, "surfels");
	if (!shaded && ts_accumulates_in_order(&run->params)) return blend_in_order(run);
	if ((shaded ? blend_shaded(run, n) : blend_attributes(run, n)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "fragments", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "pixels of boxes", ts_frame_tally(&run->frame, 1));
	return TS_OK;
}

const ts_stage ts_stage_surfel_blend = {
	.name = "surfel_blend",
	.kind = "scatter",
	.paper = "NV40: Approximate EWA Filtering",
	.doc = "colours, or shaded colours, and normals of the visible surfels, blended by integer sums or in order",
	.run = surfel_blend,
	.launches = TS_LAUNCHES(&in_any_order, &in_order, &shaded_once, &shaded_each),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

static const ts_launch means = TS_LAUNCH(surfel_blend_mean, TS_ALL);

static ts_status surfel_blend_mean(ts_run *run)
{
	ts_surfel_blend_mean_args args;
	return TS_RUN(run, &means, &args, (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height));
}

const ts_stage ts_stage_surfel_blend_mean = {
	.name = "surfel_blend.mean",
	.kind = "map",
	.paper = "NV40: 3-Pass Deferred Shading",
	.doc = "sums divided by their weights: a G-buffer",
	.run = surfel_blend_mean,
	.launches = TS_LAUNCHES(&means),
};
