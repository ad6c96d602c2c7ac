/* MegaViews as views become less coherent: where light falls first, where it is reflected, and anywhere on the scene's
 * surfaces, the paper's figure 11. */
#include "methods/views/tools/tools.h"

enum { LIGHT, BOUNCES, RANDOM };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[LIGHT] = { "megaviews", "vpl.bounces=1,vpl.place=light", true, TS_TIMED },
	[BOUNCES] = { "megaviews", "vpl.bounces=4,vpl.place=light", true, TS_TIMED },
	[RANDOM] = { "megaviews", "vpl.bounces=1,vpl.place=random", true, TS_TIMED },
	{ 0 },
};

enum { VIEWS, MS, PAIRS, SHARING, SERVED, RENDERED, TEXELS, A_VIEW, PAIRS_GROWTH, VIEWS_4, MS_4, PAIRS_4, SHARING_4,
	SERVED_4, RENDERED_4, TEXELS_4, A_VIEW_4, PAIRS_4_GROWTH, VIEWS_R, MS_R, PAIRS_R, SHARING_R, SERVED_R, RENDERED_R,
	TEXELS_R, A_VIEW_R, PAIRS_R_GROWTH, SLOWER, MORE, LESS_SHARED, TEXELS_MORE, PSNR };

#define OF(id, key, variant) \
	[VIEWS##id] = { "views" key, "views", TS_FIGURE_COUNTER, variant, 0, TS_WHOLE, "virtual point lights" }, \
	[MS##id] = { "ms" key, "ms", TS_FIGURE_STAGE_TIME, variant, 0, 2, "view_map,view_map.fuse" }, \
	[PAIRS##id] = { "pairs" key, "pairs", TS_FIGURE_COUNTER, variant, 0, TS_WHOLE, "pairs" }, \
	[SERVED##id] = { "served" key, "views served", TS_FIGURE_COUNTER, variant, 0, TS_WHOLE, "views served" }, \
	[RENDERED##id] = { "rendered" key, "rendered", TS_FIGURE_COUNTER, variant, 0, TS_WHOLE, "pairs rendered" }, \
	[SHARING##id] = { "sharing" key, "views a pair", TS_FIGURE_RATIO, SERVED##id, RENDERED##id, 2, "" }, \
	[TEXELS##id] = { "maps_mib" key, "maps, MiB", TS_FIGURE_BUFFERS, variant, 0, 1, "view_map,view_map.fuse" }, \
	[A_VIEW##id] = { "pairs_a_view" key, "pairs a view", TS_FIGURE_RATIO, PAIRS##id, VIEWS##id, 0, "" }, \
	[PAIRS##id##_GROWTH] = { "pairs_exponent" key, "exponent", TS_FIGURE_GROWTH, PAIRS##id, VIEWS##id, 3, "" }
static const ts_bench_figure figures[] = {
	OF(, "", LIGHT), OF(_4, "_4", BOUNCES), OF(_R, "_random", RANDOM),
	[SLOWER] = { "ms_ratio", "random / light", TS_FIGURE_RATIO, MS_R, MS, 2, "" },
	[MORE] = { "pairs_ratio", "pairs, random / light", TS_FIGURE_RATIO, PAIRS_R, PAIRS, 2, "" },
	[LESS_SHARED] = { "sharing_ratio", "views a pair, the same", TS_FIGURE_RATIO, SHARING_R, SHARING, 3, "" },
	[TEXELS_MORE] = { "maps_ratio", "maps, the same", TS_FIGURE_RATIO, TEXELS_R, TEXELS, 2, "" },
	[PSNR] = { "psnr", "PSNR to light, dB", TS_FIGURE_PSNR, RANDOM, LIGHT, 2, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "mega_11", "MegaViews, figure 11: views at random on all surfaces by those of single-bounce lights", { MS, MS_R,
	  SLOWER, MORE, LESS_SHARED, TEXELS_MORE, PSNR, TS_NO_FIGURE } },
	{ "mega_11_light", "Lights of one bounce; exponents of views since the row above", { VIEWS, MS, PAIRS, A_VIEW,
	  PAIRS_GROWTH, SHARING, TEXELS, TS_NO_FIGURE } },
	{ "mega_11_bounces", "Lights of four bounces, of as many paths", { VIEWS_4, MS_4, PAIRS_4, A_VIEW_4,
	  PAIRS_4_GROWTH, SHARING_4, TEXELS_4, TS_NO_FIGURE } },
	{ "mega_11_random", "Views at random", { VIEWS_R, MS_R, PAIRS_R, A_VIEW_R, PAIRS_R_GROWTH, SHARING_R, TEXELS_R,
	  TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

#define FAR_APART TS_ELSEWHERE "single-bounce lights are as far apart; see lamp.fov"
static const ts_paper_relation relations[] = {
	{ "time of views at random / single-bounce, 65,536 views", SLOWER, TS_BETWEEN, 2, 8, VIEWS, 60000, 70000,
	  TS_ELSEWHERE "the lamp lights more or less than the paper's; see lamp.fov", LESS_SHARED },
	{ "pairs of views at random / single-bounce, 65,536 views", MORE, TS_BETWEEN, 2, 8, VIEWS, 60000, 70000,
	  TS_ELSEWHERE "the lamp lights more or less than the paper's; see lamp.fov", LESS_SHARED },
	{ "pairs of views at random / single-bounce, from 1,024 on", MORE, TS_AT_LEAST, 1, 0, VIEWS, 1024, 1e9,
	  FAR_APART, LESS_SHARED },
	{ "pairs of views at random / single-bounce, row by row", MORE, TS_GROWS, 1, 0, ALL, FAR_APART, MORE },
	{ "views that share a pair, random / single-bounce", LESS_SHARED, TS_AT_MOST, 0, 1, ALL,
	  FAR_APART, LESS_SHARED },
	{ "pairs of views at random grow slower than views: exponent", PAIRS_R_GROWTH, TS_AT_MOST, 0, 1, ALL,
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING_R },
	{ "picture of views at random beside single-bounce, dB", PSNR, TS_AT_LEAST, 20, 0, VIEWS, 1024, 1e9,
	  TS_NOT_ALWAYS "most of them are in the dark; see vpl.place", PSNR },
	{ 0 },
};

/* For 64K views in Sponza. */
static const ts_paper_row rows[] = {
	{ "Sponza", "atrium", "sponza", 65536, { [SLOWER] = 4 } },
	{ 0 },
};

static const ts_paper_plot plot = { "views", "maps, ms", VIEWS, { MS, MS_R, TS_NO_FIGURE }, true };

const ts_paper_table ts_mega_11 = {
	.name = "mega-11", .title = "MegaViews, figure 11", .effect = "indirect", .scenes = "atrium",
	.objects_head = "paths", .objects_param = "vpl.paths", .objects = "256,1024,4096", .most = 1 << 24,
	.set = "reflectors.count=0", .defaults = "octree.levels=7,rsm.px=1024", .size = "width=320,height=180",
	.timed = true,
	.note = "Paths of four bounces leave up to four views each. The paper has 65,536 views, and 11 levels.",
	.variants = variants, .figures = figures, .parts = parts, .relations = relations, .plot = &plot, .rows = rows,
};
/* clang-format on */
