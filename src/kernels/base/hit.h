/* The place where a ray meets the plane of a triangle, and the triangle's weights there (METHODS 17). The truths decide
 * which triangle a ray meets; this file measures where, and gives finite numbers for every input. */
#ifndef TS_KERNELS_BASE_HIT_H
#define TS_KERNELS_BASE_HIT_H
#include "kernels/base/scene.h"

typedef struct {
	f32 t;         /* along the ray, in lengths of its direction */
	ts_v3 weights; /* barycentrics, each in [0,1], of sum 1 */
} ts_hit;

/* The weights of all three corners divided by their sum; a third each if that is zero. */
TS_FN ts_v3 ts_k_hit_weights(f32 a, f32 b, f32 c)
{
	f32 sum = a + b;
	sum = sum + c;
	f32 third = TS_THIRD;
	return sum > 0.0f ? ts_v3_make(ts_put(a / sum), ts_put(b / sum), ts_put(c / sum)) : ts_v3_make(third, third, third);
}

/* Twice the signed area of p, a, b, seen along axis 0, 1 or 2. */
TS_FN f32 ts_k_hit_area(ts_v3 p, ts_v3 a, ts_v3 b, u32 axis)
{
	ts_v3 n = ts_cross(ts_sub(a, p), ts_sub(b, p));
	return axis == 0u ? n.x : axis == 1u ? n.y : n.z;
}

/* part / whole, clamped to [0,1]; 0 if the whole is 0. */
TS_FN f32 ts_k_hit_share(f32 part, f32 whole)
{
	whole = ts_flush(whole);
	return whole != 0.0f ? ts_clamp(ts_flush(part) / whole, 0.0f, 1.0f) : 0.0f;
}

/* The barycentrics of p by areas projected along the longest component of the normal, the lowest on ties (Badouel, An
 * Efficient Ray-Polygon Intersection, Graphics Gems, 1990). */
TS_FN ts_v3 ts_k_hit_barycentrics(ts_v3 p, const ts_corners *t)
{
	f32 x = ts_abs(t->n.x);
	f32 y = ts_abs(t->n.y);
	f32 z = ts_abs(t->n.z);
	u32 axis = x >= y && x >= z ? 0u : y >= z ? 1u : 2u;
	f32 whole = axis == 0u ? t->n.x : axis == 1u ? t->n.y : t->n.z;
	return ts_k_hit_weights(ts_k_hit_share(ts_k_hit_area(p, t->b, t->c, axis), whole),
	                        ts_k_hit_share(ts_k_hit_area(p, t->c, t->a, axis), whole),
	                        ts_k_hit_share(ts_k_hit_area(p, t->a, t->b, axis), whole));
}

/* t = n.(a - o) / n.d, then the barycentrics of o + t d. For a ray within the plane, t leads to the place of the ray
 * that is closest to the centroid. |t| is at most 2^62, the bound of sanitized numbers (rule 10). */
TS_FN ts_hit ts_k_hit(ts_v3 o, ts_v3 d, const ts_corners *t)
{
	f32 slope = ts_flush(ts_dot(t->n, d));
	f32 rise = ts_flush(ts_dot(t->n, ts_sub(t->a, o)));
	f32 square = ts_flush(ts_dot(d, d));
	ts_v3 third = ts_k_hit_weights(0.0f, 0.0f, 0.0f);
	f32 along = ts_flush(ts_dot(d, ts_sub(ts_blend(third, t->a, t->b, t->c), o)));
	f32 length = slope != 0.0f ? rise / slope : square > 0.0f ? along / square : 0.0f;
	ts_hit r;
	r.t = ts_put(ts_clamp(length, -TS_MOST_INPUT, TS_MOST_INPUT));
	r.weights = ts_k_hit_barycentrics(ts_mad(o, d, r.t), t);
	return r;
}

#endif
