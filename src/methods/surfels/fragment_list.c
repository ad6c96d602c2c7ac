/* Lists of fragments, for sums in their order. */
#include "kernels/base/sort.h"
#include "kernels/surfels/fragment_list.h"
#include "kernels/surfels/surfel_blend_order.h"
#include "methods/surfels/surfel.h"

/* Until it is written, the start of a pixel's list stands in the entry after its own. */
static const ts_launch counted = TS_LAUNCH(fragment_list, TS_ALL);
static const ts_launch listed = TS_LAUNCH(fragment_list, TS_WITH(surfels));
static const ts_launch sorted =
	TS_LAUNCH(leaf_sort, TS_IN(offset, fragment_list_offset), TS_OUT(entries, fragment_list_surfel));

static ts_status fragment_list(ts_run *run)
{
	u64 total, n = ts_run_size(run, TS_DIM_surfels),
			   n_pixels = (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height);
	ts_fragment_list_args args = {.filter = ts_surfel_filter(run)};
	ts_sort_args sort;
	if (ts_launch_make(run, &counted, "offset", 1) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &counted, &args, n) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &counted, "offset", &total) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &listed, &args, n) != TS_OK) return TS_ERROR;
	ts_launch_cut(run, &counted, "offset", 1);
	return TS_RUN(run, &sorted, &sort, n_pixels);
}

bool ts_accumulates_in_order(const ts_params *params)
{
	return TS_PARAM(params, surfel_blend_accumulation) != TS_ACCUMULATION_FIXED;
}

const ts_stage ts_stage_fragment_list = {
	.name = "fragment_list",
	.kind = "emit",
	.paper = "NV40: Floating Point Precision",
	.doc = "the surfels that are blended at each pixel, in order",
	.run = fragment_list,
	.launches = TS_LAUNCHES(&counted, &listed, &sorted),
};
