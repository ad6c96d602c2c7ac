/* Normals of points that have none, from their neighbours (Hoppe et al., Surface Reconstruction from Unorganized
 * Points, SIGGRAPH 1992, sections 3.2 and 3.3). Only + - * / and the square root, in an order that no thread changes,
 * so every build gives the same bits. */
#ifndef TS_SCENE_NORMALS_H
#define TS_SCENE_NORMALS_H
#include "kernels/base/vec.h"
#include "model/core.h"
#ifdef __cplusplus
extern "C" {
#endif

/* The number of neighbours to which a point's plane is fitted, and to which its orientation is propagated. */
#define TS_NORMALS_NEIGHBOURS 24u
#define TS_NORMALS_MOST (0xffffffffu / TS_NORMALS_NEIGHBOURS)
#define TS_NORMALS_BYTES ((2 * TS_NORMALS_NEIGHBOURS + 7) * sizeof(u32)) /* of memory that a point takes */

/* Unit normals of `n` (at most TS_NORMALS_MOST) points of finite coordinates; zero for a point that is on a line with
 * all its neighbours, or in one place with them. Points connected by neighbours are oriented together: at the highest
 * (the greatest y, then the lowest index) the normal points up. `guessed` (may be NULL): 1 for points of a
 * part that is no closed surface, whose side is a guess: its normals add up to more than an eighth of their number.
 * TS_ERROR with the message set when there is no memory. */
ts_status ts_normals_estimate(ts_v3 *normals, u8 *guessed, const ts_v3 *points, u32 n);

#ifdef __cplusplus
}
#endif
#endif
