/* Embree, version 3 or 4: a device and a scene in it, what failed in them, and how much memory they may take. */
#ifndef TS_TRUTH_TREE_H
#define TS_TRUTH_TREE_H
#include "../methods/stages.h"
#include "first_error.h"
#include "rtc.h"
#if TS_EMBREE == 4
typedef struct RTCRayQueryContext ts_tree_context;
#else
typedef struct RTCIntersectContext ts_tree_context;
#endif

typedef struct {
	RTCDevice device;
	RTCScene scene;
	i64 bytes_left;       /* of the memory that Embree may still take, from any thread */
	ts_first_error error; /* Embree's threads report theirs at once */
} ts_tree;

/* Starts an empty tree; `tree` must stay where it is. Released by ts_tree_end, also on failure: Embree's own error. */
ts_status ts_tree_begin(ts_tree *tree, u32 threads);
void ts_tree_end(ts_tree *tree);
/* Builds it over the geometries that were attached. Fails with Embree, and where that broke the contract's
 * arithmetic. */
ts_status ts_tree_build(ts_tree *tree);
/* Fails if Embree has, while `doing`. */
ts_status ts_tree_check(ts_tree *tree, const char *doing);
/* Fails, with Embree's reason if it gives one: it made nothing. */
ts_status ts_tree_fail(ts_tree *tree, const char *doing);
/* The nearest hit, into *ray. Functions of geometries are handed the address of the context. From any thread. */
void ts_tree_cast(const ts_tree *tree, struct RTCRayHit *ray, ts_tree_context *context);
/* The same of 16 rays, of those that `valid` has as -1. The filter, NULL: none, is called behind the geometries' own,
 * with one triangle and some of the rays: by what it leaves of their tfar, where it accepts, the traversal goes on. */
void ts_tree_cast_16(const ts_tree *tree, const int *valid, struct RTCRayHit16 *rays, ts_tree_context *context,
                     RTCFilterFunctionN filter);

#endif
