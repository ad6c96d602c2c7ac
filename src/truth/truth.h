/* Ground truth: judged by metrics, never by bits. Embree finds the triangle, our own kernel computes the hit from it.
 * No result depends on threads. */
#ifndef TS_TRUTH_TRUTH_H
#define TS_TRUTH_TRUTH_H
#include "../stages/stage.h"

typedef struct ts_truth ts_truth;

/* Builds Embree's tree over run->frame's pose.vertex and scene.triangle; degenerate triangles are left out,
 * single-sided back faces and masked texels are skipped by a filter (SPEC 0.3.5). *truth by ts_truth_free, before the
 * run ends; NULL on failure: no memory, or Embree's own error. */
ts_status ts_truth_new(ts_truth **truth, const ts_run *run);
/* Releases a tree; NULL is allowed. */
void ts_truth_free(ts_truth *truth);

/* A: rays from the cube's centre along the very same directions as EPR's samples, all params.bounces, own reflector
 * masked. Reads pose.vertex, resize.face, eye.view and pixel.record; makes shade.radiance (P x 3, tinted as SPEC 2.7)
 * in run->frame, from which stage `image` makes the picture. Fails without memory. */
ts_status ts_truth_a(ts_truth *truth, ts_run *run);
/* B: the same with true reflections from the surface point, 25 rays a pixel; the own reflector may be hit. */
ts_status ts_truth_b(ts_truth *truth, ts_run *run);

/* What EPR's look-ups are judged by: the triangle, or TS_NONE, that each sample of each reflective pixel hits
 * (P x 25, the first legs of A). *hits by free(); NULL on failure. */
ts_status ts_truth_hits(ts_truth *truth, const ts_run *run, u32 **hits);

/* C (supersample.c): the MVR pipeline at `factor` (1 to 16) times the linear resolution of eye and faces, box-filtered
 * in linear radiance down to width x height. *radiance: width * height * 3 floats, by free(). NULL on failure: a factor
 * that takes a parameter out of its range, or more memory than a run may use. */
ts_status ts_truth_c(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 factor, u32 threads);

#endif
