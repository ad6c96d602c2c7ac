/* The k nearest neighbours of points, by a k-d tree (Bentley 1975). Of equal distances the lower index is nearer, so
 * the answer is unique and does not depend on threads. Many points in one place cost no more than others. */
#ifndef TS_SCENE_NEIGHBOURS_H
#define TS_SCENE_NEIGHBOURS_H
#include "kernels/base/vec.h"
#include "model/core.h"
#ifdef __cplusplus
extern "C" {
#endif

enum { TS_MAX_NEIGHBOURS = 64 };

typedef struct ts_neighbours ts_neighbours;

/* A tree over n points of finite coordinates, at most 2^31. The points stay the caller's and must outlive the tree
 * unmoved. NULL with the message set when there is no memory, or the work is cancelled. To be released by
 * ts_neighbours_free. */
ts_neighbours *ts_neighbours_new(const ts_v3 *points, u32 n);
void ts_neighbours_free(ts_neighbours *tree);

typedef struct {
	f32 square;
	u32 index;
} ts_neighbour; /* of the distance; of the point */

/* Finds the k (at most TS_MAX_NEIGHBOURS) points nearest to point i, without point i, in the order of distance, then
 * index. Returns their number: less than k where there are not k other points. */
u32 ts_neighbours_find(const ts_neighbours *tree, u32 i, u32 k, ts_neighbour *found);

/* The places where points stand, each once, in the order of their first points. */
typedef struct {
	ts_v3 *at;
	u32 *place, n; /* of each point its place; places */
} ts_places_of;

/* Finds them. To be released by ts_neighbours_places_free; after TS_ERROR, with the message set, there is nothing to
 * release. */
ts_status ts_neighbours_places(ts_places_of *of, const ts_v3 *points, u32 n);
void ts_neighbours_places_free(ts_places_of *of);

/* The mean distance of every point to the k places of other points that are nearest, from which splats without a radius
 * get one: 0 where all points are in one place. */
ts_status ts_neighbours_distance(f32 *distance, const ts_v3 *points, u32 n, u32 k);

#ifdef __cplusplus
}
#endif
#endif
