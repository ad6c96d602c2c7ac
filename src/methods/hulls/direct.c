/* Light of every triangle, gathered by every pixel itself. */
#include "../../kernels/hulls/direct.h"
#include "../stages.h"

static const ts_launch launch = TS_LAUNCH(direct, TS_ALL);

static ts_status direct(ts_run *run)
{
	u64 n_pixels = (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height);
	ts_direct_args args = {.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch)};
	ts_run_count(run, "gathers", (i64)(n_pixels * args.n_patches));
	return TS_RUN(run, &launch, &args, n_pixels);
}

const ts_stage ts_stage_direct = {
	.name = "direct",
	.kind = "map",
	.paper = "SSAGH 5",
	.doc = "light of every triangle at every pixel by form factors",
	.run = direct,
	.launches = TS_LAUNCHES(&launch),
};
