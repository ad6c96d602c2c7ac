/* MegaViews as maps, octrees and gathering vary: the paper's figures 12, 13 and 16, known only from its text. */
#include "methods/views/tools/bench_mega.h"

#define ALL TS_NO_FIGURE, 0, 0

/* clang-format off */
/* Figure 12. */
static const ts_bench_variant splat_variants[] = {
	[M_MEGA] = { "megaviews", "view_map.multipixel=mips", true, TS_TIMED },
	[M_LODS] = { "manylods", "view_map.multipixel=mips", true, TS_TIMED },
	{ 0 },
};

static const ts_bench_figure side_figures[] = {
	[X] = { "side", "texels a side", TS_FIGURE_PARAM, 0, 0, TS_WHOLE, "view_map.px" }, TS_MEGA_FIGURES, { 0 },
};

static const ts_paper_part side_parts[] = {
	{ "mega_12", "MegaViews, figure 12: maps, ms; exponents of texels a side since the row above", { MS, LODS_MS,
	  SPEEDUP, MS_GROWTH, LODS_MS_GROWTH, RMSE, TS_NO_FIGURE } },
	{ "mega_12_pairs", "Pairs, and ManyLoDs'", { PAIRS, LODS_PAIRS, SAVED, PAIRS_GROWTH, SHARING, SHARING_GROWTH,
	  WIDER_SHARE, TS_NO_FIGURE } },
	{ "mega_12_mib", "Memory", { QUEUE_MIB, MAPS_MIB, LODS_QUEUE_MIB, LODS_MAPS_MIB, MAPS_LESS,
	  TS_NO_FIGURE } },
	{ 0 },
};

#define PAIRS_END TS_ELSEWHERE "leaves are wider than a texel, so that pairs end early; see octree.levels"
static const ts_paper_relation side_relations[] = {
	{ "time of MegaViews, quadruple for twice the side: exponent", MS_GROWTH, TS_BETWEEN, 1.7, 2.5, ALL,
	  PAIRS_END, WIDER_SHARE },
	{ "time of ManyLoDs, the same", LODS_MS_GROWTH, TS_BETWEEN, 1.7, 2.5, ALL,
	  PAIRS_END, WIDER_SHARE },
	{ "ManyLoDs / MegaViews", SPEEDUP, TS_AT_LEAST, 1, 0, ALL,
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING },
	{ "views that share a pair become fewer: exponent", SHARING_GROWTH, TS_AT_MOST, 0, 0, ALL,
	  TS_ELSEWHERE "leaves are wider than a texel; see octree.levels", SHARING },
	{ 0 },
};

static const ts_paper_row none[] = { { 0 } };
static const ts_paper_plot side_plot = { "texels a side", "maps, ms", X, { MS, LODS_MS, TS_NO_FIGURE }, true };

const ts_paper_table ts_mega_12 = {
	.name = "mega-12", .title = "MegaViews, figure 12", .effect = "indirect", .scenes = "atrium",
	.objects_head = "view_map.px", .objects_param = "view_map.px", .objects = "16,32,64", .set = "reflectors.count=0",
	.defaults = "octree.levels=9,vpl.paths=16384,rsm.px=1024", .size = "width=320,height=180", .timed = true,
	.note = "The paper has a million views, and 11 levels.", .variants = splat_variants, .figures = side_figures,
	.parts = side_parts, .relations = side_relations, .plot = &side_plot, .rows = none,
};

/* Figure 13. Errors are for all lights, unfiltered. */
enum { M_EVERY_LIGHT = M_LODS + 1 };

static const ts_bench_variant level_variants[] = {
	[M_MEGA] = { "megaviews", "", true, TS_TIMED },
	[M_LODS] = { "manylods", "", true, TS_TIMED },
	[M_EVERY_LIGHT] = { "megaviews", "vpl_gather.lights=0,bilateral.px=0", true, TS_ONCE },
	{ 0 },
};

enum { LEVEL_PSNR = EMPTY + 1, LEVEL_SSIM };

static const ts_bench_figure level_figures[] = {
	[X] = { "leaves", "leaves", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "scene leaves" }, TS_MEGA_FIGURES,
	[EMPTY] = { "level", "level", TS_FIGURE_PARAM, 0, 0, TS_WHOLE, "octree.levels" },
	[LEVEL_PSNR] = { "psnr", "PSNR", TS_FIGURE_PSNR, M_EVERY_LIGHT, 0, 2, "" },
	[LEVEL_SSIM] = { "ssim", "SSIM", TS_FIGURE_SSIM, M_EVERY_LIGHT, 0, 4, "" },
	{ 0 },
};

static const ts_paper_part level_parts[] = {
	{ "mega_13", "MegaViews, figure 13: maps, ms; exponents of leaves of the scene since the row above", { X, MS,
	  LODS_MS, SPEEDUP, MS_GROWTH, LODS_MS_GROWTH, TS_NO_FIGURE } },
	{ "mega_13_images", "Pictures of all lights, unfiltered, beside truth `vpls`: dB", { LEVEL_PSNR, LEVEL_SSIM,
	  TS_NO_FIGURE } },
	{ "mega_13_pairs", "Pairs, and ManyLoDs'", { PAIRS, LODS_PAIRS, SAVED, PAIRS_GROWTH, SHARING, WIDER, WIDER_SHARE,
	  SEVERAL, SEVERAL_SHARE, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation level_relations[] = {
	{ "PSNR grows with levels", LEVEL_PSNR, TS_GROWS, 1, 0, ALL,
	  TS_NOT_ALWAYS "whatever is in a texel fills it, as in the paper; see view_map.texel=middle", LEVEL_PSNR },
	{ "SSIM grows with levels", LEVEL_SSIM, TS_GROWS, 1, 0, ALL,
	  TS_NOT_ALWAYS "whatever is in a texel fills it, as in the paper; see view_map.texel=middle", LEVEL_SSIM },
	{ "time grows with levels", MS, TS_GROWS, 1, 0, ALL, TS_GPU "fusion is much of the time; see view_map.fusion", MS },
	{ "time grows slower than leaves: exponent", MS_GROWTH, TS_AT_MOST, 0, 1, ALL,
	  TS_ELSEWHERE "few leaves have several views; see vpl.paths",
	  SHARING },
	{ "pairs grow slower than leaves: exponent", PAIRS_GROWTH, TS_AT_MOST, 0, 1, ALL,
	  TS_ELSEWHERE "few leaves have several views; see vpl.paths", SHARING },
	{ "pairs of several views wider than a texel, most by least", SEVERAL, TS_STEADY, 0, 15, ALL,
	  TS_ELSEWHERE "few views share a leaf of the deepest octree; see vpl.paths", SEVERAL_SHARE },
	{ 0 },
};

/* With 64K paths of four bounces. */
static const ts_paper_row level_rows[] = {
	{ "Sibenik", "atrium", "sibenik", 8, { [MS] = 7 } },
	{ "Sibenik", "atrium", "sibenik", 11, { [MS] = 31 } },
	{ 0 },
};

static const ts_paper_plot level_plot = { "leaves of the scene", "maps, ms", X, { MS, LODS_MS, TS_NO_FIGURE }, true };

const ts_paper_table ts_mega_13 = {
	.name = "mega-13", .title = "MegaViews, figure 13", .effect = "indirect", .scenes = "atrium",
	.objects_head = "levels", .objects_param = "octree.levels", .objects = "5,6,7,8", .set = "reflectors.count=0",
	.defaults = "vpl.paths=256,vpl.bounces=4,rsm.px=256", .size = "width=320,height=180", .timed = true,
	.judge = "vpls", .note = "The paper has 65,536 views.", .variants = level_variants, .figures = level_figures,
	.parts = level_parts, .relations = level_relations, .plot = &level_plot, .rows = level_rows,
};

/* Figure 16. Noise is the difference of a few lights per pixel, without the filter, from the noise-free picture of all
 * lights that culling and the cut-off leave. */
enum { M_CULLED, M_UNCULLED, M_EVERY, M_EVERY_UNCULLED };

static const ts_bench_variant gather_variants[] = {
	[M_CULLED] = { "megaviews", "bilateral.px=0", true, TS_ONCE },
	[M_UNCULLED] = { "megaviews", "bilateral.px=0,vpl_gather.level=0", true, TS_ONCE },
	[M_EVERY] = { "megaviews", "bilateral.px=0,vpl_gather.lights=0", true, TS_ONCE },
	[M_EVERY_UNCULLED] = { "megaviews", "bilateral.px=0,vpl_gather.lights=0,vpl_gather.level=0", true, TS_ONCE },
	{ 0 },
};

enum { LISTED, STRUCK, LISTED_AND_STRUCK, STRUCK_SHARE, LISTS_MS, GATHER_MS, EVERY_MS, NOISE, UNCULLED_NOISE,
	NOISE_RATIO, LEVEL };

static const ts_bench_figure gather_figures[] = {
	[LISTED] = { "listed", "left", TS_FIGURE_COUNTER, M_CULLED, 0, TS_WHOLE, "gather pairs" },
	[STRUCK] = { "culled", "culled", TS_FIGURE_COUNTER, M_CULLED, 0, TS_WHOLE, "gather pairs culled" },
	[LISTED_AND_STRUCK] = { "pairs", "pairs of nodes", TS_FIGURE_SUM, LISTED, STRUCK, TS_WHOLE, "" },
	[STRUCK_SHARE] = { "culled_percent", "culled, %", TS_FIGURE_PERCENT, STRUCK, LISTED_AND_STRUCK, 2, "" },
	[LISTS_MS] = { "lists_ms", "lists, ms", TS_FIGURE_STAGE_TIME, M_CULLED, 0, 2, "vpl_gather.pairs" },
	[GATHER_MS] = { "gather_ms", "gathering, ms", TS_FIGURE_STAGE_TIME, M_CULLED, 0, 2, "vpl_gather" },
	[EVERY_MS] = { "every_ms", "of all, ms", TS_FIGURE_STAGE_TIME, M_EVERY, 0, 2, "vpl_gather" },
	[NOISE] = { "noise", "RMSE", TS_FIGURE_RMSE, M_CULLED, M_EVERY, 3, "" },
	[UNCULLED_NOISE] = { "unculled_noise", "not culled", TS_FIGURE_RMSE, M_UNCULLED, M_EVERY_UNCULLED, 3, "" },
	[NOISE_RATIO] = { "noise_ratio", "by that", TS_FIGURE_RATIO, NOISE, UNCULLED_NOISE, 3, "" },
	[LEVEL] = { "level", "level", TS_FIGURE_PARAM, 0, 0, TS_WHOLE, "vpl_gather.level" },
	{ 0 },
};

static const ts_paper_part gather_parts[] = {
	{ "mega_16", "MegaViews, figure 16: nodes of views culled; RMSE to all lights, grey levels", { LISTED_AND_STRUCK,
	  STRUCK, STRUCK_SHARE, LISTS_MS, GATHER_MS, EVERY_MS, NOISE, UNCULLED_NOISE, NOISE_RATIO, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation gather_relations[] = {
	{ "nodes of views culled at level 6, %", STRUCK_SHARE, TS_AT_LEAST, 94, 0, LEVEL, 6, 6,
	  TS_ELSEWHERE "nothing is cut off by distance; see vpl_gather.cutoff", STRUCK_SHARE },
	{ "they are more from level to level", STRUCK_SHARE, TS_GROWS, 1, 0, ALL,
	  TS_ELSEWHERE "nodes are nearly as large as the scene; see vpl_gather.cutoff", STRUCK_SHARE },
	{ "noise by that without culling", NOISE_RATIO, TS_AT_MOST, 0, 1, ALL,
	  TS_ELSEWHERE "few views are culled; see vpl_gather.cutoff", STRUCK_SHARE },
	{ 0 },
};

static const ts_paper_row gather_rows[] = {
	{ "Sponza", "atrium", "sponza", 6, { [STRUCK_SHARE] = 94 } },
	{ 0 },
};
/* clang-format on */

static const ts_paper_plot gather_plot = {
	"level", "RMSE, grey levels", LEVEL, {NOISE, UNCULLED_NOISE, TS_NO_FIGURE}, true};

/* clang-format off */
const ts_paper_table ts_mega_16 = {
	.name = "mega-16", .title = "MegaViews, figure 16", .effect = "indirect", .scenes = "atrium",
	.objects_head = "vpl_gather.level", .objects_param = "vpl_gather.level", .objects = "2,3,4,5,6",
	.set = "reflectors.count=0",
	.defaults = "octree.levels=7,vpl.paths=1024,rsm.px=256,vpl_gather.cutoff=5", .size = "width=160,height=90",
	.note = "The paper has a million views, 11 levels, and an unknown cut-off; here a sixth of the court, beyond "
	"which light is lost.",
	.variants = gather_variants, .figures = gather_figures, .parts = gather_parts, .relations = gather_relations,
	.plot = &gather_plot, .rows = gather_rows,
};
/* clang-format on */
