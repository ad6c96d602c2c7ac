/* The tables of hulls for the tools. */
#include "methods/hulls/tools/tools.h"
#include "methods/hulls/tools/probe.h"
#include "methods/raster/tools/truth_gather.h"
#include "methods/tools/family.h"

static const ts_margin_rule margins[] = {
	{TS_B_segment_label, TS_B_segment_margin, .of = 1, .steps = 1.0f},
	{TS_B_hull_box, TS_B_hull_margin, .of = 1, .steps = 1.0f},
	{0},
};

static const ts_truth_kind truths[] = {
	{"exact", "area-light", "form factors in double precision, without shadows", "method", "shadowed", "shadows",
     .begin = ts_truth_lamps_begin, .trace = ts_truth_lamps_exact, .image = "image.indirect"},
	{"shadowed", "area-light", "the same of what rays to truth.area_samples places of each light see", "", "", "",
     .begin = ts_truth_lamps_begin, .trace = ts_truth_lamps_shadowed, .image = "image.indirect"},
	{"lights", "indirect", "the method's triangles of light, where they are seen", "", "bounce", "",
     .begin = ts_truth_indirect_begin, .trace = ts_truth_lights, .image = "image.indirect"},
	{"bounce", "indirect", "light after one bounce, path by path", "", "", "", .begin = ts_truth_indirect_begin,
     .trace = ts_truth_bounce, .image = "image.indirect"},
	{0},
};

static const ts_table_code codes[] = {
	{"segments", .work = ts_bench_segments}, {"borders", .work = ts_bench_borders}, {"curves", .work = ts_bench_curves},
	{"logistic", .work = ts_bench_logistic}, {"cosines", .work = ts_bench_cosines}, {0},
};

/* clang-format off */
static const ts_probe_part parts[] = {
	{TS_PROBE_PIXEL, "hull", ts_probe_hull_pixel,
	 "the boxes of its block, what the corners of its own gathered, and its lobes", NULL},
	{TS_PROBE_PIXEL, "direct", ts_probe_direct_pixel, "the brightest triangles of light", NULL},
	{0},
};
/* clang-format on */

const ts_family_tools ts_hulls_tools = {
	.margins = margins,
	.checks = ts_hulls_checks,
	.pictures = ts_hulls_pictures,
	.truths = truths,
	.codes = codes,
	.parts = parts,
};
