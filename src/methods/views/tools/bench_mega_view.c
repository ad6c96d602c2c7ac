/* One rendered view in colour, with and without hole filling: the paper's figure 9, and the reflections of such views,
 * judged by rays, beside the cubes of EPR and MVR. */
#include "methods/views/tools/tools.h"

enum { HOLED, FILLED, COARSE, EPR, MVR };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[HOLED] = { "megaviews", "view_map.texel=point,view_map.multipixel=off", true, TS_ONCE },
	[FILLED] = { "megaviews", "", true, TS_ONCE },
	[COARSE] = { "megaviews", "cube_view.px=64", true, TS_ONCE },
	[EPR] = { "epr", "lookup.bounces=1", true, TS_ONCE },
	[MVR] = { "mvr", "", true, TS_ONCE },
	{ 0 },
};

enum { LEAVES, PSNR_HOLED, PSNR, PSNR_COARSE, PSNR_EPR, PSNR_MVR, SSIM_HOLED, SSIM, SSIM_COARSE, SSIM_EPR, SSIM_MVR,
	GAIN, FINER };

static const ts_bench_figure figures[] = {
	[LEAVES] = { "leaves", "leaves", TS_FIGURE_COUNTER, FILLED, 0, TS_WHOLE, "scene leaves" },
	[PSNR_HOLED] = { "psnr_off", "PSNR, not filled", TS_FIGURE_PSNR, HOLED, 0, 2, "" },
	[PSNR] = { "psnr", "filled", TS_FIGURE_PSNR, FILLED, 0, 2, "" },
	[PSNR_COARSE] = { "psnr_64", "64 texels", TS_FIGURE_PSNR, COARSE, 0, 2, "" },
	[PSNR_EPR] = { "psnr_epr", "EPR", TS_FIGURE_PSNR, EPR, 0, 2, "" },
	[PSNR_MVR] = { "psnr_mvr", "MVR", TS_FIGURE_PSNR, MVR, 0, 2, "" },
	[SSIM_HOLED] = { "ssim_off", "SSIM, not filled", TS_FIGURE_SSIM, HOLED, 0, 4, "" },
	[SSIM] = { "ssim", "filled", TS_FIGURE_SSIM, FILLED, 0, 4, "" },
	[SSIM_COARSE] = { "ssim_64", "64 texels", TS_FIGURE_SSIM, COARSE, 0, 4, "" },
	[SSIM_EPR] = { "ssim_epr", "EPR", TS_FIGURE_SSIM, EPR, 0, 4, "" },
	[SSIM_MVR] = { "ssim_mvr", "MVR", TS_FIGURE_SSIM, MVR, 0, 4, "" },
	[GAIN] = { "filling_gain", "PSNR that filling gains", TS_FIGURE_DIFFERENCE, PSNR, PSNR_HOLED, 2, "" },
	[FINER] = { "side_gain", "256 - 64 texels", TS_FIGURE_DIFFERENCE, PSNR, PSNR_COARSE, 2, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "mega_9", "MegaViews, figure 9: PSNR, dB, to rays from the cubes' middles", { LEAVES, PSNR_HOLED, PSNR, GAIN,
	  PSNR_COARSE, FINER, PSNR_EPR, PSNR_MVR, TS_NO_FIGURE } },
	{ "mega_9_ssim", "SSIM", { SSIM_HOLED, SSIM, SSIM_COARSE, SSIM_EPR, SSIM_MVR, TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

static const ts_paper_relation relations[] = {
	{ "PSNR that filling gains, dB", GAIN, TS_AT_LEAST, 0.5, 0, ALL,
	  TS_ELSEWHERE "few leaves are wider than a texel; see octree.levels", LEAVES },
	{ "PSNR of 256 texels above that of 64, dB", FINER, TS_AT_LEAST, 0, 0, ALL,
	  TS_ELSEWHERE "leaves are as wide as texels of 64; see octree.levels",
	  LEAVES },
	{ "PSNR from one level to the next", PSNR, TS_GROWS, 1, 0, ALL,
	  TS_NOT_ALWAYS "leaves are narrower than texels; see cube_view.px", LEAVES },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_mega_9 = {
	.name = "mega-9", .title = "MegaViews, figure 9", .effect = "reflections", .scenes = "atrium,gallery,dining",
	.objects_head = "octree.levels", .objects_param = "octree.levels", .objects = "8,9,10", .most = 11, .set = "",
	.defaults = "", .size = "width=320,height=180", .judge = "A",
	.note = "Maps of 256 x 256 texels a half, as the paper's. render reflections --method megaviews draws one view.",
	.variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
