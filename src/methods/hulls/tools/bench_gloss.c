/* Specular reflection by lobes (SSAGH eq. 6), compared with the BRDF itself in double precision: for the lobes of
 * hulls, and for every triangle of light; and the picture without. The paper has no figure of it. */
#include "methods/hulls/tools/tools.h"

enum { M_HULLS, M_DIRECT, M_WITHOUT };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[M_HULLS] = { "hulls", "", true, TS_ONCE },
	[M_DIRECT] = { "direct", "", true, TS_ONCE },
	[M_WITHOUT] = { "hulls", "gloss.lobe=off", true, TS_ONCE },
	{ 0 },
};

enum { RADIUS, PSNR, PSNR_DIRECT, PSNR_WITHOUT, SSIM, SSIM_DIRECT, SSIM_WITHOUT, ERROR, ERROR_DIRECT, ERROR_WITHOUT,
	GAIN, SSIM_GAIN };

static const ts_bench_figure figures[] = {
	[RADIUS] = { "radius", "lamp.radius", TS_FIGURE_PARAM, 0, 0, 2, "lamp.radius" },
	[PSNR] = { "psnr", "hulls: PSNR, dB", TS_FIGURE_PSNR, M_HULLS, 0, 2, "" },
	[PSNR_DIRECT] = { "direct_psnr", "direct", TS_FIGURE_PSNR, M_DIRECT, 0, 2, "" },
	[PSNR_WITHOUT] = { "without_psnr", "without", TS_FIGURE_PSNR, M_WITHOUT, 0, 2, "" },
	[SSIM] = { "ssim", "hulls: SSIM", TS_FIGURE_SSIM, M_HULLS, 0, 4, "" },
	[SSIM_DIRECT] = { "direct_ssim", "direct", TS_FIGURE_SSIM, M_DIRECT, 0, 4, "" },
	[SSIM_WITHOUT] = { "without_ssim", "without", TS_FIGURE_SSIM, M_WITHOUT, 0, 4, "" },
	[ERROR] = { "relative_rmse", "hulls: relative", TS_FIGURE_RELATIVE, M_HULLS, 0, 4, "" },
	[ERROR_DIRECT] = { "direct_relative_rmse", "direct", TS_FIGURE_RELATIVE, M_DIRECT, 0, 4, "" },
	[ERROR_WITHOUT] = { "without_relative_rmse", "without", TS_FIGURE_RELATIVE, M_WITHOUT, 0, 4, "" },
	[GAIN] = { "psnr_gain", "PSNR gained", TS_FIGURE_DIFFERENCE, PSNR, PSNR_WITHOUT, 2, "" },
	[SSIM_GAIN] = { "ssim_gain", "SSIM gained", TS_FIGURE_DIFFERENCE, SSIM, SSIM_WITHOUT, 4, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "ssagh_gloss", "Specular reflection by lobes, beside the BRDF in double precision: hulls, direct, and hulls "
	  "without", { RADIUS, PSNR, PSNR_DIRECT, PSNR_WITHOUT, SSIM, SSIM_DIRECT, SSIM_WITHOUT, ERROR, ERROR_DIRECT,
	  ERROR_WITHOUT, GAIN, SSIM_GAIN, TS_NO_FIGURE } },
	{ 0 },
};

#define AT_LEAST(text, figure, bound, because) \
	{ text, figure, TS_AT_LEAST, bound, 0, TS_NO_FIGURE, 0, 0, because, RADIUS }
#define BROAD TS_NOT_ALWAYS "one lobe is too broad beside a broad lamp; see lamp.radius=0.1"

static const ts_paper_relation relations[] = {
	AT_LEAST("dB that specular lobes bring", GAIN, 0, BROAD),
	AT_LEAST("SSIM that they bring", SSIM_GAIN, 0, BROAD),
	AT_LEAST("PSNR of lobes of triangles, dB", PSNR_DIRECT, 35,
	  TS_NOT_ALWAYS "the BRDF is no Gaussian; see gloss.lobe"),
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_ssagh_gloss = {
	.name = "ssagh-gloss", .title = "SSAGH, eq. 6 with a specular lobe", .effect = "area-light",
	.scenes = "atrium,gallery,dining", .models = "sponza.glb,sibenik.glb,breakfast_room.glb", .own_camera = true,
	.set = "reflectors.count=0,gloss.lobe=on", .defaults = "lamp.radius=0.25", .size = "width=480,height=270",
	.judge = "exact", .variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
