/* Ground truth: judged by metrics, never by bits. Embree finds the triangle, and our own kernel computes the hit from
 * the triangle. No result depends on threads. */
#ifndef TS_TRUTH_TRUTH_H
#define TS_TRUTH_TRUTH_H
#include "methods/pipeline.h"

typedef struct ts_truth ts_truth;

/* Builds Embree's tree over run->frame's pose.vertex and scene.triangle; degenerate triangles are left out,
 * single-sided back faces and masked texels are skipped by a filter (METHODS 17). *truth is to be released by
 * ts_truth_free before the run ends; NULL on failure: no memory, or Embree's own error. */
ts_status ts_truth_new(ts_truth **truth, const ts_run *run);
/* The cost of casting so far: the rays, and the seconds of all threads together, without computing hits from
 * triangles. */
typedef struct {
	u64 rays;
	double seconds;
} ts_truth_cost;
ts_truth_cost ts_truth_cost_of(const ts_truth *truth);
/* Releases a tree; NULL is allowed. */
void ts_truth_free(ts_truth *truth);

#endif
