/* Costs and savings of EPR's parts, each by its own switch: stochastic culling (3.2: frame times fall by roughly 15 %),
 * buffers of the eye's resolution (4.1.1: by more than 60 %) and splats clipped to their triangles (3.5: speed falls by
 * less than 20 %). Doing fewer points or texels shortens a frame by a share of its time only if at least that share of
 * them is gone: so the counts are judged too. All cullable triangles of a pixel are culled with a probability of at
 * most 5 in 100,000 (footnote 1). */
#include "methods/points/tools/benches.h"

enum { M_ALL, M_UNCULLED, M_FIXED, M_UNCLIPPED };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[M_ALL] = { "epr", "", true, TS_TIMED },
	[M_UNCULLED] = { "epr", "points.cull=off", true, TS_TIMED },
	[M_FIXED] = { "epr", "cube.px=512", true, TS_TIMED },
	[M_UNCLIPPED] = { "epr", "splat.clip=off", true, TS_TIMED },
	{ 0 },
};

enum { TRIANGLES, DIAMETER, POINTS, UNCULLED_POINTS, POINTS_SAVED, TEXELS, FIXED_TEXELS, TEXELS_SAVED, WRITES,
	FIXED_WRITES, WRITES_SAVED, UNCLIPPED_WRITES, WRITES_CLIPPED, EMPTY, UNCULLED_EMPTY, EMPTY_MORE, LOOKUPS,
	EMPTY_SHARE, MS, UNCULLED_MS, CULL_SAVED, FIXED_MS, RESIZE_SAVED, UNCLIPPED_MS, CLIP_SPEED, RMSE, UNCULLED_RMSE,
	CULL_MORE, FIXED_RMSE, RESIZE_MORE, UNCLIPPED_RMSE, CLIP_MORE };

static const ts_bench_figure figures[] = {
	TS_TRIANGLES(TRIANGLES),
	[DIAMETER] = { "diameter", "cube side, px", TS_FIGURE_DIAMETER, M_ALL, 0, 1, "" },
	TS_COUNT(POINTS, "points", "points", M_ALL, "points"),
	TS_COUNT(UNCULLED_POINTS, "unculled_points", "unculled", M_UNCULLED, "points"),
	TS_SAVED(POINTS_SAVED, "points_saved_percent", "saved, %", POINTS, UNCULLED_POINTS),
	TS_COUNT(TEXELS, "texels", "texels", M_ALL, "cube texels"),
	TS_COUNT(FIXED_TEXELS, "fixed_texels", "of 512", M_FIXED, "cube texels"),
	TS_SAVED(TEXELS_SAVED, "texels_saved_percent", "saved, %", TEXELS, FIXED_TEXELS),
	TS_COUNT(WRITES, "writes", "writes", M_ALL, "texel writes"),
	TS_COUNT(FIXED_WRITES, "fixed_writes", "writes of 512", M_FIXED, "texel writes"),
	TS_SAVED(WRITES_SAVED, "writes_saved_percent", "saved, %", WRITES, FIXED_WRITES),
	TS_COUNT(UNCLIPPED_WRITES, "unclipped_writes", "writes unclipped", M_UNCLIPPED, "texel writes"),
	TS_SAVED(WRITES_CLIPPED, "writes_clipped_percent", "clipped, %", WRITES, UNCLIPPED_WRITES),
	TS_COUNT(EMPTY, "empty", "empty look-ups", M_ALL, "empty look-ups"),
	TS_COUNT(UNCULLED_EMPTY, "unculled_empty", "without", M_UNCULLED, "empty look-ups"),
	TS_LESS(EMPTY_MORE, "empty_more", "more", EMPTY, UNCULLED_EMPTY, 1),
	TS_COUNT(LOOKUPS, "lookups", "look-ups", M_ALL, "look-ups"),
	TS_PERCENT(EMPTY_SHARE, "empty_more_percent", "more, %", EMPTY_MORE, LOOKUPS),
	TS_MS(MS, "ms", "EPR", M_ALL),
	TS_MS(UNCULLED_MS, "unculled_ms", "unculled", M_UNCULLED),
	TS_SAVED(CULL_SAVED, "cull_saved_percent", "saved, %", MS, UNCULLED_MS),
	TS_MS(FIXED_MS, "fixed_ms", "faces of 512", M_FIXED),
	TS_SAVED(RESIZE_SAVED, "resize_saved_percent", "saved, %", MS, FIXED_MS),
	TS_MS(UNCLIPPED_MS, "unclipped_ms", "unclipped", M_UNCLIPPED),
	TS_SAVED(CLIP_SPEED, "clip_slower_percent", "slower, %", UNCLIPPED_MS, MS),
	TS_RMSE(RMSE, "rmse", "EPR", M_ALL),
	TS_RMSE(UNCULLED_RMSE, "unculled_rmse", "unculled", M_UNCULLED),
	TS_LESS(CULL_MORE, "cull_rmse_more", "by culling", RMSE, UNCULLED_RMSE, 3),
	TS_RMSE(FIXED_RMSE, "fixed_rmse", "faces of 512", M_FIXED),
	TS_LESS(RESIZE_MORE, "resize_rmse_more", "by resizing", RMSE, FIXED_RMSE, 3),
	TS_RMSE(UNCLIPPED_RMSE, "unclipped_rmse", "unclipped", M_UNCLIPPED),
	TS_LESS(CLIP_MORE, "clip_rmse_more", "by clipping", RMSE, UNCLIPPED_RMSE, 3),
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "epr_costs_cull", "Stochastic culling: points, and look-ups that find nothing", { TRIANGLES, POINTS,
	  UNCULLED_POINTS, POINTS_SAVED, EMPTY, UNCULLED_EMPTY, EMPTY_MORE, EMPTY_SHARE, TS_NO_FIGURE } },
	{ "epr_costs_resize", "Cubes sized by the eye's picture: texels, and those written to", { DIAMETER, TEXELS,
	  FIXED_TEXELS, TEXELS_SAVED, WRITES, FIXED_WRITES, WRITES_SAVED, TS_NO_FIGURE } },
	{ "epr_costs_clip", "Splats clipped to their triangles: texels written to", { WRITES, UNCLIPPED_WRITES,
	  WRITES_CLIPPED, TS_NO_FIGURE } },
	{ "epr_costs_ms", "The whole frame, ms", { MS, UNCULLED_MS, CULL_SAVED, FIXED_MS, RESIZE_SAVED, UNCLIPPED_MS,
	  CLIP_SPEED, TS_NO_FIGURE } },
	{ "epr_costs_rmse", "RMSE to the truth in grey levels, and what each adds", { RMSE, UNCULLED_RMSE, CULL_MORE,
	  FIXED_RMSE, RESIZE_MORE, UNCLIPPED_RMSE, CLIP_MORE, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation relations[] = {
	{ "culling: points saved, %", POINTS_SAVED, TS_AT_LEAST, 15, 0, TS_ANY,
	  TS_ELSEWHERE "few triangles are so small; see scene.triangles", TRIANGLES },
	{ "culling: time saved, %", CULL_SAVED, TS_BETWEEN, 10, 20, TS_ANY,
	  TS_ELSEWHERE "few or many are so small; see scene.triangles",
	  POINTS_SAVED },
	{ "culling: more empty look-ups, %", EMPTY_SHARE, TS_AT_MOST, 0, 0.005, TS_ANY,
	  TS_OURS "holes; see points.cull_unit",
	  EMPTY },
	{ "culling: RMSE more", CULL_MORE, TS_AT_MOST, 0, 0.05, TS_ANY,
	  TS_OURS "fewer points a texel; see points.cull_unit", POINTS_SAVED },
	{ "resizing: texels saved, %", TEXELS_SAVED, TS_AT_LEAST, 60, 0, TS_ANY,
	  TS_ELSEWHERE "large mirrors; see reflectors.px", DIAMETER },
	{ "resizing: texel writes saved, %", WRITES_SAVED, TS_AT_LEAST, 60, 0, TS_ANY,
	  TS_ELSEWHERE "large mirrors; see reflectors.px", DIAMETER },
	{ "resizing: time saved, %", RESIZE_SAVED, TS_AT_LEAST, 60, 0, TS_ANY,
	  TS_GPU "points are much of the work; see density.scale",
	  WRITES_SAVED },
	{ "clipping: RMSE more", CLIP_MORE, TS_AT_MOST, 0, 0, TS_ANY,
	  TS_OURS "clipping does not help; see points.conservative", WRITES_CLIPPED },
	{ "clipping: slower, %", CLIP_SPEED, TS_AT_MOST, 0, 20, TS_ANY,
	  TS_GPU "clipping is much of the work; see splat.size", WRITES_CLIPPED },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_epr_costs = {
	.name = "epr-costs", .title = "EPR's culling, resizing and clipping: who runs", .effect = "reflections",
	.scenes = "atrium,gallery,dining", .objects_head = "mirrors", .objects_param = "reflectors.count", .objects = "10",
	.set = "", .defaults = "", .timed = true, .judge = "A", .variants = variants, .figures = figures, .parts = parts,
	.relations = relations, .rows = rows,
};
/* clang-format on */
