/* Sums of the attributes of surfels. */
#include "../../kernels/surfels/surfel_blend_order.h"
#include "../../kernels/surfels/surfel_blend.h"
#include "surfel.h"

static const ts_launch in_any_order = TS_LAUNCH(surfel_blend, TS_ALL);
static const ts_launch in_order = TS_LAUNCH(surfel_blend_order, TS_ALL);

/* CONTRACT rule 30: as many terms as there can be surfels, each the largest that ts_fix gives. */
_Static_assert((u64)TS_NONE *INT32_MAX <= (u64)INT64_MAX, "sums of surfels may overflow");

static ts_status blend_in_order(ts_run *run)
{
	ts_surfel_blend_order_args args = {.filter = ts_surfel_filter(run),
	                                   .accumulation = TS_PARAM(&run->params, surfel_blend_accumulation)};
	ts_run_count(run, "fragments", (i64)ts_run_size(run, TS_DIM_fragments));
	return TS_RUN(run, &in_order, &args, (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height));
}

static ts_status surfel_blend(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_surfels);
	ts_surfel_blend_args args = {.filter = ts_surfel_filter(run)};
	if (n > TS_NONE) return ts_run_too_many(n, "surfels");
	if (ts_accumulates_in_order(&run->params)) return blend_in_order(run);
	if (TS_RUN(run, &in_any_order, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "fragments", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "pixels of boxes", ts_frame_tally(&run->frame, 1));
	return TS_OK;
}

const ts_stage ts_stage_surfel_blend = {
	.name = "surfel_blend",
	.kind = "scatter",
	.paper = "NV40: Approximate EWA Filtering",
	.doc = "attributes: colours and normals of the surfels before that depth, by integer sums or in order",
	.run = surfel_blend,
	.launches = TS_LAUNCHES(&in_any_order, &in_order),
};
