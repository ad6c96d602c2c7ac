/* The slides' pictures of filters and of frame buffers: the object filter alone, the lesser of two radii and exact EWA,
 * and sums of 8 bits, half floats and floats, compared with rays into the surface; and the object filter compared with
 * rays into the surfels themselves. */
#include "methods/surfels/tools/tools.h"

enum { OBJECT, LESSER, EXACT, BYTES, HALF, FLOAT, METHODS };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[OBJECT] = { "deferred", "ewa.filter=object", true, TS_ONCE },
	[LESSER] = { "deferred", "", true, TS_ONCE },
	[EXACT] = { "ewa", "", true, TS_ONCE },
	[BYTES] = { "deferred", "surfel_blend.accumulation=8bit", true, TS_ONCE },
	[HALF] = { "deferred", "surfel_blend.accumulation=half", true, TS_ONCE },
	[FLOAT] = { "deferred", "surfel_blend.accumulation=float32", true, TS_ONCE },
	{ 0 },
};

enum { PSNR, SSIM = METHODS, FRAGMENTS = 2 * METHODS, OBJECT_FRAGMENTS, SEEN, OBJECT_SEEN, OVERLAP, OBJECT_OVERLAP,
       MORE, OVER_OBJECT, UNDER_EXACT, SSIM_MORE, BYTES_LOSE, HALF_LOSES, FLOAT_LOSES, WIDER };

#define EACH(first, key, kind, digits) \
	[(first) + OBJECT] = { key "_object", "object", kind, OBJECT, 0, digits, "" }, \
	[(first) + LESSER] = { key, "lesser", kind, LESSER, 0, digits, "" }, \
	[(first) + EXACT] = { key "_exact", "exact", kind, EXACT, 0, digits, "" }, \
	[(first) + BYTES] = { key "_8bit", "8 bits", kind, BYTES, 0, digits, "" }, \
	[(first) + HALF] = { key "_half", "half", kind, HALF, 0, digits, "" }, \
	[(first) + FLOAT] = { key "_float", "float", kind, FLOAT, 0, digits, "" }
#define LESS(id, key, head, a, b) [id] = { key, head, TS_FIGURE_DIFFERENCE, PSNR + (a), PSNR + (b), 3, "" }

static const ts_bench_figure figures[] = {
	EACH(PSNR, "psnr", TS_FIGURE_PSNR, 2), EACH(SSIM, "ssim", TS_FIGURE_SSIM, 4),
	[FRAGMENTS] = { "fragments", "fragments", TS_FIGURE_COUNTER, LESSER, 0, TS_WHOLE, "fragments" },
	[OBJECT_FRAGMENTS] = { "fragments_object", "object", TS_FIGURE_COUNTER, OBJECT, 0, TS_WHOLE, "fragments" },
	[SEEN] = { "covered", "covered", TS_FIGURE_SEEN, LESSER, 0, TS_WHOLE, "" },
	[OBJECT_SEEN] = { "covered_object", "object", TS_FIGURE_SEEN, OBJECT, 0, TS_WHOLE, "" },
	[OVERLAP] = { "overlap", "fragments a pixel", TS_FIGURE_RATIO, FRAGMENTS, SEEN, 2, "" },
	[OBJECT_OVERLAP] = { "overlap_object", "object", TS_FIGURE_RATIO, OBJECT_FRAGMENTS, OBJECT_SEEN, 2, "" },
	[MORE] = { "overlap_ratio", "lesser / object", TS_FIGURE_RATIO, OVERLAP, OBJECT_OVERLAP, 2, "" },
	LESS(OVER_OBJECT, "psnr_over_object", "lesser - object", LESSER, OBJECT),
	LESS(UNDER_EXACT, "psnr_over_exact", "lesser - exact", LESSER, EXACT),
	[SSIM_MORE] = { "ssim_over_object", "lesser - object", TS_FIGURE_DIFFERENCE, SSIM + LESSER, SSIM + OBJECT, 4, "" },
	LESS(BYTES_LOSE, "8bit_loses", "8 bits lose", LESSER, BYTES),
	LESS(HALF_LOSES, "half_loses", "half loses", LESSER, HALF),
	LESS(FLOAT_LOSES, "float_loses", "float loses", LESSER, FLOAT),
	[WIDER] = { "covered_ratio", "pixels, lesser / object", TS_FIGURE_RATIO, SEEN, OBJECT_SEEN, 3, "" },
	{ 0 },
};

#define OF(first) (first) + OBJECT, (first) + LESSER, (first) + EXACT, (first) + BYTES, (first) + HALF, \
	(first) + FLOAT

static const ts_paper_part parts[] = {
	{ "nv40_filter", "NV40, filters and sums: PSNR to rays into the surface, dB", { OF(PSNR), TS_NO_FIGURE } },
	{ "nv40_filter_less", "The same, one less another", { OVER_OBJECT, UNDER_EXACT, BYTES_LOSE,
	  HALF_LOSES, FLOAT_LOSES, TS_NO_FIGURE } },
	{ "nv40_filter_ssim", "SSIM", { OF(SSIM), SSIM_MORE, TS_NO_FIGURE } },
	{ "nv40_filter_fragments", "Fragments that blend, and a pixel with a surface", { FRAGMENTS, OBJECT_FRAGMENTS,
	  OVERLAP, OBJECT_OVERLAP, MORE, WIDER, TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

static const ts_paper_relation relations[] = {
	{ "dB of the lesser radius over the object filter", OVER_OBJECT, TS_AT_LEAST, 0, 0, MORE, 1.5, 1e6,
	  TS_ELSEWHERE "surfels are wider than what they sample; see surfels.from_mesh", WIDER },
	{ "SSIM of the lesser radius over the object filter", SSIM_MORE, TS_AT_LEAST, 0, 0, MORE, 1.5, 1e6,
	  TS_ELSEWHERE "surfels are wider than what they sample; see surfels.from_mesh", WIDER },
	{ "dB of the lesser radius over exact EWA", UNDER_EXACT, TS_AT_LEAST, -1, 0, ALL,
	  TS_NOT_ALWAYS "the lesser radius is coarser; see ewa.sigma_h",
	  PSNR + EXACT },
	{ "fragments of the lesser radius by the object filter's", MORE, TS_AT_LEAST, 1, 0, ALL,
	  TS_ELSEWHERE "surfels are wider than pixels; see surfels.from_mesh",
	  OBJECT_OVERLAP },
	{ "dB that 8 bits lose", BYTES_LOSE, TS_AT_LEAST, 1, 0, ALL,
	  TS_ELSEWHERE "few fragments, whose sums stay below 1; see surfels.radius", OVERLAP },
	{ "dB that half floats lose", HALF_LOSES, TS_AT_MOST, 0, 0.05, ALL,
	  TS_NOT_ALWAYS "many fragments; see surfels.radius", OVERLAP },
	{ "dB that floats lose", FLOAT_LOSES, TS_AT_MOST, 0, 0.001, ALL,
	  TS_NOT_ALWAYS "many fragments; see surfels.radius", OVERLAP },
	{ 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_nv40_filter = {
	.name = "nv40-filter", .title = "NV40, filters and sums: who runs", .effect = "surfels",
	.scenes = "checkerboard,gallery,dining", .models = "bunny.glb,armadillo_86k.glb", .objects_head = "pixels",
	.objects = "240x135,480x270", .sampled = 60000, .set = "", .defaults = "eye.distance=outside", .judge = "surface",
	.note = "Scenes are sampled to 60,000 surfels or one a triangle.", .variants = variants, .figures = figures,
	.parts = parts, .relations = relations, .rows = rows,
};

/* Rays into the surfels. */
static const ts_bench_variant disc_variants[] = { { "deferred", "ewa.filter=object", true, TS_ONCE }, { 0 } };

enum { D_RMSE, D_PSNR, D_SSIM, D_DRAWN };

static const ts_bench_figure disc_figures[] = {
	[D_RMSE] = { "rmse", "RMSE", TS_FIGURE_RMSE, 0, 0, 3, "" },
	[D_PSNR] = { "psnr", "PSNR", TS_FIGURE_PSNR, 0, 0, 2, "" },
	[D_SSIM] = { "ssim", "SSIM", TS_FIGURE_SSIM, 0, 0, 4, "" },
	[D_DRAWN] = { "drawn", "surfels drawn", TS_FIGURE_COUNTER, 0, 0, TS_WHOLE, "surfels drawn" },
	{ 0 },
};

static const ts_paper_part disc_parts[] = {
	{ "nv40_discs", "NV40, the object filter beside rays into the surfels: grey levels, dB", { D_DRAWN, D_RMSE, D_PSNR,
	  D_SSIM, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation disc_relations[] = {
	{ "PSNR to rays into the surfels, dB", D_PSNR, TS_AT_LEAST, 30, 0, ALL,
	  TS_OURS "a pixel has one ray where the truth has several; see truth.grid_rays", D_RMSE },
	{ "SSIM to rays into the surfels", D_SSIM, TS_AT_LEAST, 0.95, 0, ALL,
	  TS_OURS "a pixel has one ray where the truth has several; see truth.grid_rays", D_RMSE },
	{ 0 },
};

const ts_paper_table ts_nv40_discs = {
	.name = "nv40-discs", .title = "NV40, rays into surfels: who runs", .effect = "surfels",
	.scenes = "atrium,gallery", .models = "bunny_splats.glb", .objects_head = "pixels",
	.objects = "240x135,480x270", .sampled = 60000, .set = "", .defaults = "eye.distance=outside",
	.judge = "discs", .note = "Scenes without surfels are sampled to 60,000.", .variants = disc_variants,
	.figures = disc_figures, .parts = disc_parts, .relations = disc_relations, .rows = rows,
};
/* clang-format on */
