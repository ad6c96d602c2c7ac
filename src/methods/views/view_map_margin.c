/* Margins of the maps of views. */
#include "kernels/views/view_map_margin.h"
#include "methods/views/octree.h"
#include "methods/views/traverse.h"

static const ts_launch measured = TS_LAUNCH(view_map_margin, TS_ALL);
static const ts_launch measured_but_own = TS_LAUNCH(view_map_margin, TS_WITH(own));

static const ts_launch *launch_of(const ts_run *run) { return run->plan.views.cubes ? &measured_but_own : &measured; }

static ts_status begin(ts_run *run, ts_view_map_margin_args *args)
{
	*args = (ts_view_map_margin_args){.pyramid = ts_view_pyramid(&run->params, &run->plan), .n_nodes = 1};
	if (ts_traverse_arguments(run, &args->of) != TS_OK) return TS_ERROR;
	return TS_FILL(run, launch_of(run), args);
}

/* Undecided pairs: the children of those of a piece. */
static ts_status take_children(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_view_map_margin_args *args = user;
	args->pairs = piece->args.next;
	return piece->n_children > 0 ? ts_launch_items(run, launch_of(run), args, piece->n_children) : TS_OK;
}

static ts_status view_map_margin(ts_run *run)
{
	ts_view_map_margin_args args;
	if (begin(run, &args) != TS_OK) return TS_ERROR;
	ts_traverse_from(run, &args.of);
	args.first = args.of.first_node;
	args.n_nodes = args.of.n_nodes;
	u64 n_starts = ts_traverse_starts(run, &args.of);
	if (n_starts > 0 && ts_launch_items(run, launch_of(run), &args, n_starts) != TS_OK) return TS_ERROR;
	return ts_traverse(run, &args.of, take_children, &args);
}

/* For brute force: every leaf of the scene with every view. */
static ts_status view_map_all_margin(ts_run *run)
{
	ts_view_map_margin_args args;
	if (begin(run, &args) != TS_OK) return TS_ERROR;
	args.first = ts_octree_first(run, &ts_scene_octree, TS_PARAM(&run->params, octree_levels));
	args.n_nodes = (u32)ts_run_size(run, TS_DIM_leaves);
	u64 n = args.n_nodes * ts_run_size(run, TS_DIM_view_nodes);
	return n > 0 ? ts_launch_items(run, launch_of(run), &args, n) : TS_OK;
}

const ts_stage ts_stage_view_map_margin = {
	.name = "view_map.margin",
	.kind = "scatter",
	.margin_of = "view_map",
	.paper = "MegaViews 3.2",
	.doc = "margins of the texels of maps",
	.run = view_map_margin,
	.launches = TS_LAUNCHES(TS_TRAVERSE_LAUNCHES, &measured, &measured_but_own),
	.looks_at = TS_BUFFERS(TS_B_octree_level, TS_B_view_octree_level),
};

const ts_stage ts_stage_view_map_all_margin = {
	.name = "view_map.all_margin",
	.kind = "scatter",
	.margin_of = "view_map.all",
	.paper = "MegaViews 4.1",
	.doc = "margins of the texels of brute force's maps",
	.run = view_map_all_margin,
	.launches = TS_LAUNCHES(&measured),
	.looks_at = TS_BUFFERS(TS_B_octree_level),
};
