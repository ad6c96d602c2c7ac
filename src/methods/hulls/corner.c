/* Light at the corners of the segments' boxes, gathered and as lobes. */
#include "kernels/hulls/corner.h"
#include "kernels/hulls/corner_lobes.h"
#include "methods/stages.h"

static const ts_launch gathered = TS_LAUNCH(corner, TS_ALL);
static const ts_launch of_lamps = TS_LAUNCH(corner, TS_IN(patches, polygon_patch), TS_WITH(lamps), TS_WITH(shapes));
static const ts_launch fitted = TS_LAUNCH(corner_lobes, TS_ALL);

static ts_status corner(ts_run *run)
{
	u64 n = 4 * ts_run_size(run, TS_DIM_segment_boxes);
	bool straight = run->plan.lights.straight;
	ts_corner_args args = {.n_patches = ts_frame_n(&run->frame, straight ? TS_B_polygon_patch : TS_B_rsm_patch),
	                       .n_lamps = straight ? (u32)ts_run_size(run, TS_DIM_lamps) : 0,
	                       .grid = TS_PARAM(&run->params, depth_grid_px),
	                       .paper = TS_PARAM(&run->params, corner_facing) == TS_FACING_PAPER,
	                       .rectangle = TS_PARAM(&run->params, hull_corners) == TS_CORNERS_RECTANGLE};
	ts_run_count(run, "gathers", (i64)(n * args.n_patches));
	return TS_RUN(run, straight ? &of_lamps : &gathered, &args, n);
}

static ts_status corner_lobes(ts_run *run)
{
	ts_corner_lobes_args args = {.vmf = TS_PARAM(&run->params, hull_sharpness) == TS_SHARPNESS_VMF};
	return TS_RUN(run, &fitted, &args, 4 * ts_run_size(run, TS_DIM_segment_boxes));
}

const ts_stage ts_stage_corner = {
	.name = "corner",
	.kind = "map",
	.paper = "SSAGH 3",
	.doc = "light at the corners of every box",
	.run = corner,
	.launches = TS_LAUNCHES(&gathered, &of_lamps),
};

const ts_stage ts_stage_corner_lobes = {
	.name = "corner.lobes",
	.kind = "map",
	.paper = "SSAGH 4, eqs 4 and 5",
	.doc = "the light at the corners as spherical Gaussians, one per channel",
	.run = corner_lobes,
	.launches = TS_LAUNCHES(&fitted),
};
