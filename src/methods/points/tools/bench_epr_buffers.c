/* What EPR's sections 3.4 and 3.5 say of variants: without buffers of points, and with cubes of colours. */
#include "benches.h"

enum { M_EPR, M_BUFFERLESS, M_FORWARD, M_FORWARD_EYE, M_MVR, M_MVR_ADAPTIVE };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[M_EPR] = { "epr", "lookup.bounces=1", true, TS_TIMED },
	[M_BUFFERLESS] = { "epr-bufferless", "lookup.bounces=1", true, TS_TIMED },
	[M_FORWARD] = { "epr-forward", "", true, TS_TIMED },
	[M_FORWARD_EYE] = { "epr-forward", "forward.viewer=eye", true, TS_ONCE },
	[M_MVR] = { "mvr", "", true, TS_ONCE },
	[M_MVR_ADAPTIVE] = { "mvr", "mvr.faces=adaptive", false, TS_ONCE },
	{ 0 },
};

enum { POINTS, EPR_OPS, FORWARD_OPS, MVR_OPS, TEXEL_OPS, SAVED_OPS, BY_DEFERRED, EPR_MIB, BUFFERLESS_MIB, FORWARD_MIB,
	SAVED_MIB, EPR_MS, BUFFERLESS_MS, FORWARD_MS, SLOWER, FORWARD_SLOWER, EPR_RMSE, BUFFERLESS_RMSE, FORWARD_RMSE,
	EYE_RMSE, MVR_RMSE, BUFFERLESS_MORE, FORWARD_MORE, EPR_SSIM, BUFFERLESS_SSIM, FORWARD_SSIM, EYE_SSIM, MVR_SSIM };

static const ts_bench_figure figures[] = {
	[POINTS] = { "points", "points", TS_FIGURE_COUNTER, M_EPR, 0, TS_WHOLE, "points" },
	[EPR_OPS] = { "epr_ops", "EPR ops", TS_FIGURE_COUNTER, M_EPR, 0, TS_WHOLE, "shading operations" },
	[FORWARD_OPS] = { "forward_ops", "forward", TS_FIGURE_COUNTER, M_FORWARD, 0, TS_WHOLE, "shading operations" },
	[MVR_OPS] = { "mvr_ops", "MVR", TS_FIGURE_COUNTER, M_MVR, 0, TS_WHOLE, "shading operations" },
	[TEXEL_OPS] = { "texel_ops", "of EPR's texels", TS_FIGURE_COUNTER, M_MVR_ADAPTIVE, 0, TS_WHOLE,
	  "shading operations" },
	[SAVED_OPS] = { "texels_by_forward", "by forward's", TS_FIGURE_RATIO, TEXEL_OPS, FORWARD_OPS, 2, "" },
	[BY_DEFERRED] = { "forward_by_epr", "forward / EPR", TS_FIGURE_RATIO, FORWARD_OPS, EPR_OPS, 2, "" },
	[EPR_MIB] = { "epr_mib", "EPR", TS_FIGURE_BUFFERS, M_EPR, 0, 2, "points" },
	[BUFFERLESS_MIB] = { "bufferless_mib", "bufferless", TS_FIGURE_BUFFERS, M_BUFFERLESS, 0, 2, "points" },
	[FORWARD_MIB] = { "forward_mib", "forward", TS_FIGURE_BUFFERS, M_FORWARD, 0, 2, "points,forward" },
	[SAVED_MIB] = { "saved", "saved, %", TS_FIGURE_SAVED, BUFFERLESS_MIB, EPR_MIB, 1, "" },
	[EPR_MS] = { "epr_ms", "EPR", TS_FIGURE_TIME, M_EPR, 0, 2, "" },
	[BUFFERLESS_MS] = { "bufferless_ms", "bufferless", TS_FIGURE_TIME, M_BUFFERLESS, 0, 2, "" },
	[FORWARD_MS] = { "forward_ms", "forward", TS_FIGURE_TIME, M_FORWARD, 0, 2, "" },
	[SLOWER] = { "bufferless_by_epr", "bufferless / EPR", TS_FIGURE_RATIO, BUFFERLESS_MS, EPR_MS, 2, "" },
	[FORWARD_SLOWER] = { "forward_ms_by_epr", "forward / EPR", TS_FIGURE_RATIO, FORWARD_MS, EPR_MS, 2, "" },
	[EPR_RMSE] = { "epr_rmse", "EPR", TS_FIGURE_RMSE, M_EPR, M_EPR, 3, "" },
	[BUFFERLESS_RMSE] = { "bufferless_rmse", "bufferless", TS_FIGURE_RMSE, M_BUFFERLESS, M_BUFFERLESS, 3, "" },
	[FORWARD_RMSE] = { "forward_rmse", "forward", TS_FIGURE_RMSE, M_FORWARD, M_FORWARD, 3, "" },
	[EYE_RMSE] = { "eye_rmse", "for the eye", TS_FIGURE_RMSE, M_FORWARD_EYE, M_FORWARD_EYE, 3, "" },
	[MVR_RMSE] = { "mvr_rmse", "MVR", TS_FIGURE_RMSE, M_MVR, M_MVR, 3, "" },
	[BUFFERLESS_MORE] = { "bufferless_more", "bufferless, %", TS_FIGURE_MORE, BUFFERLESS_RMSE, EPR_RMSE, 3, "" },
	[FORWARD_MORE] = { "forward_more", "forward, %", TS_FIGURE_MORE, FORWARD_RMSE, EPR_RMSE, 3, "" },
	[EPR_SSIM] = { "epr_ssim", "EPR", TS_FIGURE_SSIM, M_EPR, M_EPR, 4, "" },
	[BUFFERLESS_SSIM] = { "bufferless_ssim", "bufferless", TS_FIGURE_SSIM, M_BUFFERLESS, M_BUFFERLESS, 4, "" },
	[FORWARD_SSIM] = { "forward_ssim", "forward", TS_FIGURE_SSIM, M_FORWARD, M_FORWARD, 4, "" },
	[EYE_SSIM] = { "eye_ssim", "for the eye", TS_FIGURE_SSIM, M_FORWARD_EYE, M_FORWARD_EYE, 4, "" },
	[MVR_SSIM] = { "mvr_ssim", "MVR", TS_FIGURE_SSIM, M_MVR, M_MVR, 4, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "epr_buffers_work", "shading operations: of look-ups by EPR, of points forward, of texels by MVR", { POINTS,
	  EPR_OPS, FORWARD_OPS, BY_DEFERRED, MVR_OPS, TEXEL_OPS, SAVED_OPS, TS_NO_FIGURE } },
	{ "epr_buffers_mib", "buffers of points and of their counts, MiB", { EPR_MIB, BUFFERLESS_MIB, SAVED_MIB,
	  FORWARD_MIB, TS_NO_FIGURE } },
	{ "epr_buffers_ms", "the whole frame, ms", { EPR_MS, BUFFERLESS_MS, SLOWER, FORWARD_MS, FORWARD_SLOWER,
	  TS_NO_FIGURE } },
	{ "epr_buffers_rmse", "RMSE to the truth in grey levels, and less EPR's in percent of 255", { EPR_RMSE,
	  BUFFERLESS_RMSE, FORWARD_RMSE, EYE_RMSE, MVR_RMSE, BUFFERLESS_MORE, FORWARD_MORE, TS_NO_FIGURE } },
	{ "epr_buffers_ssim", "SSIM to the truth", { EPR_SSIM, BUFFERLESS_SSIM, FORWARD_SSIM, EYE_SSIM, MVR_SSIM,
	  TS_NO_FIGURE } },
	{ 0 },
};

/* "Less than half as fast"; "identical imagery", whose bits tests/methods/points/epr.c compares; once a point, not once
 * a texel; and no worse than EPR by what its table 2 calls small. */
static const ts_paper_relation relations[] = {
	{ "RMSE of bufferless less EPR's, %", BUFFERLESS_MORE, TS_BETWEEN, 0, 0, TS_NO_FIGURE, 0, 0, "another picture",
	  BUFFERLESS_RMSE },
	{ "time of bufferless / EPR", SLOWER, TS_AT_LEAST, 2, 0, TS_NO_FIGURE, 0, 0, "points are cheap to make again",
	  BUFFERLESS_MS },
	{ "operations of EPR's texels / forward's", SAVED_OPS, TS_AT_LEAST, 1, 0, TS_NO_FIGURE, 0, 0,
	  "points are finer than texels", POINTS },
	{ "RMSE of forward less EPR's, %", FORWARD_MORE, TS_AT_MOST, 0, 0.067, TS_NO_FIGURE, 0, 0,
	  "light depends on the viewer", FORWARD_RMSE },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_epr_buffers = {
	.name = "epr-buffers", .title = "EPR, sections 3.4 and 3.5: who runs", .effect = "reflections",
	.scenes = "atrium,gallery,dining", .objects_head = "mirrors", .objects_param = "reflectors.count",
	.objects = "10", .set = "", .defaults = "", .size = "width=960,height=540",
	.note = "The paper has no figures of these.",
	.timed = true, .judge = "C", .variants = variants, .figures = figures, .parts = parts,
	.relations = relations, .rows = rows,
};
/* clang-format on */
