/* Making surfels of the points of files, and checking them (METHODS 16): two half-axes longer than 0, at a right angle
 * to each other and to the normal. Only + - * / and the square root, so every build gives the same bits. */
#ifndef TS_SCENE_SURFEL_H
#define TS_SCENE_SURFEL_H
#include <stdbool.h>
#include "kernels/base/vec.h"
#include "scene/scene.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Axes of at most this length, and coordinates, as of vertices. */
#define TS_SURFEL_LIMIT 16777216.0f

/* Both functions return NULL, or what is wrong with the surfel: part of a message, to follow the surfel's name.
 * Sets u and v to a circle of `radius` in the plane of `normal`, which may be of any length above 0. */
const char *ts_surfel_circle(ts_surfel *surfel, const f32 normal[3], f32 radius);
/* Checks u and v, and exchanges them if u x v points against `normal` (NULL: u x v is the normal). Angles count as
 * right to a cosine of 1/256. */
const char *ts_surfel_ellipse(ts_surfel *surfel, const f32 normal[3]);

/* Quantiles of the radii (longer half-axes) of at least one surfel: least, a quarter, half, three quarters,
 * greatest. */
enum { TS_SURFEL_QUANTILES = 5 };
ts_status ts_surfel_quantiles(f32 quantile[TS_SURFEL_QUANTILES], const ts_surfel *surfels, u32 n);

/* One step of Jacobi's method: turns two vectors in their plane so that they are at a right angle, and u u^T + v v^T is
 * unchanged. False where they are at a right angle already. */
bool ts_axes_straighten(ts_v3 *u, ts_v3 *v);

/* Replaces conjugate half-axes at any angle, as an affine map leaves them, by the half-axes of the same ellipse at a
 * right angle. */
void ts_surfel_straighten(ts_surfel *surfel);

/* Exchanges u and v, which turns the normal over. */
void ts_surfel_turn(ts_surfel *surfel);

#ifdef __cplusplus
}
#endif
#endif
