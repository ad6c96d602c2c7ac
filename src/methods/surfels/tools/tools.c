/* The tables of surfels for the tools. */
#include "methods/surfels/tools/tools.h"
#include "methods/surfels/tools/probe.h"
#include "methods/tools/family.h"

static const ts_margin_rule margins[] = {
	{TS_B_surfel_depth_surfel, TS_B_surfel_depth_margin, .of = 1, .steps = 1.0f},
	{TS_B_surfel_blend_sum, TS_B_surfel_blend_margin, .of = 8, .steps = 1.0f},
	{TS_B_surfel_blend_heaviest, TS_B_surfel_blend_margin, .of = 1, .steps = 1.0f},
	{TS_B_image_radiance, TS_B_deferred_margin, .of = 3, .steps = 1.0f, .rare = true},
	{0},
};

static const ts_truth_kind truths[] = {
	{"discs", "surfels", "rays into the surfels themselves", "method", "surface", "sampling",
     .radiance = ts_truth_discs, .bytes = ts_truth_discs_bytes},
	{"surface", "surfels", "rays into what the surfels are samples of", "both", "", "", .radiance = ts_truth_surface,
     .bytes = ts_truth_surface_bytes, .exists = ts_truth_has_surface,
     .why_not = "what its surfels are samples of is not known"},
	{0},
};

static const ts_table_code codes[] = {
	{"crumbs", .work = ts_bench_crumbs},
	{0},
};

static const ts_note_rule notes[] = {{TS_B_surfel_depth_surfel, ts_layers_note}, {.take = NULL}};

/* clang-format off */
static const ts_probe_part parts[] = {
	{TS_PROBE_PIXEL, "deferred", ts_probe_surfel_pixel,
	 "the nearest surfel, those that are blended or hidden, their sums, the light and the outline", NULL},
	{TS_PROBE_PIXEL, "surfel_shade.image", ts_probe_shaded_pixel,
	 "the nearest surfel, those that are blended, shaded, or hidden, and their sums", NULL},
	{0},
};
/* clang-format on */

const ts_family_tools ts_surfels_tools = {
	.margins = margins,
	.checks = ts_surfels_checks,
	.truths = truths,
	.codes = codes,
	.parts = parts,
	.notes = notes,
};
