/* What the family of hulls brings for the tools. */
#include "../../tools/family.h"
#include "tools.h"

static const ts_margin_rule margins[] = {
	{TS_B_segment_label, TS_B_segment_margin, .of = 1, .steps = 1.0f},
	{TS_B_hull_box, TS_B_hull_margin, .of = 1, .steps = 1.0f},
	{0},
};

const ts_family_tools ts_hulls_tools = {.margins = margins, .checks = ts_hulls_checks};
