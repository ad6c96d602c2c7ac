/* Light of every triangle, gathered by every pixel itself. */
#include "methods/hulls/gloss.h"
#include "methods/raster/raster.h"

static const ts_launch gathered = TS_LAUNCH(direct, TS_ALL);
static const ts_launch of_lamps = TS_LAUNCH(direct, TS_IN(patches, polygon_patch), TS_WITH(lamps), TS_WITH(shapes));

ts_direct_args ts_direct_values(const ts_run *run)
{
	bool straight = run->plan.lights.straight;
	return (ts_direct_args){.n_patches = ts_frame_n(&run->frame, straight ? TS_B_polygon_patch : TS_B_rsm_patch),
	                        .n_lamps = straight ? (u32)ts_run_size(run, TS_DIM_lamps) : 0};
}

static ts_status direct(ts_run *run)
{
	ts_direct_args args = ts_direct_values(run);
	u64 n_pixels = ts_eye_size(run);
	ts_run_count(run, "gathers", (i64)(n_pixels * args.n_patches));
	return TS_RUN(run, run->plan.lights.straight ? &of_lamps : &gathered, &args, n_pixels);
}

const ts_stage ts_stage_direct = {
	.name = "direct",
	.kind = "map",
	.paper = "SSAGH 5",
	.doc = "light of every triangle of light at every pixel, by form factors",
	.run = direct,
	.launches = TS_LAUNCHES(&gathered, &of_lamps),
};
