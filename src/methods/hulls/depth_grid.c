/* The screen's depth down-sampled to the grid. */
#include <inttypes.h>
#include "kernels/hulls/depth_grid.h"
#include "methods/registry.h"
#include "methods/stages.h"

static const ts_launch sampled = TS_LAUNCH(depth_grid, TS_ALL);

u64 ts_size_grid_side(const ts_size_question *q) { return TS_PARAM(&q->run->params, depth_grid_px); }

ts_status ts_grid_check(const ts_params *params)
{
	u32 grid = TS_PARAM(params, depth_grid_px);
	if (grid % TS_BLOCK == 0) return TS_OK;
	return ts_fail("depth_grid.px=%" PRIu32 ": a multiple of 32, as %" PRIu32 ", would be right", grid,
	               grid - grid % TS_BLOCK);
}

static ts_status depth_grid(ts_run *run)
{
	ts_depth_grid_args args = {.grid = TS_PARAM(&run->params, depth_grid_px),
	                           .width = TS_PARAM(&run->params, width),
	                           .height = TS_PARAM(&run->params, height)};
	if (ts_grid_check(&run->params) != TS_OK) return TS_ERROR;
	return TS_RUN(run, &sampled, &args, (u64)args.grid * args.grid);
}

const ts_stage ts_stage_depth_grid = {
	.name = "depth_grid",
	.kind = "map",
	.paper = "SSAGH 3",
	.doc = "the depth of the screen, down-sampled",
	.run = depth_grid,
	.launches = TS_LAUNCHES(&sampled),
};
