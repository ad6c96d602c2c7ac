/* Rendered pairs in maps, and whole maps for every node of views, also in colour. */
#include <inttypes.h>
#include "kernels/views/view_map_colour.h"
#include "kernels/views/view_map_fuse.h"
#include "kernels/views/view_octree_alone.h"
#include "methods/views/octree.h"
#include "methods/views/traverse.h"

ts_status ts_view_map_check(const ts_run *run)
{
	u32 n = run->plan.views.px;
	if ((n & (n - 1)) != 0) return ts_fail("maps of %" PRIu32 " texels: a power of two would be right", n);
	bool holed = TS_PARAM(&run->params, view_map_multipixel) == TS_MULTIPIXEL_OFF;
	if (!holed || TS_PARAM(&run->params, view_map_texel) == TS_TEXEL_POINT) return TS_OK;
	return ts_fail("view_map.multipixel=off: with view_map.texel=middle a node fills what its ball covers; "
	               "view_map.texel=point would be right");
}

/* In maps of 16 x 16 hardly any leaf is wider than a texel (MegaViews section 4). */
enum { WITHOUT_FILLING = 16 };

ts_pyramid ts_view_pyramid(const ts_params *params, const ts_plan *plan)
{
	u32 how = TS_PARAM(params, view_map_multipixel);
	ts_pyramid r = {.n = plan->views.px, .levels = 1, .point = TS_PARAM(params, view_map_texel) == TS_TEXEL_POINT};
	u32 small = r.point ? TS_MULTIPIXEL_OFF : TS_MULTIPIXEL_TEXELS;
	if (how == TS_MULTIPIXEL_AUTO) how = r.n > WITHOUT_FILLING ? TS_MULTIPIXEL_MIPS : small;
	if (how != TS_MULTIPIXEL_OFF) r.fill = TS_PARAM(params, view_map_fill);
	while (how == TS_MULTIPIXEL_MIPS && r.n >> r.levels > 0) r.levels++;
	return r;
}

/* Pairs that were kept, or all pairs during the traversal; for brute force every leaf of the scene with every view. */
static const ts_launch of_kept = TS_LAUNCH(view_map, TS_ALL);
static const ts_launch of_piece = TS_LAUNCH(view_map, TS_WORK(pairs, queue));
static const ts_launch of_kept_but_own = TS_LAUNCH(view_map, TS_WITH(own));
static const ts_launch of_piece_but_own = TS_LAUNCH(view_map, TS_WORK(pairs, queue), TS_WITH(own));
static const ts_launch of_all = TS_LAUNCH(view_map_all, TS_BUT(to.pairs));
static const ts_launch fused = TS_LAUNCH(view_map_fuse, TS_ALL);

/* Views from the middles of cubes leave their own reflectors out. */
static const ts_launch *launch_of(const ts_run *run, bool kept)
{
	if (!run->plan.views.cubes) return kept ? &of_kept : &of_piece;
	return kept ? &of_kept_but_own : &of_piece_but_own;
}

static ts_status map_piece(ts_run *run, ts_traverse_piece *piece, void *user)
{
	ts_view_map_args *args = user;
	u64 n_rendered;
	if (ts_traverse_tally(run, piece, &n_rendered) != TS_OK) return TS_ERROR;
	args->pairs = piece->args.queue;
	return n_rendered > 0 ? ts_launch_items(run, launch_of(run, false), args, piece->n) : TS_OK;
}

/* The traversal and its maps without queues, where the backend can. */
static bool map_at_once(ts_run *run, ts_traverse_args how, const ts_view_map_args *args)
{
	i64 tallies[TS_TALLIES_AT_ONCE] = {0};
	how.tallies = tallies;
	u64 n_starts = ts_traverse_starts(run, &how);
	if (!ts_launch_at_once(run, launch_of(run, false), &how, args, n_starts)) return false;
	ts_traverse_count(run, tallies);
	return true;
}

static void count_bytes(ts_run *run, ts_buffer_id id)
{
	u64 n = ts_frame_n(&run->frame, id);
	ts_run_count(run, "map bytes", (i64)(n * ts_buffer_table[id].element_bytes));
}

static ts_status view_map(ts_run *run)
{
	bool kept = ts_run_made(run, TS_B_traverse_rendered);
	const ts_launch *launch = launch_of(run, kept);
	ts_view_map_args args = {.pyramid = ts_view_pyramid(&run->params, &run->plan)};
	ts_traverse_args how;
	if (ts_traverse_arguments(run, &how) != TS_OK || TS_FILL(run, launch, &args) != TS_OK) return TS_ERROR;
	ts_traverse_from(run, &how);
	count_bytes(run, TS_B_view_map_depth_node);
	if (!kept && map_at_once(run, how, &args)) return ts_go_on();
	if (!kept) return ts_traverse(run, &how, map_piece, &args);
	return ts_launch_items(run, launch, &args, ts_run_size(run, TS_DIM_rendered_pairs));
}

static ts_status view_map_all(ts_run *run)
{
	ts_view_map_all_args args = {
		.to.pyramid = ts_view_pyramid(&run->params, &run->plan),
		.first = ts_octree_first(run, &ts_scene_octree, TS_PARAM(&run->params, octree_levels)),
		.n_leaves = (u32)ts_run_size(run, TS_DIM_leaves),
	};
	u64 n = args.n_leaves * ts_run_size(run, TS_DIM_view_nodes);
	if (ts_traverse_arguments(run, &args.of) != TS_OK || TS_RUN(run, &of_all, &args, n) != TS_OK) return TS_ERROR;
	count_bytes(run, TS_B_view_map_depth_node);
	ts_run_count(run, "pairs", (i64)n);
	ts_run_count(run, "pairs rendered", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

ts_view_map_fuse_args ts_view_map_fuse_values(const ts_run *run)
{
	return (ts_view_map_fuse_args){.pyramid = ts_view_pyramid(&run->params, &run->plan),
	                               .nearest = TS_PARAM(&run->params, view_map_fusion) == TS_FUSION_MIN};
}

static ts_status view_map_fuse(ts_run *run)
{
	u64 n_texels = (u64)2 * run->plan.views.px * run->plan.views.px;
	u64 n_levels = ts_frame_n(&run->frame, TS_B_view_octree_level) - 1;
	const u32 *before = ts_frame_data(&run->frame, TS_B_view_octree_level);
	ts_view_map_fuse_args args = ts_view_map_fuse_values(run);
	if (ts_view_map_check(run) != TS_OK || TS_FILL(run, &fused, &args) != TS_OK) return TS_ERROR;
	count_bytes(run, TS_B_view_map_fused_depth);
	count_bytes(run, TS_B_view_map_fused_node);
	for (u64 level = 0; level < n_levels; level++) {
		u64 n_nodes = before[level + 1] - before[level];
		args.first = before[level];
		if (ts_launch_items(run, &fused, &args, n_nodes * n_texels) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

const ts_stage ts_stage_view_map = {
	.name = "view_map",
	.kind = "scatter",
	.paper = "MegaViews 3.2",
	.doc = "rendered pairs into dual-paraboloid maps of the nodes of views, by 64-bit minimum",
	.run = view_map,
	.launches = TS_LAUNCHES(TS_TRAVERSE_LAUNCHES, &of_kept, &of_piece, &of_kept_but_own, &of_piece_but_own),
	.looks_at = TS_BUFFERS(TS_B_octree_level, TS_B_view_octree_level),
};

const ts_stage ts_stage_view_map_all = {
	.name = "view_map.all",
	.kind = "scatter",
	.paper = "MegaViews 4.1",
	.doc = "every leaf of the scene in the map of every view",
	.run = view_map_all,
	.launches = TS_LAUNCHES(&of_all),
	.looks_at = TS_BUFFERS(TS_B_octree_level),
};

const ts_stage ts_stage_view_map_fuse = {
	.name = "view_map.fuse",
	.kind = "map",
	.paper = "MegaViews 3.2",
	.doc = "fused maps: what the maps of the nodes above show, seen from each node",
	.run = view_map_fuse,
	.launches = TS_LAUNCHES(&fused),
	.looks_at = TS_BUFFERS(TS_B_view_octree_level),
};

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
