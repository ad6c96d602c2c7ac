/* iVIR 4.2 and figure 5: soft shadows by PCSS and by few views of iVIR, compared with 128 views of MVR and with
 * rays; and widths of penumbras in texels of depth maps, for tables of soft shadows. */
#include <math.h>
#include "methods/points/tools/benches.h"
#include "methods/stages.h"

#define DEGREE 0.017453292519943295

/* The distances of occluders are not known here. So this is the penumbra, 2 radii wide, of an occluder halfway from the
 * lamp to where its irradiance is light.irradiance: the spot's target, or half the hall's height away from the ball. */
double ts_bench_penumbra(const ts_run *run)
{
	const ts_params *params = &run->params;
	if (TS_PARAM(params, lamp_source) == TS_LAMP_SCENE) return NAN;
	const ts_light *light = ts_frame_data(&run->frame, TS_B_lamp_light);
	const ts_lamp *lamp = ts_frame_data(&run->frame, TS_B_lamp_shape);
	double distance = sqrt((double)light->intensity[0] / (double)TS_PARAM(params, light_irradiance));
	double tangent = ts_run_has_cubes(run) ? 1 : tan((double)TS_PARAM(params, lamp_fov) / 2 * DEGREE);
	double texel = 2 * tangent * distance / TS_PARAM(params, depth_map_px);
	return 2 * (double)lamp->radius / texel;
}

/* clang-format off */
/* Figures of each method except the reference, by prefix `p`. */
#define OF(p) p##PCSS, p##IVIR, p##DEFAULT, p##CENTRE, p##MVR
#define EACH(ROW, p, before, after) \
	ROW(p##PCSS, before "pcss" after, "PCSS", M_PCSS), ROW(p##IVIR, before "ivir" after, "iVIR", M_IVIR), \
	ROW(p##DEFAULT, before "default" after, "defaults", M_DEFAULT), \
	ROW(p##CENTRE, before "centre" after, "at=centre", M_CENTRE), ROW(p##MVR, before "mvr" after, "MVR", M_MVR)
/* The same for iVIR alone, relative to PCSS. */
#define IVIR_OF(p) p##IVIR, p##DEFAULT, p##CENTRE
#define BESIDE_PCSS(ROW, p, of, key, by, digits) \
	ROW(p##IVIR, key, "iVIR" by, of##IVIR, of##PCSS, digits), \
	ROW(p##DEFAULT, key "_default", "defaults" by, of##DEFAULT, of##PCSS, digits), \
	ROW(p##CENTRE, key "_centre", "at=centre" by, of##CENTRE, of##PCSS, digits)
#define RMSE_TO_128(id, key, head, of) TS_RMSE_TO(id, key, head, of, M_REFERENCE)
#define SSIM_TO_128(id, key, head, of) TS_SSIM_TO(id, key, head, of, M_REFERENCE)

enum { M_REFERENCE, OF(M_), M_NARROW, OF(M_NARROW_) };

static const ts_bench_variant variants[] = {
	[M_REFERENCE] = { "mvr", "lamp.views=128", true, TS_ONCE },
	[M_PCSS] = { "pcss", "", true, TS_TIMED },
	[M_IVIR] = { "ivir", TS_IVIR_DEFAULTS, true, TS_TIMED },
	[M_DEFAULT] = { "ivir", "", true, TS_TIMED },
	[M_CENTRE] = { "ivir", "scatter.at=centre", true, TS_TIMED },
	[M_MVR] = { "mvr", "", true, TS_TIMED },
	[M_NARROW] = { "mvr", "lamp.views=128," TS_NARROW, true, TS_ONCE },
	[M_NARROW_PCSS] = { "pcss", TS_NARROW, true, TS_ONCE },
	[M_NARROW_IVIR] = { "ivir", TS_IVIR_DEFAULTS "," TS_NARROW, true, TS_ONCE },
	[M_NARROW_DEFAULT] = { "ivir", TS_NARROW, true, TS_ONCE },
	[M_NARROW_CENTRE] = { "ivir", "scatter.at=centre," TS_NARROW, true, TS_ONCE },
	[M_NARROW_MVR] = { "mvr", TS_NARROW, true, TS_ONCE },
	{ 0 },
};

/* To MVR's reference (TO) and to the truth. */
enum { OF(TO_), OF(LIKE_), OF(RMSE_), RMSE_REFERENCE, OF(SSIM_), IVIR_OF(RATIO_), IVIR_OF(TO_RATIO_), IVIR_OF(GAIN_),
	MVR_RATIO, OF(MS_), TIME, TIME_DEFAULT, SCATTER_MS, MVR_MAP_MS, TRIANGLES,
	PENUMBRA, NARROW, OF(TO_NARROW_) };

static const ts_bench_figure figures[] = {
	EACH(RMSE_TO_128, TO_, "rmse_128_", ""), EACH(SSIM_TO_128, LIKE_, "ssim_128_", ""),
	EACH(TS_RMSE, RMSE_, "rmse_", ""), TS_RMSE(RMSE_REFERENCE, "rmse_reference", "MVR, 128", M_REFERENCE),
	EACH(TS_SSIM, SSIM_, "ssim_", ""),
	BESIDE_PCSS(TS_RATIO, RATIO_, RMSE_, "ratio", " / PCSS", 3),
	BESIDE_PCSS(TS_RATIO, TO_RATIO_, TO_, "ratio_128", " / PCSS", 3),
	BESIDE_PCSS(TS_LESS, GAIN_, LIKE_, "ssim_gain", " less PCSS", 4),
	TS_RATIO(MVR_RATIO, "ratio_mvr", "MVR / PCSS", RMSE_MVR, RMSE_PCSS, 3),
	EACH(TS_MS, MS_, "", "_ms"),
	TS_RATIO(TIME, "time_ratio", "iVIR / PCSS", MS_IVIR, MS_PCSS, 3),
	TS_RATIO(TIME_DEFAULT, "time_ratio_default", "defaults / PCSS", MS_DEFAULT, MS_PCSS, 3),
	TS_PART_MS(SCATTER_MS, "scatter_ms", "scatter, defaults", M_DEFAULT, "scatter"),
	TS_PART_MS(MVR_MAP_MS, "depth_map_ms", "depth_map, MVR", M_MVR, "depth_map"),
	TS_TRIANGLES(TRIANGLES), TS_PENUMBRA(PENUMBRA, "penumbra", "penumbra", M_REFERENCE),
	TS_PENUMBRA(NARROW, "penumbra_narrow", "narrow", M_NARROW),
	TS_RMSE_TO(TO_NARROW_PCSS, "rmse_narrow_pcss", "PCSS", M_NARROW_PCSS, M_NARROW),
	TS_RMSE_TO(TO_NARROW_IVIR, "rmse_narrow_ivir", "iVIR", M_NARROW_IVIR, M_NARROW),
	TS_RMSE_TO(TO_NARROW_DEFAULT, "rmse_narrow_default", "defaults", M_NARROW_DEFAULT, M_NARROW),
	TS_RMSE_TO(TO_NARROW_CENTRE, "rmse_narrow_centre", "at=centre", M_NARROW_CENTRE, M_NARROW),
	TS_RMSE_TO(TO_NARROW_MVR, "rmse_narrow_mvr", "MVR", M_NARROW_MVR, M_NARROW),
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "ivir_5", "iVIR, figure 5: RMSE to MVR's image of 128 maps, grey levels", { OF(TO_), TS_NO_FIGURE } },
	{ "ivir_5_ssim", "SSIM to MVR's image of 128 maps", { OF(LIKE_), TS_NO_FIGURE } },
	{ "ivir_5_truth", "RMSE to the truth", { OF(RMSE_), RMSE_REFERENCE, TS_NO_FIGURE } },
	{ "ivir_5_truth_ssim", "SSIM to the truth", { OF(SSIM_), TS_NO_FIGURE } },
	{ "ivir_5_ratios", "RMSE to the truth by that of PCSS", { IVIR_OF(RATIO_), MVR_RATIO, TS_NO_FIGURE } },
	{ "ivir_5_ms", "Whole frames, ms", { TRIANGLES, OF(MS_), TS_NO_FIGURE } },
	{ "ivir_5_time", "Frames by PCSS, and the stages that fill depth maps, ms", { TIME, TIME_DEFAULT, SCATTER_MS,
	  MVR_MAP_MS, TS_NO_FIGURE } },
	{ "ivir_5_penumbra", TS_PENUMBRA_TITLE "RMSE to 128 maps", { PENUMBRA, NARROW, OF(TO_NARROW_), TS_NO_FIGURE } },
	{ 0 },
};

/* iVIR is no worse than PCSS. */
#define NO_WORSE(error, by, p, kind, least, most, cause) \
	{ error ", iVIR " by " PCSS", p##IVIR, kind, least, most, TS_ANY, TS_IVIR_NEAREST, cause }, \
	{ error ", iVIR at the defaults " by " PCSS", p##DEFAULT, kind, least, most, TS_ANY, TS_IVIR_NEAREST, cause }, \
	{ error ", iVIR at=centre " by " PCSS", p##CENTRE, kind, least, most, TS_ANY, TS_IVIR_SMALL, cause }

#define FEW_TAPS TS_GPU "points are made on a processor, taps are few; see lamp.views=8"

static const ts_paper_relation relations[] = {
	NO_WORSE("RMSE to MVR's 128 maps", "by", TO_RATIO_, TS_AT_MOST, 0, 1, TO_MVR),
	NO_WORSE("SSIM to MVR's 128 maps", "less", GAIN_, TS_AT_LEAST, 0, 0, LIKE_MVR),
	NO_WORSE("RMSE to truth", "by", RATIO_, TS_AT_MOST, 0, 1, RMSE_MVR),
	{ "time of iVIR by PCSS", TIME, TS_AT_MOST, 0, 1.1, TS_ANY, FEW_TAPS, TRIANGLES },
	{ "time of iVIR at the defaults by PCSS", TIME_DEFAULT, TS_AT_MOST, 0, 1.1, TS_ANY, FEW_TAPS, TRIANGLES },
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
	.models = "fireplace_room.glb,country_kitchen_partial.glb,bunny.glb,dragon_80k.glb",
	.alone = "bunny.glb,dragon_80k.glb", .alone_set = TS_WIDE_ALONE, .objects_head = "maps",
	.objects_param = "lamp.views", .objects = "8,16,32", .most = 1024, .set = "reflectors.count=0",
	.defaults = "scene.ground=on,truth.area_samples=256," TS_WIDE, .look = ts_bench_penumbra, .timed = true,
	.judge = "area", .variants = variants, .figures = figures, .parts = parts, .relations = relations,
	.pictures = pictures, .rows = rows,
};
/* clang-format on */
