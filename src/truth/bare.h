/* Embree alone, as a program would use it that wants the same views fast: nearest triangle and depth along rays through
 * texels, 16 a packet, without filters and without the precision of truths. Its rays are timed; their hits are never
 * judged. */
#ifndef TS_TRUTH_BARE_H
#define TS_TRUTH_BARE_H
#include "truth/truth.h"

typedef struct ts_bare ts_bare;

/* A tree over the run's pose.vertex and scene.triangle, and the run's off-screen views: all faces of its cubes, or its
 * lights' maps. *bare is to be released by ts_bare_free and may outlive the run; NULL on failure: no memory, or
 * Embree's own error. */
ts_status ts_bare_new(ts_bare **bare, const ts_run *run);
/* Releases it; NULL is allowed. */
void ts_bare_free(ts_bare *bare);

/* The number of rays, one through the middle of each texel. */
u64 ts_bare_n_rays(const ts_bare *bare);
/* Casts the rays by so many threads. */
void ts_bare_cast(ts_bare *bare, u32 threads);
/* Casts the same rays by a truth's tree, in the same order. */
void ts_bare_cast_truth(const ts_bare *bare, const ts_truth *truth, u32 threads);
/* The number of rays that hit something in the last cast. */
u64 ts_bare_n_hits(const ts_bare *bare);

#endif
