/* The octree of the views, and the cones of their directions; views without a hierarchy. */
#include "kernels/views/view_octree.h"
#include "kernels/views/view_octree_alone.h"
#include "kernels/views/view_octree_cone.h"
#include "methods/stages.h"
#include "methods/views/octree.h"

const ts_octree ts_view_octree = TS_OCTREE(view_octree_voxel_mask, view_octree_voxel_before, view_octree_level,
                                           view_octree_node, view_octree_offset, view_octree_view, view_nodes, "view");

/* Views in voxels: marked, then counted by leaf, then listed. */
static const ts_launch marked =
	TS_LAUNCH(view_octree_voxel, TS_BUT(bits), TS_BUT(before), TS_BUT(leaf), TS_BUT(offset), TS_BUT(entries));
static const ts_launch counted = TS_LAUNCH(view_octree_leaf, TS_BUT(mask), TS_BUT(entries));
static const ts_launch listed = TS_LAUNCH(view_octree_list, TS_BUT(mask));
/* Sums of directions, then the least cosine with them. */
static const ts_launch of_leaves = TS_LAUNCH(cone_leaf, TS_ALL);
static const ts_launch of_nodes = TS_LAUNCH(cone_inner, TS_ALL);
static const ts_launch narrowed = TS_LAUNCH(cone_least, TS_ALL);
static const ts_launch finished = TS_LAUNCH(cone, TS_ALL);

static ts_status view_octree_voxel(ts_run *run)
{
	ts_view_octree_args args = {.levels = TS_PARAM(&run->params, octree_levels)};
	if (TS_RUN(run, &marked, &args, ts_run_size(run, TS_DIM_vpls)) != TS_OK) return TS_ERROR;
	return ts_octree_ids(run, &ts_view_octree);
}

static ts_status view_octree(ts_run *run)
{
	u64 total, n = ts_run_size(run, TS_DIM_vpls);
	ts_view_octree_args args = {.levels = TS_PARAM(&run->params, octree_levels)};
	if (ts_octree_nodes(run, &ts_view_octree) != TS_OK) return TS_ERROR;
	args.first_leaf = ts_octree_first(run, &ts_view_octree, args.levels);
	if (ts_launch_make(run, &counted, "offset", 1) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &counted, &args, n) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &counted, "offset", &total) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &listed, &args, n) != TS_OK) return TS_ERROR;
	return ts_octree_sort(run, &ts_view_octree);
}

static ts_status view_octree_cone(ts_run *run)
{
	ts_cone_args args;
	if (TS_FILL(run, &of_leaves, &args) != TS_OK) return TS_ERROR;
	for (u32 level = TS_PARAM(&run->params, octree_levels) + 1; level-- > 0;) {
		const ts_launch *launch = level == TS_PARAM(&run->params, octree_levels) ? &of_leaves : &of_nodes;
		args.first = ts_octree_first(run, &ts_view_octree, level);
		u64 n_nodes = ts_octree_first(run, &ts_view_octree, level + 1) - args.first;
		if (ts_launch_items(run, launch, &args, n_nodes) != TS_OK) return TS_ERROR;
	}
	if (ts_launch_items(run, &narrowed, &args, ts_run_size(run, TS_DIM_vpls)) != TS_OK) return TS_ERROR;
	return ts_launch_items(run, &finished, &args, ts_run_size(run, TS_DIM_view_nodes));
}

const ts_stage ts_stage_view_octree_voxel = {
	.name = "view_octree.voxel",
	.kind = "scatter",
	.paper = "MegaViews 3.1",
	.doc = "voxels that contain views, at all levels",
	.run = view_octree_voxel,
	.launches = TS_LAUNCHES(&marked, &ts_view_octree.raised, &ts_view_octree.counted),
};

const ts_stage ts_stage_view_octree = {
	.name = "view_octree",
	.kind = "emit",
	.paper = "MegaViews 3.1",
	.doc = "the octree of the views, and the views of its leaves",
	.run = view_octree,
	.launches = TS_LAUNCHES(&ts_view_octree.levels, &ts_view_octree.nodes, &counted, &listed, &ts_view_octree.sorted),
};

const ts_stage ts_stage_view_octree_cone = {
	.name = "view_octree.cone",
	.kind = "map",
	.paper = "MegaViews 3.1",
	.doc = "the cone of the directions of the views in every node",
	.run = view_octree_cone,
	.launches = TS_LAUNCHES(&of_leaves, &of_nodes, &narrowed, &finished),
	.looks_at = TS_BUFFERS(TS_B_view_octree_level),
};

static const ts_launch alone = TS_LAUNCH(view_octree_alone, TS_ALL);

static ts_status view_octree_alone(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_vpls);
	u32 *before = ts_run_make(run, TS_B_view_octree_level);
	ts_view_octree_alone_args args;
	ts_run_set_size(run, TS_DIM_view_nodes, n);
	if (before == NULL) return TS_ERROR;
	for (u32 level = 0; level < TS_PARAM(&run->params, octree_levels) + 2; level++)
		before[level] = level > 0 ? (u32)n : 0;
	return TS_RUN(run, &alone, &args, n);
}

const ts_stage ts_stage_view_octree_alone = {
	.name = "view_octree.alone",
	.kind = "map",
	.paper = "MegaViews 4.1",
	.doc = "ManyLoDs: every view by itself, as a root that is a leaf",
	.run = view_octree_alone,
	.launches = TS_LAUNCHES(&alone),
	.makes = TS_BUFFERS(TS_B_view_octree_level),
};
