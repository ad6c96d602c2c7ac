/* What the family of hulls brings for the tools. */
#include "../../tools/family.h"
#include "../../raster/tools/truth_gather.h"
#include "tools.h"

static const ts_margin_rule margins[] = {
	{TS_B_segment_label, TS_B_segment_margin, .of = 1, .steps = 1.0f},
	{TS_B_hull_box, TS_B_hull_margin, .of = 1, .steps = 1.0f},
	{0},
};

static const ts_truth_kind truths[] = {
	{ "lights", "indirect", "the method's triangles of light, where they are seen", "", "bounce", "",
	  .begin = ts_truth_indirect_begin, .trace = ts_truth_lights, .image = "indirect_image" },
	{ "bounce", "indirect", "light after one bounce, path by path", "", "", "",
	  .begin = ts_truth_indirect_begin, .trace = ts_truth_bounce, .image = "indirect_image" },
	{ 0 },
};

const ts_family_tools ts_hulls_tools = {
	.margins = margins,
	.checks = ts_hulls_checks,
	.truths = truths,
};
