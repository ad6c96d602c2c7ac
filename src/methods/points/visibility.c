/* Visibility bits of every triangle. */
#include "kernels/raster/visibility.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(visibility, TS_BUT_SURFACES);

static ts_status visibility(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_triangles);
	ts_visibility_args args = {
		.scene.n_triangles = (u32)n,
		.n_cubes = (u32)ts_run_size(run, TS_DIM_cubes),
		.n_words = (u32)ts_run_size(run, TS_DIM_view_words),
		.vertex_mode = TS_PARAM(&run->params, visibility_test) == TS_VISIBILITY_VERTEX,
	};
	if (TS_RUN(run, &launch, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	ts_run_count(run, "triangles processed", (i64)n);
	return TS_OK;
}

const ts_stage ts_stage_visibility = {
	.name = "visibility",
	.kind = "map",
	.paper = "EPR 3.1",
	.doc = "visibility of triangles: one bit per triangle and cube face",
	.run = visibility,
	.launches = TS_LAUNCHES(&launch),
};
