/* Maps with sides of 64 texels against those of 16: the paper's figure 15, by pictures and rays. Each pixel gathers
 * from all lights, so that neither draws nor the filter hide the maps' errors. */
#include "methods/views/tools/tools.h"

enum { COARSE, HOLED, FINE, LODS_COARSE, LODS_FINE };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[COARSE] = { "megaviews", "view_map.px=16", true, TS_ONCE },
	[HOLED] = { "megaviews", "view_map.px=64,view_map.texel=point,view_map.multipixel=off", true, TS_ONCE },
	[FINE] = { "megaviews", "view_map.px=64", true, TS_ONCE },
	[LODS_COARSE] = { "manylods", "view_map.px=16", true, TS_ONCE },
	[LODS_FINE] = { "manylods", "view_map.px=64", true, TS_ONCE },
	{ 0 },
};

enum { LEAVES, PSNR, PSNR_HOLED, PSNR_FINE, PSNR_LODS, PSNR_LODS_FINE, SSIM, SSIM_HOLED, SSIM_FINE, SSIM_LODS,
	SSIM_LODS_FINE, ASKED, LIT, DARK, WRONG, LIT_HOLED, DARK_HOLED, WRONG_HOLED, LIT_FINE, DARK_FINE, WRONG_FINE,
	WRONG_SHARE, WRONG_HOLED_SHARE, WRONG_FINE_SHARE, COVERED, LEAKS, LEAKS_SHARE, COVERED_FINE, LEAKS_HOLED,
	LEAKS_HOLED_SHARE, LEAKS_FINE, LEAKS_FINE_SHARE, GAIN, SSIM_GAIN, WRONG_LEFT, COST, LEAKS_LEFT, WIDER, SEVERAL,
	RENDERED, OVER_LODS, OVER_LODS_FINE, WIDER_SHARE, SEVERAL_SHARE,
#define WRONG(id, ...) WHY_##id, WHY_FINE_##id, WHY_SHARE_##id, WHY_FINE_SHARE_##id,
#include "methods/views/tools/truth_wrong.def"
#undef WRONG
};

#define COUNT(id, key, head, variant, what) [id] = { key, head, TS_FIGURE_COUNTER, variant, 0, TS_WHOLE, what }
#define SHARE(id, key, head, part, of) [id] = { key, head, TS_FIGURE_PERCENT, part, of, 2, "" }
#define WRONG_OF(id, key, variant) \
	COUNT(LIT##id, "lit" key, "lit", variant, "lit but by rays"), \
	COUNT(DARK##id, "dark" key, "dark", variant, "dark but by rays"), \
	[WRONG##id] = { "wrong" key, "wrong", TS_FIGURE_SUM, LIT##id, DARK##id, TS_WHOLE, "" }, \
	SHARE(WRONG##id##_SHARE, "wrong" key "_percent", "wrong, %", WRONG##id, ASKED)
static const ts_bench_figure figures[] = {
	COUNT(LEAVES, "leaves", "leaves", COARSE, "scene leaves"),
	[PSNR] = { "psnr_16", "PSNR, 16", TS_FIGURE_PSNR, COARSE, 0, 2, "" },
	[PSNR_HOLED] = { "psnr_64_off", "64, not filled", TS_FIGURE_PSNR, HOLED, 0, 2, "" },
	[PSNR_FINE] = { "psnr_64", "64", TS_FIGURE_PSNR, FINE, 0, 2, "" },
	[PSNR_LODS] = { "manylods_psnr_16", "ManyLoDs, 16", TS_FIGURE_PSNR, LODS_COARSE, 0, 2, "" },
	[PSNR_LODS_FINE] = { "manylods_psnr_64", "64", TS_FIGURE_PSNR, LODS_FINE, 0, 2, "" },
	[SSIM] = { "ssim_16", "SSIM, 16", TS_FIGURE_SSIM, COARSE, 0, 4, "" },
	[SSIM_HOLED] = { "ssim_64_off", "64, not filled", TS_FIGURE_SSIM, HOLED, 0, 4, "" },
	[SSIM_FINE] = { "ssim_64", "64", TS_FIGURE_SSIM, FINE, 0, 4, "" },
	[SSIM_LODS] = { "manylods_ssim_16", "ManyLoDs, 16", TS_FIGURE_SSIM, LODS_COARSE, 0, 4, "" },
	[SSIM_LODS_FINE] = { "manylods_ssim_64", "64", TS_FIGURE_SSIM, LODS_FINE, 0, 4, "" },
	COUNT(ASKED, "asked", "asked", COARSE, "shadows asked of rays"),
	WRONG_OF(, "_16", COARSE),
	WRONG_OF(_HOLED, "_64_off", HOLED),
	WRONG_OF(_FINE, "_64", FINE),
	COUNT(COVERED, "texels_16", "texels", COARSE, "texels covered by rays"),
	COUNT(LEAKS, "leaks_16", "leaks", COARSE, "leaks"),
	SHARE(LEAKS_SHARE, "leaks_16_percent", "16: leaks, %", LEAKS, COVERED),
	COUNT(COVERED_FINE, "texels_64", "texels", FINE, "texels covered by rays"),
	COUNT(LEAKS_HOLED, "leaks_64_off", "leaks", HOLED, "leaks"),
	SHARE(LEAKS_HOLED_SHARE, "leaks_64_off_percent", "64, not filled: leaks, %", LEAKS_HOLED, COVERED_FINE),
	COUNT(LEAKS_FINE, "leaks_64", "leaks", FINE, "leaks"),
	SHARE(LEAKS_FINE_SHARE, "leaks_64_percent", "64: leaks, %", LEAKS_FINE, COVERED_FINE),
	[GAIN] = { "psnr_gain", "PSNR, 64 - 16", TS_FIGURE_DIFFERENCE, PSNR_FINE, PSNR, 2, "" },
	[SSIM_GAIN] = { "ssim_gain", "SSIM, 64 - 16", TS_FIGURE_DIFFERENCE, SSIM_FINE, SSIM, 4, "" },
	[WRONG_LEFT] = { "wrong_ratio", "wrong, 64 / 16", TS_FIGURE_RATIO, WRONG_FINE, WRONG, 3, "" },
	[COST] = { "filling_cost", "PSNR that filling costs", TS_FIGURE_DIFFERENCE, PSNR_HOLED, PSNR_FINE, 2, "" },
	[LEAKS_LEFT] = { "leaks_ratio", "leaks, filled / not", TS_FIGURE_RATIO, LEAKS_FINE, LEAKS_HOLED, 3, "" },
	[OVER_LODS] = { "psnr_over_manylods_16", "PSNR less ManyLoDs', 16", TS_FIGURE_DIFFERENCE, PSNR, PSNR_LODS, 2, "" },
	[OVER_LODS_FINE] = { "psnr_over_manylods_64", "64", TS_FIGURE_DIFFERENCE, PSNR_FINE, PSNR_LODS_FINE, 2, "" },
	COUNT(WIDER, "wider", "wider than a texel", FINE, "pairs wider than a texel"),
	COUNT(SEVERAL, "wider_several", "of several views", FINE, "of these of several views"),
	COUNT(RENDERED, "rendered", "rendered", FINE, "pairs rendered"),
	SHARE(WIDER_SHARE, "wider_percent", "wider, %", WIDER, RENDERED),
	SHARE(SEVERAL_SHARE, "wider_several_percent", "of several views, %", SEVERAL, RENDERED),
#define WRONG(id, counter, head) \
	COUNT(WHY_##id, #id "_16", head, COARSE, counter), \
	COUNT(WHY_FINE_##id, #id "_64", head, FINE, counter), \
	SHARE(WHY_SHARE_##id, #id "_16_percent", head, WHY_##id, ASKED), \
	SHARE(WHY_FINE_SHARE_##id, #id "_64_percent", head, WHY_FINE_##id, ASKED),
#include "methods/views/tools/truth_wrong.def"
#undef WRONG
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "mega_15", "MegaViews, figure 15: PSNR, dB, and SSIM to truth `vpls` of maps of 16 and 64 texels a side", { PSNR,
	  PSNR_HOLED, PSNR_FINE, GAIN, SSIM, SSIM_HOLED, SSIM_FINE, SSIM_GAIN, TS_NO_FIGURE } },
	{ "mega_15_manylods", "ManyLoDs", { PSNR_LODS, PSNR_LODS_FINE, SSIM_LODS, SSIM_LODS_FINE,
	  OVER_LODS, OVER_LODS_FINE, TS_NO_FIGURE } },
	{ "mega_15_answers", "Answers about shadows that rays give otherwise", { ASKED, WRONG_SHARE, WRONG_HOLED_SHARE,
	  WRONG_FINE_SHARE, WRONG_LEFT, LIT_FINE, DARK_FINE, TS_NO_FIGURE } },
	{ "mega_15_why_16", "Why those of 16 are wrong, % of all asked: the first half lit, the second dark", {
#define WRONG(id, ...) WHY_SHARE_##id,
#include "methods/views/tools/truth_wrong.def"
#undef WRONG
	  TS_NO_FIGURE } },
	{ "mega_15_why_64", "And those of 64", {
#define WRONG(id, ...) WHY_FINE_SHARE_##id,
#include "methods/views/tools/truth_wrong.def"
#undef WRONG
	  TS_NO_FIGURE } },
	{ "mega_15_leaks", "Texels that show what lies behind what rays hit", { LEAKS_SHARE, LEAKS_HOLED_SHARE,
	  LEAKS_FINE_SHARE, LEAKS_LEFT, COST, TS_NO_FIGURE } },
	{ "mega_15_pairs", "Rendered pairs wider than one of 64 texels", { LEAVES, RENDERED, WIDER_SHARE, SEVERAL_SHARE,
	  TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

#define TOO_FULL TS_OURS "leaves throw more shadow than they have; see view_map.fill=0.5"
#define SHARED TS_NOT_ALWAYS "what views of a leaf share is coarse; see octree.levels"
/* The paper's scene is Sibenik. */
static const ts_paper_relation relations[] = {
	{ "PSNR at 64 not below that at 16, dB", GAIN, TS_AT_LEAST, 0, 0, ALL, TOO_FULL, DARK_FINE },
	{ "the paper: much better; 1 dB", GAIN, TS_AT_LEAST, 1, 0, ALL, TOO_FULL, WRONG_LEFT },
	{ "SSIM at 64 not below that at 16", SSIM_GAIN, TS_AT_LEAST, 0, 0, ALL, TOO_FULL, DARK_FINE },
	{ "wrong answers at 64 by those at 16", WRONG_LEFT, TS_AT_MOST, 0, 1, ALL, TOO_FULL,
	  DARK_FINE },
	{ "dB less ManyLoDs', 16 texels", OVER_LODS, TS_AT_LEAST, -0.5, 0, ALL, SHARED, WRONG_SHARE },
	{ "dB less ManyLoDs', 64 texels", OVER_LODS_FINE, TS_AT_LEAST, -0.5, 0, ALL, SHARED,
	  WRONG_FINE_SHARE },
	{ "leaks, filled / not filled", LEAKS_LEFT, TS_AT_MOST, 0, 1.0 / 3, ALL,
	  TS_OURS "leaves are not filled; see view_map.fill=1", LEAKS_FINE },
	{ "PSNR of the paper's texels over filled ones, dB", COST, TS_AT_MOST, 0, 0.05, ALL, TOO_FULL,
	  DARK_FINE },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_mega_15 = {
	.name = "mega-15", .title = "MegaViews, figure 15", .effect = "indirect", .models = "sibenik.glb",
	.own_camera = true, .objects_head = "octree.levels", .objects_param = "octree.levels",
	.objects = "8,9", .most = 11, .set = "reflectors.count=0,vpl_gather.lights=0,bilateral.px=0",
	.defaults = "vpl.paths=512", .size = "width=160,height=90", .judge = "vpls", .rays = true,
	.note = "All pixels gather from all lights, unfiltered. The paper has 8K views, and 11 levels.",
	.variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
