/* The pictures of SSAGH's figures 2 to 4: a grid without segments, a constant cosine and a Gaussian one, each beside
 * the default method; and the convolution by quadrature in place of the closed form. */
#include "methods/hulls/tools/tools.h"

enum { OURS, GRID, CONSTANT, GAUSSIAN, QUADRATURE, METHODS, DIRECT = METHODS };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[OURS] = { "hulls", "", true, TS_ONCE },
	[GRID] = { "hulls", "segment.method=none", true, TS_ONCE },
	[CONSTANT] = { "hulls", "hull.cosine=constant", true, TS_ONCE },
	[GAUSSIAN] = { "hulls", "hull.cosine=sg", true, TS_ONCE },
	[QUADRATURE] = { "hulls", "hull.cosine=quadrature", true, TS_ONCE },
	[DIRECT] = { "direct", "", true, TS_ONCE },
	{ 0 },
};

enum { PSNR, SSIM = METHODS, ELSEWHERE = 2 * METHODS, MEDIAN = 3 * METHODS, GIVEN = 4 * METHODS,
       MORE_GRID = 5 * METHODS, MORE_CONSTANT, MORE_GAUSSIAN, MORE_QUADRATURE, ERROR_GRID, ERROR_CONSTANT,
       ERROR_GAUSSIAN, ERROR_QUADRATURE, TAILS, BOXES };

#define EACH(first, key, kind, digits) \
	[(first) + OURS] = { key, "as it is", kind, OURS, DIRECT, digits, "" }, \
	[(first) + GRID] = { key "_grid", "grid", kind, GRID, DIRECT, digits, "" }, \
	[(first) + CONSTANT] = { key "_constant", "constant", kind, CONSTANT, DIRECT, digits, "" }, \
	[(first) + GAUSSIAN] = { key "_gaussian", "Gaussian", kind, GAUSSIAN, DIRECT, digits, "" }, \
	[(first) + QUADRATURE] = { key "_quadrature", "quadrature", kind, QUADRATURE, DIRECT, digits, "" }
#define MORE(id, key, head) \
	[MORE_##id] = { "psnr_over_" key, head, TS_FIGURE_DIFFERENCE, PSNR + OURS, PSNR + id, 2, "" }
#define RATIO(id, key, head) \
	[ERROR_##id] = { key "_ratio", head, TS_FIGURE_RATIO, ELSEWHERE + id, ELSEWHERE + OURS, 3, "" }

static const ts_bench_figure figures[] = {
	EACH(PSNR, "psnr", TS_FIGURE_PSNR, 2), EACH(SSIM, "ssim", TS_FIGURE_SSIM, 4),
	EACH(ELSEWHERE, "elsewhere", TS_FIGURE_ELSEWHERE, 4), EACH(MEDIAN, "median", TS_FIGURE_MEDIAN, 4),
	EACH(GIVEN, "unlit", TS_FIGURE_GIVEN, 2),
	MORE(GRID, "grid", "over grid"), MORE(CONSTANT, "constant", "over constant"),
	MORE(GAUSSIAN, "gaussian", "over Gaussian"), MORE(QUADRATURE, "quadrature", "over quadrature"),
	RATIO(GRID, "grid", "grid by ours"), RATIO(CONSTANT, "constant", "constant by ours"),
	RATIO(GAUSSIAN, "gaussian", "Gaussian by ours"),
	RATIO(QUADRATURE, "quadrature", "quadrature by ours"),
	[TAILS] = { "tails_ratio", "Gaussian by ours", TS_FIGURE_RATIO, GIVEN + GAUSSIAN, GIVEN + OURS, 2, "" },
	[BOXES] = { "boxes", "boxes", TS_FIGURE_COUNTER, OURS, 0, TS_WHOLE, "boxes" },
	{ 0 },
};

#define OF(first) (first) + OURS, (first) + GRID, (first) + CONSTANT, (first) + GAUSSIAN, (first) + QUADRATURE

static const ts_paper_part parts[] = {
	{ "ssagh_2", "SSAGH, figures 2 to 4: PSNR to direct, dB", { OF(PSNR), TS_NO_FIGURE } },
	{ "ssagh_2_over", "The method as it is less another choice, dB", { MORE_GRID, MORE_CONSTANT, MORE_GAUSSIAN,
	  MORE_QUADRATURE, TS_NO_FIGURE } },
	{ "ssagh_2_ssim", "SSIM", { OF(SSIM), TS_NO_FIGURE } },
	{ "ssagh_2_elsewhere", "Relative RMSE in radiance elsewhere than near triangles of light", { OF(ELSEWHERE),
	  TS_NO_FIGURE } },
	{ "ssagh_2_ratios", "The same by that of the method as it is", { ERROR_GRID, ERROR_CONSTANT, ERROR_GAUSSIAN,
	  ERROR_QUADRATURE, TS_NO_FIGURE } },
	{ "ssagh_2_median", "Median error of a pixel", { OF(MEDIAN), TS_NO_FIGURE } },
	{ "ssagh_2_unlit", "Mean radiance of pixels that direct leaves dark, % of the mean of direct", { OF(GIVEN), TAILS,
	  TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

/* A picture with another choice, and its error, beside ours. */
#define WORSE(id, what, because, cause) \
	{ what ": dB that ours brings", MORE_##id, TS_AT_LEAST, 0, 0, ALL, because, cause }, \
	{ what ": RMSE elsewhere, by ours", ERROR_##id, TS_AT_LEAST, 1, 0, ALL, because, cause }

static const ts_paper_relation relations[] = {
	WORSE(GRID, "grid", TS_NOT_ALWAYS "few edges in depth; see segment.method", BOXES),
	WORSE(CONSTANT, "constant cosine", TS_NOT_ALWAYS "lights are small; see hull.cosine", ELSEWHERE + OURS),
	WORSE(GAUSSIAN, "Gaussian cosine", TS_NOT_ALWAYS "lights are small; see hull.cosine", ELSEWHERE + OURS),
	{ "Gaussian cosine: light where there is none, by ours", TAILS, TS_AT_LEAST, 1, 0, ALL,
	  TS_NOT_ALWAYS "its tail is shorter; see hull.cosine",
	  GIVEN + OURS },
	{ "quadrature: dB over ours, less", MORE_QUADRATURE, TS_AT_LEAST, -0.1, 0, ALL,
	  TS_NOT_ALWAYS "eqs 15 to 18 are not exact; see hull.cosine=quadrature",
	  ERROR_QUADRATURE },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_ssagh_2 = {
	.name = "ssagh-2", .title = "SSAGH, figures 2 to 4", .effect = "indirect", .scenes = "atrium,gallery,dining",
	.models = "sponza.glb,sibenik.glb,breakfast_room.glb", .own_camera = true, .objects_head = "pixels",
	.objects = "960x540",
	.set = "reflectors.count=0", .defaults = "", .note = "Light of one bounce, where the paper's figures have lights "
	"of an area.", .variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
