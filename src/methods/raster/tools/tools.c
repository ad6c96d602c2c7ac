/* Tables of standard rasterization, which families share, for the tools. */
#include "methods/raster/tools/tools.h"
#include "methods/raster/tools/probe.h"
#include "methods/tools/family.h"

static const ts_margin_rule margins[] = {
	{TS_B_eye_depth_triangle, TS_B_eye_margin, .of = 1, .steps = 1.0f},
	{TS_B_cube_face_depth_triangle, TS_B_cube_face_margin, .of = 1, .steps = 1.0f},
	{TS_B_depth_map_depth, TS_B_depth_map_margin, .of = 1, .steps = 1.0f},
	{TS_B_shadow_test_lit, TS_B_shadow_test_margin, .of = 1, .steps = 1.0f},
	{0},
};

/* clang-format off */
static const ts_probe_part parts[] = {
	{TS_PROBE_PIXEL, "shadow_test", ts_probe_shadow_pixel, "what each sample of each light found in its depth map",
	NULL},
	{0},
};
/* clang-format on */

static const ts_buffer_id keeps[] = {TS_B_offscreen_view, TS_B_lamp_shape,    TS_B_shadow_test_lit,
                                     TS_B_rsm_patch,      TS_B_gbuffer_pixel, TS_N_BUFFERS};

const ts_family_tools ts_raster_tools = {
	.margins = margins,
	.checks = ts_raster_checks,
	.parts = parts,
	.pictures = ts_raster_pictures,
	.marks = ts_raster_marks,
	.viewers = ts_raster_viewers,
	.keeps = keeps,
};
