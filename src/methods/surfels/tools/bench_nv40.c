/* The timings of the slides on surface splatting: surfels per second by shader, and how little the shader matters, as
 * each pixel is shaded once for any number of fragments. */
#include "methods/surfels/tools/tools.h"

/* By shader, each with and without the screen filter, on all threads and on one. */
enum { PHONG, NPR, PHONG_SHADOW, NPR_SHADOW, SHADERS };
enum { M_BOTH = 0, M_OBJECT = SHADERS, M_BOTH_ALONE = 2 * SHADERS, M_OBJECT_ALONE = 3 * SHADERS };

/* clang-format off */
#define EACH(first, filter, seen, runs) \
	[(first) + PHONG] = { "deferred", "ewa.filter=" filter ",deferred.shader=phong", seen, runs }, \
	[(first) + NPR] = { "deferred", "ewa.filter=" filter ",deferred.shader=npr", false, runs }, \
	[(first) + PHONG_SHADOW] = { "deferred", "ewa.filter=" filter ",deferred.shader=phong_shadow", false, runs }, \
	[(first) + NPR_SHADOW] = { "deferred", "ewa.filter=" filter ",deferred.shader=npr_shadow", false, runs }

static const ts_bench_variant variants[] = {
	EACH(M_BOTH, "min", true, TS_TIMED), EACH(M_OBJECT, "object", true, TS_TIMED),
	EACH(M_BOTH_ALONE, "min", false, TS_ALONE), EACH(M_OBJECT_ALONE, "object", false, TS_ALONE), { 0 },
};

/* Rates are numbered like their variants. */
enum { SURFELS = 4 * SHADERS, NPR_COST, NPR_SHADOW_COST, SHADOW_COST, FILTER_COST, THREADS, FRAGMENTS, OBJECT_FRAGMENTS,
       SHADED, OBJECT_SHADED, SEEN, OBJECT_SEEN, OVERLAP, OBJECT_OVERLAP, MORE, ONCE, OBJECT_ONCE, NPR_SHADED,
       DRAWN, A_PIXEL, NPR_ONCE };

#define RATE(variant, key, head) [variant] = { key, head, TS_FIGURE_SURFEL_RATE, variant, 0, 2, "" }
#define RATES(first, key) \
	RATE((first) + PHONG, "phong" key, "Phong"), RATE((first) + NPR, "npr" key, "NPR"), \
	RATE((first) + PHONG_SHADOW, "phong_shadow" key, "Phong, shadows"), \
	RATE((first) + NPR_SHADOW, "npr_shadow" key, "NPR, shadows")

static const ts_bench_figure figures[] = {
	RATES(M_BOTH, ""), RATES(M_OBJECT, "_object"), RATES(M_BOTH_ALONE, "_alone"),
	RATES(M_OBJECT_ALONE, "_object_alone"),
	[SURFELS] = { "surfels", "surfels", TS_FIGURE_SURFELS, 0, 0, TS_WHOLE, "" },
	[NPR_COST] = { "npr_ratio", "NPR / Phong", TS_FIGURE_RATIO, NPR, PHONG, 3, "" },
	[NPR_SHADOW_COST] = { "npr_shadow_ratio", "with shadows", TS_FIGURE_RATIO, NPR_SHADOW, PHONG_SHADOW, 3, "" },
	[SHADOW_COST] = { "shadow_ratio", "shadows / none", TS_FIGURE_RATIO, PHONG_SHADOW, PHONG, 3, "" },
	[FILTER_COST] = { "filter_ratio", "screen filter / none", TS_FIGURE_RATIO, PHONG, M_OBJECT + PHONG, 3, "" },
	[THREADS] = { "threads_ratio", "threads / 1", TS_FIGURE_RATIO, PHONG, M_BOTH_ALONE + PHONG, 3, "" },
	[FRAGMENTS] = { "fragments", "fragments", TS_FIGURE_COUNTER, M_BOTH, 0, TS_WHOLE, "fragments" },
	[OBJECT_FRAGMENTS] = { "fragments_object", "fragments", TS_FIGURE_COUNTER, M_OBJECT, 0, TS_WHOLE, "fragments" },
	[SHADED] = { "shaded", "shading operations", TS_FIGURE_COUNTER, M_BOTH, 0, TS_WHOLE, "shading operations" },
	[OBJECT_SHADED] = { "shaded_object", "no screen filter", TS_FIGURE_COUNTER, M_OBJECT, 0, TS_WHOLE,
	                    "shading operations" },
	[SEEN] = { "covered", "covered", TS_FIGURE_SEEN, M_BOTH, 0, TS_WHOLE, "" },
	[OBJECT_SEEN] = { "covered_object", "no screen filter", TS_FIGURE_SEEN, M_OBJECT, 0, TS_WHOLE, "" },
	[OVERLAP] = { "overlap", "fragments a pixel", TS_FIGURE_RATIO, FRAGMENTS, SEEN, 2, "" },
	[OBJECT_OVERLAP] = { "overlap_object", "no screen filter", TS_FIGURE_RATIO, OBJECT_FRAGMENTS, OBJECT_SEEN, 2, "" },
	[MORE] = { "overlap_ratio", "by ours without", TS_FIGURE_RATIO, OVERLAP, OBJECT_OVERLAP, 2, "" },
	[ONCE] = { "shaded_a_pixel", "a pixel", TS_FIGURE_RATIO, SHADED, SEEN, 3, "" },
	[OBJECT_ONCE] = { "shaded_a_pixel_object", "no screen filter", TS_FIGURE_RATIO, OBJECT_SHADED, OBJECT_SEEN, 3, "" },
	[NPR_SHADED] = { "shaded_npr", "NPR", TS_FIGURE_COUNTER, M_BOTH + NPR, 0, TS_WHOLE, "shading operations" },
	[DRAWN] = { "drawn", "surfels drawn", TS_FIGURE_COUNTER, M_BOTH, 0, TS_WHOLE, "surfels drawn" },
	[A_PIXEL] = { "surfels_a_pixel", "surfels a pixel", TS_FIGURE_RATIO, DRAWN, SEEN, 2, "" },
	[NPR_ONCE] = { "shaded_a_pixel_npr", "NPR", TS_FIGURE_RATIO, NPR_SHADED, SEEN, 3, "" },
	{ 0 },
};

#define SHADERS_OF(first) (first) + PHONG, (first) + NPR, (first) + PHONG_SHADOW, (first) + NPR_SHADOW

static const ts_paper_part parts[] = {
	{ "nv40", "NV40: millions of surfels a second, whole frames", { SURFELS, SHADERS_OF(M_BOTH), TS_NO_FIGURE } },
	{ "nv40_object", "Without the screen filter", { SHADERS_OF(M_OBJECT), TS_NO_FIGURE } },
	{ "nv40_alone", "One thread", { SHADERS_OF(M_BOTH_ALONE), TS_NO_FIGURE } },
	{ "nv40_object_alone", "One thread, without the screen filter", { SHADERS_OF(M_OBJECT_ALONE), TS_NO_FIGURE } },
	{ "nv40_ratios", "Ratios of these rates", { NPR_COST, NPR_SHADOW_COST, SHADOW_COST, FILTER_COST, THREADS,
	  TS_NO_FIGURE } },
	{ "nv40_fragments", "Pixels with a surface, and fragments that blend there", { SEEN, OBJECT_SEEN, A_PIXEL,
	  OVERLAP, OBJECT_OVERLAP, MORE, TS_NO_FIGURE } },
	{ "nv40_shading", "Shading operations, whatever overlaps", { SHADED, OBJECT_SHADED, ONCE, OBJECT_ONCE,
	  NPR_ONCE, TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

#define NOT_DEFERRED TS_OURS "not deferred; see deferred.shader"
static const ts_paper_relation relations[] = {
	{ "fragments a pixel, of 10 to 20 surfels a pixel", OVERLAP, TS_BETWEEN, 20, 40, A_PIXEL, 10, 20,
	  TS_ELSEWHERE "surfels are wider or narrower; see surfels.radius", OBJECT_OVERLAP },
	{ "fragments a pixel without the screen filter, of those", OBJECT_OVERLAP, TS_BETWEEN, 4, 10, A_PIXEL, 10, 20,
	  TS_ELSEWHERE "surfels are wider or narrower; see surfels.radius", A_PIXEL },
	{ "shading operations a pixel", ONCE, TS_BETWEEN, 1, 1, ALL, NOT_DEFERRED, OVERLAP },
	{ "the same without the screen filter", OBJECT_ONCE, TS_BETWEEN, 1, 1, ALL, NOT_DEFERRED, OBJECT_OVERLAP },
	{ "the same of NPR", NPR_ONCE, TS_BETWEEN, 1, 1, ALL, NOT_DEFERRED, OVERLAP },
	{ "rate of NPR / Phong", NPR_COST, TS_BETWEEN, 0.85, 1.1, ALL,
	  TS_GPU "48 instructions against 8 are work on a processor; see deferred.shader", NPR_COST },
	{ "the same with shadows", NPR_SHADOW_COST, TS_BETWEEN, 0.85, 1.1, ALL,
	  TS_GPU "48 instructions against 8 are work on a processor; see deferred.shader", NPR_SHADOW_COST },
	{ "rate with shadows / without", SHADOW_COST, TS_BETWEEN, 0.4, 1.1, ALL,
	  TS_GPU "the depth map is made by the same processor; see depth_map.px", SHADOW_COST },
	{ 0 },
};

/* On a GeForce 6800 Ultra; scenes and sizes are not stated. */
#define ROW(builtin, file, pixels) \
	{ "slides", builtin, file, pixels, { [PHONG] = 22.8, [NPR] = 21.3, [PHONG_SHADOW] = 15.7, [NPR_SHADOW] = 15.0, \
	  [OVERLAP] = 30, [OBJECT_OVERLAP] = 7, [ONCE] = 1, [OBJECT_ONCE] = 1 } }
#define ROWS(builtin, file) \
	ROW(builtin, file, 240 * 135), ROW(builtin, file, 480 * 270), ROW(builtin, file, 1920 * 1080)

static const ts_paper_row rows[] = { ROWS("checkerboard", "bunny"), ROWS("atrium", "dragon"), { 0 } };

const ts_paper_table ts_nv40 = {
	.name = "nv40", .title = "NV40 surface splatting: who runs", .effect = "surfels", .scenes = "checkerboard,atrium",
	.models = "bunny_splats.glb,dragon_splats.glb", .objects_head = "pixels", .objects = "240x135,480x270,1920x1080",
	.sampled = 300000, .set = "", .defaults = "eye.distance=outside", .timed = true,
	.note = "Scenes without surfels are sampled to 300,000. The slides' scenes and sizes are not known.",
	.variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
