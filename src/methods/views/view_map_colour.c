/* Whole maps of views in colour. */
#include "kernels/views/view_map_colour.h"
#include "methods/views/octree.h"

static const ts_launch shaded = TS_LAUNCH(view_map_colour, TS_IN(of.surfaces, octree_surface));

static ts_status view_map_colour(ts_run *run)
{
	u32 levels = TS_PARAM(&run->params, octree_levels);
	ts_view_map_colour_args args = {
		.of = {.scene = ts_run_scene(run), .levels = levels, .first = ts_octree_first(run, &ts_scene_octree, levels)},
		.n = run->plan.views.px,
	};
	u64 n = ts_run_size(run, TS_DIM_vpls) * 2 * args.n * args.n;
	if (TS_RUN(run, &shaded, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "shading operations", (i64)n);
	return TS_OK;
}

const ts_stage ts_stage_view_map_colour = {
	.name = "view_map.colour",
	.kind = "map",
	.paper = "MegaViews 3.1",
	.doc = "deferred shading of the nodes that fused maps show",
	.run = view_map_colour,
	.launches = TS_LAUNCHES(&shaded),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_octree_level),
};
