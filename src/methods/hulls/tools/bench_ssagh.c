/* The SSAGH paper's table of frames per second for growing images. Speed-ups follow from the paper's own. */
#include "methods/hulls/tools/tools.h"

enum { M_HULLS, M_DIRECT, M_VMF };

/* clang-format off */
/* `direct` takes a minute, so it is timed once. */
static const ts_bench_variant variants[] = {
	[M_HULLS] = { "hulls", "", true, TS_TIMED },
	[M_DIRECT] = { "direct", "", true, TS_ONCE },
	[M_VMF] = { "hulls", "hull.sharpness=vmf", true, TS_ONCE },
	{ 0 },
};

enum { PIXELS, DIRECT_MS, HULLS_MS, DIRECT_RATE, HULLS_RATE, SPEEDUP, COST, BOXES, GATHERS, DIRECT_GATHERS, SAVED, RMSE,
       RELATIVE, RELATIVE_VMF, NEAR, ELSEWHERE, NEAR_SHARE, NEAR_ERROR, MEDIAN, BEYOND, UNLIT, GIVEN, PSNR, SSIM };

static const ts_bench_figure figures[] = {
	[PIXELS] = { "megapixels", "Mpixels", TS_FIGURE_PIXELS, 0, 0, 2, "" },
	[DIRECT_MS] = { "direct_ms", "direct, ms", TS_FIGURE_TIME, M_DIRECT, 0, 2, "" },
	[HULLS_MS] = { "hulls_ms", "hulls, ms", TS_FIGURE_TIME, M_HULLS, 0, 2, "" },
	[DIRECT_RATE] = { "direct_rate", "direct, 1/s", TS_FIGURE_RATE, DIRECT_MS, DIRECT_MS, 4, "" },
	[HULLS_RATE] = { "hulls_rate", "hulls, 1/s", TS_FIGURE_RATE, HULLS_MS, HULLS_MS, 4, "" },
	[SPEEDUP] = { "speedup", "direct / hulls", TS_FIGURE_RATIO, DIRECT_MS, HULLS_MS, 2, "" },
	[COST] = { "direct_ns", "direct, ns a pixel", TS_FIGURE_RATIO, DIRECT_MS, PIXELS, 1, "" },
	[BOXES] = { "boxes", "boxes", TS_FIGURE_COUNTER, M_HULLS, 0, TS_WHOLE, "boxes" },
	[GATHERS] = { "hulls_gathers", "hulls", TS_FIGURE_COUNTER, M_HULLS, 0, TS_WHOLE, "gathers" },
	[DIRECT_GATHERS] = { "direct_gathers", "direct", TS_FIGURE_COUNTER, M_DIRECT, 0, TS_WHOLE, "gathers" },
	[SAVED] = { "gathers_ratio", "direct / hulls", TS_FIGURE_RATIO, DIRECT_GATHERS, GATHERS, 2, "" },
	[RMSE] = { "rmse", "RMSE", TS_FIGURE_RMSE, M_HULLS, M_DIRECT, 3, "" },
	[RELATIVE] = { "relative_rmse", "relative", TS_FIGURE_RELATIVE, M_HULLS, M_DIRECT, 4, "" },
	[RELATIVE_VMF] = { "relative_rmse_vmf", "with vmf", TS_FIGURE_RELATIVE, M_VMF, M_DIRECT, 4, "" },
	[NEAR] = { "relative_rmse_near", "RMSE, near", TS_FIGURE_NEAR, M_HULLS, M_DIRECT, 4, "" },
	[ELSEWHERE] = { "relative_rmse_elsewhere", "elsewhere", TS_FIGURE_ELSEWHERE, M_HULLS, M_DIRECT, 4, "" },
	[NEAR_SHARE] = { "near_percent", "near, % of pixels", TS_FIGURE_NEAR_SHARE, M_HULLS, M_DIRECT, 2, "" },
	[NEAR_ERROR] = { "near_error_percent", "of squared error", TS_FIGURE_NEAR_ERROR, M_HULLS, M_DIRECT, 2, "" },
	[MEDIAN] = { "median_error", "median error", TS_FIGURE_MEDIAN, M_HULLS, M_DIRECT, 4, "" },
	[BEYOND] = { "beyond_percent", "above 10 %, %", TS_FIGURE_BEYOND, M_HULLS, M_DIRECT, 2, "" },
	[UNLIT] = { "unlit_pixels", "unlit pixels", TS_FIGURE_UNLIT, M_HULLS, M_DIRECT, TS_WHOLE, "" },
	[GIVEN] = { "unlit_percent", "mean, %", TS_FIGURE_GIVEN, M_HULLS, M_DIRECT, 2, "" },
	[PSNR] = { "psnr", "PSNR", TS_FIGURE_PSNR, M_HULLS, M_DIRECT, 2, "" },
	[SSIM] = { "ssim", "SSIM", TS_FIGURE_SSIM, M_HULLS, M_DIRECT, 4, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "ssagh_1", "SSAGH, table 1: whole frames", { DIRECT_MS, HULLS_MS, DIRECT_RATE, HULLS_RATE, SPEEDUP, COST,
	  TS_NO_FIGURE } },
	{ "ssagh_1_gathers", "Gathers, pixels or corners by triangles of light; RMSE of hulls to direct, grey levels; and "
	  "in radiance", { BOXES, GATHERS, DIRECT_GATHERS, SAVED, RMSE, RELATIVE,
	  RELATIVE_VMF, TS_NO_FIGURE } },
	{ "ssagh_1_light", "Relative errors of hulls to direct in radiance; near: within a side of the middle of a "
	  "triangle of light", { NEAR, ELSEWHERE, NEAR_SHARE, NEAR_ERROR, MEDIAN, BEYOND, TS_NO_FIGURE } },
	{ "ssagh_1_images", "SSAGH, figure 8: images of hulls beside those of direct, PSNR in dB", { PSNR, SSIM,
	  TS_NO_FIGURE } },
	{ "ssagh_1_unlit", "Pixels that have light of hulls and none of direct; their mean radiance by that of direct",
	  { UNLIT, GIVEN, TS_NO_FIGURE } },
	{ 0 },
};

/* The least over the paper's scenes, for images of `least` to `most` million pixels. */
#define FASTER(bound, least, most) \
	{ "direct / hulls", SPEEDUP, TS_AT_LEAST, bound, 0, PIXELS, least, most, \
	  TS_GPU "gathers are not most of the work; see rsm.px", SAVED }

static const ts_paper_relation relations[] = {
	FASTER(5.01, 0.92, 2.07), FASTER(9.48, 2.07, 4.09), FASTER(11.92, 4.09, 9.21), FASTER(16.80, 9.21, 1e6),
	{ "direct / hulls, from size to size", SPEEDUP, TS_GROWS, 1, 0, TS_NO_FIGURE, 0, 0,
	  TS_GPU "what hulls do besides gathering grows with pixels, too; see depth_grid.px", SAVED },
	{ "gathers of direct by those of hulls", SAVED, TS_AT_LEAST, 5.01, 0, PIXELS, 0.92, 1e6,
	  TS_ELSEWHERE "many boxes; see depth_grid.px", BOXES },
	{ "gathers of hulls, most by least", GATHERS, TS_STEADY, 0, 1.1, TS_NO_FIGURE, 0, 0,
	  TS_ELSEWHERE "the grid is finer than the smaller image; see depth_grid.px=512", BOXES },
	{ "direct, ns a pixel, most by least", COST, TS_STEADY, 0, 1.25, TS_NO_FIGURE, 0, 0,
	  TS_GPU "what is not gathering counts in small images; see rsm.px", DIRECT_MS },
	{ "PSNR of hulls to direct, dB", PSNR, TS_AT_LEAST, 30, 0, TS_NO_FIGURE, 0, 0,
	  TS_NOT_ALWAYS "one Gaussian is too narrow near triangles of light; see hull.sharpness=vmf", NEAR_ERROR },
	{ "SSIM of hulls to direct", SSIM, TS_AT_LEAST, 0.9, 0, TS_NO_FIGURE, 0, 0,
	  TS_NOT_ALWAYS "one Gaussian has no light from both sides; see hull.sharpness=vmf", GIVEN },
	{ "RMSE elsewhere than near triangles of light", ELSEWHERE, TS_AT_MOST, 0, 0.2, TS_NO_FIGURE, 0, 0,
	  TS_NOT_ALWAYS "one Gaussian has no light from both sides; see hull.sharpness=vmf", GIVEN },
	{ "median error of a pixel", MEDIAN, TS_AT_MOST, 0, 0.15, TS_NO_FIGURE, 0, 0,
	  TS_NOT_ALWAYS "one Gaussian has no light from both sides; see hull.sharpness=vmf", GIVEN },
	{ 0 },
};

#define ROW(scene, builtin, file, w, h, direct, hulls) \
	{ scene, builtin, file, (w) * (h), { [PIXELS] = 1e-6 * (w) * (h), [DIRECT_MS] = 1e3 / (direct), \
	  [HULLS_MS] = 1e3 / (hulls) } }

static const ts_paper_row rows[] = {
	ROW("Bunny/Sphere/Dragon", "gallery", "bunny", 1280, 720, 30.45, 179.34),
	ROW("Bunny/Sphere/Dragon", "gallery", "bunny", 1920, 1080, 11.37, 172.51),
	ROW("Bunny/Sphere/Dragon", "gallery", "bunny", 2560, 1600, 6.27, 130.16),
	ROW("Bunny/Sphere/Dragon", "gallery", "bunny", 3840, 2400, 2.71, 80.48),
	ROW("Crytek Sponza", "atrium", "sponza", 1280, 720, 28.38, 142.26),
	ROW("Crytek Sponza", "atrium", "sponza", 1920, 1080, 10.59, 100.36),
	ROW("Crytek Sponza", "atrium", "sponza", 2560, 1600, 6.10, 72.71),
	ROW("Crytek Sponza", "atrium", "sponza", 3840, 2400, 2.44, 40.98),
	ROW("Conference", "dining", "breakfast", 1280, 720, 28.55, 170.42),
	ROW("Conference", "dining", "breakfast", 1920, 1080, 10.67, 145.11),
	ROW("Conference", "dining", "breakfast", 2560, 1600, 6.22, 103.10),
	ROW("Conference", "dining", "breakfast", 3840, 2400, 2.52, 63.23),
	{ 0 },
};

const ts_paper_table ts_ssagh_1 = {
	.name = "ssagh-1", .title = "SSAGH, table 1: who runs", .effect = "indirect", .scenes = "atrium,gallery,dining",
	.models = "sponza.glb,sibenik.glb,breakfast_room.glb", .own_camera = true, .objects_head = "pixels",
	.objects = "1280x720,1920x1080,2560x1600,3840x2400", .set = "reflectors.count=0", .defaults = "",
	.note = "A light of the paper is 256 triangles.",
	.timed = true, .variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
