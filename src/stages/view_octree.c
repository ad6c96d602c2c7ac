/* The octree of the views, and the cones of their directions. */
#include "octree.h"

const ts_octree ts_view_octree = {
	TS_B_view_voxel_mask, TS_B_view_voxel_before, TS_B_view_octree_level, TS_B_view_octree_node, TS_B_view_octree_offset,
	TS_B_view_octree_view, "view nodes", "view leaves", "view octree bytes",
};

static ts_view_octree_args arguments(const ts_run *run)
{
	return (ts_view_octree_args){
		.root = ts_frame_handle(&run->frame, TS_B_root_cube),
		.views = ts_frame_handle(&run->frame, TS_B_vpl_light),
		.levels = run->params.levels,
	};
}

ts_status ts_stage_view_voxel(ts_run *run)
{
	ts_view_octree_args args = arguments(run);
	args.mask = ts_octree_mask(run, &ts_view_octree);
	u64 n = ts_frame_n(&run->frame, TS_B_vpl_light);
	if (args.mask == NULL || ts_run_launch(run, TS_KERNEL_view_voxel, &args, n) != TS_OK) return TS_ERROR;
	return ts_octree_ids(run, &ts_view_octree);
}

ts_status ts_stage_view_octree(ts_run *run)
{
	const ts_octree *octree = &ts_view_octree;
	u64 n = ts_frame_n(&run->frame, TS_B_vpl_light);
	if (ts_octree_nodes(run, octree) != TS_OK) return TS_ERROR;
	ts_view_octree_args args = arguments(run);
	args.bits = ts_frame_handle(&run->frame, octree->mask);
	args.before = ts_frame_handle(&run->frame, octree->before);
	args.leaf = ts_frame_make1(&run->frame, TS_B_view_octree_leaf, n);
	args.offset = ts_frame_handle(&run->frame, octree->offset);
	args.first_leaf = ts_octree_first(run, octree, args.levels);
	if (args.leaf == NULL || ts_run_launch(run, TS_KERNEL_view_leaf, &args, n) != TS_OK) return TS_ERROR;
	if (ts_octree_lists(run, octree) != TS_OK) return TS_ERROR;
	args.entries = ts_frame_handle(&run->frame, octree->entries);
	if (ts_run_launch(run, TS_KERNEL_view_list, &args, n) != TS_OK) return TS_ERROR;
	return ts_octree_sort(run, octree);
}

ts_status ts_stage_view_cone(ts_run *run)
{
	const ts_octree *octree = &ts_view_octree;
	u64 n = ts_frame_n(&run->frame, octree->node);
	ts_cone_args args = {
		.views = ts_frame_handle(&run->frame, TS_B_vpl_light),
		.nodes = ts_frame_handle(&run->frame, octree->node),
		.offset = ts_frame_handle(&run->frame, octree->offset),
		.entries = ts_frame_handle(&run->frame, octree->entries),
		.leaf = ts_frame_handle(&run->frame, TS_B_view_octree_leaf),
		.sums = ts_frame_make2(&run->frame, TS_B_view_cone_sum, n, 3),
		.least = ts_frame_make1(&run->frame, TS_B_view_cone_least, n),
		.cones = ts_frame_make1(&run->frame, TS_B_view_cone_node, n),
	};
	if (args.sums == NULL || args.least == NULL || args.cones == NULL) return TS_ERROR;
	for (u32 level = run->params.levels + 1; level-- > 0;) {
		ts_kernel kernel = level == run->params.levels ? TS_KERNEL_cone_leaf : TS_KERNEL_cone_inner;
		args.first = ts_octree_first(run, octree, level);
		u64 n_nodes = ts_octree_first(run, octree, level + 1) - args.first;
		if (ts_run_launch(run, kernel, &args, n_nodes) != TS_OK) return TS_ERROR;
	}
	if (ts_run_fill(run, TS_B_view_cone_least, 0xff) != TS_OK) return TS_ERROR;
	u64 n_views = ts_frame_n(&run->frame, TS_B_vpl_light);
	if (ts_run_launch(run, TS_KERNEL_cone_least, &args, n_views) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_cone, &args, n);
}
