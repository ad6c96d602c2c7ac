/* Claims of EPR's sections 3.4 and 3.5 about variants: without buffers of points, and with cubes of colours. */
#include "methods/points/tools/benches.h"

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

/* Figures of each method whose image is kept, by suffix `p`. */
#define OF(p) EPR_##p, BUFFERLESS_##p, FORWARD_##p, EYE_##p, MVR_##p
#define EACH(ROW, p, key) \
	ROW(EPR_##p, "epr_" key, "EPR", M_EPR), ROW(BUFFERLESS_##p, "bufferless_" key, "bufferless", M_BUFFERLESS), \
	ROW(FORWARD_##p, "forward_" key, "forward", M_FORWARD), \
	ROW(EYE_##p, "eye_" key, "for the eye", M_FORWARD_EYE), ROW(MVR_##p, "mvr_" key, "MVR", M_MVR)

enum { POINTS, EPR_OPS, FORWARD_OPS, ONCE, MVR_OPS, TEXEL_OPS, SAVED_OPS, BY_DEFERRED, EPR_MIB, BUFFERLESS_MIB,
	FORWARD_MIB, SAVED_MIB, EPR_MS, BUFFERLESS_MS, FORWARD_MS, SLOWER, FORWARD_SLOWER, OF(RMSE), BUFFERLESS_MORE,
	FORWARD_MORE, OF(SSIM) };

static const ts_bench_figure figures[] = {
	TS_COUNT(POINTS, "points", "points", M_EPR, "points"),
	TS_COUNT(EPR_OPS, "epr_ops", "EPR ops", M_EPR, "shading operations"),
	TS_COUNT(FORWARD_OPS, "forward_ops", "forward", M_FORWARD, "shading operations"),
	TS_RATIO(ONCE, "forward_each", "a point", FORWARD_OPS, POINTS, 2),
	TS_COUNT(MVR_OPS, "mvr_ops", "MVR", M_MVR, "shading operations"),
	TS_COUNT(TEXEL_OPS, "texel_ops", "of EPR's texels", M_MVR_ADAPTIVE, "shading operations"),
	TS_RATIO(SAVED_OPS, "texels_by_forward", "by forward's", TEXEL_OPS, FORWARD_OPS, 2),
	TS_RATIO(BY_DEFERRED, "forward_by_epr", "forward / EPR", FORWARD_OPS, EPR_OPS, 2),
	[EPR_MIB] = { "epr_mib", "EPR", TS_FIGURE_BUFFERS, M_EPR, 0, 2, "points" },
	[BUFFERLESS_MIB] = { "bufferless_mib", "bufferless", TS_FIGURE_BUFFERS, M_BUFFERLESS, 0, 2, "points" },
	[FORWARD_MIB] = { "forward_mib", "forward", TS_FIGURE_BUFFERS, M_FORWARD, 0, 2, "points,forward" },
	TS_SAVED(SAVED_MIB, "saved", "saved, %", BUFFERLESS_MIB, EPR_MIB),
	TS_MS(EPR_MS, "epr_ms", "EPR", M_EPR),
	TS_MS(BUFFERLESS_MS, "bufferless_ms", "bufferless", M_BUFFERLESS),
	TS_MS(FORWARD_MS, "forward_ms", "forward", M_FORWARD),
	TS_RATIO(SLOWER, "bufferless_by_epr", "bufferless / EPR", BUFFERLESS_MS, EPR_MS, 2),
	TS_RATIO(FORWARD_SLOWER, "forward_ms_by_epr", "forward / EPR", FORWARD_MS, EPR_MS, 2),
	EACH(TS_RMSE, RMSE, "rmse"),
	TS_MORE(BUFFERLESS_MORE, "bufferless_more", "bufferless, %", BUFFERLESS_RMSE, EPR_RMSE),
	TS_MORE(FORWARD_MORE, "forward_more", "forward, %", FORWARD_RMSE, EPR_RMSE),
	EACH(TS_SSIM, SSIM, "ssim"),
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "epr_buffers_work", "shading operations: of look-ups by EPR, of points forward, of texels by MVR", { POINTS,
	  EPR_OPS, FORWARD_OPS, ONCE, BY_DEFERRED, MVR_OPS, TEXEL_OPS, SAVED_OPS, TS_NO_FIGURE } },
	{ "epr_buffers_mib", "buffers of points and of their counts, MiB", { EPR_MIB, BUFFERLESS_MIB, SAVED_MIB,
	  FORWARD_MIB, TS_NO_FIGURE } },
	{ "epr_buffers_ms", "the whole frame, ms", { EPR_MS, BUFFERLESS_MS, SLOWER, FORWARD_MS, FORWARD_SLOWER,
	  TS_NO_FIGURE } },
	{ "epr_buffers_rmse", "RMSE to the truth in grey levels, and less EPR's in percent of 255", { OF(RMSE),
	  BUFFERLESS_MORE, FORWARD_MORE, TS_NO_FIGURE } },
	{ "epr_buffers_ssim", "SSIM to the truth", { OF(SSIM), TS_NO_FIGURE } },
	{ 0 },
};

/* "Less than half as fast"; "identical imagery", whose bits tests/methods/points/epr.c compares; lighting "only once
 * per point". The paper claims neither that texels outnumber points, nor that the picture equals EPR's. */
static const ts_paper_relation relations[] = {
	{ "RMSE of bufferless less EPR's, %", BUFFERLESS_MORE, TS_BETWEEN, 0, 0, TS_ANY, TS_OURS "another picture",
	  BUFFERLESS_RMSE },
	{ "time of bufferless / EPR", SLOWER, TS_AT_LEAST, 2, 0, TS_ANY,
	  TS_GPU "a processor makes a point again in nanoseconds", BUFFERLESS_MS },
	{ "forward's operations a point", ONCE, TS_BETWEEN, 1, 1, TS_ANY, TS_OURS "points are lit again", FORWARD_OPS },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_epr_buffers = {
	.name = "epr-buffers", .title = "EPR, sections 3.4 and 3.5: who runs", .effect = "reflections",
	.scenes = "atrium,gallery,dining", .objects_head = "mirrors", .objects_param = "reflectors.count", .objects = "10",
	.set = "", .defaults = "", .size = "width=960,height=540", .note = "The paper has no figures of these.",
	.timed = true, .judge = "C", .variants = variants, .figures = figures, .parts = parts, .relations = relations,
	.rows = rows,
};
/* clang-format on */
