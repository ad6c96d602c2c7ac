/* MVR: draws every triangle into every view of the batch. */
#include "kernels/raster/depth_map.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(depth_map, TS_ALL);

static ts_status depth_map(ts_run *run)
{
	ts_depth_map_args args = {.scene = ts_run_scene(run)};
	ts_run_views(run, &args.first_view, &args.n_views);
	if (TS_RUN(run, &launch, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", args.n_views);
	ts_run_count(run, "triangles processed", (i64)args.scene.n_triangles * args.n_views);
	return TS_OK;
}

const ts_stage ts_stage_depth_map = {
	.name = "depth_map",
	.kind = "scatter",
	.paper = "iVIR 4",
	.doc = "MVR: standard rasterization into every depth map",
	.run = depth_map,
	.launches = TS_LAUNCHES(&launch),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face),
};
