/* The iVIR paper's figures 3, 4 and 6: its pictures, with RMSE and SSIM instead of HDR-VDP2.
 * Figure 5 is in bench_pcss.c, figure 7 in table 3. */
#include "methods/points/tools/benches.h"

/* clang-format off */
static const ts_paper_row rows[] = { { 0 } };

/* Figure 3: soft shadows with and without stochastic culling. In maps of 1024 our triangles are too large to be culled;
 * the brief run has maps of 256, in which models' triangles are about as small as the paper's. */
enum { K_WHOLE, K_CULLED, K_WHOLE_D, K_CULLED_D, K_NARROW_WHOLE, K_NARROW_CULLED };

static const ts_bench_variant cull_variants[] = {
	[K_WHOLE] = { "ivir", TS_IVIR_DEFAULTS ",points.cull=off", true, TS_ONCE },
	[K_CULLED] = { "ivir", TS_IVIR_DEFAULTS ",points.cull=on", true, TS_ONCE },
	[K_WHOLE_D] = { "ivir", "points.cull=off", true, TS_ONCE },
	[K_CULLED_D] = { "ivir", "points.cull=on", true, TS_ONCE },
	[K_NARROW_WHOLE] = { "ivir", TS_IVIR_DEFAULTS ",points.cull=off," TS_NARROW, true, TS_ONCE },
	[K_NARROW_CULLED] = { "ivir", TS_IVIR_DEFAULTS ",points.cull=on," TS_NARROW, true, TS_ONCE },
	{ 0 },
};

enum { POINTS, CULLED, SHARE, POINTS_D, CULLED_D, SHARE_D, COVERED, HOLES, HOLES_CULLED, HOLES_D, HOLES_CULLED_D,
	LOST_D, CHANGE, CHANGE_SSIM, CHANGE_D, CHANGE_SSIM_D, ERROR, ERROR_CULLED, WORSE, ERROR_D, ERROR_CULLED_D,
	WORSE_D, PENUMBRA, NARROW, CHANGE_NARROW, CHANGE_SSIM_NARROW };

static const ts_bench_figure cull_figures[] = {
	TS_COUNT(POINTS, "points", "points", K_WHOLE, "points"),
	TS_COUNT(CULLED, "points_culled", "culled", K_CULLED, "points"),
	TS_RATIO(SHARE, "share", "share", CULLED, POINTS, 3),
	TS_COUNT(POINTS_D, "points_default", "defaults", K_WHOLE_D, "points"),
	TS_COUNT(CULLED_D, "points_culled_default", "culled", K_CULLED_D, "points"),
	TS_RATIO(SHARE_D, "share_default", "share", CULLED_D, POINTS_D, 3),
	TS_COUNT(COVERED, "covered", "texels", K_WHOLE_D, "texels covered by rays"),
	TS_COUNT(HOLES, "holes", "holes", K_WHOLE, "holes"),
	TS_COUNT(HOLES_CULLED, "holes_culled", "culled", K_CULLED, "holes"),
	TS_COUNT(HOLES_D, "holes_default", "defaults", K_WHOLE_D, "holes"),
	TS_COUNT(HOLES_CULLED_D, "holes_culled_default", "culled", K_CULLED_D, "holes"),
	TS_PERCENT(LOST_D, "lost_percent", "%", HOLES_CULLED_D, COVERED),
	TS_RMSE_TO(CHANGE, "rmse_culled", "RMSE", K_CULLED, K_WHOLE),
	TS_SSIM_TO(CHANGE_SSIM, "ssim_culled", "SSIM", K_CULLED, K_WHOLE),
	TS_RMSE_TO(CHANGE_D, "rmse_culled_default", "RMSE, defaults", K_CULLED_D, K_WHOLE_D),
	TS_SSIM_TO(CHANGE_SSIM_D, "ssim_culled_default", "SSIM", K_CULLED_D, K_WHOLE_D),
	TS_RMSE(ERROR, "rmse_truth", "not culled", K_WHOLE),
	TS_RMSE(ERROR_CULLED, "rmse_truth_culled", "culled", K_CULLED),
	TS_LESS(WORSE, "rmse_truth_more", "more", ERROR_CULLED, ERROR, 3),
	TS_RMSE(ERROR_D, "rmse_truth_default", "defaults", K_WHOLE_D),
	TS_RMSE(ERROR_CULLED_D, "rmse_truth_culled_default", "culled", K_CULLED_D),
	TS_LESS(WORSE_D, "rmse_truth_more_default", "more", ERROR_CULLED_D, ERROR_D, 3),
	TS_PENUMBRA(PENUMBRA, "penumbra", "penumbra", K_WHOLE),
	TS_PENUMBRA(NARROW, "penumbra_narrow", "narrow", K_NARROW_WHOLE),
	TS_RMSE_TO(CHANGE_NARROW, "rmse_culled_narrow", "RMSE", K_NARROW_CULLED, K_NARROW_WHOLE),
	TS_SSIM_TO(CHANGE_SSIM_NARROW, "ssim_culled_narrow", "SSIM", K_NARROW_CULLED, K_NARROW_WHOLE),
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
	{ "ivir_culling_penumbra", TS_PENUMBRA_TITLE "culled beside not culled", { PENUMBRA, CHANGE, NARROW, CHANGE_NARROW,
	  CHANGE_SSIM_NARROW, TS_NO_FIGURE } },
	{ 0 },
};

#define FEW_LEFT TS_NOT_ALWAYS "few points are left a texel; see points.cull=off"

static const ts_paper_relation cull_relations[] = {
	{ "RMSE by stochastic culling, grey levels", CHANGE, TS_AT_MOST, 0, 1, TS_ANY, FEW_LEFT,
	  SHARE },
	{ "RMSE by stochastic culling, at the defaults", CHANGE_D, TS_AT_MOST, 0, 1, TS_ANY, FEW_LEFT,
	  SHARE_D },
	{ "RMSE to truth that culling adds", WORSE, TS_AT_MOST, 0, 0.1, TS_ANY, FEW_LEFT, SHARE },
	{ "RMSE to truth that culling adds, at the defaults", WORSE_D, TS_AT_MOST, 0, 0.1, TS_ANY,
	  FEW_LEFT, SHARE_D },
	{ "SSIM of culled beside not culled", CHANGE_SSIM, TS_AT_LEAST, 0.99, 0, TS_ANY, FEW_LEFT,
	  SHARE },
	{ "SSIM of culled beside not culled, at the defaults", CHANGE_SSIM_D, TS_AT_LEAST, 0.99, 0, TS_ANY,
	  FEW_LEFT, SHARE_D },
	{ "texels without a point where nothing is culled, at the defaults", HOLES_D, TS_AT_MOST, 0, 0, TS_ANY,
	  TS_OURS "the rate is not watertight; see density.rate=exact", POINTS_D },
	{ "texels that culling leaves without a point, at the defaults, %", LOST_D, TS_AT_MOST, 0, 0.0001, TS_ANY,
	  TS_NOT_ALWAYS "ten pieces are left a sample, and exp(-10) is more; see points.cull=off", SHARE_D },
	{ 0 },
};

static const ts_paper_picture cull_pictures[] = {
	{ K_WHOLE, "ivir-paper" }, { K_CULLED, "ivir-paper-culled" }, { K_WHOLE_D, "ivir" }, { K_CULLED_D,
	  "ivir-culled" },
	{ 0 },
};

const ts_paper_table ts_ivir_culling = {
	.name = "ivir-culling", .title = "iVIR, figure 3: stochastic culling", .effect = "soft-shadows",
	.scenes = "atrium,gallery,dining", .models = TS_MODELS, .alone = TS_MODELS, .alone_set = TS_WIDE_ALONE,
	.set = "reflectors.count=0", .defaults = "scene.ground=on,truth.area_samples=256," TS_WIDE, .judge = "area",
	.rays = true, .look = ts_bench_penumbra, .variants = cull_variants, .figures = cull_figures, .parts = cull_parts,
	.relations = cull_relations, .pictures = cull_pictures, .rows = rows,
};

/* Figures 4 and 6: figures of each method except MVR, by prefix `p`. */
#define OF(p) p##VIR, p##IVIR, p##DEFAULT, p##CENTRE
#define EACH(ROW, p, key) \
	ROW(p##VIR, key "_vir", "VIR", VIR), ROW(p##IVIR, key "_ivir", "iVIR", IVIR), \
	ROW(p##DEFAULT, key "_default", "defaults", DEFAULT), ROW(p##CENTRE, key "_centre", "at=centre", CENTRE)
#define RMSE_TO_MVR(id, key, head, of) TS_RMSE_TO(id, key, head, of, MVR)
#define SSIM_TO_MVR(id, key, head, of) TS_SSIM_TO(id, key, head, of, MVR)

/* Figure 4: soft shadows by iVIR, VIR and MVR. */
enum { MVR, OF(), FACES, FACES_D };
#define VARIANTS(mvr) \
	[MVR] = { "mvr", mvr, true, TS_ONCE }, \
	[VIR] = { "vir", TS_IVIR_DEFAULTS, true, TS_ONCE }, \
	[IVIR] = { "ivir", TS_IVIR_DEFAULTS, true, TS_ONCE }, \
	[DEFAULT] = { "ivir", "", true, TS_ONCE }, \
	[CENTRE] = { "ivir", "scatter.at=centre", true, TS_ONCE }

enum { NARROW_MVR = CENTRE + 1, NARROW_VIR, NARROW_IVIR, NARROW_DEFAULT };

static const ts_bench_variant soft_variants[] = {
	VARIANTS(""),
	[NARROW_MVR] = { "mvr", TS_NARROW, true, TS_ONCE },
	[NARROW_VIR] = { "vir", TS_IVIR_DEFAULTS "," TS_NARROW, true, TS_ONCE },
	[NARROW_IVIR] = { "ivir", TS_IVIR_DEFAULTS "," TS_NARROW, true, TS_ONCE },
	[NARROW_DEFAULT] = { "ivir", TS_NARROW, true, TS_ONCE },
	{ 0 },
};

enum { WIDTH, WIDTH_NARROW, TO_NARROW_VIR, TO_NARROW_IVIR, TO_NARROW_DEFAULT, OF(TO_), TO_RATIO, TO_RATIO_D, OF(LIKE_),
	E_MVR, OF(E_), E_MORE, E_MORE_D, E_MORE_C, Q_MVR, OF(Q_) };

static const ts_bench_figure soft_figures[] = {
	TS_PENUMBRA(WIDTH, "penumbra", "penumbra", MVR), TS_PENUMBRA(WIDTH_NARROW, "penumbra_narrow", "narrow", NARROW_MVR),
	TS_RMSE_TO(TO_NARROW_VIR, "rmse_narrow_vir", "VIR", NARROW_VIR, NARROW_MVR),
	TS_RMSE_TO(TO_NARROW_IVIR, "rmse_narrow_ivir", "iVIR", NARROW_IVIR, NARROW_MVR),
	TS_RMSE_TO(TO_NARROW_DEFAULT, "rmse_narrow_default", "defaults", NARROW_DEFAULT, NARROW_MVR),
	EACH(RMSE_TO_MVR, TO_, "rmse"),
	TS_RATIO(TO_RATIO, "rmse_ratio", "iVIR / VIR", TO_IVIR, TO_VIR, 3),
	TS_RATIO(TO_RATIO_D, "rmse_ratio_default", "defaults / VIR", TO_DEFAULT, TO_VIR, 3),
	EACH(SSIM_TO_MVR, LIKE_, "ssim"),
	TS_RMSE(E_MVR, "rmse_truth_mvr", "MVR", MVR), EACH(TS_RMSE, E_, "rmse_truth"),
	TS_LESS(E_MORE, "rmse_more", "iVIR less MVR", E_IVIR, E_MVR, 3),
	TS_LESS(E_MORE_D, "rmse_more_default", "defaults less MVR", E_DEFAULT, E_MVR, 3),
	TS_LESS(E_MORE_C, "rmse_more_centre", "at=centre less MVR", E_CENTRE, E_MVR, 3),
	TS_SSIM(Q_MVR, "ssim_truth_mvr", "MVR", MVR), EACH(TS_SSIM, Q_, "ssim_truth"),
	{ 0 },
};

static const ts_paper_part soft_parts[] = {
	{ "ivir_4", "iVIR, figure 4: RMSE to MVR's image, grey levels", { TO_VIR, TO_IVIR, TO_RATIO, TO_DEFAULT, TO_RATIO_D,
	  TO_CENTRE, TS_NO_FIGURE } },
	{ "ivir_4_ssim", "SSIM to MVR's image", { OF(LIKE_), TS_NO_FIGURE } },
	{ "ivir_4_truth", "RMSE to the truth", { E_MVR, OF(E_), TS_NO_FIGURE } },
	{ "ivir_4_truth_ssim", "SSIM to the truth", { Q_MVR, OF(Q_), TS_NO_FIGURE } },
	{ "ivir_4_more", "RMSE to the truth less MVR's", { E_MORE, E_MORE_D, E_MORE_C, TS_NO_FIGURE } },
	{ "ivir_4_penumbra", TS_PENUMBRA_TITLE "RMSE to MVR's image", { WIDTH, WIDTH_NARROW, TO_NARROW_VIR, TO_NARROW_IVIR,
	  TO_NARROW_DEFAULT, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation soft_relations[] = {
	{ "RMSE to MVR, iVIR by VIR", TO_RATIO, TS_AT_MOST, 0, 1.1, TS_ANY, TS_IVIR_FEWER, TO_IVIR },
	{ "RMSE to MVR, iVIR at the defaults by VIR", TO_RATIO_D, TS_AT_MOST, 0, 1.1, TS_ANY, TS_IVIR_NEAREST, TO_DEFAULT },
	TS_TRUTH_RELATIONS(E_MORE, E_MORE_D, E_MVR),
	{ "RMSE to truth, iVIR at=centre less MVR", E_MORE_C, TS_AT_MOST, 0, 0.05, TS_ANY, TS_IVIR_SMALL, E_MVR },
	{ 0 },
};

#define PICTURES { MVR, "mvr" }, { VIR, "vir" }, { IVIR, "ivir-paper" }, { DEFAULT, "ivir" }, { CENTRE, "ivir-centre" }

static const ts_paper_picture soft_pictures[] = { PICTURES, { 0 } };

const ts_paper_table ts_ivir_4 = {
	.name = "ivir-4", .title = "iVIR, figure 4: soft shadows", .effect = "soft-shadows",
	.scenes = "atrium,gallery,dining", .models = TS_MODELS, .alone = TS_MODELS, .alone_set = TS_WIDE_ALONE,
	.set = "reflectors.count=0", .defaults = "scene.ground=on,truth.area_samples=256," TS_WIDE, .judge = "area",
	.look = ts_bench_penumbra, .note = TS_VIR_NOTE, .variants = soft_variants, .figures = soft_figures,
	.parts = soft_parts, .relations = soft_relations, .pictures = soft_pictures, .rows = rows,
};

/* Figure 6: reflections by MVR, VIR and iVIR. */
static const ts_bench_variant mirror_variants[] = {
	VARIANTS("mvr.faces=fixed"),
	[FACES] = { "ivir", TS_IVIR_DEFAULTS ",cube.px=" TS_IVIR_FACE, true, TS_ONCE },
	[FACES_D] = { "ivir", "cube.px=" TS_IVIR_FACE, true, TS_ONCE },
	{ 0 },
};

enum { OF(M_), M_FACES, M_FACES_D, M_RATIO, M_RATIO_D, M_FACES_RATIO, M_FACES_RATIO_D, OF(L_), L_FACES, L_FACES_D, SIDE,
	T_MVR, OF(T_), T_FACES, T_FACES_D, U_MVR, OF(U_), U_FACES, U_FACES_D };

#define EACH_AND_FACES(ROW, p, key) \
	EACH(ROW, p, key), ROW(p##FACES, key "_faces", "VIR's faces", FACES), \
	ROW(p##FACES_D, key "_faces_default", "defaults", FACES_D)

static const ts_bench_figure mirror_figures[] = {
	EACH_AND_FACES(RMSE_TO_MVR, M_, "rmse"),
	TS_RATIO(M_RATIO, "rmse_ratio", "iVIR / VIR", M_IVIR, M_VIR, 3),
	TS_RATIO(M_RATIO_D, "rmse_ratio_default", "defaults", M_DEFAULT, M_VIR, 3),
	TS_RATIO(M_FACES_RATIO, "rmse_faces_ratio", "VIR's faces", M_FACES, M_VIR, 3),
	TS_RATIO(M_FACES_RATIO_D, "rmse_faces_ratio_default", "defaults", M_FACES_D, M_VIR, 3),
	EACH_AND_FACES(SSIM_TO_MVR, L_, "ssim"),
	[SIDE] = { "side", "side of iVIR's faces", TS_FIGURE_DIAMETER, IVIR, 0, 1, "" },
	TS_RMSE(T_MVR, "rmse_truth_mvr", "MVR", MVR), EACH_AND_FACES(TS_RMSE, T_, "rmse_truth"),
	TS_SSIM(U_MVR, "ssim_truth_mvr", "MVR", MVR), EACH_AND_FACES(TS_SSIM, U_, "ssim_truth"),
	{ 0 },
};

static const ts_paper_part mirror_parts[] = {
	{ "ivir_6", "iVIR, figure 6: RMSE to MVR's image, grey levels", { SIDE, OF(M_), M_FACES, M_FACES_D,
	  TS_NO_FIGURE } },
	{ "ivir_6_ratios", "The same, by VIR's", { M_RATIO, M_RATIO_D, M_FACES_RATIO, M_FACES_RATIO_D, TS_NO_FIGURE } },
	{ "ivir_6_ssim", "SSIM to MVR's image", { OF(L_), L_FACES, L_FACES_D, TS_NO_FIGURE } },
	{ "ivir_6_truth", "RMSE to the truth", { T_MVR, OF(T_), T_FACES, T_FACES_D, TS_NO_FIGURE } },
	{ "ivir_6_truth_ssim", "SSIM to the truth", { U_MVR, OF(U_), U_FACES, U_FACES_D, TS_NO_FIGURE } },
	{ 0 },
};

/* The paper's faces are closer to VIR's in size. */
#define SMALLER TS_ELSEWHERE "iVIR's faces are a third of VIR's; see cube.px=" TS_IVIR_FACE

static const ts_paper_relation mirror_relations[] = {
	{ "RMSE to MVR, iVIR by VIR", M_RATIO, TS_AT_MOST, 0, 1.31, TS_ANY,
	  SMALLER, SIDE },
	{ "RMSE to MVR, iVIR at the defaults by VIR", M_RATIO_D, TS_AT_MOST, 0, 1.31, TS_ANY,
	  SMALLER, SIDE },
	{ "RMSE to MVR, iVIR of VIR's faces by VIR", M_FACES_RATIO, TS_AT_MOST, 0, 1.31, TS_ANY, TS_IVIR_FEWER,
	  M_FACES },
	{ "RMSE to MVR, iVIR of VIR's faces at the defaults by VIR", M_FACES_RATIO_D, TS_AT_MOST, 0, 1.31, TS_ANY,
	  TS_IVIR_NEAREST, M_FACES_D },
	{ "SSIM to MVR of iVIR", L_IVIR, TS_AT_LEAST, 0.98, 0, TS_ANY, SMALLER, SIDE },
	{ "SSIM to MVR of iVIR at the defaults", L_DEFAULT, TS_AT_LEAST, 0.98, 0, TS_ANY, SMALLER, SIDE },
	{ 0 },
};

static const ts_paper_picture mirror_pictures[] = {
	PICTURES, { FACES, "ivir-paper-faces" }, { FACES_D, "ivir-faces" }, { 0 },
};

const ts_paper_table ts_ivir_6 = {
	.name = "ivir-6", .title = "iVIR, figure 6: reflections", .effect = "reflections", .scenes = "dining,gallery",
	.objects_head = "mirrors", .objects_param = "reflectors.count", .objects = "1,8,16,20", .set = "",
	.defaults = TS_IVIR_QUARTER, .size = "width=480,height=270", .judge = "C",
	.note = TS_IVIR_QUARTER_NOTE " " TS_VIR_NOTE, .variants = mirror_variants, .figures = mirror_figures,
	.parts = mirror_parts, .relations = mirror_relations, .pictures = mirror_pictures, .rows = rows,
};
/* clang-format on */
