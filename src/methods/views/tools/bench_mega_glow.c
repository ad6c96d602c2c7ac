/* Glowing particles with and without shadows, compared with rays to all of them: the paper's figure 17. */
#include "methods/views/tools/tools.h"

enum { SHADOWED, UNSHADOWED, LODS };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[SHADOWED] = { "megaviews", "", true, TS_ONCE },
	[UNSHADOWED] = { "megaviews", "vpl_gather.shadows=off", true, TS_ONCE },
	[LODS] = { "manylods", "", true, TS_ONCE },
	{ 0 },
};

enum { PSNR, PSNR_OFF, PSNR_LODS, SSIM, SSIM_OFF, SSIM_LODS, GAIN, SSIM_GAIN, UNDER_LODS, SERVED, RENDERED,
	SHARING, ASKED, DARK, DARK_SHARE };

static const ts_bench_figure figures[] = {
	[PSNR] = { "psnr", "PSNR", TS_FIGURE_PSNR, SHADOWED, 0, 2, "" },
	[PSNR_OFF] = { "psnr_off", "no shadows", TS_FIGURE_PSNR, UNSHADOWED, 0, 2, "" },
	[PSNR_LODS] = { "manylods_psnr", "ManyLoDs", TS_FIGURE_PSNR, LODS, 0, 2, "" },
	[SSIM] = { "ssim", "SSIM", TS_FIGURE_SSIM, SHADOWED, 0, 4, "" },
	[SSIM_OFF] = { "ssim_off", "no shadows", TS_FIGURE_SSIM, UNSHADOWED, 0, 4, "" },
	[SSIM_LODS] = { "manylods_ssim", "ManyLoDs", TS_FIGURE_SSIM, LODS, 0, 4, "" },
	[GAIN] = { "psnr_gain", "by shadows", TS_FIGURE_DIFFERENCE, PSNR, PSNR_OFF, 2, "" },
	[SSIM_GAIN] = { "ssim_gain", "by shadows", TS_FIGURE_DIFFERENCE, SSIM, SSIM_OFF, 4, "" },
	[UNDER_LODS] = { "psnr_over_manylods", "less ManyLoDs'", TS_FIGURE_DIFFERENCE, PSNR, PSNR_LODS, 2, "" },
	[SERVED] = { "served", "views served", TS_FIGURE_COUNTER, SHADOWED, 0, TS_WHOLE, "views served" },
	[RENDERED] = { "rendered", "rendered", TS_FIGURE_COUNTER, SHADOWED, 0, TS_WHOLE, "pairs rendered" },
	[SHARING] = { "sharing", "views a pair", TS_FIGURE_RATIO, SERVED, RENDERED, 2, "" },
	[ASKED] = { "asked", "asked", TS_FIGURE_COUNTER, SHADOWED, 0, TS_WHOLE, "shadows asked of rays" },
	[DARK] = { "dark", "dark", TS_FIGURE_COUNTER, SHADOWED, 0, TS_WHOLE, "dark but by rays" },
	[DARK_SHARE] = { "dark_percent", "dark but by rays, %", TS_FIGURE_PERCENT, DARK, ASKED, 2, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "mega_17", "MegaViews, figure 17: images of particles beside truth `glow`, PSNR in dB", { PSNR, PSNR_OFF, GAIN,
	  PSNR_LODS, UNDER_LODS, SSIM, SSIM_OFF, SSIM_GAIN, SSIM_LODS, SHARING, DARK_SHARE,
	  TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

static const ts_paper_relation relations[] = {
	{ "dB that shadows bring", GAIN, TS_AT_LEAST, 0, 0, ALL,
	  TS_NOT_ALWAYS "leaves throw more shadow than they have; see view_map.fill=0.5",
	  DARK_SHARE },
	{ "SSIM that shadows bring", SSIM_GAIN, TS_AT_LEAST, 0, 0, ALL,
	  TS_NOT_ALWAYS "leaves throw more shadow than they have; see view_map.fill=0.5",
	  DARK_SHARE },
	{ "dB over ManyLoDs", UNDER_LODS, TS_AT_LEAST, -0.5, 0, ALL,
	  TS_NOT_ALWAYS "what views of a leaf share is coarse; see octree.levels", SHARING },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_mega_17 = {
	.name = "mega-17", .title = "MegaViews, figure 17", .effect = "particles", .scenes = "atrium,gallery,dining",
	.objects_head = "particles", .objects_param = "particle.count", .objects = "256,1024", .most = 1 << 20,
	.set = "reflectors.count=0,vpl_gather.lights=0,bilateral.px=0", .defaults = "octree.levels=8",
	.size = "width=160,height=90", .judge = "glow", .rays = true,
	.note = "All pixels gather from all particles, unfiltered. The paper has 4,096 and 65,536, and 11 levels.",
	.variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
