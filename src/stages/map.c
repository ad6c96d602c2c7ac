/* Rendered pairs in maps, and whole maps for every node of views. */
#include "octree.h"
#include "traverse.h"
#include <inttypes.h>

ts_status ts_view_px_check(const ts_params *params)
{
	u32 n = params->view_px;
	return (n & (n - 1)) == 0 ? TS_OK : ts_fail("view_px=%" PRIu32 ": a power of two would be right", n);
}

ts_pyramid ts_view_pyramid(const ts_params *params)
{
	ts_pyramid r = {.n = params->view_px, .levels = 1};
	while (params->multipixel && r.n >> r.levels > 0) r.levels++;
	return r;
}

static ts_status map_piece(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_map_args *args = user;
	u64 n_rendered;
	if (ts_traverse_tally(run, piece, &n_rendered) != TS_OK) return TS_ERROR;
	args->pairs = piece->args.queue;
	return n_rendered > 0 ? ts_run_launch(run, TS_KERNEL_map, args, piece->n) : TS_OK;
}

/* Makes the maps, all empty. */
static ts_status begin(ts_run *run, ts_map_args *args)
{
	ts_pyramid pyramid = ts_view_pyramid(&run->params);
	u64 n = ts_frame_n(&run->frame, TS_B_view_octree_node);
	*args = (ts_map_args){
		.nodes = ts_frame_handle(&run->frame, TS_B_octree_node),
		.views = ts_frame_handle(&run->frame, TS_B_view_octree_node),
		.texels = ts_frame_make2(&run->frame, TS_B_map_depth_node, n, ts_k_pyramid_texels(&pyramid)),
		.pyramid = pyramid,
	};
	if (args->texels == NULL || ts_view_px_check(&run->params) != TS_OK) return TS_ERROR;
	ts_run_count(run, "map bytes", (i64)run->frame.buffer[TS_B_map_depth_node].bytes);
	return ts_run_fill(run, TS_B_map_depth_node, 0xff);
}

/* Those that were kept, or all as the traversal comes by them. */
ts_status ts_stage_map(ts_run *run)
{
	ts_map_args args;
	ts_traverse_args how;
	if (begin(run, &args) != TS_OK || ts_traverse_arguments(run, &how) != TS_OK) return TS_ERROR;
	if (!run->frame.buffer[TS_B_traverse_rendered].made) return ts_traverse(run, &how, map_piece, &args);
	args.pairs = ts_frame_handle(&run->frame, TS_B_traverse_rendered);
	return ts_run_launch(run, TS_KERNEL_map, &args, ts_frame_n(&run->frame, TS_B_traverse_rendered));
}

/* By brute force: every leaf of the scene for every view. */
ts_status ts_stage_map_all(ts_run *run)
{
	ts_map_all_args args = {.first = ts_octree_first(run, &ts_scene_octree, run->params.levels)};
	args.n_leaves = ts_octree_first(run, &ts_scene_octree, run->params.levels + 1) - args.first;
	u64 n = args.n_leaves * ts_frame_n(&run->frame, TS_B_view_octree_node);
	if (begin(run, &args.to) != TS_OK || ts_traverse_arguments(run, &args.of) != TS_OK) return TS_ERROR;
	args.n_rendered = ts_frame_tallies(&run->frame);
	if (ts_run_launch(run, TS_KERNEL_map_all, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pairs", (i64)n);
	ts_run_count(run, "pairs rendered", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

ts_status ts_stage_fuse(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_view_octree_node), n_levels = ts_frame_n(&run->frame, TS_B_view_octree_level) - 1;
	u64 n_texels = (u64)2 * run->params.view_px * run->params.view_px;
	const u32 *before = ts_frame_data(&run->frame, TS_B_view_octree_level);
	ts_fuse_args args = {
		.views = ts_frame_handle(&run->frame, TS_B_view_octree_node),
		.texels = ts_frame_handle(&run->frame, TS_B_map_depth_node),
		.depths = ts_frame_make2(&run->frame, TS_B_fuse_depth, n, n_texels),
		.nodes = ts_frame_make2(&run->frame, TS_B_fuse_node, n, n_texels),
		.pyramid = ts_view_pyramid(&run->params),
		.nearest = run->params.fusion == TS_FUSION_MIN,
	};
	if (args.depths == NULL || args.nodes == NULL || ts_view_px_check(&run->params) != TS_OK) return TS_ERROR;
	ts_run_count(run, "map bytes", (i64)run->frame.buffer[TS_B_fuse_depth].bytes);
	ts_run_count(run, "map bytes", (i64)run->frame.buffer[TS_B_fuse_node].bytes);
	for (u64 level = 0; level < n_levels; level++) {
		args.first = before[level];
		u64 n_nodes = before[level + 1] - before[level];
		if (ts_run_launch(run, TS_KERNEL_fuse, &args, n_nodes * n_texels) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}
