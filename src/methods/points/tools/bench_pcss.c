/* iVIR 4.2 and figure 5: soft shadows by PCSS and by few views of iVIR, beside those of 128 views of MVR and beside
 * rays. */
#include "benches.h"

enum { M_REFERENCE, M_PCSS, M_IVIR, M_DEFAULT, M_CENTRE, M_MVR };

/* clang-format off */
static const ts_bench_variant variants[] = {
	[M_REFERENCE] = { "mvr", "lamp.views=128", true, TS_ONCE },
	[M_PCSS] = { "pcss", "", true, TS_TIMED },
	[M_IVIR] = { "ivir", TS_IVIR_DEFAULTS, true, TS_TIMED },
	[M_DEFAULT] = { "ivir", "", true, TS_TIMED },
	[M_CENTRE] = { "ivir", "scatter.at=centre", true, TS_TIMED },
	[M_MVR] = { "mvr", "", true, TS_TIMED },
	{ 0 },
};

/* To MVR's reference (TO) and to the truth. */
enum { TO_PCSS, TO_IVIR, TO_DEFAULT, TO_CENTRE, TO_MVR, LIKE_PCSS, LIKE_IVIR, LIKE_DEFAULT, LIKE_CENTRE, LIKE_MVR,
	PCSS, IVIR, DEFAULT, CENTRE, MVR, REFERENCE, SSIM_PCSS, SSIM_IVIR, SSIM_DEFAULT, SSIM_CENTRE, SSIM_MVR,
	RATIO, RATIO_DEFAULT, RATIO_CENTRE, TO_RATIO, TO_RATIO_DEFAULT, TO_RATIO_CENTRE, GAIN, GAIN_DEFAULT, GAIN_CENTRE,
	MVR_RATIO, PCSS_MS, IVIR_MS, DEFAULT_MS, CENTRE_MS, MVR_MS, TIME, TIME_DEFAULT, SCATTER_MS, MVR_MAP_MS,
	TRIANGLES };

#define ERROR(id, key, head, variant) [id] = { key, head, TS_FIGURE_RMSE, variant, 0, 3, "" }
#define ERROR_TO(id, key, head, variant) [id] = { key, head, TS_FIGURE_RMSE, variant, M_REFERENCE, 3, TS_TO_IMAGE }
#define LIKE(id, key, head, variant) [id] = { key, head, TS_FIGURE_SSIM, variant, 0, 4, "" }
#define LIKE_TO(id, key, head, variant) [id] = { key, head, TS_FIGURE_SSIM, variant, M_REFERENCE, 4, TS_TO_IMAGE }
#define BY(id, key, head, a, b) [id] = { key, head, TS_FIGURE_RATIO, a, b, 3, "" }
#define MORE(id, key, head, a, b) [id] = { key, head, TS_FIGURE_DIFFERENCE, a, b, 4, "" }
#define MS(id, key, head, variant) [id] = { key, head, TS_FIGURE_TIME, variant, 0, 2, "" }

static const ts_bench_figure figures[] = {
	ERROR_TO(TO_PCSS, "rmse_128_pcss", "PCSS", M_PCSS),
	ERROR_TO(TO_IVIR, "rmse_128_ivir", "iVIR", M_IVIR),
	ERROR_TO(TO_DEFAULT, "rmse_128_default", "defaults", M_DEFAULT),
	ERROR_TO(TO_CENTRE, "rmse_128_centre", "at=centre", M_CENTRE),
	ERROR_TO(TO_MVR, "rmse_128_mvr", "MVR", M_MVR),
	LIKE_TO(LIKE_PCSS, "ssim_128_pcss", "PCSS", M_PCSS),
	LIKE_TO(LIKE_IVIR, "ssim_128_ivir", "iVIR", M_IVIR),
	LIKE_TO(LIKE_DEFAULT, "ssim_128_default", "defaults", M_DEFAULT),
	LIKE_TO(LIKE_CENTRE, "ssim_128_centre", "at=centre", M_CENTRE),
	LIKE_TO(LIKE_MVR, "ssim_128_mvr", "MVR", M_MVR),
	ERROR(PCSS, "rmse_pcss", "PCSS", M_PCSS),
	ERROR(IVIR, "rmse_ivir", "iVIR", M_IVIR),
	ERROR(DEFAULT, "rmse_default", "defaults", M_DEFAULT),
	ERROR(CENTRE, "rmse_centre", "at=centre", M_CENTRE),
	ERROR(MVR, "rmse_mvr", "MVR", M_MVR),
	ERROR(REFERENCE, "rmse_reference", "MVR, 128", M_REFERENCE),
	LIKE(SSIM_PCSS, "ssim_pcss", "PCSS", M_PCSS),
	LIKE(SSIM_IVIR, "ssim_ivir", "iVIR", M_IVIR),
	LIKE(SSIM_DEFAULT, "ssim_default", "defaults", M_DEFAULT),
	LIKE(SSIM_CENTRE, "ssim_centre", "at=centre", M_CENTRE),
	LIKE(SSIM_MVR, "ssim_mvr", "MVR", M_MVR),
	BY(RATIO, "ratio", "iVIR / PCSS", IVIR, PCSS),
	BY(RATIO_DEFAULT, "ratio_default", "defaults / PCSS", DEFAULT, PCSS),
	BY(RATIO_CENTRE, "ratio_centre", "at=centre / PCSS", CENTRE, PCSS),
	BY(TO_RATIO, "ratio_128", "iVIR / PCSS", TO_IVIR, TO_PCSS),
	BY(TO_RATIO_DEFAULT, "ratio_128_default", "defaults / PCSS", TO_DEFAULT, TO_PCSS),
	BY(TO_RATIO_CENTRE, "ratio_128_centre", "at=centre / PCSS", TO_CENTRE, TO_PCSS),
	MORE(GAIN, "ssim_gain", "iVIR less PCSS", LIKE_IVIR, LIKE_PCSS),
	MORE(GAIN_DEFAULT, "ssim_gain_default", "defaults less PCSS", LIKE_DEFAULT, LIKE_PCSS),
	MORE(GAIN_CENTRE, "ssim_gain_centre", "at=centre less PCSS", LIKE_CENTRE, LIKE_PCSS),
	BY(MVR_RATIO, "ratio_mvr", "MVR / PCSS", MVR, PCSS),
	MS(PCSS_MS, "pcss_ms", "PCSS", M_PCSS),
	MS(IVIR_MS, "ivir_ms", "iVIR", M_IVIR),
	MS(DEFAULT_MS, "default_ms", "defaults", M_DEFAULT),
	MS(CENTRE_MS, "centre_ms", "at=centre", M_CENTRE),
	MS(MVR_MS, "mvr_ms", "MVR", M_MVR),
	BY(TIME, "time_ratio", "iVIR / PCSS", IVIR_MS, PCSS_MS),
	BY(TIME_DEFAULT, "time_ratio_default", "defaults / PCSS", DEFAULT_MS, PCSS_MS),
	[SCATTER_MS] = { "scatter_ms", "scatter, defaults", TS_FIGURE_PART_TIME, M_DEFAULT, 0, 2, "scatter" },
	[MVR_MAP_MS] = { "depth_map_ms", "depth_map, MVR", TS_FIGURE_PART_TIME, M_MVR, 0, 2, "depth_map" },
	[TRIANGLES] = { "triangles", "triangles", TS_FIGURE_TRIANGLES, 0, 0, TS_WHOLE, "" },
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "ivir_5", "iVIR, figure 5: RMSE to MVR's image of 128 maps, grey levels", { TO_PCSS, TO_IVIR,
	  TO_DEFAULT, TO_CENTRE,
	  TO_MVR, TS_NO_FIGURE } },
	{ "ivir_5_ssim", "SSIM to MVR's image of 128 maps", { LIKE_PCSS, LIKE_IVIR, LIKE_DEFAULT, LIKE_CENTRE, LIKE_MVR,
	  TS_NO_FIGURE } },
	{ "ivir_5_truth", "RMSE to the truth", { PCSS, IVIR, DEFAULT, CENTRE, MVR, REFERENCE, TS_NO_FIGURE } },
	{ "ivir_5_truth_ssim", "SSIM to the truth", { SSIM_PCSS, SSIM_IVIR, SSIM_DEFAULT, SSIM_CENTRE, SSIM_MVR,
	  TS_NO_FIGURE } },
	{ "ivir_5_ratios", "RMSE to the truth by that of PCSS", { RATIO, RATIO_DEFAULT, RATIO_CENTRE, MVR_RATIO,
	  TS_NO_FIGURE } },
	{ "ivir_5_ms", "Whole frames, ms", { TRIANGLES, PCSS_MS, IVIR_MS, DEFAULT_MS, CENTRE_MS, MVR_MS, TS_NO_FIGURE } },
	{ "ivir_5_time", "Frames by PCSS, and the stages that fill depth maps, ms", { TIME, TIME_DEFAULT, SCATTER_MS,
	  MVR_MAP_MS, TS_NO_FIGURE } },
	{ 0 },
};

#define ALL TS_NO_FIGURE, 0, 0

static const ts_paper_relation relations[] = {
	{ "RMSE to MVR's 128 maps, iVIR by PCSS", TO_RATIO, TS_AT_MOST, 0, 1, ALL, TS_IVIR_NEAREST, TO_MVR },
	{ "RMSE to MVR's 128 maps, iVIR at the defaults by PCSS", TO_RATIO_DEFAULT, TS_AT_MOST, 0, 1, ALL,
	  TS_IVIR_NEAREST, TO_MVR },
	{ "RMSE to MVR's 128 maps, iVIR at=centre by PCSS", TO_RATIO_CENTRE, TS_AT_MOST, 0, 1, ALL, TS_IVIR_SMALL,
	  TO_MVR },
	{ "SSIM to MVR's 128 maps, iVIR less PCSS", GAIN, TS_AT_LEAST, 0, 0, ALL, TS_IVIR_NEAREST, LIKE_MVR },
	{ "SSIM to MVR's 128 maps, iVIR at the defaults less PCSS", GAIN_DEFAULT, TS_AT_LEAST, 0, 0, ALL,
	  TS_IVIR_NEAREST, LIKE_MVR },
	{ "SSIM to MVR's 128 maps, iVIR at=centre less PCSS", GAIN_CENTRE, TS_AT_LEAST, 0, 0, ALL, TS_IVIR_SMALL,
	  LIKE_MVR },
	{ "RMSE to truth, iVIR by PCSS", RATIO, TS_AT_MOST, 0, 1, ALL, TS_IVIR_NEAREST, MVR },
	{ "RMSE to truth, iVIR at the defaults by PCSS", RATIO_DEFAULT, TS_AT_MOST, 0, 1, ALL, TS_IVIR_NEAREST, MVR },
	{ "RMSE to truth, iVIR at=centre by PCSS", RATIO_CENTRE, TS_AT_MOST, 0, 1, ALL, TS_IVIR_SMALL, MVR },
	{ "time of iVIR by PCSS", TIME, TS_AT_MOST, 0, 1.1, ALL, "points are made on a processor, taps are few",
	  TRIANGLES },
	{ "time of iVIR at the defaults by PCSS", TIME_DEFAULT, TS_AT_MOST, 0, 1.1, ALL,
	  "points are made on a processor, taps are few", TRIANGLES },
	{ 0 },
};

static const ts_paper_picture pictures[] = {
	{ M_REFERENCE, "mvr-128" }, { M_PCSS, "pcss" }, { M_IVIR, "ivir-paper" }, { M_DEFAULT, "ivir" },
	{ M_CENTRE, "ivir-centre" }, { M_MVR, "mvr" }, { 0 },
};

static const ts_paper_row rows[] = { { 0 } };

const ts_paper_table ts_ivir_5 = {
	.name = "ivir-5", .title = "iVIR, figure 5: soft shadows", .effect = "soft-shadows",
	.scenes = "atrium,gallery,dining",
	.models = "fireplace_room.glb,country_kitchen_partial.glb,bunny.glb,dragon_80k.glb", .objects_head = "maps",
	.objects_param = "lamp.views", .objects = "8,16,32", .most = 1024, .set = "reflectors.count=0",
	.defaults = "scene.ground=on,truth.area_samples=256", .timed = true, .judge = "area", .variants =
	variants, .figures = figures,
	.parts = parts, .relations = relations, .pictures = pictures, .rows = rows,
};
/* clang-format on */
