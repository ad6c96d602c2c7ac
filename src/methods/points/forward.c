/* Light of every point. */
#include "kernels/points/forward.h"
#include "methods/points/points.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(forward, TS_STORED_POINTS(from));

static ts_status forward(ts_run *run)
{
	ts_forward_args args = {
		.from = ts_points_values(run),
		.n_cubes = (u32)ts_run_size(run, TS_DIM_cubes),
		.n_words = (u32)ts_run_size(run, TS_DIM_view_words),
		.for_eye = TS_PARAM(&run->params, forward_viewer) == TS_VIEWER_EYE,
	};
	u64 n = ts_run_size(run, TS_DIM_points);
	ts_run_count(run, "shading operations", (i64)n);
	return TS_RUN(run, &launch, &args, n);
}

const ts_stage ts_stage_forward = {
	.name = "forward",
	.kind = "map",
	.paper = "EPR 3.5",
	.doc = "forward shading: every point is lit once",
	.run = forward,
	.launches = TS_LAUNCHES(&launch),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
