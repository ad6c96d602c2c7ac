/* What standard rasterization, which families share, brings for the tools. */
#include "../../tools/family.h"
#include "tools.h"

static const ts_margin_rule margins[] = {
	{TS_B_eye_depth_triangle, TS_B_eye_margin, .of = 1, .steps = 1.0f},
	{TS_B_face_depth_triangle, TS_B_face_margin, .of = 1, .steps = 1.0f},
	{TS_B_scatter_depth, TS_B_depth_margin, .of = 1, .steps = 1.0f},
	{TS_B_resolve_lit, TS_B_resolve_margin, .of = 1, .steps = 1.0f},
	{0},
};

const ts_family_tools ts_raster_tools = {
	.margins = margins,
	.checks = ts_raster_checks,
};
