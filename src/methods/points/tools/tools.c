/* What the family of points brings for the tools. */
#include "../../tools/family.h"
#include "tools.h"
#include "tie.h"

static const ts_tie_rule ties[] = {
	{TS_B_splat_depth_index, ts_splat_ties_open, ts_splat_tie_allows, ts_splat_ties_close},
	{0},
};

#define CHANCE 0.00000095367431640625f /* 2^-20 of a random number's range */

static const ts_margin_rule margins[] = {
	{TS_B_face_depth_triangle, TS_B_face_margin, .of = 1, .steps = 1.0f},
	{TS_B_cull_keep, TS_B_cull_margin, .of = 1, .steps = CHANCE},
	{TS_B_splat_depth_index, TS_B_splat_tie, .of = 1},
	{TS_B_scatter_depth, TS_B_depth_margin, .of = 1, .steps = 1.0f},
	{0},
};

const ts_family_tools ts_points_tools = {.ties = ties, .margins = margins, .checks = ts_points_checks};
