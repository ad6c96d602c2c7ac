/* The G-buffer, and its depth down-sampled. */
#include "../../kernels/raster/gbuffer.h"
#include "../../kernels/hulls/grid.h"
#include <inttypes.h>
#include "../stages.h"

static const ts_launch surfaces = TS_LAUNCH(gbuffer, TS_ALL);
static const ts_launch sampled = TS_LAUNCH(nearest, TS_ALL);

static ts_status gbuffer(ts_run *run)
{
	ts_gbuffer_args args = {.scene = ts_run_scene(run)};
	return TS_RUN(run, &surfaces, &args, (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height));
}

ts_status ts_grid_check(const ts_params *params)
{
	u32 grid = TS_PARAM(params, grid_px);
	if (grid % TS_BLOCK == 0) return TS_OK;
	return ts_fail("grid_px=%" PRIu32 ": a multiple of 32, as %" PRIu32 ", would be right", grid, grid - grid % TS_BLOCK);
}

static ts_status nearest(ts_run *run)
{
	ts_nearest_args args = {.grid = TS_PARAM(&run->params, grid_px),
	                        .width = TS_PARAM(&run->params, width),
	                        .height = TS_PARAM(&run->params, height)};
	if (ts_grid_check(&run->params) != TS_OK) return TS_ERROR;
	return TS_RUN(run, &sampled, &args, (u64)args.grid * args.grid);
}

const ts_stage ts_stage_gbuffer = {
	.name = "gbuffer", .kind = "map", .paper = "SSAGH 3", .doc = "position, normal and albedo of every pixel",
	.run = gbuffer, .launches = TS_LAUNCHES(&surfaces), .looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_nearest = {
	.name = "nearest", .kind = "map", .paper = "SSAGH 3", .doc = "the screen's depth down-sampled",
	.run = nearest, .launches = TS_LAUNCHES(&sampled),
};
