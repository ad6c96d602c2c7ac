/* What the family of many views brings for the tools. */
#include "../../tools/family.h"
#include "tools.h"

static const ts_margin_rule margins[] = {
	{TS_B_map_depth_node, TS_B_map_margin, .of = 1, .steps = 1.0f},
	{TS_B_vpl_gather_irradiance, TS_B_vpl_gather_margin, .of = 3, .steps = 1.0f},
	{0},
};

const ts_family_tools ts_views_tools = {.margins = margins, .checks = ts_views_checks};
