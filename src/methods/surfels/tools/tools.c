/* What the family of surfels brings for the tools. */
#include "../../tools/family.h"
#include "tools.h"

static const ts_margin_rule margins[] = {
	{TS_B_surfel_depth_surfel, TS_B_surfel_depth_margin, .of = 1, .steps = 1.0f},
	{TS_B_blend_sum, TS_B_blend_margin, .of = 8, .steps = 1.0f},
	{TS_B_blend_heaviest, TS_B_blend_margin, .of = 1, .steps = 1.0f},
	{TS_B_image_radiance, TS_B_deferred_margin, .of = 3, .steps = 1.0f, .rare = true},
	{0},
};

const ts_family_tools ts_surfels_tools = {.margins = margins, .checks = ts_surfels_checks};
