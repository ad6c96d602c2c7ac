/* MegaViews compared with ManyLoDs for growing numbers of views: the paper's figure 10, known only from its text. The
 * stages `view_map` and `view_map.fuse` render maps. */
#include <math.h>
#include "kernels/base/num.h"
#include "methods/views/tools/tools.h"

enum { M_MEGA, M_LODS, M_UNCULLED, M_DESCEND, M_DEEP, M_VIEWS, M_BRUTE };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[M_MEGA] = { "megaviews", "", true, TS_TIMED },
	[M_LODS] = { "manylods", "", true, TS_TIMED },
	[M_UNCULLED] = { "megaviews", "traverse.cull=off", true, TS_TIMED },
	[M_DESCEND] = { "megaviews", "vpl_gather.query=descend", true, TS_TIMED },
	[M_DEEP] = { "megaviews", "octree.levels=9", false, TS_ONCE },
	[M_VIEWS] = { "megaviews", "traverse.hierarchies=views", false, TS_LONG },
	[M_BRUTE] = { "bruteforce", "", false, TS_ONCE },
	{ 0 },
};

enum { VIEWS, MS, LODS_MS, UNCULLED_MS, BRUTE_MS, SPEEDUP, CULLING, TREE_MS, GATHER_MS, LODS_GATHER_MS, MS_GROWTH,
	LODS_MS_GROWTH, PAIRS, LODS_PAIRS, BRUTE_PAIRS, SAVED, A_VIEW, LODS_A_VIEW, PAIRS_GROWTH, LODS_PAIRS_GROWTH, SERVED,
	RENDERED, SHARING, CULLED, CULLED_SHARE, UNCULLED_PAIRS, PAIRS_SAVED, WIDER, WIDER_SHARE, SEVERAL,
	SEVERAL_SHARE, DEEP_RENDERED, DEEP_SEVERAL, DEEP_SHARE, EMPTY, SCENE_LEAVES, LEAVES, SCENE_MIB, TREE_MIB, MAPS_MIB,
	MIB, QUEUE_MIB, LODS_SCENE_MIB, LODS_VIEWS_MIB, LODS_MAPS_MIB, LODS_MIB, LODS_QUEUE_MIB, LESS, FUSE_MS, ASK_MS,
	DESCEND_MS, SLOWER,
	FUSED_MS, WORTH, TEXELS, DESCENT_TEXELS, OTHER, VIEWS_MS, VIEWS_PAIRS, VIEWS_TIME, VIEWS_MORE, VIEWS_RENDERED,
	VIEWS_RENDERED_MORE, VIEWS_BY_BRUTE, UNCULLED_RMSE };

static const ts_bench_figure figures[] = {
	[VIEWS] = { "views", "views", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "virtual point lights" },
	[MS] = { "megaviews_ms", "MegaViews", TS_FIGURE_STAGE_TIME, M_MEGA, 0, 2, "view_map,view_map.fuse" },
	[LODS_MS] = { "manylods_ms", "ManyLoDs", TS_FIGURE_STAGE_TIME, M_LODS, 0, 2, "view_map,view_map.fuse" },
	[UNCULLED_MS] = { "unculled_ms", "no culling", TS_FIGURE_STAGE_TIME, M_UNCULLED, 0, 2, "view_map,view_map.fuse" },
	[BRUTE_MS] = { "bruteforce_ms", "brute force", TS_FIGURE_STAGE_TIME, M_BRUTE, 0, 2, "view_map.all,view_map.fuse" },
	[SPEEDUP] = { "speedup", "ManyLoDs / MegaViews", TS_FIGURE_RATIO, LODS_MS, MS, 2, "" },
	[CULLING] = { "culling_percent", "culling saves, %", TS_FIGURE_SAVED, MS, UNCULLED_MS, 1, "" },
	[TREE_MS] = { "hierarchy_ms", "hierarchy of views", TS_FIGURE_STAGE_TIME, M_MEGA, 0, 2,
	              "view_octree.voxel,view_octree,view_octree.cone" },
	[GATHER_MS] = { "gather_ms", "gathering", TS_FIGURE_STAGE_TIME, M_MEGA, 0, 2, "vpl_gather.pairs,vpl_gather" },
	[LODS_GATHER_MS] = { "manylods_gather_ms", "ManyLoDs'", TS_FIGURE_STAGE_TIME, M_LODS, 0, 2,
	  "vpl_gather.pairs,vpl_gather" },
	[MS_GROWTH] = { "ms_exponent", "exponent", TS_FIGURE_GROWTH, MS, VIEWS, 3, "" },
	[LODS_MS_GROWTH] = { "manylods_ms_exponent", "ManyLoDs'", TS_FIGURE_GROWTH, LODS_MS, VIEWS, 3, "" },
	[PAIRS] = { "pairs", "pairs", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "pairs" },
	[LODS_PAIRS] = { "manylods_pairs", "ManyLoDs'", TS_FIGURE_COUNTER, M_LODS, 0, TS_WHOLE, "pairs" },
	[BRUTE_PAIRS] = { "bruteforce_pairs", "leaves by views", TS_FIGURE_COUNTER, M_BRUTE, 0, TS_WHOLE, "pairs" },
	[SAVED] = { "pairs_ratio", "by ours", TS_FIGURE_RATIO, LODS_PAIRS, PAIRS, 2, "" },
	[A_VIEW] = { "pairs_a_view", "a view", TS_FIGURE_RATIO, PAIRS, VIEWS, 1, "" },
	[LODS_A_VIEW] = { "manylods_pairs_a_view", "ManyLoDs'", TS_FIGURE_RATIO, LODS_PAIRS, VIEWS, 1, "" },
	[PAIRS_GROWTH] = { "pairs_exponent", "exponent", TS_FIGURE_GROWTH, PAIRS, VIEWS, 3, "" },
	[LODS_PAIRS_GROWTH] = { "manylods_pairs_exponent", "ManyLoDs'", TS_FIGURE_GROWTH, LODS_PAIRS, VIEWS, 3, "" },
	[SERVED] = { "served", "views served", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "views served" },
	[RENDERED] = { "rendered", "rendered", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "pairs rendered" },
	[SHARING] = { "sharing", "views a pair", TS_FIGURE_RATIO, SERVED, RENDERED, 2, "" },
	[CULLED] = { "culled", "culled", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "pairs culled" },
	[CULLED_SHARE] = { "culled_percent", "culled, %", TS_FIGURE_PERCENT, CULLED, PAIRS, 2, "" },
	[UNCULLED_PAIRS] = { "unculled_pairs", "without", TS_FIGURE_COUNTER, M_UNCULLED, 0, TS_WHOLE, "pairs" },
	[PAIRS_SAVED] = { "pairs_culling_percent", "pairs saved, %", TS_FIGURE_SAVED, PAIRS, UNCULLED_PAIRS, 2, "" },
	[WIDER] = { "wider", "wider than a texel", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "pairs wider than a texel" },
	[WIDER_SHARE] = { "wider_percent", "wider, %", TS_FIGURE_PERCENT, WIDER, RENDERED, 2, "" },
	[SEVERAL] = { "wider_several", "of several views", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE,
	  "of these of several views" },
	[SEVERAL_SHARE] = { "wider_several_percent", "of several views, %", TS_FIGURE_PERCENT, SEVERAL, RENDERED, 2, "" },
	[DEEP_RENDERED] = { "deep_rendered", "of 9 levels", TS_FIGURE_COUNTER, M_DEEP, 0, TS_WHOLE, "pairs rendered" },
	[DEEP_SEVERAL] = { "deep_several", "wider, of several", TS_FIGURE_COUNTER, M_DEEP, 0, TS_WHOLE,
	  "of these of several views" },
	[DEEP_SHARE] = { "deep_several_percent", "of several views, %", TS_FIGURE_PERCENT, DEEP_SEVERAL, DEEP_RENDERED, 2,
	  "" },
	[EMPTY] = { "empty_percent", "empty, %", TS_FIGURE_LOOKED, M_MEGA, 0, 1, "" },
	[SCENE_LEAVES] = { "scene_leaves", "leaves of the scene", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "scene leaves" },
	[LEAVES] = { "leaves", "of views", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "view leaves" },
	[SCENE_MIB] = { "scene_mib", "scene", TS_FIGURE_BUFFERS, M_MEGA, 0, 1, "voxel,octree" },
	[TREE_MIB] = { "views_mib", "views", TS_FIGURE_BUFFERS, M_MEGA, 0, 1,
	  "view_octree.voxel,view_octree,view_octree.cone" },
	[MAPS_MIB] = { "maps_mib", "maps", TS_FIGURE_BUFFERS, M_MEGA, 0, 1, "view_map,view_map.fuse" },
	[MIB] = { "mib", "all", TS_FIGURE_SUM, SCENE_MIB, MAPS_MIB, 1, "" },
	[QUEUE_MIB] = { "queue_mib", "longest step", TS_FIGURE_MEMORY, M_MEGA, 8, 1, "longest queue" },
	[LODS_SCENE_MIB] = { "manylods_scene_mib", "scene", TS_FIGURE_BUFFERS, M_LODS, 0, 1, "voxel,octree" },
	[LODS_VIEWS_MIB] = { "manylods_views_mib", "views", TS_FIGURE_BUFFERS, M_LODS, 0, 1,
	  "view_octree,view_octree.cone" },
	[LODS_MAPS_MIB] = { "manylods_maps_mib", "maps", TS_FIGURE_BUFFERS, M_LODS, 0, 1, "view_map,view_map.fuse" },
	[LODS_MIB] = { "manylods_mib", "all", TS_FIGURE_SUM, LODS_SCENE_MIB, LODS_MAPS_MIB, 1, "" },
	[LODS_QUEUE_MIB] = { "manylods_queue_mib", "longest step", TS_FIGURE_MEMORY, M_LODS, 8, 1, "longest queue" },
	[LESS] = { "mib_ratio", "by ours", TS_FIGURE_RATIO, LODS_MIB, MIB, 2, "" },
	[FUSE_MS] = { "fuse_ms", "fusion", TS_FIGURE_STAGE_TIME, M_MEGA, 0, 2, "view_map.fuse" },
	[ASK_MS] = { "ask_ms", "asking", TS_FIGURE_STAGE_TIME, M_MEGA, 0, 2, "vpl_gather" },
	[DESCEND_MS] = { "descend_ms", "without fusion", TS_FIGURE_STAGE_TIME, M_DESCEND, 0, 2, "vpl_gather" },
	[SLOWER] = { "descend_ratio", "by asking", TS_FIGURE_RATIO, DESCEND_MS, ASK_MS, 2, "" },
	[FUSED_MS] = { "fused_ms", "both", TS_FIGURE_SUM, FUSE_MS, ASK_MS, 2, "" },
	[WORTH] = { "fused_ratio", "by both", TS_FIGURE_RATIO, DESCEND_MS, FUSED_MS, 2, "" },
	[TEXELS] = { "texels", "texels a question", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "texels a question" },
	[DESCENT_TEXELS] = { "descend_texels", "without fusion", TS_FIGURE_COUNTER, M_DESCEND, 0, TS_WHOLE,
	  "texels a question" },
	[OTHER] = { "descend_rmse", "RMSE", TS_FIGURE_RMSE, M_DESCEND, M_MEGA, 3, "" },
	[VIEWS_MS] = { "views_only_ms", "views alone", TS_FIGURE_STAGE_TIME, M_VIEWS, 0, 2, "view_map,view_map.fuse" },
	[VIEWS_PAIRS] = { "views_only_pairs", "pairs", TS_FIGURE_COUNTER, M_VIEWS, 0, TS_WHOLE, "pairs" },
	[VIEWS_TIME] = { "views_only_time_ratio", "by MegaViews", TS_FIGURE_RATIO, VIEWS_MS, MS, 2, "" },
	[VIEWS_MORE] = { "views_only_pairs_ratio", "by MegaViews", TS_FIGURE_RATIO, VIEWS_PAIRS, PAIRS, 2, "" },
	[VIEWS_RENDERED] = { "views_only_rendered", "rendered", TS_FIGURE_COUNTER, M_VIEWS, 0, TS_WHOLE, "pairs rendered" },
	[VIEWS_RENDERED_MORE] = { "views_only_rendered_ratio", "by MegaViews", TS_FIGURE_RATIO, VIEWS_RENDERED, RENDERED, 2,
	  "" },
	[VIEWS_BY_BRUTE] = { "views_only_brute_ratio", "by leaves by views", TS_FIGURE_RATIO, VIEWS_PAIRS, BRUTE_PAIRS, 2,
	  "" },
	[UNCULLED_RMSE] = { "rmse_to_unculled", "to no culling", TS_FIGURE_RMSE, M_MEGA, M_UNCULLED, 3, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "mega_10", "MegaViews, figure 10: maps, ms; exponents of views since the row above", { VIEWS, MS, LODS_MS,
	  SPEEDUP, MS_GROWTH, LODS_MS_GROWTH, UNCULLED_MS, CULLING, TS_NO_FIGURE } },
	{ "mega_10_ms", "The rest, ms", { BRUTE_MS, TREE_MS, GATHER_MS, LODS_GATHER_MS, TS_NO_FIGURE } },
	{ "mega_10_pairs", "Pairs, and ManyLoDs'", { PAIRS, LODS_PAIRS, BRUTE_PAIRS, SAVED, A_VIEW, LODS_A_VIEW,
	  PAIRS_GROWTH, LODS_PAIRS_GROWTH, TS_NO_FIGURE } },
	{ "mega_10_fates", "What becomes of pairs", { RENDERED, WIDER, WIDER_SHARE, SEVERAL, SEVERAL_SHARE, CULLED,
	  CULLED_SHARE, UNCULLED_PAIRS, PAIRS_SAVED, TS_NO_FIGURE } },
	{ "mega_10_sharing", "Views of rendered pairs, and texels of whole maps of leaves", { SERVED, SHARING, EMPTY,
	  TS_NO_FIGURE } },
	{ "mega_10_deep", "Pairs rendered in octrees of 9 levels, and those wider than a texel", { DEEP_RENDERED,
	  DEEP_SEVERAL, DEEP_SHARE, TS_NO_FIGURE } },
	{ "mega_10_images", "Images of MegaViews: RMSE in grey levels", { UNCULLED_RMSE, TS_NO_FIGURE } },
	{ "mega_10_mib", "Memory of MegaViews, MiB: octrees, maps of all nodes and whole ones; and a queue of the longest "
	  "step, 8 bytes per pair", { SCENE_LEAVES, LEAVES, SCENE_MIB, TREE_MIB, MAPS_MIB, MIB,
	  QUEUE_MIB, TS_NO_FIGURE } },
	{ "mega_10_manylods_mib", "Memory of ManyLoDs, MiB", { LODS_SCENE_MIB, LODS_VIEWS_MIB, LODS_MAPS_MIB,
	  LODS_MIB, LESS, LODS_QUEUE_MIB, TS_NO_FIGURE } },
	{ "mega_10_views", "A hierarchy of views alone, each leaf of the scene by itself", { VIEWS_MS, VIEWS_TIME,
	  VIEWS_PAIRS, VIEWS_MORE, VIEWS_RENDERED, VIEWS_RENDERED_MORE, VIEWS_BY_BRUTE, TS_NO_FIGURE } },
	{ "mega_10_queries", "Gathering from whole maps, and without fusion from those from the root down, ms", { FUSE_MS,
	  ASK_MS, DESCEND_MS, SLOWER, WORTH, TEXELS, DESCENT_TEXELS, OTHER, TS_NO_FIGURE } },
	{ 0 },
};

#define MILLION VIEWS, 900e3, 1e9
#define MANY VIEWS, 60e3, 1e9
#define ALL TS_NO_FIGURE, 0, 0

/* There are few pairs wider than a texel while few views share a leaf: a million in 11 levels, 65,536 in 9. */
static const ts_paper_relation relations[] = {
	{ "time of ManyLoDs / MegaViews, 60,000 views or more", SPEEDUP, TS_AT_LEAST, 10, 0, MANY,
	  TS_GPU "maps are copied and fused as long as views share them; see view_map.fusion", SHARING },
	{ "the same, below 2,048 views: parity", SPEEDUP, TS_BETWEEN, 0.5, 2, VIEWS, 0, 2048,
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING },
	{ "memory of ManyLoDs / MegaViews, a million views", LESS, TS_AT_LEAST, 10, 0, MILLION,
	  TS_OURS "maps of inner nodes, and before they are fused, count; see octree.levels", LEAVES },
	{ "time grows slower than views: exponent", MS_GROWTH, TS_AT_MOST, 0, 1, ALL,
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING },
	{ "pairs grow slower than views: exponent", PAIRS_GROWTH, TS_AT_MOST, 0, 1, ALL,
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING },
	{ "views that share a pair, from row to row", SHARING, TS_GROWS, 1, 0, ALL,
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING },
	{ "pairs that culling saves, %", PAIRS_SAVED, TS_BETWEEN, 0, 20, ALL,
	  TS_ELSEWHERE "more or less of the scene is behind views; see view_map.field", CULLED_SHARE },
	{ "pairs of a hierarchy of views alone / MegaViews, from 100 views on", VIEWS_MORE, TS_AT_LEAST, 10, 0, VIEWS, 100,
	  1e9, TS_ELSEWHERE "few leaves of the scene, or deep chains of views; see octree.levels", SCENE_LEAVES },
	{ "time of asking without fusion: an order of magnitude more", SLOWER, TS_AT_LEAST, 10, 0, ALL,
	  TS_GPU "texels of nodes above are in caches, and asking is not all of gathering; see vpl_gather.query",
	  DESCENT_TEXELS },
	{ "texels read without fusion: the depth of the hierarchy", DESCENT_TEXELS, TS_AT_LEAST, 8, 0, ALL,
	  TS_ELSEWHERE "octrees are not as deep as the paper's 12 levels; see octree.levels", DESCENT_TEXELS },
	{ "pictures with and without fusion, RMSE", OTHER, TS_AT_MOST, 0, 0, ALL,
	  TS_OURS "fusion answers otherwise; see vpl_gather.query", OTHER },
	{ "pairs of several views wider than a texel, of 9 levels, %", DEEP_SHARE, TS_AT_MOST, 0, 5, VIEWS, 0,
	  70e3, TS_ELSEWHERE "more views share a leaf than the paper's; see octree.levels", SCENE_LEAVES },
	{ "pairs of ManyLoDs / MegaViews, 60,000 views or more", SAVED, TS_AT_LEAST, 10, 0, MANY,
	  TS_ELSEWHERE "few views share a leaf; see octree.levels", SHARING },
	{ "RMSE to the image without culling", UNCULLED_RMSE, TS_AT_MOST, 0, 0.1, ALL,
	  TS_OURS "culling loses what a view sees; see traverse.cull", CULLED_SHARE },
	{ 0 },
};

/* Means over four scenes. */
static const ts_paper_row rows[] = {
	{ "four scenes", "atrium", "sponza", 2048, { [SPEEDUP] = 1 } },
	{ "four scenes", "atrium", "sponza", 1048576, { [SPEEDUP] = 10, [LESS] = 10 } },
	{ 0 },
};
/* clang-format on */

double ts_empty_share(const ts_run *run)
{
	if (!run->frame.buffer[TS_B_view_map_fused_depth].made) return NAN;
	const u32 *depth = ts_frame_data(&run->frame, TS_B_view_map_fused_depth);
	const ts_node *node = ts_frame_data(&run->frame, TS_B_view_octree_node);
	u64 n = ts_frame_n(&run->frame, TS_B_view_octree_node), all = 0, empty = 0;
	u64 n_texels = (u64)2 * run->plan.views.px * run->plan.views.px;
	for (u64 i = 0; i < n; i++) {
		if (node[i].children != 0) continue;
		for (u64 k = 0; k < n_texels; k++) empty += depth[i * n_texels + k] == TS_NONE;
		all += n_texels;
	}
	return 100 * ((double)empty / (double)all);
}

static const ts_paper_plot plot = {"views", "maps, ms", VIEWS, {MS, LODS_MS, VIEWS_MS, BRUTE_MS, TS_NO_FIGURE}, true};

/* clang-format off */
const ts_paper_table ts_mega_10 = {
	.name = "mega-10", .title = "MegaViews, figure 10", .effect = "indirect", .scenes = "atrium",
	.objects_head = "paths",
	.objects_param = "vpl.paths", .objects = "256,1024,4096,16384,65536", .most = 1 << 24, .most_long = 1024,
	.set = "reflectors.count=0",
	.defaults = "octree.levels=7,rsm.px=1024", .size = "width=320,height=180", .timed = true,
	.note = "Paths leave vpl.bounces views, the paper's 1 or 4, of 11 levels. A million take 9 GB. Brute force, views "
	"alone: to 1024.",
	.look = ts_empty_share, .variants = variants, .figures = figures, .parts = parts, .relations = relations,
	.plot = &plot, .rows = rows,
};
/* clang-format on */
