/* The tables of many views for the tools. */
#include "methods/views/tools/tools.h"
#include "methods/raster/tools/truth_gather.h"
#include "methods/tools/family.h"
#include "methods/views/tools/probe.h"

static const ts_margin_rule margins[] = {
	{TS_B_view_map_depth_node, TS_B_view_map_margin, .of = 1, .steps = 1.0f},
	{TS_B_vpl_gather_irradiance, TS_B_vpl_gather_margin, .of = 3, .steps = 1.0f},
	{0},
};

static const ts_truth_kind truths[] = {
	{"vpls", "indirect", "all virtual point lights, where they are seen", "method", "", "",
     .begin = ts_truth_indirect_begin, .trace = ts_truth_vpls, .image = "image.indirect"},
	{"glow", "particles", "all particles, where they are seen", "method", "", "", .begin = ts_truth_particles_begin,
     .trace = ts_truth_glow, .image = "image.indirect"},
	{0},
};

static const ts_texel_rule texels[] = {
	{TS_B_vpl_gather_irradiance, ts_truth_maps},
	{0},
};

/* clang-format off */
static const ts_probe_part parts[] = {
	{TS_PROBE_PIXEL, "vpl_gather", ts_probe_views_pixel,
	 "the lights that culling leaves, the brightest of those it draws, and its neighbours in the filter", NULL},
	{TS_PROBE_TEXEL, "view_map.fuse", ts_probe_light_texel,
	 "the pairs of nodes rendered into it and above it, and what fusion made of them", &ts_probe_map_of_light},
	{TS_PROBE_TEXEL, "view_map.fuse", ts_probe_node_texel, "the same", &ts_probe_map_of_node},
	{0},
};
/* clang-format on */

/* For the share of empty texels (bench_mega.c). */
static const ts_buffer_id keeps[] = {TS_B_view_octree_node, TS_B_view_map_fused_depth, TS_N_BUFFERS};

static u64 queue_bytes(const ts_params *params) { return (u64)TS_PARAM(params, traverse_queue_mb) << 20; }

static const ts_lower_rule lowers[] = {
	{TS_B_view_map_depth_node, "traverse.queue_mb", queue_bytes},
	{0},
};

const ts_family_tools ts_views_tools = {
	.margins = margins,
	.checks = ts_views_checks,
	.truths = truths,
	.texels = texels,
	.codes = ts_views_codes,
	.parts = parts,
	.pictures = ts_views_pictures,
	.places = ts_views_places,
	.keeps = keeps,
	.lowers = lowers,
};
