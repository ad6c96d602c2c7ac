/* Depth segments of the blocks of the grid, how near they were to other segments, and their boxes. */
#include "kernels/hulls/segment.h"
#include "kernels/hulls/segment_box.h"
#include "kernels/hulls/segment_margin.h"
#include "methods/stages.h"

static const ts_launch sweep = TS_LAUNCH(segment, TS_ALL);
static const ts_launch components = TS_LAUNCH(segment_components, TS_ALL);
static const ts_launch whole = TS_LAUNCH(segment_none, TS_ALL);
static const ts_launch measured = TS_LAUNCH(segment_margin, TS_ALL);
static const ts_launch extent = TS_LAUNCH(segment_extent, TS_ALL);
static const ts_launch counted = TS_LAUNCH(segment_box_count, TS_BUT(boxes));
static const ts_launch written = TS_LAUNCH(segment_box, TS_IN(offset, segment_box_offset), TS_BUT(n_labels));

#define NO_STEP 1e30f /* larger than any step: parts nothing, with the greatest margin */

static u64 n_texels(const ts_run *run)
{
	return (u64)TS_PARAM(&run->params, depth_grid_px) * TS_PARAM(&run->params, depth_grid_px);
}

static ts_status segment(ts_run *run)
{
	ts_segment_args args = {.grid = TS_PARAM(&run->params, depth_grid_px),
	                        .step = TS_PARAM(&run->params, segment_step)};
	u32 method = TS_PARAM(&run->params, segment_method);
	if (method == TS_SEGMENTATION_NONE) return TS_RUN(run, &whole, &args, n_texels(run));
	if (method == TS_SEGMENTATION_COMPONENTS) {
		return TS_RUN(run, &components, &args, n_texels(run) / TS_BLOCK_TEXELS);
	}
	for (args.sweep = 0; args.sweep < 4; args.sweep++) {
		if (TS_RUN(run, &sweep, &args, n_texels(run) / TS_BLOCK) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status segment_margin(ts_run *run)
{
	bool none = TS_PARAM(&run->params, segment_method) == TS_SEGMENTATION_NONE;
	ts_segment_margin_args args = {.grid = TS_PARAM(&run->params, depth_grid_px),
	                               .step = none ? NO_STEP : TS_PARAM(&run->params, segment_step)};
	return TS_RUN(run, &measured, &args, n_texels(run) / TS_BLOCK_TEXELS);
}

static ts_status segment_extent(ts_run *run)
{
	ts_segment_extent_args args = {.grid = TS_PARAM(&run->params, depth_grid_px)};
	return TS_RUN(run, &extent, &args, n_texels(run));
}

static ts_status segment_box(ts_run *run)
{
	u64 total, n = n_texels(run);
	ts_segment_box_args args;
	if (TS_RUN(run, &counted, &args, n) != TS_OK) return TS_ERROR;
	i64 n_labels = ts_frame_tally(&run->frame, 0);
	if (ts_launch_sum(run, &counted, "offset", &total) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &written, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "blocks", (i64)(n / TS_BLOCK_TEXELS));
	ts_run_count(run, "labels", n_labels);
	ts_run_count(run, "boxes", (i64)total);
	return TS_OK;
}

const ts_stage ts_stage_segment = {
	.name = "segment",
	.kind = "map",
	.paper = "SSAGH 3, algorithm 1",
	.doc = "segments of like depth in each block",
	.run = segment,
	.launches = TS_LAUNCHES(&sweep, &components, &whole),
};

const ts_stage ts_stage_segment_margin = {
	.name = "segment.margin",
	.kind = "map",
	.margin_of = "segment",
	.paper = "SSAGH 3, algorithm 1",
	.doc = "margins of the steps between segments",
	.run = segment_margin,
	.launches = TS_LAUNCHES(&measured),
};

const ts_stage ts_stage_segment_extent = {
	.name = "segment.extent",
	.kind = "scatter",
	.paper = "SSAGH 3",
	.doc = "extent of each segment by integer minimum",
	.run = segment_extent,
	.launches = TS_LAUNCHES(&extent),
};

const ts_stage ts_stage_segment_box = {
	.name = "segment.box",
	.kind = "emit",
	.paper = "SSAGH 3",
	.doc = "boxes of the segments, except of the sky",
	.run = segment_box,
	.launches = TS_LAUNCHES(&counted, &written),
};
