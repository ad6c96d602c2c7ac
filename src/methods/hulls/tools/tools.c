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

static const ts_bench_row benches[] = {
	{"ssagh-1", "SSAGH: frames a second by size of the image; --objects takes sizes, WxH; also of models in TS_SCENES",
     TS_BENCH_BY_ITSELF " size", .paper = &ts_ssagh_1, .brief = "--objects 640x360,1280x720 --runs 1"},
	{"ssagh-2", "SSAGH: pictures without segments, and by other cosines; --objects takes sizes",
     TS_BENCH_BY_ITSELF " size runs", .paper = &ts_ssagh_2, .brief = "--objects 480x270"},
	{"ssagh-segments", "SSAGH: labels of algorithm 1 beside connected components", TS_BENCH_BY_ITSELF " objects runs",
     .run = ts_bench_segments, .brief = "--size 960x540"},
	{"ssagh-borders", "SSAGH: seams with the paper's facing and corners; also of models in TS_SCENES",
     TS_BENCH_BY_ITSELF " objects runs", .run = ts_bench_borders},
	{"ssagh-3", "SSAGH: a broad lamp with the cosine constant; also of models in TS_SCENES",
     TS_BENCH_BY_ITSELF " objects runs", .paper = &ts_ssagh_3, .brief = "--size 480x270"},
	{"ssagh-4", "SSAGH: the same with the cosine as a Gaussian", TS_BENCH_BY_ITSELF " objects runs",
     .paper = &ts_ssagh_4, .brief = "--size 480x270"},
	{"ssagh-gloss", "SSAGH: specular reflection by lobes, beside the BRDF; also of models in TS_SCENES",
     TS_BENCH_BY_ITSELF " objects runs", .paper = &ts_ssagh_gloss, .brief = "--size 240x135"},
	{"ssagh-flicker", "SSAGH: change from frame to frame beyond that of direct", TS_BENCH_BY_ITSELF " objects runs",
     .paper = &ts_ssagh_flicker, .brief = "--frames 0..29"},
	{"ssagh-5", "SSAGH: the curves c and s; no scene", "", .takes = TS_BENCH_FILES " json", .run = ts_bench_curves,
     .brief = ""},
	{"ssagh-6", "SSAGH: logistic curves fitted to s; no scene", "", .takes = TS_BENCH_FILES " json",
     .run = ts_bench_logistic, .brief = ""},
	{"ssagh-7", "SSAGH: errors of integrals with the cosine; no scene", "", .takes = TS_BENCH_FILES " json",
     .run = ts_bench_cosines, .brief = ""},
	{0},
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
	.benches = benches,
	.claims = ts_hulls_claims,
	.parts = parts,
};
