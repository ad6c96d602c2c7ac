/* Dual-paraboloid maps (Heidrich and Seidel 1998; Brabec, Annen and Seidel 2002), with the same parametrisation for all
 * views (MegaViews section 3.1; METHODS 13). The front map looks along +x, the back map along -x. A direction d is at
 * (d.y, d.z) / (|d| + |d.x|) of the unit disc, which fills N x N texels, columns along y and rows along z. Texels are
 * stored front map first, then back map, each row by row. The mapping is stereographic: circles stay circles. */
#ifndef TS_KERNELS_VIEWS_PARABOLOID_H
#define TS_KERNELS_VIEWS_PARABOLOID_H
#include "kernels/base/vec.h"

/* (u + 1) / 2 * n */
TS_FN f32 ts_k_paraboloid_place(f32 u, u32 n)
{
	f32 unit = u * 0.5f;
	unit = unit + 0.5f;
	return unit * (f32)n;
}

/* The place of a direction d, of any length, in its map, in texels; d = 0 is in the middle. */
TS_FN ts_v2 ts_k_paraboloid_at(ts_v3 d, u32 n)
{
	f32 sum = ts_length(d) + ts_abs(d.x);
	f32 divisor = sum > 0.0f ? sum : 1.0f;
	return ts_v2_make(ts_k_paraboloid_place(d.y / divisor, n), ts_k_paraboloid_place(d.z / divisor, n));
}

/* The texel of a column and a row, clamped to the map, in the map that shows d; d = 0 is in the front map. */
TS_FN u32 ts_k_paraboloid_index(ts_v3 d, i32 column, i32 row, u32 n)
{
	u32 i = (u32)ts_min_i32(ts_max_i32(column, 0), (i32)n - 1);
	u32 j = (u32)ts_min_i32(ts_max_i32(row, 0), (i32)n - 1);
	u32 back = d.x < 0.0f ? 1u : 0u;
	return (back * n + j) * n + i;
}

TS_FN u32 ts_k_paraboloid_texel(ts_v3 d, u32 n)
{
	ts_v2 at = ts_k_paraboloid_at(d, n);
	return ts_k_paraboloid_index(d, ts_floor_i32(at.x), ts_floor_i32(at.y), n);
}

/* The coordinate of the middle of texel i of n, in [-1, 1]. */
TS_FN f32 ts_k_paraboloid_middle(u32 i, u32 n)
{
	f32 twice = (f32)(2u * i + 1u) / (f32)n;
	return twice - 1.0f;
}

/* Square of the distance of a texel's middle from the middle of the disc. */
TS_FN f32 ts_k_paraboloid_square(u32 texel, u32 n)
{
	f32 u = ts_k_paraboloid_middle(texel % n, n);
	f32 v = ts_k_paraboloid_middle((texel / n) % n, n);
	f32 uu = u * u;
	f32 vv = v * v;
	return uu + vv;
}

/* Whether the texel's middle is on the disc. Texels in the corners show directions of the other map. */
TS_FN bool ts_k_paraboloid_is_used(u32 texel, u32 n) { return ts_k_paraboloid_square(texel, n) <= 1.0f; }

/* Unit direction of a texel's middle. */
TS_FN ts_v3 ts_k_paraboloid_direction(u32 texel, u32 n)
{
	f32 square = ts_k_paraboloid_square(texel, n);
	f32 divisor = 1.0f + square;
	f32 along = (1.0f - square) / divisor;
	f32 y = (2.0f * ts_k_paraboloid_middle(texel % n, n)) / divisor;
	f32 z = (2.0f * ts_k_paraboloid_middle((texel / n) % n, n)) / divisor;
	return ts_v3_make(texel < n * n ? along : -along, y, z);
}

#define TS_LEAST_COSINES 0.00000095367431640625f /* 2^-20: keeps the sum below, a divisor, from 0 */

/* Width of a ball in texels: N sin rho / (cos alpha + cos rho), alpha its angle to the nearer of +x and -x, rho its
 * angular radius. */
TS_FN f32 ts_k_paraboloid_size(f32 cos_alpha, f32 sin_rho, u32 n)
{
	f32 square = sin_rho * sin_rho;
	f32 cos_rho = ts_sqrt(ts_flush(ts_max(1.0f - square, 0.0f)));
	f32 sum = cos_alpha + cos_rho;
	f32 wide = (f32)n * sin_rho;
	return wide / ts_max(sum, TS_LEAST_COSINES);
}

#endif
