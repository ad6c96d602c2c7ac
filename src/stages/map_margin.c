/* How near what maps of views show was to another answer. */
#include "octree.h"
#include "traverse.h"

/* Makes the margins, all none. */
static ts_status begin(ts_run *run, ts_map_margin_args *args)
{
	ts_pyramid pyramid = ts_view_pyramid(&run->params);
	u64 n = ts_frame_n(&run->frame, TS_B_view_octree_node);
	*args = (ts_map_margin_args){
		.texels = ts_frame_handle(&run->frame, TS_B_map_depth_node),
		.margin = ts_frame_make2(&run->frame, TS_B_map_margin, n, ts_k_pyramid_texels(&pyramid)),
		.pyramid = pyramid,
		.n_nodes = 1,
	};
	if (args->margin == NULL || ts_traverse_arguments(run, &args->of) != TS_OK) return TS_ERROR;
	return ts_run_fill(run, TS_B_map_margin, 0xff);
}

/* Pairs before they are decided: the children of those of a piece. */
static ts_status take_children(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_map_margin_args *args = user;
	args->pairs = piece->args.next;
	return piece->n_children > 0 ? ts_run_launch(run, TS_KERNEL_map_margin, args, piece->n_children) : TS_OK;
}

ts_status ts_stage_map_margin(ts_run *run)
{
	ts_map_margin_args args;
	if (begin(run, &args) != TS_OK) return TS_ERROR;
	u64 n_roots = ts_frame_n(&run->frame, TS_B_octree_node) > 0 ? ts_octree_first(run, &ts_view_octree, 1) : 0;
	if (n_roots > 0 && ts_run_launch(run, TS_KERNEL_map_margin, &args, n_roots) != TS_OK) return TS_ERROR;
	return ts_traverse(run, &args.of, take_children, &args);
}

/* By brute force: every leaf of the scene for every view. */
ts_status ts_stage_map_all_margin(ts_run *run)
{
	ts_map_margin_args args;
	if (begin(run, &args) != TS_OK) return TS_ERROR;
	args.first = ts_octree_first(run, &ts_scene_octree, run->params.levels);
	args.n_nodes = ts_octree_first(run, &ts_scene_octree, run->params.levels + 1) - args.first;
	u64 n = args.n_nodes * ts_frame_n(&run->frame, TS_B_view_octree_node);
	return n > 0 ? ts_run_launch(run, TS_KERNEL_map_margin, &args, n) : TS_OK;
}
