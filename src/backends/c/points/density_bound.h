/* Triangles in vector lanes, and the cubes that may still change their densities. */
#ifndef TS_BACKENDS_C_POINTS_DENSITY_BOUND_H
#define TS_BACKENDS_C_POINTS_DENSITY_BOUND_H
#include "kernels/points/split.h"

enum { TS_PART = 128, TS_COORDINATES = 9 };

/* Consecutive triangles, and the results of their cubes so far. */
typedef struct {
	u32 n;
	f32 corner[TS_COORDINATES][TS_PART];
	f32 middle[3][TS_PART], reach[TS_PART]; /* no corner is farther from the middle */
	f32 extent;                             /* no coordinate is larger */
	f32 shortest[TS_PART], densest[TS_PART];
	u32 any[TS_PART];
} ts_density_part;

typedef struct {
	ts_v3 eye, centre;
	f32 radius, least, half_size;
} ts_density_cube;

static inline ts_v3 ts_part_corner(const ts_density_part *p, u32 k, u32 i)
{
	return ts_v3_make(p->corner[3 * k][i], p->corner[3 * k + 1][i], p->corner[3 * k + 2][i]);
}

/* Finds middles, reaches and the extent; there are no results yet. */
void ts_density_begin(ts_density_part *p);

/* Lists the triangles whose shortest way or densest need the cube may change; returns their number. */
u32 ts_density_may_count(u32 list[TS_PART], const ts_density_part *p, const ts_density_cube *of);

/* The other half of the fast path of split_count, as src/backends/fast.h has it: densities by the eye (density_eye.c).
 */
bool ts_c_eye_density(const ts_density_args *args, u32 n, u32 threads);

#endif
