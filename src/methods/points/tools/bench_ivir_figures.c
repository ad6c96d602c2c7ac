/* The iVIR paper's figures 3, 4 and 6: its pictures, with RMSE and SSIM for its HDR-VDP2.
 * Figure 5 is bench_pcss.c's, figure 7 that of table 3. */
#include "benches.h"

/* clang-format off */
#define ALL TS_NO_FIGURE, 0, 0
#define COUNT(id, key, head, variant, counter) [id] = { key, head, TS_FIGURE_COUNTER, variant, 0, TS_WHOLE, counter }
#define RMSE(id, key, head, variant) [id] = { key, head, TS_FIGURE_RMSE, variant, 0, 3, "" }
#define SSIM(id, key, head, variant) [id] = { key, head, TS_FIGURE_SSIM, variant, 0, 4, "" }
#define RMSE_TO(id, key, head, variant, to) [id] = { key, head, TS_FIGURE_RMSE, variant, to, 3, TS_TO_IMAGE }
#define SSIM_TO(id, key, head, variant, to) [id] = { key, head, TS_FIGURE_SSIM, variant, to, 4, TS_TO_IMAGE }
#define LESS(id, key, head, a, b) [id] = { key, head, TS_FIGURE_DIFFERENCE, a, b, 3, "" }
#define RATIO(id, key, head, a, b) [id] = { key, head, TS_FIGURE_RATIO, a, b, 3, "" }
#define PERCENT(id, key, head, a, b) [id] = { key, head, TS_FIGURE_PERCENT, a, b, 4, "" }

static const ts_paper_row rows[] = { { 0 } };

/* Figure 3: soft shadows with and without stochastic culling. */
enum { K_WHOLE, K_CULLED, K_WHOLE_D, K_CULLED_D };

static const ts_bench_variant cull_variants[] = {
	[K_WHOLE] = { "ivir", TS_IVIR_DEFAULTS ",points.cull=off", true, TS_ONCE },
	[K_CULLED] = { "ivir", TS_IVIR_DEFAULTS ",points.cull=on", true, TS_ONCE },
	[K_WHOLE_D] = { "ivir", "points.cull=off", true, TS_ONCE },
	[K_CULLED_D] = { "ivir", "points.cull=on", true, TS_ONCE },
	{ 0 },
};

enum { POINTS, CULLED, SHARE, POINTS_D, CULLED_D, SHARE_D, COVERED, HOLES, HOLES_CULLED, HOLES_D, HOLES_CULLED_D,
	LOST_D, CHANGE, CHANGE_SSIM, CHANGE_D, CHANGE_SSIM_D, ERROR, ERROR_CULLED, WORSE, ERROR_D, ERROR_CULLED_D,
	WORSE_D };

static const ts_bench_figure cull_figures[] = {
	COUNT(POINTS, "points", "points", K_WHOLE, "points"),
	COUNT(CULLED, "points_culled", "culled", K_CULLED, "points"),
	RATIO(SHARE, "share", "share", CULLED, POINTS),
	COUNT(POINTS_D, "points_default", "defaults", K_WHOLE_D, "points"),
	COUNT(CULLED_D, "points_culled_default", "culled", K_CULLED_D, "points"),
	RATIO(SHARE_D, "share_default", "share", CULLED_D, POINTS_D),
	COUNT(COVERED, "covered", "texels", K_WHOLE_D, "texels covered by rays"),
	COUNT(HOLES, "holes", "holes", K_WHOLE, "holes"),
	COUNT(HOLES_CULLED, "holes_culled", "culled", K_CULLED, "holes"),
	COUNT(HOLES_D, "holes_default", "defaults", K_WHOLE_D, "holes"),
	COUNT(HOLES_CULLED_D, "holes_culled_default", "culled", K_CULLED_D, "holes"),
	PERCENT(LOST_D, "lost_percent", "%", HOLES_CULLED_D, COVERED),
	RMSE_TO(CHANGE, "rmse_culled", "RMSE", K_CULLED, K_WHOLE),
	SSIM_TO(CHANGE_SSIM, "ssim_culled", "SSIM", K_CULLED, K_WHOLE),
	RMSE_TO(CHANGE_D, "rmse_culled_default", "RMSE, defaults", K_CULLED_D, K_WHOLE_D),
	SSIM_TO(CHANGE_SSIM_D, "ssim_culled_default", "SSIM", K_CULLED_D, K_WHOLE_D),
	RMSE(ERROR, "rmse_truth", "not culled", K_WHOLE),
	RMSE(ERROR_CULLED, "rmse_truth_culled", "culled", K_CULLED),
	LESS(WORSE, "rmse_truth_more", "more", ERROR_CULLED, ERROR),
	RMSE(ERROR_D, "rmse_truth_default", "defaults", K_WHOLE_D),
	RMSE(ERROR_CULLED_D, "rmse_truth_culled_default", "culled", K_CULLED_D),
	LESS(WORSE_D, "rmse_truth_more_default", "more", ERROR_CULLED_D, ERROR_D),
	{ 0 },
};

static const ts_paper_part cull_parts[] = {
	{ "ivir_culling", "iVIR, figure 3: images with culling beside those without, RMSE in grey levels", { CHANGE,
	  CHANGE_SSIM, CHANGE_D, CHANGE_SSIM_D, TS_NO_FIGURE } },
	{ "ivir_culling_truth", "RMSE to the truth", { ERROR, ERROR_CULLED, WORSE, ERROR_D, ERROR_CULLED_D, WORSE_D,
	  TS_NO_FIGURE } },
	{ "ivir_culling_points", "Points, at rate=paper and at the defaults", { POINTS, CULLED, SHARE, POINTS_D, CULLED_D,
	  SHARE_D, TS_NO_FIGURE } },
	{ "ivir_culling_holes", "Texels that rays say are covered, and those of them without a point", { COVERED, HOLES,
	  HOLES_CULLED, HOLES_D, HOLES_CULLED_D, LOST_D, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation cull_relations[] = {
	{ "RMSE by stochastic culling, grey levels", CHANGE, TS_AT_MOST, 0, 1, ALL, "few points are left a texel",
	  SHARE },
	{ "RMSE by stochastic culling, at the defaults", CHANGE_D, TS_AT_MOST, 0, 1, ALL, "few points are left a texel",
	  SHARE_D },
	{ "RMSE to truth that culling adds", WORSE, TS_AT_MOST, 0, 0.1, ALL, "few points are left a texel", SHARE },
	{ "RMSE to truth that culling adds, at the defaults", WORSE_D, TS_AT_MOST, 0, 0.1, ALL,
	  "few points are left a texel", SHARE_D },
	{ "SSIM of culled beside not culled", CHANGE_SSIM, TS_AT_LEAST, 0.99, 0, ALL, "few points are left a texel",
	  SHARE },
	{ "SSIM of culled beside not culled, at the defaults", CHANGE_SSIM_D, TS_AT_LEAST, 0.99, 0, ALL,
	  "few points are left a texel", SHARE_D },
	{ "texels without a point where nothing is culled, at the defaults", HOLES_D, TS_AT_MOST, 0, 0, ALL,
	  "the rate is not watertight", POINTS_D },
	{ "texels that culling leaves without a point, at the defaults, %", LOST_D, TS_AT_MOST, 0, 0.0001, ALL,
	  "ten pieces are left a sample, and exp(-10) is more", SHARE_D },
	{ 0 },
};

static const ts_paper_picture cull_pictures[] = {
	{ K_WHOLE, "ivir-paper" }, { K_CULLED, "ivir-paper-culled" }, { K_WHOLE_D, "ivir" }, { K_CULLED_D,
	  "ivir-culled" },
	{ 0 },
};

const ts_paper_table ts_ivir_culling = {
	.name = "ivir-culling", .title = "iVIR, figure 3: stochastic culling", .effect = "soft-shadows",
	.scenes = "atrium,gallery,dining", .models = "bunny.glb,armadillo_86k.glb,dragon_80k.glb,dragon_scans.glb",
	.set = "reflectors.count=0", .defaults = "scene.ground=on,truth.area_samples=256", .judge = "area", .rays = true,
	.variants = cull_variants, .figures = cull_figures, .parts = cull_parts, .relations = cull_relations,
	.pictures = cull_pictures, .rows = rows,
};

/* Figure 4: soft shadows by iVIR, VIR and MVR. */
enum { S_MVR, S_VIR, S_IVIR, S_DEFAULT, S_CENTRE };

static const ts_bench_variant soft_variants[] = {
	[S_MVR] = { "mvr", "", true, TS_ONCE },
	[S_VIR] = { "vir", TS_IVIR_DEFAULTS, true, TS_ONCE },
	[S_IVIR] = { "ivir", TS_IVIR_DEFAULTS, true, TS_ONCE },
	[S_DEFAULT] = { "ivir", "", true, TS_ONCE },
	[S_CENTRE] = { "ivir", "scatter.at=centre", true, TS_ONCE },
	{ 0 },
};

enum { TO_VIR, TO_IVIR, TO_DEFAULT, TO_CENTRE, TO_RATIO, TO_RATIO_D, LIKE_VIR, LIKE_IVIR, LIKE_DEFAULT, LIKE_CENTRE,
	E_MVR, E_VIR, E_IVIR, E_DEFAULT, E_CENTRE, E_MORE, E_MORE_D, E_MORE_C, Q_MVR, Q_VIR, Q_IVIR, Q_DEFAULT,
	Q_CENTRE };

static const ts_bench_figure soft_figures[] = {
	RMSE_TO(TO_VIR, "rmse_vir", "VIR", S_VIR, S_MVR),
	RMSE_TO(TO_IVIR, "rmse_ivir", "iVIR", S_IVIR, S_MVR),
	RMSE_TO(TO_DEFAULT, "rmse_default", "defaults", S_DEFAULT, S_MVR),
	RMSE_TO(TO_CENTRE, "rmse_centre", "at=centre", S_CENTRE, S_MVR),
	RATIO(TO_RATIO, "rmse_ratio", "iVIR / VIR", TO_IVIR, TO_VIR),
	RATIO(TO_RATIO_D, "rmse_ratio_default", "defaults / VIR", TO_DEFAULT, TO_VIR),
	SSIM_TO(LIKE_VIR, "ssim_vir", "VIR", S_VIR, S_MVR),
	SSIM_TO(LIKE_IVIR, "ssim_ivir", "iVIR", S_IVIR, S_MVR),
	SSIM_TO(LIKE_DEFAULT, "ssim_default", "defaults", S_DEFAULT, S_MVR),
	SSIM_TO(LIKE_CENTRE, "ssim_centre", "at=centre", S_CENTRE, S_MVR),
	RMSE(E_MVR, "rmse_truth_mvr", "MVR", S_MVR),
	RMSE(E_VIR, "rmse_truth_vir", "VIR", S_VIR),
	RMSE(E_IVIR, "rmse_truth_ivir", "iVIR", S_IVIR),
	RMSE(E_DEFAULT, "rmse_truth_default", "defaults", S_DEFAULT),
	RMSE(E_CENTRE, "rmse_truth_centre", "at=centre", S_CENTRE),
	LESS(E_MORE, "rmse_more", "iVIR less MVR", E_IVIR, E_MVR),
	LESS(E_MORE_D, "rmse_more_default", "defaults less MVR", E_DEFAULT, E_MVR),
	LESS(E_MORE_C, "rmse_more_centre", "at=centre less MVR", E_CENTRE, E_MVR),
	SSIM(Q_MVR, "ssim_truth_mvr", "MVR", S_MVR),
	SSIM(Q_VIR, "ssim_truth_vir", "VIR", S_VIR),
	SSIM(Q_IVIR, "ssim_truth_ivir", "iVIR", S_IVIR),
	SSIM(Q_DEFAULT, "ssim_truth_default", "defaults", S_DEFAULT),
	SSIM(Q_CENTRE, "ssim_truth_centre", "at=centre", S_CENTRE),
	{ 0 },
};

static const ts_paper_part soft_parts[] = {
	{ "ivir_4", "iVIR, figure 4: RMSE to MVR's image, grey levels", { TO_VIR, TO_IVIR, TO_RATIO, TO_DEFAULT,
	  TO_RATIO_D,
	  TO_CENTRE, TS_NO_FIGURE } },
	{ "ivir_4_ssim", "SSIM to MVR's image", { LIKE_VIR, LIKE_IVIR, LIKE_DEFAULT, LIKE_CENTRE, TS_NO_FIGURE } },
	{ "ivir_4_truth", "RMSE to the truth", { E_MVR, E_VIR, E_IVIR, E_DEFAULT, E_CENTRE, TS_NO_FIGURE } },
	{ "ivir_4_truth_ssim", "SSIM to the truth", { Q_MVR, Q_VIR, Q_IVIR, Q_DEFAULT, Q_CENTRE, TS_NO_FIGURE } },
	{ "ivir_4_more", "RMSE to the truth less MVR's", { E_MORE, E_MORE_D, E_MORE_C, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation soft_relations[] = {
	{ "RMSE to MVR, iVIR by VIR", TO_RATIO, TS_AT_MOST, 0, 1.1, ALL, "fewer points than VIR", TO_IVIR },
	{ "RMSE to MVR, iVIR at the defaults by VIR", TO_RATIO_D, TS_AT_MOST, 0, 1.1, ALL, TS_IVIR_NEAREST, TO_DEFAULT },
	{ "RMSE to truth, iVIR less MVR", E_MORE, TS_AT_MOST, 0, 0.5, ALL, TS_IVIR_NEAREST, E_MVR },
	{ "RMSE to truth, iVIR at the defaults less MVR", E_MORE_D, TS_AT_MOST, 0, 0.5, ALL, TS_IVIR_NEAREST, E_MVR },
	{ "RMSE to truth, iVIR at=centre less MVR", E_MORE_C, TS_AT_MOST, 0, 0.05, ALL, TS_IVIR_SMALL, E_MVR },
	{ 0 },
};

static const ts_paper_picture soft_pictures[] = {
	{ S_MVR, "mvr" }, { S_VIR, "vir" }, { S_IVIR, "ivir-paper" }, { S_DEFAULT, "ivir" }, { S_CENTRE, "ivir-centre" },
	{ 0 },
};

const ts_paper_table ts_ivir_4 = {
	.name = "ivir-4", .title = "iVIR, figure 4: soft shadows", .effect = "soft-shadows",
	.scenes = "atrium,gallery,dining", .models = "bunny.glb,armadillo_86k.glb,dragon_80k.glb,dragon_scans.glb",
	.set = "reflectors.count=0", .defaults = "scene.ground=on,truth.area_samples=256", .judge = "area", .note
	= TS_VIR_NOTE,
	.variants = soft_variants, .figures = soft_figures, .parts = soft_parts, .relations = soft_relations,
	.pictures = soft_pictures, .rows = rows,
};

/* Figure 6: reflections by MVR, VIR and iVIR. */
enum { R_MVR, R_VIR, R_IVIR, R_DEFAULT, R_CENTRE, R_FACES, R_FACES_D };

static const ts_bench_variant mirror_variants[] = {
	[R_MVR] = { "mvr", "mvr.faces=fixed", true, TS_ONCE },
	[R_VIR] = { "vir", TS_IVIR_DEFAULTS, true, TS_ONCE },
	[R_IVIR] = { "ivir", TS_IVIR_DEFAULTS, true, TS_ONCE },
	[R_DEFAULT] = { "ivir", "", true, TS_ONCE },
	[R_CENTRE] = { "ivir", "scatter.at=centre", true, TS_ONCE },
	[R_FACES] = { "ivir", TS_IVIR_DEFAULTS ",cube.px=" TS_IVIR_FACE, true, TS_ONCE },
	[R_FACES_D] = { "ivir", "cube.px=" TS_IVIR_FACE, true, TS_ONCE },
	{ 0 },
};

enum { M_VIR, M_IVIR, M_DEFAULT, M_CENTRE, M_FACES, M_FACES_D, M_RATIO, M_RATIO_D, M_FACES_RATIO, M_FACES_RATIO_D,
	L_VIR, L_IVIR, L_DEFAULT, L_CENTRE, L_FACES, L_FACES_D, SIDE, T_MVR, T_VIR, T_IVIR, T_DEFAULT, T_CENTRE,
	T_FACES, T_FACES_D,
	U_MVR, U_VIR, U_IVIR, U_DEFAULT, U_CENTRE, U_FACES, U_FACES_D };

static const ts_bench_figure mirror_figures[] = {
	RMSE_TO(M_VIR, "rmse_vir", "VIR", R_VIR, R_MVR),
	RMSE_TO(M_IVIR, "rmse_ivir", "iVIR", R_IVIR, R_MVR),
	RMSE_TO(M_DEFAULT, "rmse_default", "defaults", R_DEFAULT, R_MVR),
	RMSE_TO(M_CENTRE, "rmse_centre", "at=centre", R_CENTRE, R_MVR),
	RMSE_TO(M_FACES, "rmse_faces", "VIR's faces", R_FACES, R_MVR),
	RMSE_TO(M_FACES_D, "rmse_faces_default", "defaults", R_FACES_D, R_MVR),
	RATIO(M_RATIO, "rmse_ratio", "iVIR / VIR", M_IVIR, M_VIR),
	RATIO(M_RATIO_D, "rmse_ratio_default", "defaults", M_DEFAULT, M_VIR),
	RATIO(M_FACES_RATIO, "rmse_faces_ratio", "VIR's faces", M_FACES, M_VIR),
	RATIO(M_FACES_RATIO_D, "rmse_faces_ratio_default", "defaults", M_FACES_D, M_VIR),
	SSIM_TO(L_VIR, "ssim_vir", "VIR", R_VIR, R_MVR),
	SSIM_TO(L_IVIR, "ssim_ivir", "iVIR", R_IVIR, R_MVR),
	SSIM_TO(L_DEFAULT, "ssim_default", "defaults", R_DEFAULT, R_MVR),
	SSIM_TO(L_CENTRE, "ssim_centre", "at=centre", R_CENTRE, R_MVR),
	SSIM_TO(L_FACES, "ssim_faces", "VIR's faces", R_FACES, R_MVR),
	SSIM_TO(L_FACES_D, "ssim_faces_default", "defaults", R_FACES_D, R_MVR),
	[SIDE] = { "side", "side of iVIR's faces", TS_FIGURE_DIAMETER, R_IVIR, 0, 1, "" },
	RMSE(T_MVR, "rmse_truth_mvr", "MVR", R_MVR),
	RMSE(T_VIR, "rmse_truth_vir", "VIR", R_VIR),
	RMSE(T_IVIR, "rmse_truth_ivir", "iVIR", R_IVIR),
	RMSE(T_DEFAULT, "rmse_truth_default", "defaults", R_DEFAULT),
	RMSE(T_CENTRE, "rmse_truth_centre", "at=centre", R_CENTRE),
	RMSE(T_FACES, "rmse_truth_faces", "VIR's faces", R_FACES),
	RMSE(T_FACES_D, "rmse_truth_faces_default", "defaults", R_FACES_D),
	SSIM(U_MVR, "ssim_truth_mvr", "MVR", R_MVR),
	SSIM(U_VIR, "ssim_truth_vir", "VIR", R_VIR),
	SSIM(U_IVIR, "ssim_truth_ivir", "iVIR", R_IVIR),
	SSIM(U_DEFAULT, "ssim_truth_default", "defaults", R_DEFAULT),
	SSIM(U_CENTRE, "ssim_truth_centre", "at=centre", R_CENTRE),
	SSIM(U_FACES, "ssim_truth_faces", "VIR's faces", R_FACES),
	SSIM(U_FACES_D, "ssim_truth_faces_default", "defaults", R_FACES_D),
	{ 0 },
};

static const ts_paper_part mirror_parts[] = {
	{ "ivir_6", "iVIR, figure 6: RMSE to MVR's image, grey levels", { SIDE, M_VIR, M_IVIR, M_DEFAULT,
	  M_CENTRE, M_FACES,
	  M_FACES_D, TS_NO_FIGURE } },
	{ "ivir_6_ratios", "The same, by VIR's", { M_RATIO, M_RATIO_D, M_FACES_RATIO, M_FACES_RATIO_D, TS_NO_FIGURE } },
	{ "ivir_6_ssim", "SSIM to MVR's image", { L_VIR, L_IVIR, L_DEFAULT, L_CENTRE, L_FACES, L_FACES_D,
	  TS_NO_FIGURE } },
	{ "ivir_6_truth", "RMSE to the truth", { T_MVR, T_VIR, T_IVIR, T_DEFAULT, T_CENTRE, T_FACES, T_FACES_D,
	  TS_NO_FIGURE } },
	{ "ivir_6_truth_ssim", "SSIM to the truth", { U_MVR, U_VIR, U_IVIR, U_DEFAULT, U_CENTRE, U_FACES, U_FACES_D,
	  TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation mirror_relations[] = {
	{ "RMSE to MVR, iVIR by VIR", M_RATIO, TS_AT_MOST, 0, 1.31, ALL, "its faces are smaller; see that of VIR's faces",
	  SIDE },
	{ "RMSE to MVR, iVIR at the defaults by VIR", M_RATIO_D, TS_AT_MOST, 0, 1.31, ALL,
	  "its faces are smaller; see that of VIR's faces", SIDE },
	{ "RMSE to MVR, iVIR of VIR's faces by VIR", M_FACES_RATIO, TS_AT_MOST, 0, 1.31, ALL, "fewer points than VIR",
	  M_FACES },
	{ "RMSE to MVR, iVIR of VIR's faces at the defaults by VIR", M_FACES_RATIO_D, TS_AT_MOST, 0, 1.31, ALL,
	  TS_IVIR_NEAREST, M_FACES_D },
	{ "SSIM to MVR of iVIR", L_IVIR, TS_AT_LEAST, 0.98, 0, ALL, "its faces are smaller", SIDE },
	{ "SSIM to MVR of iVIR at the defaults", L_DEFAULT, TS_AT_LEAST, 0.98, 0, ALL, "its faces are smaller", SIDE },
	{ 0 },
};

static const ts_paper_picture mirror_pictures[] = {
	{ R_MVR, "mvr" }, { R_VIR, "vir" }, { R_IVIR, "ivir-paper" }, { R_DEFAULT, "ivir" }, { R_CENTRE, "ivir-centre" },
	{ R_FACES, "ivir-paper-faces" }, { R_FACES_D, "ivir-faces" }, { 0 },
};

const ts_paper_table ts_ivir_6 = {
	.name = "ivir-6", .title = "iVIR, figure 6: reflections", .effect = "reflections", .scenes = "dining,gallery",
	.objects_head = "mirrors", .objects_param = "reflectors.count", .objects = "1,8,16,20", .set = "",
	.defaults = TS_IVIR_QUARTER, .size = "width=480,height=270", .judge = "C",
	.note = TS_IVIR_QUARTER_NOTE " " TS_VIR_NOTE, .variants = mirror_variants, .figures = mirror_figures,
	.parts = mirror_parts, .relations = mirror_relations, .pictures = mirror_pictures, .rows = rows,
};
/* clang-format on */
