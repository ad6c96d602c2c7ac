/* The tables of `bench` that are of this family. */
#ifndef TS_METHODS_POINTS_TOOLS_BENCHES_H
#define TS_METHODS_POINTS_TOOLS_BENCHES_H
#include "study/bench.h"
#include "study/bench_paper.h"
#include "study/claims.h"
#include "study/speed.h"

/* The settings of the iVIR paper, and a quarter of its image, faces and mirrors. */
#define TS_IVIR_DEFAULTS "density.rate=paper,points.snap=off"
#define TS_IVIR_FACE "128"
#define TS_IVIR_QUARTER "cube.max_px=" TS_IVIR_FACE ",reflectors.px=28.75"
#define TS_IVIR_QUARTER_NOTE "A quarter of 1920 x 1080, faces of 512 and mirrors of 115 pixels, for VIR's points."
#define TS_IVIR_NEAREST \
	TS_NOT_ALWAYS \
	"a texel has the nearest of its points, not what is at its centre; see scatter.at=centre"
#define TS_IVIR_SMALL \
	TS_NOT_ALWAYS \
	"points of pieces that are small enough to be culled count at their own place; see points.cull=off"
#define TS_IVIR_VIR TS_OURS "VIR's worst case is a reconstruction; see FIGURES 17, Readings of VIR"
#define TS_IVIR_FEWER TS_NOT_ALWAYS "iVIR has fewer points than VIR; see density.rate=exact"

/* Where pieces are tiny, culling leaves ten of them a texel on average, so that none is left with a chance of
 * exp(-10): in %. The holes of large triangles are those of a simulation, at one sample a texel, of jittered grids. */
#define TS_IVIR_HOLES 0.0045
#define TS_IVIR_LARGE \
	TS_NOT_ALWAYS "triangles larger than a texel show holes: of 0.3 texels 0 %, of 1 0.07, of 3 0.32, " \
				  "of 10 3.5, of 100 5.9, of 1000 7.8, and 0 at sqrt 2 times the rate; see density.rate=watertight"
#define TS_VIR_NOTE "VIR is a reconstruction (METHODS 9)."
#define TS_OMNI_NOTE "Depth maps have 256 x 256 texels, the paper's 1024 x 1024."

/* What penumbras are in the paper's pictures: wide to an eye, and many texels of maps of 1024 wide. The lamp of a model
 * that stands alone is three times as far away, and the eye sees all of the model and its shadow. Penumbras of a lamp
 * that is hard to tell from a point, in coarse maps, are printed and not judged. */
#define TS_WIDE "lamp.radius=0.1"
#define TS_WIDE_ALONE "lamp.radius=0.3,eye.distance=outside"
#define TS_MODELS "bunny.glb,armadillo_86k.glb,dragon_80k.glb,dragon_scans.glb"
#define TS_NARROW "depth_map.px=256,lamp.radius=0.02"
#define TS_PENUMBRA_TITLE "Penumbras, texels wide; narrow: maps of 256, lamp of 0.02; "

/* The stages that make points, those that fill off-screen views, and both, which the totals of the iVIR paper
 * include. */
#define TS_POINT_STAGES "visibility,offscreen.visibility,split,split.views,split.shadow,cull,align,points.count,points"
#define TS_VIEW_STAGES "splat,scatter,scatter.colour,environment_map,cube_face,depth_map,shadow_cube_size,shadow_splat"
#define TS_MAP_STAGES TS_POINT_STAGES "," TS_VIEW_STAGES

/* clang-format off */
/* Rows of figures: their names, their variant or figures, and the decimals if tables differ in them. RMSE and SSIM are
 * to the truth, and missing without a truth; those that end in TO are to the image of the variant `to`. */
#define TS_TRIANGLES(id) [id] = { "triangles", "triangles", TS_FIGURE_TRIANGLES, 0, 0, TS_WHOLE, "" }
#define TS_COUNT(id, key, head, of, what) [id] = { key, head, TS_FIGURE_COUNTER, of, 0, TS_WHOLE, what }
#define TS_MS(id, key, head, of) [id] = { key, head, TS_FIGURE_TIME, of, 0, 2, "" }
#define TS_PART_MS(id, key, head, of, stages) [id] = { key, head, TS_FIGURE_PART_TIME, of, 0, 2, stages }
#define TS_RMSE(id, key, head, of) [id] = { key, head, TS_FIGURE_RMSE, of, of, 3, "" }
#define TS_SSIM(id, key, head, of) [id] = { key, head, TS_FIGURE_SSIM, of, of, 4, "" }
#define TS_RMSE_TO(id, key, head, of, to) [id] = { key, head, TS_FIGURE_RMSE, of, to, 3, TS_TO_IMAGE }
#define TS_SSIM_TO(id, key, head, of, to) [id] = { key, head, TS_FIGURE_SSIM, of, to, 4, TS_TO_IMAGE }
#define TS_RATIO(id, key, head, a, b, digits) [id] = { key, head, TS_FIGURE_RATIO, a, b, digits, "" }
#define TS_LESS(id, key, head, a, b, digits) [id] = { key, head, TS_FIGURE_DIFFERENCE, a, b, digits, "" }
#define TS_PERCENT(id, key, head, a, b) [id] = { key, head, TS_FIGURE_PERCENT, a, b, 4, "" }
#define TS_PENUMBRA(id, key, head, of) [id] = { key, head, TS_FIGURE_LOOKED, of, 0, 1, "" }
#define TS_SAVED(id, key, head, a, b) [id] = { key, head, TS_FIGURE_SAVED, a, b, 1, "" }
#define TS_MORE(id, key, head, a, b) [id] = { key, head, TS_FIGURE_MORE, a, b, 3, "" }

/* Relations by rays for iVIR at either rate: of holes, and of errors against MVR's. */
#define TS_HOLE_RELATIONS(share, cause, default_share, default_cause) \
	{ "holes of iVIR, % of covered texels", share, TS_AT_MOST, 0, TS_IVIR_HOLES, TS_ANY, TS_IVIR_LARGE, cause }, \
	{ "holes of iVIR at the defaults, % of covered texels", default_share, TS_AT_MOST, 0, TS_IVIR_HOLES, TS_ANY, \
	  TS_NOT_ALWAYS "small pieces are culled; see points.cull=off", default_cause }
#define TS_TRUTH_RELATIONS(more, default_more, mvr) \
	{ "RMSE to truth, iVIR less MVR", more, TS_AT_MOST, 0, 0.5, TS_ANY, TS_IVIR_NEAREST, mvr }, \
	{ "RMSE to truth, iVIR at the defaults less MVR", default_more, TS_AT_MOST, 0, 0.5, TS_ANY, TS_IVIR_NEAREST, mvr }
#define TS_HOLES_TITLE "Texels that rays say are covered, and those of them that are empty"
#define TS_IMAGES_TITLE "Images beside the truth, RMSE in grey levels"
/* clang-format on */

extern const ts_speed_of ts_points_speed;
extern const ts_claim ts_points_claims[];
extern const ts_paper_table ts_ivir_1, ts_ivir_2, ts_ivir_3, ts_ivir_culling, ts_ivir_4, ts_ivir_5, ts_ivir_6;
extern const ts_paper_table ts_epr_1, ts_epr_2, ts_epr_3, ts_epr_5, ts_epr_costs, ts_epr_buffers;
/* `look` of tables of soft shadows: the width of penumbras in texels of depth maps; NAN for the scene's own lights. */
double ts_bench_penumbra(const ts_run *run);
ts_status ts_bench_sweep(const ts_job *job);

#endif
