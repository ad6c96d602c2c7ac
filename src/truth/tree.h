/* A device of Embree, version 3 or 4, and a scene in it, with their first error and their limit of memory. */
#ifndef TS_TRUTH_TREE_H
#define TS_TRUTH_TREE_H
#include "methods/stages.h"
#include "truth/first_error.h"
#include "truth/rtc.h"
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
/* Builds the tree over the attached geometries. Fails if Embree fails, or if Embree's threads break the contract's
 * arithmetic. */
ts_status ts_tree_build(ts_tree *tree);
/* Fails if Embree has failed; `doing` is for the message. */
ts_status ts_tree_check(ts_tree *tree, const char *doing);
/* Fails with Embree's reason, if Embree gives one, where Embree made nothing; `doing` is for the message. */
ts_status ts_tree_fail(ts_tree *tree, const char *doing);
/* Finds the nearest hit, in *ray. Filters of geometries get the address of the context. From any thread. */
void ts_tree_cast(const ts_tree *tree, struct RTCRayHit *ray, ts_tree_context *context);
/* As ts_tree_cast, for those of 16 rays whose `valid` is -1. The filter (NULL: none) is called after the geometries'
 * own filters, with one triangle and some of the rays; where it accepts, the traversal continues up to the tfar that it
 * leaves. */
void ts_tree_cast_16(const ts_tree *tree, const int *valid, struct RTCRayHit16 *rays, ts_tree_context *context,
                     RTCFilterFunctionN filter);

#endif
