/* Ground truth: judged by metrics, never by bits. Rays go into Embree's tree, which finds the triangle, and our own
 * kernel computes the hit from the triangle. No result depends on threads. */
#ifndef TS_TRUTH_TRUTH_H
#define TS_TRUTH_TRUTH_H
#include "kernels/base/hit.h"
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

/* A leg of a light path that began at the eye. A hit q has a footprint of spread * (path + |from - q|) world units. */
typedef struct {
	ts_v3 origin, direction; /* world; the direction is unit, or zero: nothing is hit */
	f32 near;                /* no hit before this, world units */
	u32 masked;              /* reflector whose triangles let the ray pass, or TS_NONE */
	ts_v3 from;              /* surface point at which this leg begins, even if the ray starts at a cube's centre */
	f32 path;                /* length of the legs before it */
	f32 spread;              /* footprint of one unit of length: 1 / focal length in pixels; 0: finest level */
	bool whole;              /* holes that alpha cuts out also stop the ray */
} ts_truth_query;

typedef struct {
	u32 triangle;  /* TS_NONE: nothing was hit, and the other fields are 0 */
	f32 t;         /* world units */
	ts_v3 weights; /* barycentrics */
	f32 footprint; /* world units */
	f32 path;      /* |from - q| added to the query's */
} ts_truth_hit;

/* The arrays that the tree was built from. */
const ts_arrays *ts_truth_scene(const ts_truth *truth);
/* The nearest hit that no filter rejects. Safe to call from any number of threads. */
ts_truth_hit ts_truth_cast(const ts_truth *truth, const ts_truth_query *query);

/* As ts_truth_cast, for n queries, in packets of 16; neighbouring queries should have similar directions. */
void ts_truth_cast_all(ts_truth_hit *hits, const ts_truth *truth, const ts_truth_query *queries, u32 n);

/* The distance from a surface at p at which rays begin that must not meet that surface: 2^-12 of the greatest
 * coordinate. */
f32 ts_truth_skip(ts_v3 p);
/* Whether nothing stops a ray from the first point to the second, apart from the last `reach` of its way. */
bool ts_truth_sees(const ts_truth *truth, ts_v3 from, ts_v3 to, f32 reach);
/* As ts_truth_sees, for n pairs at once. */
enum { TS_TRUTH_PAIRS = 64 }; /* at most */
typedef struct {
	ts_v3 from, to;
	f32 reach;
} ts_truth_pair;
void ts_truth_sees_all(bool *sees, const ts_truth *truth, const ts_truth_pair *pairs, u32 n);

/* Runs, in a run that has just begun, the first method of the effect (NULL: of any effect) that makes all buffers
 * `needs`, ended by TS_N_BUFFERS, until these exist (begin.c). */
ts_status ts_truth_begin(ts_run *run, const char *effect, const ts_buffer_id *needs);
/* Runs the stage that makes a buffer, of the first method that has one. */
ts_status ts_truth_make(ts_run *run, ts_buffer_id id);

#endif
