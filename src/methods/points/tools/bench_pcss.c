/* iVIR's figure 5: soft shadows by PCSS and by 16 views of iVIR, beside those of 128 views of MVR. */
#include "benches.h"

enum { M_PCSS, M_IVIR, M_FEW, M_MVR };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[M_PCSS] = { "pcss", "", true, TS_TIMED },
	[M_IVIR] = { "ivir", "lamp.views=16", true, TS_TIMED },
	[M_FEW] = { "mvr", "lamp.views=16", true, TS_ONCE },
	[M_MVR] = { "mvr", "lamp.views=128", true, TS_ONCE },
	{ 0 },
};

enum { PCSS_MS, IVIR_MS, RATIO, PCSS_RMSE, IVIR_RMSE, FEW_RMSE, PSNR, IVIR_PSNR, SSIM, IVIR_SSIM, GAIN,
       SSIM_GAIN, TRIANGLES };

static const ts_bench_figure figures[] = {
	[PCSS_MS] = { "pcss_ms", "PCSS", TS_FIGURE_TIME, M_PCSS, 0, 2, "" },
	[IVIR_MS] = { "ivir_ms", "iVIR", TS_FIGURE_TIME, M_IVIR, 0, 2, "" },
	[RATIO] = { "ratio", "iVIR / PCSS", TS_FIGURE_RATIO, IVIR_MS, PCSS_MS, 2, "" },
	[PCSS_RMSE] = { "pcss_rmse", "PCSS, RMSE", TS_FIGURE_RMSE, M_PCSS, M_MVR, 3, "" },
	[IVIR_RMSE] = { "ivir_rmse", "iVIR", TS_FIGURE_RMSE, M_IVIR, M_MVR, 3, "" },
	[FEW_RMSE] = { "mvr_rmse", "MVR, 16", TS_FIGURE_RMSE, M_FEW, M_MVR, 3, "" },
	[PSNR] = { "pcss_psnr", "PCSS, PSNR", TS_FIGURE_PSNR, M_PCSS, M_MVR, 2, "" },
	[IVIR_PSNR] = { "ivir_psnr", "iVIR", TS_FIGURE_PSNR, M_IVIR, M_MVR, 2, "" },
	[SSIM] = { "pcss_ssim", "PCSS, SSIM", TS_FIGURE_SSIM, M_PCSS, M_MVR, 4, "" },
	[IVIR_SSIM] = { "ivir_ssim", "iVIR", TS_FIGURE_SSIM, M_IVIR, M_MVR, 4, "" },
	[GAIN] = { "psnr_gain", "dB more", TS_FIGURE_DIFFERENCE, IVIR_PSNR, PSNR, 2, "" },
	[SSIM_GAIN] = { "ssim_gain", "SSIM more", TS_FIGURE_DIFFERENCE, IVIR_SSIM, SSIM, 4, "" },
	[TRIANGLES] = { "triangles", "triangles", TS_FIGURE_TRIANGLES, 0, 0, TS_WHOLE, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "ivir_5", "iVIR, figure 5: images beside MVR's of 128 views, RMSE in grey levels, PSNR in dB", { PCSS_RMSE,
	  IVIR_RMSE, FEW_RMSE, PSNR, IVIR_PSNR, GAIN, SSIM, IVIR_SSIM, SSIM_GAIN, TS_NO_FIGURE } },
	{ "ivir_5_ms", "Whole frames, ms", { TRIANGLES, PCSS_MS, IVIR_MS, RATIO, TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

static const ts_paper_relation relations[] = {
	{ "dB of iVIR over PCSS", GAIN, TS_AT_LEAST, 0, 0, ALL, "16 views are few", FEW_RMSE },
	{ "SSIM of iVIR over PCSS", SSIM_GAIN, TS_AT_LEAST, 0, 0, ALL, "16 views are few", FEW_RMSE },
	{ "time of iVIR by PCSS", RATIO, TS_AT_MOST, 0, 1.1, ALL, "points are made on a processor, taps are few",
	  TRIANGLES },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_ivir_5 = {
	.name = "ivir-5", .title = "iVIR, figure 5: soft shadows", .effect = "soft-shadows",
	.scenes = "atrium,gallery,dining", .models = "bunny.glb,dragon_80k.glb", .set = "reflectors.count=0",
	.defaults = TS_IVIR_DEFAULTS, .timed = true, .variants = variants, .figures = figures,
	.parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
