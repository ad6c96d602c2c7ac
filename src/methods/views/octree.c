/* Octrees: their root, masks, nodes and the lists of the leaves; also the scene's octree, and what its nodes belong
 * to. */
#include "methods/views/octree.h"
#include "kernels/views/octree_reflector.h"
#include "kernels/views/octree_root.h"
#include "kernels/views/octree_surface.h"
#include "methods/stages.h"

const ts_octree ts_scene_octree =
	TS_OCTREE(voxel_mask, voxel_before, octree_level, octree_node, octree_offset, octree_triangle, nodes, "scene");

ts_status ts_octree_ids(ts_run *run, const ts_octree *octree)
{
	u64 total;
	ts_mask_args args;
	if (TS_FILL(run, &octree->raised, &args) != TS_OK) return TS_ERROR;
	for (args.level = TS_PARAM(&run->params, octree_levels); args.level-- > 0;) {
		u64 words = ts_k_mask_first(args.level + 1) - ts_k_mask_first(args.level);
		if (ts_launch_items(run, &octree->raised, &args, words) != TS_OK) return TS_ERROR;
	}
	if (TS_RUN(run, &octree->counted, &args, ts_run_size(run, TS_DIM_mask_words)) != TS_OK) return TS_ERROR;
	return ts_launch_sum(run, &octree->counted, "before", &total);
}

u32 ts_octree_first(const ts_run *run, const ts_octree *octree, u32 level)
{
	return ((const u32 *)ts_frame_data(&run->frame, octree->level))[level];
}

ts_status ts_octree_nodes(ts_run *run, const ts_octree *octree)
{
	u32 levels = TS_PARAM(&run->params, octree_levels);
	ts_octree_args args = {.levels = levels};
	if (TS_RUN(run, &octree->levels, &args, levels + 2) != TS_OK) return TS_ERROR;
	u32 n = ts_octree_first(run, octree, levels + 1), first_leaf = ts_octree_first(run, octree, levels);
	ts_run_set_size(run, octree->n_nodes, n);
	ts_run_count(run, octree->name_nodes, n);
	ts_run_count(run, octree->name_leaves, n - first_leaf);
	return TS_RUN(run, &octree->nodes, &args, ts_run_size(run, TS_DIM_mask_words));
}

ts_status ts_octree_sort(ts_run *run, const ts_octree *octree)
{
	const ts_buffer_id made[] = {octree->level, octree->node, octree->offset, octree->entries};
	ts_sort_args args;
	ts_launch_cut(run, &octree->sorted, "offset", 1);
	for (u32 k = 0; k < 4; k++) ts_run_count(run, octree->name_bytes, (i64)run->frame.buffer[made[k]].bytes);
	return TS_RUN(run, &octree->sorted, &args, ts_frame_n(&run->frame, octree->offset) - 1);
}

ts_status ts_octree_rise(ts_run *run, const ts_launch *leaves, const ts_launch *nodes, const void *args, u32 *first)
{
	u32 levels = TS_PARAM(&run->params, octree_levels);
	for (u32 level = levels + 1; level-- > 0;) {
		*first = ts_octree_first(run, &ts_scene_octree, level);
		u64 n = ts_octree_first(run, &ts_scene_octree, level + 1) - *first;
		if (ts_launch_items(run, level == levels ? leaves : nodes, args, n) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Triangles in the voxels of leaves: counted, then listed. */
static const ts_launch counted = TS_LAUNCH(voxel, TS_BUT_LIT);
static const ts_launch listed = TS_LAUNCH(voxel, TS_WITH(triangles), TS_BUT_LIT);
static const ts_launch of_leaves = TS_LAUNCH(leaf_surface, TS_ALL);
static const ts_launch of_nodes = TS_LAUNCH(inner_surface, TS_ALL);

static ts_status octree(ts_run *run)
{
	u64 total;
	ts_voxel_args args = ts_voxel_values(run);
	u32 n = args.scene.n_triangles;
	if (ts_octree_nodes(run, &ts_scene_octree) != TS_OK) return TS_ERROR;
	args.first_leaf = ts_octree_first(run, &ts_scene_octree, args.levels);
	if (ts_launch_make(run, &counted, "offset", 1) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &counted, &args, n) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &counted, "offset", &total) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &listed, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 2);
	return ts_octree_sort(run, &ts_scene_octree);
}

static ts_status octree_surface(ts_run *run)
{
	ts_octree_surface_args args = {.scene = ts_run_scene(run), .levels = TS_PARAM(&run->params, octree_levels)};
	if (TS_FILL(run, &of_leaves, &args) != TS_OK) return TS_ERROR;
	return ts_octree_rise(run, &of_leaves, &of_nodes, &args, &args.first);
}

const ts_stage ts_stage_octree = {
	.name = "octree",
	.kind = "emit",
	.paper = "MegaViews 3.1",
	.doc = "the scene's octree, and the triangles of its leaves",
	.run = octree,
	.launches =
		TS_LAUNCHES(&ts_scene_octree.levels, &ts_scene_octree.nodes, &counted, &listed, &ts_scene_octree.sorted),
};

const ts_stage ts_stage_octree_surface = {
	.name = "octree.surface",
	.kind = "map",
	.paper = "MegaViews 3.1",
	.doc = "mean surface of every node: material and normal",
	.run = octree_surface,
	.launches = TS_LAUNCHES(&of_leaves, &of_nodes),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_octree_level),
};

/* The cube that both octrees divide. */

static const ts_launch extent = TS_LAUNCH(octree_root_least, TS_BUT(root));
static const ts_launch cube = TS_LAUNCH(octree_root, TS_IN(least, octree_root_least), TS_BUT(vertices));

static ts_status octree_root(ts_run *run)
{
	ts_octree_root_args args;
	if (TS_RUN(run, &extent, &args, ts_run_size(run, TS_DIM_vertices)) != TS_OK) return TS_ERROR;
	return TS_RUN(run, &cube, &args, 1);
}

const ts_stage ts_stage_octree_root = {
	.name = "octree.root",
	.kind = "map",
	.paper = "MegaViews 3.1",
	.doc = "the cube around all vertices, the root of both octrees",
	.run = octree_root,
	.launches = TS_LAUNCHES(&extent, &cube),
};

/* The reflectors that nodes of the scene's octree belong to. */

static const ts_launch leaf_reflectors = TS_LAUNCH(leaf_reflector, TS_BUT_SURFACES, TS_BUT(scene.materials));
static const ts_launch node_reflectors = TS_LAUNCH(inner_reflector, TS_BUT(scene), TS_BUT(offset), TS_BUT(triangles));

static ts_status octree_reflector(ts_run *run)
{
	ts_octree_reflector_args args = {.scene = ts_run_scene(run)};
	if (TS_FILL(run, &leaf_reflectors, &args) != TS_OK) return TS_ERROR;
	return ts_octree_rise(run, &leaf_reflectors, &node_reflectors, &args, &args.first);
}

const ts_stage ts_stage_octree_reflector = {
	.name = "octree.reflector",
	.kind = "map",
	.paper = "EPR 4.1.3",
	.doc = "the reflector to which each node belongs",
	.run = octree_reflector,
	.launches = TS_LAUNCHES(&leaf_reflectors, &node_reflectors),
	.looks_at = TS_BUFFERS(TS_B_octree_level),
};
