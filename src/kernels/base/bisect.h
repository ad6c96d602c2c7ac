/* Bisection of triangles that are too large for one lattice of samples (METHODS 2). */
#ifndef TS_KERNELS_BASE_BISECT_H
#define TS_KERNELS_BASE_BISECT_H
#include "kernels/base/area.h"

/* Limits of a lattice: samples of a part; and samples along an edge, so that indices stay below 2^15. */
#define TS_SPLIT_SAMPLES 65536.0f /* 2^16 */
#define TS_MOST_WIDTH 16384.0f

/* A part of a triangle, and its path: a one, then a bit for each bisection. */
typedef struct {
	ts_v3 v[3];
	u32 path;
} ts_part;

/* The child of a bisected part: 0 keeps the edge's first corner, 1 its second. Both neighbours of an edge compute the
 * same midpoint. */
TS_FN ts_part ts_k_child(const ts_part *part, u32 edge, u32 child)
{
	u32 next = edge == 2u ? 0u : edge + 1u;
	ts_part r = *part;
	r.v[child == 0u ? next : edge] = ts_scale(ts_add(part->v[edge], part->v[next]), 0.5f);
	r.path = part->path * 2u + child;
	return r;
}

#endif
