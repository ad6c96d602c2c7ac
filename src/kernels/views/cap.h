/* The texels of dual-paraboloid maps that a ball covers: those whose middle shows a direction that meets the ball
 * (MegaViews section 3.2, "Multi-Pixel Filling"; METHODS 13). The mapping is stereographic, so the cap of these
 * directions is the inside of a circle on the map's disc, c + 2 (y u + z v) - b (u^2 + v^2) >= 0, or a half plane, or
 * the outside of a circle. */
#ifndef TS_KERNELS_VIEWS_CAP_H
#define TS_KERNELS_VIEWS_CAP_H
#include "kernels/views/paraboloid.h"

#define TS_CAP_ROUNDING 0.00000095367431640625f /* times the ball's distance: the error of `inside` */
#define TS_CAP_LEAST 512.0f                     /* times that error: the least b of a circle */

/* A ball in one of the two maps. */
typedef struct {
	f32 b, c, y, z;
	f32 radius, rounding;
} ts_cap;

TS_FN ts_cap ts_k_cap(ts_v3 vs, f32 radius, bool back)
{
	/* Measure the ball; d^2 - radius^2 as a product keeps its digits where the view is near the ball. */
	f32 d = ts_length(vs);
	f32 nearest = d - radius;
	f32 square = nearest * (d + radius);
	/* Compute x along the axis of this map, and e, the length of the tangents from the view to the ball. */
	f32 along = back ? -vs.x : vs.x;
	f32 edge = ts_sqrt(ts_flush(ts_max(square, 0.0f)));
	/* Set the circle's b = x + e and c = x - e. From inside the ball every direction meets it; c = 1 and zeros then
	 * make every texel inside. */
	bool all = !(nearest > 0.0f);
	ts_cap r;
	r.b = all ? 0.0f : along + edge;
	r.c = all ? 1.0f : along - edge;
	r.y = all ? 0.0f : vs.y;
	r.z = all ? 0.0f : vs.z;
	r.radius = radius;
	r.rounding = all ? 0.0f : d * TS_CAP_ROUNDING;
	return r;
}

/* 2 y u - b u^2 */
TS_FN f32 ts_k_cap_along(f32 y, f32 b, f32 u)
{
	f32 bent = b * u;
	return ((y + y) - bent) * u;
}

/* The least of 2 y u - b u^2 between two middles; a bound where b is negative. */
TS_FN f32 ts_k_cap_least(f32 y, f32 b, f32 from, f32 to)
{
	return ts_min(ts_k_cap_along(y, b, from), ts_k_cap_along(y, b, to));
}

/* At least 0 if the middle of the texel meets the ball; above the finest level, if the middles of all finest texels in
 * the texel do. */
TS_FN f32 ts_k_cap_inside(const ts_cap *cap, u32 n, u32 level, u32 column, u32 row)
{
	u32 last = (1u << level) - 1u;
	f32 u = ts_k_paraboloid_middle(column << level, n);
	f32 v = ts_k_paraboloid_middle(row << level, n);
	if (level == 0u) return cap->c + (ts_k_cap_along(cap->y, cap->b, u) + ts_k_cap_along(cap->z, cap->b, v));
	f32 b = ts_max(cap->b, 0.0f);
	f32 x = ts_k_cap_least(cap->y, b, u, ts_k_paraboloid_middle((column << level) + last, n));
	f32 y = ts_k_cap_least(cap->z, b, v, ts_k_paraboloid_middle((row << level) + last, n));
	return (cap->c + (x + y)) - cap->rounding;
}

/* Ranges of texels along one axis, and along both. */
typedef struct {
	i32 from, to;
} ts_reach;
typedef struct {
	ts_reach x, y;
} ts_cap_box;

TS_FN ts_reach ts_k_circle_reach(f32 middle, f32 radius, u32 n)
{
	ts_reach r;
	r.from = ts_floor_i32(ts_clamp(ts_k_paraboloid_place(middle - radius, n), 0.0f, (f32)n));
	r.to = ts_floor_i32(ts_clamp(ts_k_paraboloid_place(middle + radius, n), -1.0f, (f32)n - 1.0f)) + 1;
	return r;
}

/* The box of texels in which the cap may be, in a map of n texels per side: the box of its circle, if b is so far above
 * its rounding error that there is one; otherwise the whole map, or nothing if no place of the map can be inside. */
TS_FN ts_cap_box ts_k_cap_box(const ts_cap *cap, u32 n)
{
	ts_cap_box r;
	f32 sides = (ts_abs(cap->y) + ts_abs(cap->z)) + ts_max(-cap->b, 0.0f);
	bool any = (cap->c + (sides + sides)) + cap->rounding >= 0.0f;
	r.x.from = 0;
	r.x.to = any ? (i32)n : 0;
	r.y = r.x;
	if (cap->b > cap->rounding * TS_CAP_LEAST) {
		r.x = ts_k_circle_reach(cap->y / cap->b, cap->radius / cap->b, n);
		r.y = ts_k_circle_reach(cap->z / cap->b, cap->radius / cap->b, n);
	}
	return r;
}

#endif
