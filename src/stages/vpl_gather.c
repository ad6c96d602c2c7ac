/* Light from virtual point lights: which nodes of views may light which nodes of the scene, and what pixels gather. */
#include "octree.h"
#include "traverse.h"

#define TEXEL_DIAGONAL 1.41421354f /* of its width: places in one texel are no farther apart */

u32 ts_gather_level_of(const ts_params *params, u32 field, bool alone)
{
	bool culls = field == TS_VIEW_FIELD_HALF || params->cutoff > 0;
	u32 level = params->gather_level < params->levels ? params->gather_level : params->levels;
	return alone || !culls ? 0 : level;
}

u32 ts_gather_level(const ts_run *run)
{
	bool alone = ts_octree_first(run, &ts_view_octree, 1) == ts_frame_n(&run->frame, TS_B_view_octree_node);
	return ts_gather_level_of(&run->params, run->plan.views.field, alone);
}

ts_status ts_vpl_pairs_arguments(const ts_run *run, ts_traverse_args *args)
{
	if (ts_traverse_arguments(run, args) != TS_OK) return TS_ERROR;
	args->last = ts_gather_level(run);
	args->to_last = args->touching = 1;
	args->cutoff = run->params.cutoff;
	return TS_OK;
}

static ts_status traverse(ts_run *run, ts_traverse_sink *sink, ts_vpl_pairs_args *args)
{
	ts_traverse_args how;
	return ts_vpl_pairs_arguments(run, &how) == TS_OK ? ts_traverse(run, &how, sink, args) : TS_ERROR;
}

static ts_status count_piece(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_vpl_pairs_args *args = user;
	args->pairs = piece->args.queue;
	return ts_run_launch(run, TS_KERNEL_vpl_pairs_count, args, piece->n);
}

static ts_status list_piece(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_vpl_pairs_args *args = user;
	args->pairs = piece->args.queue;
	return ts_run_launch(run, TS_KERNEL_vpl_pairs_list, args, piece->n);
}

static u64 nodes_of(const ts_run *run, const ts_octree *octree, u32 level)
{
	return ts_octree_first(run, octree, level + 1) - ts_octree_first(run, octree, level);
}

/* Where lists begin stands one later while they are written, as in octrees. */
static ts_status make_lists(ts_run *run, ts_vpl_pairs_args *args, u64 *n)
{
	if (ts_run_fill(run, TS_B_vpl_pairs_offset, 0) != TS_OK) return TS_ERROR;
	if (traverse(run, count_piece, args) != TS_OK) return TS_ERROR;
	if (ts_run_scan(run, TS_B_vpl_pairs_offset, n) != TS_OK) return TS_ERROR;
	args->nodes = ts_frame_make1(&run->frame, TS_B_vpl_pairs_node, *n);
	args->views = ts_frame_make1(&run->frame, TS_B_vpl_pairs_views, *n);
	if (args->nodes == NULL || args->views == NULL) return TS_ERROR;
	return traverse(run, list_piece, args);
}

ts_status ts_stage_vpl_pairs(ts_run *run)
{
	u32 level = ts_gather_level(run);
	u64 n_lists = nodes_of(run, &ts_scene_octree, level), n_views = nodes_of(run, &ts_view_octree, level), n;
	ts_vpl_pairs_args args = {
		.cones = ts_frame_handle(&run->frame, TS_B_view_cone_node),
		.offset = ts_frame_make1(&run->frame, TS_B_vpl_pairs_offset, n_lists + 2),
		.first = ts_octree_first(run, &ts_scene_octree, level),
	};
	if (args.offset == NULL || make_lists(run, &args, &n) != TS_OK) return TS_ERROR;
	ts_frame_cut(&run->frame, TS_B_vpl_pairs_offset, n_lists + 1);
	ts_sort_args sort = {.offset = args.offset, .entries = args.nodes};
	if (ts_run_launch(run, TS_KERNEL_leaf_sort, &sort, n_lists) != TS_OK) return TS_ERROR;
	ts_run_count(run, "gather pairs", (i64)n);
	ts_run_count(run, "gather pairs culled", (i64)(n_lists * n_views - n));
	return ts_run_launch(run, TS_KERNEL_vpl_pairs_sum, &args, n_lists);
}

ts_vpl_gather_args ts_vpl_gather_arguments(const ts_run *run)
{
	const ts_params *params = &run->params;
	u32 level = ts_gather_level(run);
	bool by_plane = params->shadow_test == TS_SHADOW_TEST_PLANE;
	return (ts_vpl_gather_args){
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.root = ts_frame_handle(&run->frame, TS_B_root_cube),
		.mask = ts_frame_handle(&run->frame, TS_B_voxel_mask),
		.before = ts_frame_handle(&run->frame, TS_B_voxel_before),
		.offset = ts_frame_handle(&run->frame, TS_B_vpl_pairs_offset),
		.list = ts_frame_handle(&run->frame, TS_B_vpl_pairs_node),
		.sums = ts_frame_handle(&run->frame, TS_B_vpl_pairs_views),
		.cones = ts_frame_handle(&run->frame, TS_B_view_cone_node),
		.views = ts_frame_handle(&run->frame, TS_B_view_octree_view),
		.leaves = ts_frame_handle(&run->frame, TS_B_view_octree_leaf),
		.nodes = ts_frame_handle(&run->frame, TS_B_view_octree_node),
		.lights = ts_frame_handle(&run->frame, TS_B_vpl_light),
		.depths = ts_frame_handle(&run->frame, TS_B_fuse_depth),
		.shown = ts_frame_handle(&run->frame, TS_B_fuse_node),
		.scene = ts_frame_handle(&run->frame, TS_B_octree_node),
		.levels = params->levels,
		.level = level,
		.first = ts_octree_first(run, &ts_scene_octree, level),
		.n_lights = (u32)ts_frame_n(&run->frame, TS_B_vpl_light),
		.draws = params->gather_lights,
		.seed = params->seed,
		.n = params->view_px,
		.shadows = params->shadows,
		.near = params->light_near,
		.bias = params->light_bias,
		.bias_px = by_plane ? params->bias * TEXEL_DIAGONAL : params->bias,
		.bias_slope = by_plane ? 0 : params->bias_slope,
		.by_plane = by_plane,
		.bias_plane = params->bias_plane,
	};
}

ts_status ts_stage_vpl_gather(ts_run *run)
{
	u64 width = run->params.width, height = run->params.height;
	ts_vpl_gather_args args = ts_vpl_gather_arguments(run);
	args.irradiance = ts_frame_make3(&run->frame, TS_B_vpl_gather_irradiance, height, width, 3);
	args.n_astray = ts_frame_tallies(&run->frame);
	if (args.irradiance == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_vpl_gather, &args, width * height) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pixels in no node", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

ts_status ts_stage_vpl_gather_margin(ts_run *run)
{
	u64 width = run->params.width, height = run->params.height;
	ts_vpl_gather_margin_args args = {
		.of = ts_vpl_gather_arguments(run),
		.margin = ts_frame_make2(&run->frame, TS_B_vpl_gather_margin, height, width),
	};
	if (args.margin == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_vpl_gather_margin, &args, width * height);
}
