/* Light from virtual point lights: which nodes of views may light which nodes of the scene, and gathering by pixels. */
#include "kernels/views/vpl_gather_margin.h"
#include "kernels/views/vpl_gather_pairs.h"
#include "methods/raster/raster.h"
#include "methods/views/octree.h"
#include "methods/views/traverse.h"

#define TEXEL_DIAGONAL 1.41421354f /* of its width: places in one texel are no farther apart */

/* Views of the level of gathering, by node of the scene: counted, listed, sorted, and summed up. */
static const ts_launch counted = TS_LAUNCH(vpl_gather_pairs_count, TS_BUT(nodes), TS_BUT(views));
static const ts_launch listed = TS_LAUNCH(vpl_gather_pairs_list, TS_ALL);
static const ts_launch sorted =
	TS_LAUNCH(leaf_sort, TS_IN(offset, vpl_gather_pair_offset), TS_OUT(entries, vpl_gather_pair_node));
static const ts_launch summed = TS_LAUNCH(vpl_gather_pairs_sum, TS_BUT(pairs));

/* By whole maps, or by maps of the nodes from the root down. */
static const ts_launch gathered[] = {
	[TS_QUERY_FUSED] = TS_LAUNCH(vpl_gather, TS_BUT(unfused)),
	[TS_QUERY_DESCEND] =
		TS_LAUNCH(vpl_gather, TS_BUT(depths), TS_BUT(shown), TS_BUT(unfused.depths), TS_BUT(unfused.nodes)),
};
static const ts_launch measured[] = {
	[TS_QUERY_FUSED] = TS_LAUNCH(vpl_gather_margin, TS_BUT(of.irradiance), TS_BUT(of.n_astray), TS_BUT(of.unfused)),
	[TS_QUERY_DESCEND] = TS_LAUNCH(vpl_gather_margin, TS_BUT(of.irradiance), TS_BUT(of.n_astray), TS_BUT(of.depths),
                                   TS_BUT(of.shown), TS_BUT(of.unfused.depths), TS_BUT(of.unfused.nodes)),
};

bool ts_gather_asks_fused(const ts_params *params) { return TS_PARAM(params, vpl_gather_query) == TS_QUERY_FUSED; }

u32 ts_gather_level_of(const ts_params *params, u32 field, bool alone)
{
	bool culls = field == TS_VIEW_FIELD_HALF || TS_PARAM(params, vpl_gather_cutoff) > 0;
	u32 level = TS_PARAM(params, vpl_gather_level) < TS_PARAM(params, octree_levels)
	                ? TS_PARAM(params, vpl_gather_level)
	                : TS_PARAM(params, octree_levels);
	return alone || !culls ? 0 : level;
}

/* Views have no hierarchy. */
static bool are_alone(const ts_run *run)
{
	return ts_octree_first(run, &ts_view_octree, 1) == ts_frame_n(&run->frame, TS_B_view_octree_node);
}

u32 ts_gather_level(const ts_run *run)
{
	return ts_gather_level_of(&run->params, run->plan.views.field, are_alone(run));
}

ts_status ts_vpl_pairs_arguments(ts_run *run, ts_traverse_args *args)
{
	if (ts_traverse_arguments(run, args) != TS_OK) return TS_ERROR;
	args->phi = ts_view_aperture(run->plan.views.field);
	args->last = ts_gather_level(run);
	args->to_last = 1;
	args->apart = 0;
	args->cutoff = TS_PARAM(&run->params, vpl_gather_cutoff);
	return TS_OK;
}

static ts_status count_piece(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_vpl_gather_pairs_args *args = user;
	args->pairs = piece->args.queue;
	return ts_launch_items(run, &counted, args, piece->n);
}

static ts_status list_piece(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_vpl_gather_pairs_args *args = user;
	args->pairs = piece->args.queue;
	return ts_launch_items(run, &listed, args, piece->n);
}

/* Visits all pairs that culling leaves, by the traversal if need be. */
static ts_status over_pairs(ts_run *run, const ts_launch *launch, ts_traverse_sink *sink,
                            ts_vpl_gather_pairs_args *args)
{
	ts_traverse_args how;
	if (ts_vpl_pairs_arguments(run, &how) != TS_OK) return TS_ERROR;
	if (ts_launch_at_once(run, launch, &how, args, ts_traverse_starts(run, &how))) return ts_go_on();
	return ts_traverse(run, &how, sink, args);
}

static u64 nodes_of(const ts_run *run, const ts_octree *octree, u32 level)
{
	return ts_octree_first(run, octree, level + 1) - ts_octree_first(run, octree, level);
}

/* Until it is written, the start of a list stands in the entry after its own, as in octrees. */
static ts_status make_lists(ts_run *run, ts_vpl_gather_pairs_args *args, u64 *n)
{
	if (ts_launch_make(run, &counted, "offset", 1) != TS_OK || TS_FILL(run, &counted, args) != TS_OK) return TS_ERROR;
	if (over_pairs(run, &counted, count_piece, args) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &counted, "offset", n) != TS_OK) return TS_ERROR;
	if (TS_FILL(run, &listed, args) != TS_OK) return TS_ERROR;
	if (over_pairs(run, &listed, list_piece, args) != TS_OK) return TS_ERROR;
	ts_launch_cut(run, &counted, "offset", 1);
	return TS_OK;
}

static ts_status vpl_gather_pairs(ts_run *run)
{
	u32 level = ts_gather_level(run);
	u64 n_lists = nodes_of(run, &ts_scene_octree, level), n_views = nodes_of(run, &ts_view_octree, level), n;
	ts_vpl_gather_pairs_args args = {.first = ts_octree_first(run, &ts_scene_octree, level)};
	ts_sort_args sort;
	if (make_lists(run, &args, &n) != TS_OK || TS_RUN(run, &sorted, &sort, n_lists) != TS_OK) return TS_ERROR;
	ts_run_count(run, "gather pairs", (i64)n);
	ts_run_count(run, "gather pairs culled", (i64)(n_lists * n_views - n));
	return ts_launch_items(run, &summed, &args, n_lists);
}

static ts_vpl_gather_args values(const ts_run *run)
{
	const ts_params *params = &run->params;
	u32 level = ts_gather_level(run);
	bool by_plane = TS_PARAM(params, vpl_gather_test) == TS_SHADOW_TEST_PLANE;
	return (ts_vpl_gather_args){
		.levels = TS_PARAM(params, octree_levels),
		.level = level,
		.first = ts_octree_first(run, &ts_scene_octree, level),
		.n_lights = (u32)ts_run_size(run, TS_DIM_vpls),
		.draws = TS_PARAM(params, vpl_gather_lights),
		.seed = TS_PARAM(params, seed),
		.n = run->plan.views.px,
		.unfused = ts_view_map_fuse_values(run),
		.shadows = TS_PARAM(params, vpl_gather_shadows),
		.near = TS_PARAM(params, vpl_gather_near),
		.bias = TS_PARAM(params, vpl_gather_bias),
		.bias_px = by_plane ? TS_PARAM(params, depth_map_bias) * TEXEL_DIAGONAL : TS_PARAM(params, depth_map_bias),
		.bias_slope = by_plane ? 0 : TS_PARAM(params, depth_map_bias_slope),
		.by_plane = by_plane,
		.bias_plane = TS_PARAM(params, vpl_gather_bias_plane),
	};
}

ts_status ts_vpl_gather_ask(const ts_run *run, ts_vpl_gather_args *args)
{
	*args = values(run);
	return TS_ASK(run, &gathered[TS_PARAM(&run->params, vpl_gather_query)], args);
}

/* Texels read per look-up: one of a whole map, or all levels of the maps from the root down. */
static u32 texels_asked(const ts_run *run, u32 query, const ts_pyramid *pyramid)
{
	u32 n_nodes = are_alone(run) ? 1 : TS_PARAM(&run->params, octree_levels) + 1;
	return query == TS_QUERY_FUSED ? 1 : n_nodes * pyramid->levels;
}

static ts_status vpl_gather(ts_run *run)
{
	ts_vpl_gather_args args = values(run);
	u32 query = TS_PARAM(&run->params, vpl_gather_query);
	if (TS_RUN(run, &gathered[query], &args, ts_eye_size(run)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pixels in no node", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "texels a question", texels_asked(run, query, &args.unfused.pyramid));
	return TS_OK;
}

static ts_status vpl_gather_margin(ts_run *run)
{
	ts_vpl_gather_margin_args args = {.of = values(run)};
	const ts_launch *launch = &measured[TS_PARAM(&run->params, vpl_gather_query)];
	return TS_RUN(run, launch, &args, ts_eye_size(run));
}

const ts_stage ts_stage_vpl_gather_pairs = {
	.name = "vpl_gather.pairs",
	.kind = "emit",
	.paper = "MegaViews 5.1",
	.doc = "for every node of the scene at one level the nodes of views that may light it",
	.run = vpl_gather_pairs,
	.launches = TS_LAUNCHES(TS_TRAVERSE_LAUNCHES, &counted, &listed, &sorted, &summed),
	.looks_at = TS_BUFFERS(TS_B_octree_level, TS_B_view_octree_level),
};

const ts_stage ts_stage_vpl_gather = {
	.name = "vpl_gather",
	.kind = "map",
	.paper = "MegaViews 5.1",
	.doc = "light of some virtual point lights at every pixel, if their maps show nothing in between",
	.run = vpl_gather,
	.launches = TS_LAUNCHES(&gathered[TS_QUERY_FUSED], &gathered[TS_QUERY_DESCEND]),
	.looks_at = TS_BUFFERS(TS_B_octree_level, TS_B_view_octree_level),
};

const ts_stage ts_stage_vpl_gather_margin = {
	.name = "vpl_gather.margin",
	.kind = "map",
	.margin_of = "vpl_gather",
	.paper = "MegaViews 5.1",
	.doc = "margins of the lists of lights and of their shadows",
	.run = vpl_gather_margin,
	.launches = TS_LAUNCHES(&measured[TS_QUERY_FUSED], &measured[TS_QUERY_DESCEND]),
	.looks_at = TS_BUFFERS(TS_B_octree_level, TS_B_view_octree_level),
};
