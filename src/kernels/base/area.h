/* A triangle's size: its longest edge and its area. */
#ifndef TS_KERNELS_BASE_AREA_H
#define TS_KERNELS_BASE_AREA_H
#include "kernels/base/vec.h"

/* The longest edge: k, where the edge runs from corner k to the next, and its length; of equal lengths the lowest k. */
TS_FN u32 ts_k_longest_edge(ts_v3 a, ts_v3 b, ts_v3 c, f32 *length)
{
	f32 ab = ts_length(ts_sub(b, a));
	f32 bc = ts_length(ts_sub(c, b));
	f32 ca = ts_length(ts_sub(a, c));
	u32 k = bc > ab ? 1u : 0u;
	f32 longest = bc > ab ? bc : ab;
	k = ca > longest ? 2u : k;
	*length = ca > longest ? ca : longest;
	return k;
}

TS_FN f32 ts_k_area(ts_v3 a, ts_v3 b, ts_v3 c) { return 0.5f * ts_length(ts_cross(ts_sub(b, a), ts_sub(c, a))); }

#endif
