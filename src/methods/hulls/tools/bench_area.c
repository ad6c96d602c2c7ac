/* Figures 3 and 4 of the SSAGH paper: a broad lamp with hulls, by the paper's integral of lobe and cosine and by
 * another, compared with light that every pixel gathers itself. Eq. 7, the constant cosine of figure 3, leaves black
 * the surfaces that the lobe's middle is behind; eq. 8, the Gaussian cosine of figure 4, lights surfaces that are
 * turned away. */
#include "methods/hulls/tools/tools.h"

enum { M_DIRECT, M_OURS, M_OTHER };

/* clang-format off */
#define VARIANTS(other) { { "direct", "", true, TS_ONCE }, { "hulls", "", true, TS_ONCE }, \
	{ "hulls", "hull.cosine=" other, true, TS_ONCE }, { 0 } }

static const ts_bench_variant constant[] = VARIANTS("constant"), gaussian[] = VARIANTS("sg");

enum { RADIUS, OURS_PSNR, OTHER_PSNR, OURS_SSIM, OTHER_SSIM, OURS_ERROR, OTHER_ERROR, GAIN, SSIM_GAIN, MORE, OURS_DARK,
       OTHER_DARK, OURS_TAIL, OTHER_TAIL, LONGER };

static const ts_bench_figure figures[] = {
	[RADIUS] = { "radius", "lamp.radius", TS_FIGURE_PARAM, 0, 0, 2, "lamp.radius" },
	[OURS_PSNR] = { "ours_psnr", "ours: PSNR, dB", TS_FIGURE_PSNR, M_OURS, M_DIRECT, 2, "" },
	[OTHER_PSNR] = { "other_psnr", "other: PSNR, dB", TS_FIGURE_PSNR, M_OTHER, M_DIRECT, 2, "" },
	[OURS_SSIM] = { "ours_ssim", "SSIM", TS_FIGURE_SSIM, M_OURS, M_DIRECT, 5, "" },
	[OTHER_SSIM] = { "other_ssim", "SSIM", TS_FIGURE_SSIM, M_OTHER, M_DIRECT, 5, "" },
	[OURS_ERROR] = { "ours_relative_rmse", "relative", TS_FIGURE_RELATIVE, M_OURS, M_DIRECT, 4, "" },
	[OTHER_ERROR] = { "other_relative_rmse", "relative", TS_FIGURE_RELATIVE, M_OTHER, M_DIRECT, 4, "" },
	[GAIN] = { "psnr_gain", "PSNR gained", TS_FIGURE_DIFFERENCE, OURS_PSNR, OTHER_PSNR, 2, "" },
	[SSIM_GAIN] = { "ssim_gain", "SSIM gained", TS_FIGURE_DIFFERENCE, OURS_SSIM, OTHER_SSIM, 5, "" },
	[MORE] = { "error_ratio", "relative, other / ours", TS_FIGURE_RATIO, OTHER_ERROR, OURS_ERROR, 2, "" },
	[OURS_DARK] = { "ours_dark", "ours: black", TS_FIGURE_UNLIT, M_DIRECT, M_OURS, TS_WHOLE, "" },
	[OTHER_DARK] = { "other_dark", "other: black", TS_FIGURE_UNLIT, M_DIRECT, M_OTHER, TS_WHOLE, "" },
	[OURS_TAIL] = { "ours_tail_percent", "ours: tail, %", TS_FIGURE_GIVEN, M_OURS, M_DIRECT, 3, "" },
	[OTHER_TAIL] = { "other_tail_percent", "other: tail, %", TS_FIGURE_GIVEN, M_OTHER, M_DIRECT, 3, "" },
	[LONGER] = { "tail_ratio", "other / ours", TS_FIGURE_RATIO, OTHER_TAIL, OURS_TAIL, 2, "" },
	{ 0 },
};

#define PARTS(key, title) { \
	{ key, title, { RADIUS, OURS_PSNR, OURS_SSIM, OURS_ERROR, OTHER_PSNR, OTHER_SSIM, OTHER_ERROR, TS_NO_FIGURE } }, \
	{ key "_gained", "What is gained; lit pixels that hulls leave black; mean radiance of unlit ones, by the image's", \
	  { GAIN, SSIM_GAIN, MORE, OURS_DARK, OTHER_DARK, OURS_TAIL, OTHER_TAIL, LONGER, TS_NO_FIGURE } }, { 0 } }

static const ts_paper_part constant_parts[] = PARTS("ssagh_3", "SSAGH, figure 3: hulls by eqs 15 to 18, and by a "
	"constant cosine, to light of every pixel");
static const ts_paper_part gaussian_parts[] = PARTS("ssagh_4", "SSAGH, figure 4: hulls by eqs 15 to 18, and by a "
	"Gaussian cosine, to light of every pixel");

#define AT_LEAST(text, figure, bound, because) \
	{ text, figure, TS_AT_LEAST, bound, 0, TS_NO_FIGURE, 0, 0, because, RADIUS }
#define ANOTHER TS_NOT_ALWAYS "one Gaussian errs more; see hull.sharpness=vmf"
#define NEARER \
	AT_LEAST("PSNR of ours above the other's, dB", GAIN, 3, ANOTHER), \
	AT_LEAST("SSIM above it", SSIM_GAIN, 0, ANOTHER), \
	AT_LEAST("relative RMSE of the other / ours", MORE, 1, ANOTHER)
#define TURNED TS_ELSEWHERE "no surface in sight is turned so; see lamp.radius"

static const ts_paper_relation constant_relations[] = {
	NEARER, AT_LEAST("lit pixels that the constant cosine leaves black", OTHER_DARK, 1, TURNED), { 0 } };
static const ts_paper_relation gaussian_relations[] = {
	NEARER, AT_LEAST("tail of the Gaussian cosine / ours", LONGER, 1, TURNED), { 0 } };

static const ts_paper_row rows[] = { { 0 } };

#define TABLE \
	.effect = "area-light", .scenes = "atrium,gallery,dining", .models = "sponza.glb,sibenik.glb,breakfast_room.glb", \
	.own_camera = true, \
	.set = "reflectors.count=0", .defaults = "lamp.radius=0.25", .size = "width=960,height=540", .figures = figures, \
	.rows = rows

const ts_paper_table ts_ssagh_3 = {
	.name = "ssagh-3", .title = "SSAGH, figure 3: who runs", TABLE, .variants = constant, .parts = constant_parts,
	.relations = constant_relations,
};

const ts_paper_table ts_ssagh_4 = {
	.name = "ssagh-4", .title = "SSAGH, figure 4: who runs", TABLE, .variants = gaussian, .parts = gaussian_parts,
	.relations = gaussian_relations,
};
/* clang-format on */
