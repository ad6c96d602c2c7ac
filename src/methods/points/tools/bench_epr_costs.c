/* What parts of EPR cost and save, each by its own switch: stochastic culling (3.2: frame times fall by roughly 15 %),
 * buffers of the eye's resolution (4.1.1: by more than 60 %) and splats clipped to their triangles (3.5: speed falls by
 * less than 20 %). A frame cannot be shorter by a share of its time by doing fewer points or texels alone, unless at
 * least that share of them is gone: so the counts are judged too. */
#include "benches.h"

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
	FIXED_WRITES, WRITES_SAVED, UNCLIPPED_WRITES, WRITES_CLIPPED, EMPTY, UNCULLED_EMPTY, EMPTY_MORE, MS, UNCULLED_MS,
	CULL_SAVED, FIXED_MS, RESIZE_SAVED, UNCLIPPED_MS, CLIP_SPEED, RMSE, UNCULLED_RMSE, CULL_MORE, FIXED_RMSE,
	RESIZE_MORE, UNCLIPPED_RMSE, CLIP_MORE };

static const ts_bench_figure figures[] = {
	[TRIANGLES] = { "triangles", "triangles", TS_FIGURE_TRIANGLES, 0, 0, TS_WHOLE, "" },
	[DIAMETER] = { "diameter", "cube side, px", TS_FIGURE_DIAMETER, M_ALL, 0, 1, "" },
	[POINTS] = { "points", "points", TS_FIGURE_COUNTER, M_ALL, 0, TS_WHOLE, "points" },
	[UNCULLED_POINTS] = { "unculled_points", "unculled", TS_FIGURE_COUNTER, M_UNCULLED, 0, TS_WHOLE, "points" },
	[POINTS_SAVED] = { "points_saved_percent", "saved, %", TS_FIGURE_SAVED, POINTS, UNCULLED_POINTS, 1, "" },
	[TEXELS] = { "texels", "texels", TS_FIGURE_COUNTER, M_ALL, 0, TS_WHOLE, "cube texels" },
	[FIXED_TEXELS] = { "fixed_texels", "of 512", TS_FIGURE_COUNTER, M_FIXED, 0, TS_WHOLE, "cube texels" },
	[TEXELS_SAVED] = { "texels_saved_percent", "saved, %", TS_FIGURE_SAVED, TEXELS, FIXED_TEXELS, 1, "" },
	[WRITES] = { "writes", "writes", TS_FIGURE_COUNTER, M_ALL, 0, TS_WHOLE, "texel writes" },
	[FIXED_WRITES] = { "fixed_writes", "writes of 512", TS_FIGURE_COUNTER, M_FIXED, 0, TS_WHOLE, "texel writes" },
	[WRITES_SAVED] = { "writes_saved_percent", "saved, %", TS_FIGURE_SAVED, WRITES, FIXED_WRITES, 1, "" },
	[UNCLIPPED_WRITES] = { "unclipped_writes", "writes unclipped", TS_FIGURE_COUNTER, M_UNCLIPPED, 0, TS_WHOLE,
	                       "texel writes" },
	[WRITES_CLIPPED] = { "writes_clipped_percent", "clipped, %", TS_FIGURE_SAVED, WRITES, UNCLIPPED_WRITES, 1, "" },
	[EMPTY] = { "empty", "empty look-ups", TS_FIGURE_COUNTER, M_ALL, 0, TS_WHOLE, "empty look-ups" },
	[UNCULLED_EMPTY] = { "unculled_empty", "unculled", TS_FIGURE_COUNTER, M_UNCULLED, 0, TS_WHOLE, "empty look-ups" },
	[EMPTY_MORE] = { "empty_more", "more", TS_FIGURE_DIFFERENCE, EMPTY, UNCULLED_EMPTY, 1, "" },
	[MS] = { "ms", "EPR", TS_FIGURE_TIME, M_ALL, 0, 2, "" },
	[UNCULLED_MS] = { "unculled_ms", "unculled", TS_FIGURE_TIME, M_UNCULLED, 0, 2, "" },
	[CULL_SAVED] = { "cull_saved_percent", "saved, %", TS_FIGURE_SAVED, MS, UNCULLED_MS, 1, "" },
	[FIXED_MS] = { "fixed_ms", "faces of 512", TS_FIGURE_TIME, M_FIXED, 0, 2, "" },
	[RESIZE_SAVED] = { "resize_saved_percent", "saved, %", TS_FIGURE_SAVED, MS, FIXED_MS, 1, "" },
	[UNCLIPPED_MS] = { "unclipped_ms", "unclipped", TS_FIGURE_TIME, M_UNCLIPPED, 0, 2, "" },
	[CLIP_SPEED] = { "clip_slower_percent", "slower, %", TS_FIGURE_SAVED, UNCLIPPED_MS, MS, 1, "" },
	[RMSE] = { "rmse", "EPR", TS_FIGURE_RMSE, M_ALL, M_ALL, 3, "" },
	[UNCULLED_RMSE] = { "unculled_rmse", "unculled", TS_FIGURE_RMSE, M_UNCULLED, M_UNCULLED, 3, "" },
	[CULL_MORE] = { "cull_rmse_more", "by culling", TS_FIGURE_DIFFERENCE, RMSE, UNCULLED_RMSE, 3, "" },
	[FIXED_RMSE] = { "fixed_rmse", "faces of 512", TS_FIGURE_RMSE, M_FIXED, M_FIXED, 3, "" },
	[RESIZE_MORE] = { "resize_rmse_more", "by resizing", TS_FIGURE_DIFFERENCE, RMSE, FIXED_RMSE, 3, "" },
	[UNCLIPPED_RMSE] = { "unclipped_rmse", "unclipped", TS_FIGURE_RMSE, M_UNCLIPPED, M_UNCLIPPED, 3, "" },
	[CLIP_MORE] = { "clip_rmse_more", "by clipping", TS_FIGURE_DIFFERENCE, RMSE, UNCLIPPED_RMSE, 3, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "epr_costs_cull", "Stochastic culling: points, and look-ups that find nothing", { TRIANGLES, POINTS,
	  UNCULLED_POINTS, POINTS_SAVED, EMPTY, UNCULLED_EMPTY, EMPTY_MORE, TS_NO_FIGURE } },
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

#define ALL TS_NO_FIGURE, 0, 0

static const ts_paper_relation relations[] = {
	{ "culling: points saved, %", POINTS_SAVED, TS_AT_LEAST, 15, 0, ALL, "few triangles are so small", TRIANGLES },
	{ "culling: time saved, %", CULL_SAVED, TS_BETWEEN, 10, 20, ALL, "few or many are so small", POINTS_SAVED },
	{ "culling: more empty look-ups", EMPTY_MORE, TS_AT_MOST, 0, 0, ALL, "holes", EMPTY },
	{ "culling: RMSE more", CULL_MORE, TS_AT_MOST, 0, 0.05, ALL, "fewer points a texel", POINTS_SAVED },
	{ "resizing: texels saved, %", TEXELS_SAVED, TS_AT_LEAST, 60, 0, ALL, "large mirrors", DIAMETER },
	{ "resizing: texel writes saved, %", WRITES_SAVED, TS_AT_LEAST, 60, 0, ALL, "large mirrors", DIAMETER },
	{ "resizing: time saved, %", RESIZE_SAVED, TS_AT_LEAST, 60, 0, ALL, "points are much of the work", WRITES_SAVED },
	{ "clipping: RMSE more", CLIP_MORE, TS_AT_MOST, 0, 0, ALL, "clipping does not help", WRITES_CLIPPED },
	{ "clipping: slower, %", CLIP_SPEED, TS_AT_MOST, 0, 20, ALL, "clipping is much of the work", WRITES_CLIPPED },
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
