/* Functions of this folder's files: for tools.c, and the tables of bench. */
#ifndef TS_METHODS_HULLS_TOOLS_TOOLS_H
#define TS_METHODS_HULLS_TOOLS_TOOLS_H
#include "replay/check.h"
#include "study/stage_pictures.h"
#include "study/tables/text.h"
#include "truth/sampling.h"
#include "truth/truth.h"

extern const ts_check_rule ts_hulls_checks[];
extern const ts_stage_picture_rule ts_hulls_pictures[];

/* Truths of indirect light (truth_lights.c). Light as in `direct`, but only from the triangles of light whose middle
 * the pixel sees, which shows what visibility would change. Reads gbuffer.pixel and rsm.patch; makes
 * indirect.irradiance in run->frame, from which stage `image.indirect` makes the picture. Fails without memory. */
ts_status ts_truth_lights(ts_truth *truth, ts_run *run, ts_sampling *sampling);
/* Light after one diffuse bounce, by params.truth_bounce_rays rays per pixel, without triangles of light; its
 * difference from ts_truth_lights is the error of the reflective shadow map. Reads gbuffer.pixel and lamp.light; makes
 * the same buffer. */
ts_status ts_truth_bounce(ts_truth *truth, ts_run *run, ts_sampling *sampling);

/* Truths of lamps (truth_lamps.c), from a run that ts_truth_lamps_begin has brought to its lamps and its G-buffer.
 * `exact`: form factors of the lamps' triangles in double precision, without shadows. `shadowed`: the same for the part
 * of each triangle that the pixel sees, by params.truth_area_samples rays per lamp. Both read gbuffer.pixel,
 * polygon.patch, lamp.light and lamp.shape, and make the same buffer. */
ts_status ts_truth_lamps_begin(ts_run *run, const char *effect);
ts_status ts_truth_lamps_exact(ts_truth *truth, ts_run *run, ts_sampling *sampling);
ts_status ts_truth_lamps_shadowed(ts_truth *truth, ts_run *run, ts_sampling *sampling);

/* Tables of bench. */

ts_status ts_bench_segments(const ts_job *job);
ts_status ts_bench_borders(const ts_job *job);
ts_status ts_bench_curves(const ts_job *job);
ts_status ts_bench_logistic(const ts_job *job);
ts_status ts_bench_cosines(const ts_job *job);

#endif
