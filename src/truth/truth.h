/* Ground truth: judged by metrics, never by bits. Embree finds the triangle, our own kernel computes the hit from it. */
#ifndef TS_TRUTH_TRUTH_H
#define TS_TRUTH_TRUTH_H
#include "../stages/stage.h"

typedef struct ts_truth ts_truth;

/* Builds Embree's tree over run->frame's pose.vertex and scene.triangle; degenerate triangles are left out.
 * Single-sided back faces and masked texels are skipped by a filter (SPEC 0.3.5). Released by ts_truth_free. */
ts_status ts_truth_new(ts_truth **truth, const ts_run *run);
void ts_truth_free(ts_truth *truth);
/* Name and version, e.g. "Embree 3.13.5". */
const char *ts_truth_version(void);

/* A: rays from the cube centre along the very same directions as EPR's samples, all params.bounces, own reflector masked.
 * B: true reflections from the surface point, 25 rays a pixel; the own reflector may be hit.
 * Both read pose.vertex, resize.face, eye.view, pixel.record; make shade.radiance (P x 3, tinted as SPEC 2.7) in run->frame
 * from which stage `image` makes the picture. */
ts_status ts_truth_a(ts_truth *truth, ts_run *run);
ts_status ts_truth_b(ts_truth *truth, ts_run *run);
/* For tests and counters of empty look-ups: for each sample of each reflective pixel (P x 25, first bounce, method A's rays)
 * the triangle hit or TS_NONE. *hits by free(). */
ts_status ts_truth_hits(ts_truth *truth, const ts_run *run, u32 **hits);
/* One ray: the nearest triangle with t >= tnear not belonging to reflector `masked` (TS_NONE: none), or TS_NONE. */
u32 ts_truth_ray(const ts_truth *truth, const f32 origin[3], const f32 direction[3], f32 tnear, u32 masked);

/* C (supersample.c): the MVR pipeline at `factor` times the linear resolution of eye and faces, box-filtered in linear
 * radiance down to width x height. radiance: width * height * 3, by free(). */
ts_status ts_truth_c(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 factor, u32 threads);

#endif
