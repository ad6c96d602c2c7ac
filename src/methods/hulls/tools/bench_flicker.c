/* How much more hulls change from frame to frame than `direct` does, by the choices that keep them steady (SSAGH 5,
 * temporal coherence). */
#include "methods/hulls/tools/tools.h"

enum { HULLS, DIRECT, FACING, GRID };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[HULLS] = { "hulls", "", true, TS_ONCE },
	[DIRECT] = { "direct", "", true, TS_ONCE },
	[FACING] = { "hulls", "corner.facing=paper", true, TS_ONCE },
	[GRID] = { "hulls", "segment.method=none", true, TS_ONCE },
	{ 0 },
};

enum { CHANGE, FLICKER, FLICKER_FACING, FLICKER_GRID, SHARE, BY_FACING, BY_GRID };

static const ts_bench_figure figures[] = {
	[CHANGE] = { "direct_change", "direct changes by", TS_FIGURE_FLICKER, DIRECT, DIRECT, 2, "" },
	[FLICKER] = { "flicker", "hulls", TS_FIGURE_FLICKER, HULLS, DIRECT, 2, "" },
	[FLICKER_FACING] = { "flicker_facing", "paper's facing", TS_FIGURE_FLICKER, FACING, DIRECT, 2, "" },
	[FLICKER_GRID] = { "flicker_grid", "grid", TS_FIGURE_FLICKER, GRID, DIRECT, 2, "" },
	[SHARE] = { "flicker_percent", "by that, %", TS_FIGURE_PERCENT, FLICKER, CHANGE, 1, "" },
	[BY_FACING] = { "facing_ratio", "facing by ours", TS_FIGURE_RATIO, FLICKER_FACING, FLICKER, 2, "" },
	[BY_GRID] = { "grid_ratio", "grid by ours", TS_FIGURE_RATIO, FLICKER_GRID, FLICKER, 2, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "ssagh_flicker", "SSAGH, temporal coherence: change since the frame before, beyond that of direct, grey levels",
	  { CHANGE, FLICKER, SHARE, FLICKER_FACING, BY_FACING, FLICKER_GRID, BY_GRID, TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

static const ts_paper_relation relations[] = {
	{ "flicker of hulls by the change of direct, %", SHARE, TS_AT_MOST, 0, 20, ALL,
	  TS_NOT_ALWAYS "corners see triangles of light come and go; see depth_grid.px", FLICKER },
	{ "flicker without segments / with", BY_GRID, TS_AT_LEAST, 1, 0, ALL,
	  TS_NOT_ALWAYS "few edges in depth; see segment.method", FLICKER_GRID },
	{ "flicker of the paper's facing / of the ramp", BY_FACING, TS_AT_LEAST, 1, 0, ALL,
	  TS_NOT_ALWAYS "few corners near triangles of light; see corner.facing", FLICKER_FACING },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_ssagh_flicker = {
	.name = "ssagh-flicker", .title = "SSAGH, temporal coherence", .effect = "indirect", .scenes = "atrium,gallery",
	.set = "reflectors.count=0", .defaults = "", .size = "width=160,height=90",
	.note = "Of several frames: --frames 0..29.", .variants = variants, .figures = figures, .parts = parts,
	.relations = relations, .rows = rows,
};
/* clang-format on */
