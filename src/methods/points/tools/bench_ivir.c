/* The iVIR paper's tables. */
#include "benches.h"

/* Table 1. Brackets of the paper: with stochastic culling. */
enum { M_IVIR, M_IVIR_CULL, M_STORED, M_STORED_CULL, M_VIR, M_VIR_CULL, M_MVR, M_WATERTIGHT };

/* clang-format off */
static const ts_bench_variant soft_variants[] = {
	[M_IVIR] = { "ivir", "points.buffered=off,points.cull=off", true, TS_TIMED },
	[M_IVIR_CULL] = { "ivir", "points.buffered=off,points.cull=on", true, TS_TIMED },
	[M_STORED] = { "ivir", "points.buffered=on,points.cull=off", false, TS_TIMED },
	[M_STORED_CULL] = { "ivir", "points.buffered=on,points.cull=on", false, TS_TIMED },
	[M_VIR] = { "vir", "points.buffered=on,points.cull=off", false, TS_TIMED },
	[M_VIR_CULL] = { "vir", "points.buffered=on,points.cull=on", true, TS_TIMED },
	[M_MVR] = { "mvr", "", true, TS_TIMED },
	[M_WATERTIGHT] = { "ivir", "density.rate=watertight,points.snap=on,points.buffered=off", true, TS_ONCE },
	{ 0 },
};

enum { S_TRIANGLES, S_POINTS, S_POINTS_CULL, S_SHARE, S_VIR_POINTS, S_VIR_POINTS_CULL, S_OVER_VIR, S_OVER_VIR_CULL,
	S_PIECES, S_A_TRIANGLE, S_POINT_MS, S_MS, S_MS_CULL, S_STORED_MS, S_STORED_MS_CULL, S_VIR_POINT_MS, S_VIR_MS,
	S_VIR_MS_CULL, S_MVR_MS, S_RATIO, S_RATIO_CULL, S_STORED_RATIO_CULL, S_FRAME_MS, S_FRAME_MS_CULL, S_FRAME_MVR_MS,
	S_FRAME_RATIO, S_FRAME_RATIO_CULL, S_WORK, S_MVR_WORK, S_WORK_RATIO, S_SCATTERS, S_SCATTERS_CULL, S_WRITES,
	S_RMSE, S_RMSE_WATERTIGHT, S_RMSE_VIR, S_RMSE_CULLED, S_RMSE_RATIO };

static const ts_bench_figure soft_figures[] = {
	[S_TRIANGLES] = { "triangles", "triangles", TS_FIGURE_TRIANGLES, 0, 0, TS_WHOLE, "" },
	[S_POINTS] = { "points", "iVIR", TS_FIGURE_COUNTER, M_IVIR, 0, TS_WHOLE, "points" },
	[S_POINTS_CULL] = { "points_culled", "[culled]", TS_FIGURE_COUNTER, M_IVIR_CULL, 0, TS_WHOLE, "points" },
	[S_SHARE] = { "culled_share", "share", TS_FIGURE_RATIO, S_POINTS_CULL, S_POINTS, 3, "" },
	[S_VIR_POINTS] = { "vir_points", "VIR", TS_FIGURE_COUNTER, M_VIR, 0, TS_WHOLE, "points" },
	[S_VIR_POINTS_CULL] = { "vir_points_culled", "[culled]", TS_FIGURE_COUNTER, M_VIR_CULL, 0, TS_WHOLE, "points" },
	[S_OVER_VIR] = { "over_vir", "iVIR / VIR", TS_FIGURE_RATIO, S_POINTS, S_VIR_POINTS, 3, "" },
	[S_OVER_VIR_CULL] = { "over_vir_culled", "[culled]", TS_FIGURE_RATIO, S_POINTS_CULL, S_VIR_POINTS_CULL, 3, "" },
	[S_PIECES] = { "pieces", "in sight", TS_FIGURE_COUNTER, M_IVIR, 0, TS_WHOLE, "pieces" },
	[S_A_TRIANGLE] = { "points_a_triangle", "a triangle", TS_FIGURE_RATIO, S_POINTS, S_PIECES, 2, "" },
	[S_POINT_MS] = { "point_ms", "points", TS_FIGURE_PART_TIME, M_STORED, 0, 2, TS_POINT_STAGES },
	[S_MS] = { "bufferless_ms", "bufferless", TS_FIGURE_PART_TIME, M_IVIR, 0, 2, TS_MAP_STAGES },
	[S_MS_CULL] = { "bufferless_culled_ms", "[culled]", TS_FIGURE_PART_TIME, M_IVIR_CULL, 0, 2, TS_MAP_STAGES },
	[S_STORED_MS] = { "buffered_ms", "buffered", TS_FIGURE_PART_TIME, M_STORED, 0, 2, TS_MAP_STAGES },
	[S_STORED_MS_CULL] = { "buffered_culled_ms", "[culled]", TS_FIGURE_PART_TIME, M_STORED_CULL, 0, 2, TS_MAP_STAGES },
	[S_VIR_POINT_MS] = { "vir_point_ms", "VIR pts", TS_FIGURE_PART_TIME, M_VIR, 0, 2, TS_POINT_STAGES },
	[S_VIR_MS] = { "vir_ms", "VIR", TS_FIGURE_PART_TIME, M_VIR, 0, 2, TS_MAP_STAGES },
	[S_VIR_MS_CULL] = { "vir_culled_ms", "[culled]", TS_FIGURE_PART_TIME, M_VIR_CULL, 0, 2, TS_MAP_STAGES },
	[S_MVR_MS] = { "mvr_ms", "MVR", TS_FIGURE_PART_TIME, M_MVR, 0, 2, TS_MAP_STAGES },
	[S_RATIO] = { "speedup", "MVR / bufferless", TS_FIGURE_RATIO, S_MVR_MS, S_MS, 2, "" },
	[S_RATIO_CULL] = { "speedup_culled", "[culled]", TS_FIGURE_RATIO, S_MVR_MS, S_MS_CULL, 2, "" },
	[S_STORED_RATIO_CULL] = { "buffered_speedup_culled", "/ buffered [culled]", TS_FIGURE_RATIO, S_MVR_MS,
	                          S_STORED_MS_CULL, 2, "" },
	[S_FRAME_MS] = { "frame_ms", "iVIR", TS_FIGURE_TIME, M_IVIR, 0, 2, "" },
	[S_FRAME_MS_CULL] = { "frame_culled_ms", "[culled]", TS_FIGURE_TIME, M_IVIR_CULL, 0, 2, "" },
	[S_FRAME_MVR_MS] = { "frame_mvr_ms", "MVR", TS_FIGURE_TIME, M_MVR, 0, 2, "" },
	[S_FRAME_RATIO] = { "frame_ratio", "iVIR / MVR", TS_FIGURE_RATIO, S_FRAME_MS, S_FRAME_MVR_MS, 3, "" },
	[S_FRAME_RATIO_CULL] = { "frame_ratio_culled", "[culled]", TS_FIGURE_RATIO, S_FRAME_MS_CULL, S_FRAME_MVR_MS, 3,
	  "" },
	[S_WORK] = { "traversed", "iVIR", TS_FIGURE_TRAVERSED, M_IVIR, 0, TS_WHOLE, "" },
	[S_MVR_WORK] = { "mvr_traversed", "MVR", TS_FIGURE_TRAVERSED, M_MVR, 0, TS_WHOLE, "" },
	[S_WORK_RATIO] = { "work_ratio", "MVR / iVIR", TS_FIGURE_RATIO, S_MVR_WORK, S_WORK, 2, "" },
	[S_SCATTERS] = { "scatters", "scatters", TS_FIGURE_COUNTER, M_IVIR, 0, TS_WHOLE, "point-view scatters" },
	[S_SCATTERS_CULL] = { "scatters_culled", "[culled]", TS_FIGURE_COUNTER, M_IVIR_CULL, 0, TS_WHOLE,
	  "point-view scatters" },
	[S_WRITES] = { "writes", "texel writes", TS_FIGURE_COUNTER, M_IVIR, 0, TS_WHOLE, "texel writes" },
	[S_RMSE] = { "rmse_paper", "iVIR", TS_FIGURE_RMSE, M_IVIR_CULL, M_MVR, 3, "" },
	[S_RMSE_WATERTIGHT] = { "rmse_watertight", "iVIR watertight", TS_FIGURE_RMSE, M_WATERTIGHT, M_MVR, 3, "" },
	[S_RMSE_VIR] = { "rmse_vir", "VIR", TS_FIGURE_RMSE, M_VIR_CULL, M_MVR, 3, "" },
	[S_RMSE_CULLED] = { "rmse_culled", "culled, to iVIR not culled", TS_FIGURE_RMSE, M_IVIR_CULL, M_IVIR, 3, "" },
	[S_RMSE_RATIO] = { "rmse_ratio", "iVIR / VIR", TS_FIGURE_RATIO, S_RMSE, S_RMSE_VIR, 3, "" },
	{ 0 },
};

static const ts_paper_part soft_parts[] = {
	{ "ivir_1_points", "Points; a triangle: of those in sight", { S_TRIANGLES, S_POINTS, S_POINTS_CULL, S_SHARE,
	  S_VIR_POINTS, S_VIR_POINTS_CULL, S_OVER_VIR, S_OVER_VIR_CULL, S_A_TRIANGLE, TS_NO_FIGURE } },
	{ "ivir_1_ms", "Points and depth maps, ms", { S_POINT_MS, S_MS, S_MS_CULL, S_STORED_MS, S_STORED_MS_CULL,
	  S_VIR_POINT_MS, S_VIR_MS, S_VIR_MS_CULL, S_MVR_MS, TS_NO_FIGURE } },
	{ "ivir_1_ratios", "The same, MVR's by iVIR's", { S_RATIO, S_RATIO_CULL, S_STORED_RATIO_CULL, TS_NO_FIGURE } },
	{ "ivir_1_frame", "The whole frame, ms", { S_FRAME_MS, S_FRAME_MS_CULL, S_FRAME_MVR_MS, S_FRAME_RATIO,
	  S_FRAME_RATIO_CULL, TS_NO_FIGURE } },
	{ "ivir_1_work", "Work: triangles in all passes over the geometry, and points by the views they went to", {
	  S_WORK, S_MVR_WORK, S_WORK_RATIO, S_PIECES, S_SCATTERS, S_SCATTERS_CULL, S_WRITES, TS_NO_FIGURE } },
	{ "ivir_1_rmse", "RMSE to MVR's image, grey levels", { S_RMSE, S_RMSE_WATERTIGHT, S_RMSE_VIR, S_RMSE_RATIO,
	  S_RMSE_CULLED, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation soft_relations[] = {
	{ "iVIR points / VIR's", S_OVER_VIR, TS_AT_MOST, 0, 1, TS_NO_FIGURE, 0, 0, "more points than VIR", S_A_TRIANGLE },
	{ "the same, culled", S_OVER_VIR_CULL, TS_AT_MOST, 0, 1, TS_NO_FIGURE, 0, 0, "more points than VIR", S_A_TRIANGLE },
	{ "points that culling leaves", S_SHARE, TS_AT_MOST, 0, 1, TS_NO_FIGURE, 0, 0, "culling adds points",
	  S_A_TRIANGLE },
	{ "they rise with points a triangle", S_SHARE, TS_RISES_WITH, S_A_TRIANGLE, 0, TS_NO_FIGURE, 0, 0,
	  "differs: not in every pair of scenes", S_A_TRIANGLE },
	{ "points a triangle in sight where culling leaves a third", S_A_TRIANGLE, TS_BETWEEN, 1, 1.1, S_SHARE, 0, 0.33,
	  "not all triangles are tiny", S_SHARE },
	{ "RMSE by stochastic culling, grey levels", S_RMSE_CULLED, TS_AT_MOST, 0, 1, TS_NO_FIGURE, 0, 0,
	  "few points are left a texel", S_SHARE },
	{ "RMSE to MVR, iVIR by VIR", S_RMSE_RATIO, TS_AT_MOST, 0, 1.1, TS_NO_FIGURE, 0, 0, "fewer points than VIR",
	  S_OVER_VIR_CULL },
	{ "frame of iVIR / MVR's, culled", S_FRAME_RATIO_CULL, TS_AT_MOST, 0, 1, S_TRIANGLES, 100e3, 1e12,
	  "more points a triangle", S_A_TRIANGLE },
	{ 0 },
};

static const ts_paper_row soft_rows[] = {
	{ "Tree House", "", "", 0, { [S_TRIANGLES] = 151800, [S_POINTS] = 245500, [S_POINTS_CULL] = 194100,
	  [S_VIR_POINTS] = 253000, [S_VIR_POINTS_CULL] = 203700, [S_A_TRIANGLE] = 3.23, [S_POINT_MS] = 0.69,
	  [S_MS] = 3.33, [S_MS_CULL] = 1.82, [S_STORED_MS] = 3.81, [S_STORED_MS_CULL] = 3.50, [S_VIR_POINT_MS] = 0.67,
	  [S_VIR_MS] = 4.01, [S_VIR_MS_CULL] = 3.77, [S_MVR_MS] = 7.33 } },
	{ "Dragon", "", "", 0, { [S_TRIANGLES] = 883300, [S_POINTS] = 693700, [S_POINTS_CULL] = 482100,
	  [S_VIR_POINTS] = 935100, [S_VIR_POINTS_CULL] = 810400, [S_A_TRIANGLE] = 1.57, [S_POINT_MS] = 4.67,
	  [S_MS] = 16.73, [S_MS_CULL] = 10.86, [S_STORED_MS] = 9.79, [S_STORED_MS_CULL] = 8.83, [S_VIR_POINT_MS] = 4.08,
	  [S_VIR_MS] = 10.39, [S_VIR_MS_CULL] = 9.73, [S_MVR_MS] = 57.01 } },
	{ "Buddha", "", "", 0, { [S_TRIANGLES] = 1100000, [S_POINTS] = 569500, [S_POINTS_CULL] = 130500,
	  [S_VIR_POINTS] = 617200, [S_VIR_POINTS_CULL] = 252100, [S_A_TRIANGLE] = 1.04, [S_POINT_MS] = 5.35,
	  [S_MS] = 20.64, [S_MS_CULL] = 9.01, [S_STORED_MS] = 9.70, [S_STORED_MS_CULL] = 7.75, [S_VIR_POINT_MS] = 4.65,
	  [S_VIR_MS] = 9.24, [S_VIR_MS_CULL] = 7.58, [S_MVR_MS] = 69.33 } },
	{ "Lucy", "", "", 0, { [S_TRIANGLES] = 2000000, [S_POINTS] = 1000000, [S_POINTS_CULL] = 125900,
	  [S_VIR_POINTS] = 1100000, [S_VIR_POINTS_CULL] = 298600, [S_A_TRIANGLE] = 1.00, [S_POINT_MS] = 9.85,
	  [S_MS] = 38.35, [S_MS_CULL] = 14.05, [S_STORED_MS] = 15.92, [S_STORED_MS_CULL] = 12.21, [S_VIR_POINT_MS] = 8.28,
	  [S_VIR_MS] = 14.75, [S_VIR_MS_CULL] = 11.38, [S_MVR_MS] = 122.3 } },
	{ 0 },
};

const ts_paper_table ts_ivir_1 = {
	.name = "ivir-1", .title = "iVIR, table 1: soft shadows",
	.effect = "soft-shadows", .scenes = "atrium,gallery,dining",
	.models = "bunny.glb,armadillo_86k.glb,dragon_80k.glb,dragon_scans.glb", .set = "reflectors.count=0",
	.defaults = TS_IVIR_DEFAULTS,
	.note = "The paper's row is the nearest in triangles; it counts points a triangle twice. " TS_VIR_NOTE,
	.timed = true, .by_triangles = true, .variants = soft_variants, .figures = soft_figures, .parts = soft_parts,
	.relations = soft_relations, .rows = soft_rows,
};
/* clang-format on */
