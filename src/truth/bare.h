/* Embree alone, as who wants the same pictures fast would use it: nearest triangle and depth along rays through texels,
 * 16 a packet, without filters and without the care of truths. What it sees is timed and never judged. */
#ifndef TS_TRUTH_BARE_H
#define TS_TRUTH_BARE_H
#include "truth.h"

typedef struct ts_bare ts_bare;

/* A tree over the run's pose.vertex and scene.triangle, and the run's off-screen views: all faces of its cubes, or its
 * lights' maps. *bare by ts_bare_free, which may outlive the run; NULL on failure: no memory, or Embree's own error. */
ts_status ts_bare_new(ts_bare **bare, const ts_run *run);
/* Releases it; NULL is allowed. */
void ts_bare_free(ts_bare *bare);

/* Rays through the middles of all texels. */
u64 ts_bare_n_rays(const ts_bare *bare);
/* Casts them by so many threads. */
void ts_bare_cast(ts_bare *bare, u32 threads);
/* Has a truth cast the same, in the same order. */
void ts_bare_cast_truth(const ts_bare *bare, const ts_truth *truth, u32 threads);
/* How many of them hit something, the last time. */
u64 ts_bare_n_hits(const ts_bare *bare);

#endif
