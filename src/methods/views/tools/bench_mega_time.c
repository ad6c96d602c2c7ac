/* Many views with small maps against few with large ones in the same time: the paper's figure 14. */
#include "methods/views/tools/tools.h"

#define FEW(n) "view_map.px=1024,vpl_gather.lights=0,vpl.paths=" #n

enum { MANY, FEW_1, FEW_4, FEW_18 };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[MANY] = { "megaviews", "view_map.px=16", true, TS_TIMED },
	[FEW_1] = { "megaviews", FEW(1), true, TS_TIMED },
	[FEW_4] = { "megaviews", FEW(4), true, TS_TIMED },
	[FEW_18] = { "megaviews", FEW(18), true, TS_TIMED },
	{ 0 },
};

enum { MS, MS_1, MS_4, MS_18, TIME_1, TIME_4, TIME_18, PSNR, PSNR_1, PSNR_4, PSNR_18, SSIM, SSIM_1, SSIM_4, SSIM_18,
	MORE_1, MORE_4, MORE_18, SSIM_MORE_1, SSIM_MORE_4, SSIM_MORE_18 };

#define OF_FEW(n) \
	[MS_##n] = { "ms_" #n, #n, TS_FIGURE_TIME, FEW_##n, 0, 0, "" }, \
	[TIME_##n] = { "time_" #n, #n " by many", TS_FIGURE_RATIO, MS_##n, MS, 2, "" }, \
	[PSNR_##n] = { "psnr_" #n, #n, TS_FIGURE_PSNR, FEW_##n, 0, 2, "" }, \
	[SSIM_##n] = { "ssim_" #n, #n, TS_FIGURE_SSIM, FEW_##n, 0, 4, "" }, \
	[MORE_##n] = { "psnr_more_than_" #n, "more than " #n, TS_FIGURE_DIFFERENCE, PSNR, PSNR_##n, 2, "" }, \
	[SSIM_MORE_##n] = { "ssim_more_than_" #n, "more than " #n, TS_FIGURE_DIFFERENCE, SSIM, SSIM_##n, 4, "" }
static const ts_bench_figure figures[] = {
	[MS] = { "ms", "many", TS_FIGURE_TIME, MANY, 0, 0, "" },
	[PSNR] = { "psnr", "PSNR, many", TS_FIGURE_PSNR, MANY, 0, 2, "" },
	[SSIM] = { "ssim", "SSIM, many", TS_FIGURE_SSIM, MANY, 0, 4, "" },
	OF_FEW(1), OF_FEW(4), OF_FEW(18), { 0 },
};

static const ts_paper_part parts[] = {
	{ "mega_14", "MegaViews, figure 14: frames, ms, of many views with 16 texels a side, and of few with 1024", { MS,
	  MS_1, MS_4, MS_18, TIME_1, TIME_4, TIME_18, TS_NO_FIGURE } },
	{ "mega_14_psnr", "Their pictures beside truth `vpls` of the many, dB", { PSNR, PSNR_1, PSNR_4, PSNR_18, MORE_1,
	  MORE_4, MORE_18, TS_NO_FIGURE } },
	{ "mega_14_ssim", "The same, SSIM", { SSIM, SSIM_1, SSIM_4, SSIM_18, SSIM_MORE_1, SSIM_MORE_4, SSIM_MORE_18,
	  TS_NO_FIGURE } },
	{ 0 },
};

/* Where the few views take half the time or more. */
#define AS_LONG(n) \
	{ "PSNR of many less that of " #n ", no faster", MORE_##n, TS_AT_LEAST, 0, 0, TIME_##n, 0.5, 1e9, \
	  TS_NOT_ALWAYS "maps of 16 texels answer too coarsely; see view_map.px", PSNR }, \
	{ "SSIM, of " #n, SSIM_MORE_##n, TS_AT_LEAST, 0, 0, TIME_##n, 0.5, 1e9, \
	  TS_NOT_ALWAYS "maps of 16 texels answer too coarsely; see view_map.px", SSIM }
static const ts_paper_relation relations[] = { AS_LONG(1), AS_LONG(4), AS_LONG(18), { 0 } };

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_mega_14 = {
	.name = "mega-14", .title = "MegaViews, figure 14", .effect = "indirect", .scenes = "atrium",
	.models = "sibenik.glb,sponza.glb", .own_camera = true, .objects_head = "paths", .objects_param = "vpl.paths",
	.objects = "4096",
	.most = 1 << 24, .set = "reflectors.count=0", .defaults = "octree.levels=8", .size = "width=160,height=90",
	.timed = true, .judge = "vpls",
	.note = "The paper has 65,536 views of 16 texels a side in the time of 18 of 1024, in its Hairball.",
	.variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
