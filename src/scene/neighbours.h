/* The k nearest neighbours of points, by a k-d tree (Bentley 1975). Equal distances go to the lower index, so the
 * answer is one, whatever the threads; as many points in one place as there may be cost no more than others. */
#ifndef TS_SCENE_NEIGHBOURS_H
#define TS_SCENE_NEIGHBOURS_H
#include "../model/core.h"
#include "../kernels/base/vec.h"
#ifdef __cplusplus
extern "C" {
#endif

enum { TS_MAX_NEIGHBOURS = 64 };

typedef struct ts_neighbours ts_neighbours;

/* A tree over n points of finite coordinates, at most 2^31 of them; they stay the caller's and must stay in place. NULL
 * with the message set when there is no memory. To be released by ts_neighbours_free. */
ts_neighbours *ts_neighbours_new(const ts_v3 *points, u32 n);
void ts_neighbours_free(ts_neighbours *tree);

typedef struct {
	f32 square;
	u32 index;
} ts_neighbour; /* of the distance; of the point */

/* The k (at most TS_MAX_NEIGHBOURS) points nearest to point i, without itself, by distance, then index. Returns how
 * many there are: less than k where there are not k others. */
u32 ts_neighbours_find(const ts_neighbours *tree, u32 i, u32 k, ts_neighbour *found);

/* The mean distance of every point to its k nearest neighbours, what a splat without a radius is given: 0 where those
 * are in the same place or there are none. */
ts_status ts_neighbours_distance(f32 *distance, const ts_v3 *points, u32 n, u32 k);

#ifdef __cplusplus
}
#endif
#endif
