/* Octrees: masks, nodes and the lists of the leaves; that of the scene. */
#include "octree.h"

const ts_octree ts_scene_octree = {
	TS_B_voxel_mask, TS_B_voxel_before, TS_B_octree_level, TS_B_octree_node, TS_B_octree_offset, TS_B_octree_triangle,
	"scene nodes", "scene leaves", "scene octree bytes",
};

u64 *ts_octree_mask(ts_run *run, const ts_octree *octree)
{
	u64 *mask = ts_frame_make1(&run->frame, octree->mask, ts_k_mask_first(run->params.levels + 1));
	return mask != NULL && ts_run_fill(run, octree->mask, 0) == TS_OK ? mask : NULL;
}

ts_status ts_octree_ids(ts_run *run, const ts_octree *octree)
{
	u64 total, n = ts_frame_n(&run->frame, octree->mask);
	ts_mask_args args = {
		.mask = ts_frame_handle(&run->frame, octree->mask),
		.before = ts_frame_make1(&run->frame, octree->before, n + 1),
	};
	if (args.before == NULL) return TS_ERROR;
	for (args.level = run->params.levels; args.level-- > 0;) {
		u64 words = ts_k_mask_first(args.level + 1) - ts_k_mask_first(args.level);
		if (ts_run_launch(run, TS_KERNEL_mask_up, &args, words) != TS_OK) return TS_ERROR;
	}
	if (ts_run_launch(run, TS_KERNEL_mask_count, &args, n) != TS_OK) return TS_ERROR;
	return ts_run_scan(run, octree->before, &total);
}

u32 ts_octree_first(const ts_run *run, const ts_octree *octree, u32 level)
{
	return ((const u32 *)ts_frame_data(&run->frame, octree->level))[level];
}

ts_status ts_octree_nodes(ts_run *run, const ts_octree *octree)
{
	u32 levels = run->params.levels;
	ts_octree_args args = {
		.root = ts_frame_handle(&run->frame, TS_B_root_cube),
		.mask = ts_frame_handle(&run->frame, octree->mask),
		.before = ts_frame_handle(&run->frame, octree->before),
		.level = ts_frame_make1(&run->frame, octree->level, levels + 2),
		.levels = levels,
	};
	if (args.level == NULL || ts_run_launch(run, TS_KERNEL_octree_level, &args, levels + 2) != TS_OK) return TS_ERROR;
	u64 n = ts_octree_first(run, octree, levels + 1), n_leaves = n - ts_octree_first(run, octree, levels);
	args.nodes = ts_frame_make1(&run->frame, octree->node, n);
	if (args.nodes == NULL || ts_frame_make1(&run->frame, octree->offset, n_leaves + 2) == NULL) return TS_ERROR;
	if (ts_run_fill(run, octree->offset, 0) != TS_OK) return TS_ERROR;
	ts_run_count(run, octree->nodes, (i64)n);
	ts_run_count(run, octree->leaves, (i64)n_leaves);
	return ts_run_launch(run, TS_KERNEL_octree, &args, ts_frame_n(&run->frame, octree->mask));
}

ts_status ts_octree_lists(ts_run *run, const ts_octree *octree)
{
	u64 total;
	if (ts_run_scan(run, octree->offset, &total) != TS_OK) return TS_ERROR;
	return ts_frame_make1(&run->frame, octree->entries, total) != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_octree_sort(ts_run *run, const ts_octree *octree)
{
	const ts_buffer_id made[] = {octree->level, octree->node, octree->offset, octree->entries};
	u64 n_leaves = ts_frame_n(&run->frame, octree->offset) - 2;
	ts_frame_cut(&run->frame, octree->offset, n_leaves + 1);
	ts_sort_args args = {
		.offset = ts_frame_handle(&run->frame, octree->offset),
		.entries = ts_frame_handle(&run->frame, octree->entries),
	};
	for (u32 k = 0; k < 4; k++) ts_run_count(run, octree->bytes, (i64)run->frame.buffer[made[k]].bytes);
	return ts_run_launch(run, TS_KERNEL_leaf_sort, &args, n_leaves);
}

static ts_voxel_args arguments(const ts_run *run)
{
	return (ts_voxel_args){
		.scene = ts_run_arrays(run),
		.root = ts_frame_handle(&run->frame, TS_B_root_cube),
		.levels = run->params.levels,
	};
}

ts_status ts_stage_voxel(ts_run *run)
{
	ts_voxel_args args = arguments(run);
	args.mask = ts_octree_mask(run, &ts_scene_octree);
	if (args.mask == NULL || ts_run_launch(run, TS_KERNEL_voxel, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	return ts_octree_ids(run, &ts_scene_octree);
}

ts_status ts_stage_octree(ts_run *run)
{
	const ts_octree *octree = &ts_scene_octree;
	if (ts_octree_nodes(run, octree) != TS_OK) return TS_ERROR;
	ts_voxel_args args = arguments(run);
	args.bits = ts_frame_handle(&run->frame, octree->mask);
	args.before = ts_frame_handle(&run->frame, octree->before);
	args.offset = ts_frame_handle(&run->frame, octree->offset);
	args.first_leaf = ts_octree_first(run, octree, args.levels);
	if (ts_run_launch(run, TS_KERNEL_voxel, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	if (ts_octree_lists(run, octree) != TS_OK) return TS_ERROR;
	args.triangles = ts_frame_handle(&run->frame, octree->entries);
	if (ts_run_launch(run, TS_KERNEL_voxel, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 2);
	return ts_octree_sort(run, octree);
}

ts_status ts_stage_octree_surface(ts_run *run)
{
	const ts_octree *octree = &ts_scene_octree;
	ts_octree_surface_args args = {
		.scene = ts_run_arrays(run),
		.root = ts_frame_handle(&run->frame, TS_B_root_cube),
		.nodes = ts_frame_handle(&run->frame, octree->node),
		.offset = ts_frame_handle(&run->frame, octree->offset),
		.triangles = ts_frame_handle(&run->frame, octree->entries),
		.surfaces = ts_frame_make1(&run->frame, TS_B_octree_surface_node, ts_frame_n(&run->frame, octree->node)),
		.levels = run->params.levels,
	};
	if (args.surfaces == NULL) return TS_ERROR;
	for (u32 level = args.levels + 1; level-- > 0;) {
		ts_kernel kernel = level == args.levels ? TS_KERNEL_leaf_surface : TS_KERNEL_inner_surface;
		args.first = ts_octree_first(run, octree, level);
		u64 n_nodes = ts_octree_first(run, octree, level + 1) - args.first;
		if (ts_run_launch(run, kernel, &args, n_nodes) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}
