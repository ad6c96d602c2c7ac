/* What the family of points brings for the tools. */
#include "../../tools/family.h"
#include "tie.h"

static const ts_tie_rule ties[] = {
	{TS_B_splat_depth_index, ts_splat_ties_open, ts_splat_tie_allows, ts_splat_ties_close},
	{0},
};

const ts_family_tools ts_points_tools = {.ties = ties};
