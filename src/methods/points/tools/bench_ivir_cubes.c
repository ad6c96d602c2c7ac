/* The iVIR paper's tables of cube maps: reflections, and omnidirectional shadows. */
#include <math.h>
#include "methods/points/tools/benches.h"

/* The side of the largest face of a cube in sight. */
static double largest_face(const ts_run *run)
{
	if (!run->frame.buffer[TS_B_cube_size_face].made) return NAN;
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
	double most = NAN;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_cube_size_face); i++) most = fmax(most, cubes[i].n);
	return most;
}

enum { M_IVIR, M_STORED, M_VIR, M_MVR, M_DEFAULT };

/* clang-format off */
static const ts_bench_variant cube_variants[] = {
	[M_IVIR] = { "ivir", TS_IVIR_DEFAULTS ",points.buffered=off", false, TS_TIMED },
	[M_STORED] = { "ivir", TS_IVIR_DEFAULTS ",points.buffered=on", true, TS_TIMED },
	[M_VIR] = { "vir", TS_IVIR_DEFAULTS ",points.buffered=on", true, TS_TIMED },
	[M_MVR] = { "mvr", "", true, TS_TIMED },
	[M_DEFAULT] = { "ivir", "", true, TS_TIMED },
	{ 0 },
};

enum { C_TRIANGLES, C_POINTS, C_VIR_POINTS, C_SAVED, C_POINT_MS, C_MS, C_STORED_MS, C_VIR_POINT_MS, C_VIR_MS, C_MVR_MS,
	C_OVER_VIR, C_OVER_MVR, C_STORED_OVER_VIR, C_STORED_OVER_MVR, C_A_TRIANGLE, C_LARGEST, C_D_POINTS, C_D_OVER, C_D_MS,
	C_D_OVER_MVR, C_COVERED, C_HOLES, C_HOLES_SHARE, C_D_COVERED, C_D_HOLES, C_D_HOLES_SHARE, C_MVR_HOLES, C_RMSE,
	C_D_RMSE, C_VIR_RMSE, C_MVR_RMSE, C_MORE, C_D_MORE, C_SSIM, C_D_SSIM, C_VIR_SSIM, C_MVR_SSIM, C_TO_MVR, C_D_TO_MVR,
	C_VIR_TO_MVR, C_TO_RATIO, C_D_TO_RATIO, C_LIGHTS, C_PENUMBRA };

static const ts_bench_figure cube_figures[] = {
	TS_TRIANGLES(C_TRIANGLES),
	TS_COUNT(C_POINTS, "points", "iVIR points", M_STORED, "points"),
	TS_COUNT(C_VIR_POINTS, "vir_points", "VIR points", M_VIR, "points"),
	TS_SAVED(C_SAVED, "saved_percent", "saved, %", C_POINTS, C_VIR_POINTS),
	TS_PART_MS(C_POINT_MS, "point_ms", "points", M_STORED, TS_POINT_STAGES),
	TS_PART_MS(C_MS, "bufferless_ms", "bufferless", M_IVIR, TS_MAP_STAGES),
	TS_PART_MS(C_STORED_MS, "buffered_ms", "buffered", M_STORED, TS_MAP_STAGES),
	TS_PART_MS(C_VIR_POINT_MS, "vir_point_ms", "VIR points", M_VIR, TS_POINT_STAGES),
	TS_PART_MS(C_VIR_MS, "vir_ms", "VIR", M_VIR, TS_MAP_STAGES),
	TS_PART_MS(C_MVR_MS, "mvr_ms", "MVR", M_MVR, TS_MAP_STAGES),
	TS_RATIO(C_OVER_VIR, "over_vir", "VIR / bufferless", C_VIR_MS, C_MS, 2),
	TS_RATIO(C_OVER_MVR, "over_mvr", "MVR / bufferless", C_MVR_MS, C_MS, 2),
	TS_RATIO(C_STORED_OVER_VIR, "buffered_over_vir", "VIR / buffered", C_VIR_MS, C_STORED_MS, 2),
	TS_RATIO(C_STORED_OVER_MVR, "buffered_over_mvr", "MVR / buffered", C_MVR_MS, C_STORED_MS, 2),
	TS_RATIO(C_A_TRIANGLE, "points_a_triangle", "a triangle", C_POINTS, C_TRIANGLES, 2),
	[C_LARGEST] = { "largest_face", "largest face", TS_FIGURE_LOOKED, M_STORED, 0, TS_WHOLE, "" },
	TS_COUNT(C_D_POINTS, "points_default", "points", M_DEFAULT, "points"),
	TS_RATIO(C_D_OVER, "over_paper", "by rate=paper", C_D_POINTS, C_POINTS, 2),
	TS_PART_MS(C_D_MS, "default_ms", "ms", M_DEFAULT, TS_MAP_STAGES),
	TS_RATIO(C_D_OVER_MVR, "default_over_mvr", "MVR / ms", C_MVR_MS, C_D_MS, 2),
	TS_COUNT(C_COVERED, "covered", "texels", M_STORED, "texels covered by rays"),
	TS_COUNT(C_HOLES, "holes", "holes", M_STORED, "holes"),
	TS_PERCENT(C_HOLES_SHARE, "holes_percent", "%", C_HOLES, C_COVERED),
	TS_COUNT(C_D_COVERED, "covered_default", "texels", M_DEFAULT, "texels covered by rays"),
	TS_COUNT(C_D_HOLES, "holes_default", "holes, defaults", M_DEFAULT, "holes"),
	TS_PERCENT(C_D_HOLES_SHARE, "holes_percent_default", "%", C_D_HOLES, C_D_COVERED),
	TS_COUNT(C_MVR_HOLES, "holes_mvr", "holes, MVR", M_MVR, "holes"),
	TS_RMSE(C_RMSE, "rmse", "iVIR", M_STORED),
	TS_RMSE(C_D_RMSE, "rmse_default", "defaults", M_DEFAULT),
	TS_RMSE(C_VIR_RMSE, "rmse_vir", "VIR", M_VIR),
	TS_RMSE(C_MVR_RMSE, "rmse_mvr", "MVR", M_MVR),
	TS_LESS(C_MORE, "rmse_more", "iVIR less MVR", C_RMSE, C_MVR_RMSE, 3),
	TS_LESS(C_D_MORE, "rmse_more_default", "defaults less MVR", C_D_RMSE, C_MVR_RMSE, 3),
	TS_SSIM(C_SSIM, "ssim", "iVIR, SSIM", M_STORED),
	TS_SSIM(C_D_SSIM, "ssim_default", "defaults", M_DEFAULT),
	TS_SSIM(C_VIR_SSIM, "ssim_vir", "VIR", M_VIR),
	TS_SSIM(C_MVR_SSIM, "ssim_mvr", "MVR", M_MVR),
	TS_RMSE_TO(C_TO_MVR, "to_mvr", "iVIR", M_STORED, M_MVR),
	TS_RMSE_TO(C_D_TO_MVR, "to_mvr_default", "defaults", M_DEFAULT, M_MVR),
	TS_RMSE_TO(C_VIR_TO_MVR, "to_mvr_vir", "VIR", M_VIR, M_MVR),
	TS_RATIO(C_TO_RATIO, "to_mvr_ratio", "iVIR / VIR", C_TO_MVR, C_VIR_TO_MVR, 3),
	TS_RATIO(C_D_TO_RATIO, "to_mvr_ratio_default", "defaults / VIR", C_D_TO_MVR, C_VIR_TO_MVR, 3),
	[C_LIGHTS] = { "cubes", "cubes", TS_FIGURE_PARAM, 0, 0, TS_WHOLE, "lamp.cubes" },
	TS_PENUMBRA(C_PENUMBRA, "penumbra", "penumbra", M_STORED),
	{ 0 },
};

#define POINT_FIGURES C_TRIANGLES, C_POINTS, C_A_TRIANGLE, C_VIR_POINTS, C_SAVED
#define DEFAULT_FIGURES { C_D_POINTS, C_D_OVER, C_D_MS, C_D_OVER_MVR, TS_NO_FIGURE }
#define HOLE_FIGURES { C_COVERED, C_HOLES, C_HOLES_SHARE, C_D_COVERED, C_D_HOLES, C_D_HOLES_SHARE, C_MVR_HOLES, \
	TS_NO_FIGURE }
#define IMAGE_FIGURES { C_RMSE, C_D_RMSE, C_VIR_RMSE, C_MVR_RMSE, C_MORE, C_D_MORE, C_SSIM, C_D_SSIM, C_VIR_SSIM, \
	C_MVR_SSIM, TS_NO_FIGURE }
#define RAY_RELATIONS TS_HOLE_RELATIONS(C_HOLES_SHARE, C_A_TRIANGLE, C_D_HOLES_SHARE, C_D_HOLES), \
	TS_TRUTH_RELATIONS(C_MORE, C_D_MORE, C_MVR_RMSE)

#define TIME_FIGURES { C_POINT_MS, C_MS, C_STORED_MS, C_VIR_POINT_MS, C_VIR_MS, C_MVR_MS, TS_NO_FIGURE }
#define RATIO_FIGURES { C_OVER_VIR, C_OVER_MVR, C_STORED_OVER_VIR, C_STORED_OVER_MVR, TS_NO_FIGURE }

static const ts_paper_part mirror_parts[] = {
	{ "ivir_2_points", "Points", { POINT_FIGURES, C_LARGEST, TS_NO_FIGURE } },
	{ "ivir_2_ms", "Points and environment maps, ms", TIME_FIGURES },
	{ "ivir_2_ratios", "The same, VIR's and MVR's by iVIR's", RATIO_FIGURES },
	{ "ivir_2_default", "iVIR at the defaults", DEFAULT_FIGURES },
	{ "ivir_2_holes", TS_HOLES_TITLE, HOLE_FIGURES },
	{ "ivir_2_rmse", TS_IMAGES_TITLE, IMAGE_FIGURES },
	{ 0 },
};

static const ts_paper_relation mirror_relations[] = {
	{ "iVIR points saved of VIR's, %", C_SAVED, TS_AT_LEAST, 90, 0, TS_ANY,
	  TS_OURS "VIR's worst case is reconstructed by us, and one near mirror sets iVIR's rate; see reflectors.count=1",
	  C_LARGEST },
	{ "iVIR points saved of VIR's where no face is more than a third of VIR's, %", C_SAVED, TS_AT_LEAST, 90, 0,
	  C_LARGEST, 0, 128.0 / 3, TS_IVIR_VIR, C_VIR_POINTS },
	RAY_RELATIONS,
	{ 0 },
};

#define MIRROR(scene, builtin, n, triangles, points, ms, bufferless, buffered, vir_points, vir_point_ms, vir, mvr) \
	{ scene, builtin, builtin, n, { [C_TRIANGLES] = triangles, [C_POINTS] = points, [C_POINT_MS] = ms, \
	  [C_MS] = bufferless, [C_STORED_MS] = buffered, [C_VIR_POINTS] = vir_points, \
	  [C_VIR_POINT_MS] = vir_point_ms, [C_VIR_MS] = vir, [C_MVR_MS] = mvr } }

static const ts_paper_row mirror_rows[] = {
	MIRROR("Dining", "dining", 1, 1.57e6, 1.28e6, 1.46, 2.68, 2.60, 15.07e6, 13.34, 17.01, 3.94),
	MIRROR("Dining", "dining", 8, 1.92e6, 3.82e6, 4.30, 16.69, 11.63, 40.42e6, 98.91, 199.95, 21.31),
	MIRROR("Dining", "dining", 16, 2.34e6, 5.57e6, 8.43, 43.84, 24.17, 63.37e6, 204.51, 495.35, 48.06),
	MIRROR("Dining", "dining", 20, 2.39e6, 5.60e6, 10.30, 56.53, 29.65, 66.88e6, 206.61, 570.10, 60.30),
	MIRROR("Gallery", "gallery", 1, 1.01e6, 352530, 1.13, 2.20, 2.00, 10.26e6, 8.73, 11.40, 3.44),
	MIRROR("Gallery", "gallery", 8, 1.09e6, 859330, 3.37, 17.12, 8.94, 17.63e6, 34.33, 68.25, 28.64),
	MIRROR("Gallery", "gallery", 16, 1.19e6, 995820, 6.27, 38.88, 17.35, 23.72e6, 61.46, 191.46, 58.20),
	MIRROR("Gallery", "gallery", 20, 1.24e6, 1.06e6, 7.90, 50.90, 21.46, 25.49e6, 63.86, 227.04, 74.49),
	{ 0 },
};

const ts_paper_table ts_ivir_2 = {
	.name = "ivir-2", .title = "iVIR, table 2: environment maps", .effect = "reflections", .scenes = "dining,gallery",
	.objects_head = "mirrors", .objects_param = "reflectors.count", .objects = "1,8,16,20", .set = "",
	.defaults = TS_IVIR_QUARTER, .judge = "C", .rays = true, .look = largest_face, .size = "width=480,height=270",
	.note = TS_IVIR_QUARTER_NOTE " " TS_VIR_NOTE, .timed = true, .variants = cube_variants, .figures = cube_figures,
	.parts = mirror_parts, .relations = mirror_relations, .rows = mirror_rows,
};

static const ts_paper_part omni_parts[] = {
	{ "ivir_3_points", "Points", { POINT_FIGURES, TS_NO_FIGURE } },
	{ "ivir_3_ms", "Points and depth maps, ms", TIME_FIGURES },
	{ "ivir_3_ratios", "The same, VIR's and MVR's by iVIR's", RATIO_FIGURES },
	{ "ivir_3_default", "iVIR at the defaults", DEFAULT_FIGURES },
	{ "ivir_3_holes", TS_HOLES_TITLE, HOLE_FIGURES },
	{ "ivir_3_rmse", TS_IMAGES_TITLE, IMAGE_FIGURES },
	{ "ivir_3_mvr", "Penumbras, texels wide; RMSE to MVR's image, grey levels", { C_PENUMBRA, C_TO_MVR, C_D_TO_MVR,
	  C_VIR_TO_MVR, C_TO_RATIO, C_D_TO_RATIO, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation omni_relations[] = {
	{ "iVIR points saved of VIR's, %", C_SAVED, TS_BETWEEN, 15, 30, TS_ANY, TS_IVIR_VIR,
	  C_VIR_POINTS },
	{ "RMSE to MVR, iVIR by VIR", C_TO_RATIO, TS_AT_MOST, 0, 1.1, TS_ANY, TS_IVIR_FEWER, C_SAVED },
	{ "RMSE to MVR, iVIR at the defaults by VIR", C_D_TO_RATIO, TS_AT_MOST, 0, 1.1, TS_ANY, TS_IVIR_NEAREST, C_D_OVER },
	RAY_RELATIONS,
	{ "speed by MVR's, of five lights and more", C_OVER_MVR, TS_AT_LEAST, 1, 0, C_LIGHTS, 5, 1000,
	  TS_GPU "points are made on a processor; see points.buffered=on", C_POINT_MS },
	{ 0 },
};

#define OMNI(n, points, bufferless, buffered, vir_points, vir, mvr) \
	{ "Dining", "dining", "dining", n, { [C_TRIANGLES] = 1.4e6, [C_POINTS] = points, [C_MS] = bufferless, \
	  [C_STORED_MS] = buffered, [C_VIR_POINTS] = vir_points, [C_VIR_MS] = vir, [C_MVR_MS] = mvr } }

static const ts_paper_row omni_rows[] = {
	OMNI(1, 10.94e6, 2.46, 4.03, 14.31e6, 4.75, 2.16), OMNI(5, 11.43e6, 4.86, 5.86, 14.83e6, 7.11, 7.22),
	OMNI(10, 11.69e6, 7.88, 7.98, 15.03e6, 8.98, 15.15), OMNI(20, 11.74e6, 20.32, 30.74, 15.07e6, 36.97, 29.74),
	{ 0 },
};

const ts_paper_table ts_ivir_3 = {
	.name = "ivir-3", .title = "iVIR, table 3: omnidirectional soft shadows", .effect = "omni-shadows",
	.scenes = "dining", .objects_head = "lights", .objects_param = "lamp.cubes", .objects = "1,5,10,20",
	.set = "reflectors.count=0", .defaults = "depth_map.px=512,truth.area_samples=256", .judge = "area", .rays = true,
	.look = ts_bench_penumbra, .size = "width=960,height=540",
	.note = "Depth maps have 512 x 512 texels, the paper's 1024 x 1024. " TS_VIR_NOTE, .timed = true,
	.variants = cube_variants, .figures = cube_figures, .parts = omni_parts, .relations = omni_relations,
	.rows = omni_rows,
};
/* clang-format on */
