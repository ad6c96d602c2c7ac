/* The slides' three-pass shading and per-pixel Phong shading: how often flat, Gouraud, Phong and deferred shading
 * shade, and how close their pictures are to rays into the sampled surface. */
#include "methods/surfels/tools/tools.h"

enum { FLAT, GOURAUD, PHONG, DEFERRED, METHODS };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[FLAT] = { "flat", "", true, TS_ONCE }, [GOURAUD] = { "gouraud", "", true, TS_ONCE },
	[PHONG] = { "phong", "", true, TS_ONCE }, [DEFERRED] = { "deferred", "", true, TS_ONCE }, { 0 },
};

enum { PSNR, SSIM = METHODS, SHADED = 2 * METHODS, ONCE = 3 * METHODS, DRAWN = 4 * METHODS, SEEN, FRAGMENTS, OVERLAP,
       A_PIXEL, SAVED, OVER_FLAT, OVER_GOURAUD, PHONG_OVER, OVER_PHONG };

#define EACH(first, key, kind, digits, what) \
	[(first) + FLAT] = { "flat_" key, "flat", kind, FLAT, 0, digits, what }, \
	[(first) + GOURAUD] = { "gouraud_" key, "Gouraud", kind, GOURAUD, 0, digits, what }, \
	[(first) + PHONG] = { "phong_" key, "Phong", kind, PHONG, 0, digits, what }, \
	[(first) + DEFERRED] = { "deferred_" key, "deferred", kind, DEFERRED, 0, digits, what }
#define A_PIXEL_OF(method, name, head) \
	[ONCE + (method)] = { name "_a_pixel", head, TS_FIGURE_RATIO, SHADED + (method), SEEN, 2, "" }

static const ts_bench_figure figures[] = {
	EACH(PSNR, "psnr", TS_FIGURE_PSNR, 2, ""), EACH(SSIM, "ssim", TS_FIGURE_SSIM, 4, ""),
	EACH(SHADED, "shaded", TS_FIGURE_COUNTER, TS_WHOLE, "shading operations"),
	A_PIXEL_OF(FLAT, "flat", "flat"), A_PIXEL_OF(GOURAUD, "gouraud", "Gouraud"), A_PIXEL_OF(PHONG, "phong", "Phong"),
	A_PIXEL_OF(DEFERRED, "deferred", "deferred"),
	[DRAWN] = { "drawn", "surfels", TS_FIGURE_COUNTER, DEFERRED, 0, TS_WHOLE, "surfels drawn" },
	[SEEN] = { "covered", "pixels", TS_FIGURE_SEEN, DEFERRED, 0, TS_WHOLE, "" },
	[FRAGMENTS] = { "fragments", "fragments", TS_FIGURE_COUNTER, DEFERRED, 0, TS_WHOLE, "fragments" },
	[OVERLAP] = { "overlap", "fragments a pixel", TS_FIGURE_RATIO, FRAGMENTS, SEEN, 2, "" },
	[A_PIXEL] = { "surfels_a_pixel", "surfels a pixel", TS_FIGURE_RATIO, DRAWN, SEEN, 2, "" },
	[SAVED] = { "saved", "Phong / deferred", TS_FIGURE_RATIO, SHADED + PHONG, SHADED + DEFERRED, 2, "" },
	[OVER_FLAT] = { "over_flat", "over flat", TS_FIGURE_DIFFERENCE, PSNR + DEFERRED, PSNR + FLAT, 2, "" },
	[OVER_GOURAUD] = { "over_gouraud", "over Gouraud", TS_FIGURE_DIFFERENCE, PSNR + DEFERRED, PSNR + GOURAUD, 2, "" },
	[PHONG_OVER] = { "phong_ssim_over_gouraud", "Phong over Gouraud", TS_FIGURE_DIFFERENCE, SSIM + PHONG,
	  SSIM + GOURAUD, 4, "" },
	[OVER_PHONG] = { "over_phong", "over Phong", TS_FIGURE_DIFFERENCE, PSNR + DEFERRED, PSNR + PHONG, 2, "" },
	{ 0 },
};

#define OF(first) (first) + FLAT, (first) + GOURAUD, (first) + PHONG, (first) + DEFERRED

static const ts_paper_part parts[] = {
	{ "nv40_shading", "NV40: shading operations a pixel", { OVERLAP, A_PIXEL, OF(ONCE), SAVED, TS_NO_FIGURE } },
	{ "nv40_shading_psnr", "PSNR to the surface, dB", { OF(PSNR), OVER_FLAT, OVER_GOURAUD, OVER_PHONG,
	  TS_NO_FIGURE } },
	{ "nv40_shading_ssim", "SSIM", { OF(SSIM), PHONG_OVER, TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

/* Slides show models from near. Where surfels outnumber pixels a filter gives the mean of shaded colours, which is not
 * the shade of a mean normal. */
static const ts_paper_relation relations[] = {
	{ "shading operations a pixel, deferred", ONCE + DEFERRED, TS_BETWEEN, 1, 1, ALL,
	  TS_OURS "not deferred; see deferred.shader", OVERLAP },
	{ "shading operations, Phong / deferred", SAVED, TS_AT_LEAST, 7, 0, ALL,
	  TS_ELSEWHERE "fewer fragments a pixel; see surfels.radius", OVERLAP },
	{ "dB, deferred over flat", OVER_FLAT, TS_AT_LEAST, 0, 0, ALL,
	  TS_ELSEWHERE "many surfels a pixel, of which the nearest is near enough; see surfels.from_mesh", A_PIXEL },
	{ "SSIM, Phong over Gouraud, where pixels outnumber surfels", PHONG_OVER, TS_AT_LEAST, 0, 0, A_PIXEL, 0, 1,
	  TS_ELSEWHERE "few highlights, or edges that both blend; see surfels.from_mesh", A_PIXEL },
	{ 0 },
};

#define ROW(builtin, file, pixels) { "slides", builtin, file, pixels, { [OVERLAP] = 30, [ONCE + DEFERRED] = 1 } }
#define ROWS(builtin, file) ROW(builtin, file, 240 * 135), ROW(builtin, file, 960 * 540)

static const ts_paper_row rows[] = { ROWS("gallery", "suzanne"), ROWS("dining", "bunny"), { 0 } };

const ts_paper_table ts_nv40_shading = {
	.name = "nv40-shading", .title = "NV40, 3-pass shading: who runs", .effect = "surfels", .scenes = "gallery,dining",
	.models = "suzanne.glb,bunny.glb,damaged_helmet.glb", .objects_head = "pixels", .objects = "240x135,960x540",
	.sampled = 20000,
	.set = "", .defaults = "eye.distance=outside", .judge = "surface",
	.note = "Scenes are sampled to 20,000 surfels or one a triangle. The slides' scenes and sizes are not known.",
	.variants = variants, .figures = figures, .parts = parts, .relations = relations, .rows = rows,
};
/* clang-format on */
