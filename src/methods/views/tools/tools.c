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

static const ts_bench_row benches[] = {
	{"mega-9", "MegaViews: reflections by views in colour, with and without hole filling; --objects are levels",
     TS_BENCH_BY_ITSELF, .paper = &ts_mega_9, .brief = "--objects 8,9 --size 240x135"},
	{"mega-10", "MegaViews and ManyLoDs as views become many; --objects are paths of light", TS_BENCH_BY_ITSELF,
     .paper = &ts_mega_10, .brief = "--objects 64,1024,65536,1048576 --runs 1"},
	{"mega-10-bounces", "the same of four bounces", TS_BENCH_BY_ITSELF, .paper = &ts_mega_10_bounces,
     .brief = "--objects 64,256,262144 --runs 1"},
	{"mega-11", "MegaViews: of views at random on all surfaces; --objects are paths of light", TS_BENCH_BY_ITSELF,
     .paper = &ts_mega_11, .brief = "--objects 1024,65536 --runs 1"},
	{"mega-12", "MegaViews: as maps become large; --objects are texels a side", TS_BENCH_BY_ITSELF,
     .paper = &ts_mega_12, .brief = "--objects 16,32 --size 160x90 --runs 1"},
	{"mega-13", "MegaViews: as octrees become deep; --objects are levels", TS_BENCH_BY_ITSELF, .paper = &ts_mega_13,
     .brief = "--size 160x90 --runs 1"},
	{"mega-14", "MegaViews: many small maps against few large ones", TS_BENCH_BY_ITSELF, .paper = &ts_mega_14,
     .brief = "--objects 1024 --size 80x45 --runs 1"},
	{"mega-15", "MegaViews: maps of 16 and 64 texels against rays; --objects are levels", TS_BENCH_BY_ITSELF,
     .paper = &ts_mega_15, .brief = "--objects 8 --size 80x45"},
	{"mega-16", "MegaViews: what gathering culls; --objects are levels", TS_BENCH_BY_ITSELF, .paper = &ts_mega_16,
     .brief = ""},
	{"mega-17", "MegaViews: particles with shadows and without; --objects are how many", TS_BENCH_BY_ITSELF,
     .paper = &ts_mega_17, .brief = ""},
	{"mega-particles", "MegaViews: of particles at random in the air; --objects are how many", TS_BENCH_BY_ITSELF,
     .paper = &ts_mega_particles, .brief = "--size 160x90 --runs 1"},
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
	.benches = benches,
	.speed = &ts_views_speed,
	.claims = ts_views_claims,
	.parts = parts,
	.pictures = ts_views_pictures,
	.places = ts_views_places,
	.keeps = keeps,
	.lowers = lowers,
};
