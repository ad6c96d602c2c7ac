/* Closest points: on a triangle (by its Voronoi regions), on a segment, on a triangle's border; and the circumcentre of
 * a triangle. */
#ifndef TS_KERNELS_BASE_CLOSEST_H
#define TS_KERNELS_BASE_CLOSEST_H
#include "kernels/base/vec.h"

/* a / b; 0 if b is 0. */
TS_FN f32 ts_k_ratio(f32 a, f32 b)
{
	f32 sum = ts_flush(b);
	return sum != 0.0f ? a / sum : 0.0f;
}

/* The point of triangle a b c that is closest to p: finds the Voronoi region of p among those of the corners, the edges
 * and the inside (Ericson, Real-Time Collision Detection, 2005, 5.1.5). The order of the tests decides ties. */
TS_CALL ts_v3 ts_k_closest_on_triangle(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Return a where p lies in the region of corner a. */
	ts_v3 ab = ts_sub(b, a);
	ts_v3 ac = ts_sub(c, a);
	ts_v3 ap = ts_sub(p, a);
	f32 d1 = ts_dot(ab, ap);
	f32 d2 = ts_dot(ac, ap);
	if (d1 <= 0.0f && d2 <= 0.0f) return a;
	/* Return b, or the point of ab below p, where p lies in the region of corner b or of edge ab. */
	ts_v3 bp = ts_sub(p, b);
	f32 d3 = ts_dot(ab, bp);
	f32 d4 = ts_dot(ac, bp);
	if (d3 >= 0.0f && d4 <= d3) return b;
	f32 vc = ts_flush(ts_diff_of_products(d1, d4, d3, d2));
	if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return ts_mad(a, ab, ts_k_ratio(d1, d1 - d3));
	/* Return c, or the point of ac below p, where p lies in the region of corner c or of edge ac. */
	ts_v3 cp = ts_sub(p, c);
	f32 d5 = ts_dot(ab, cp);
	f32 d6 = ts_dot(ac, cp);
	if (d6 >= 0.0f && d5 <= d6) return c;
	f32 vb = ts_flush(ts_diff_of_products(d5, d2, d1, d6));
	if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return ts_mad(a, ac, ts_k_ratio(d2, d2 - d6));
	/* Return the point of bc below p where p lies in the region of edge bc. */
	f32 va = ts_flush(ts_diff_of_products(d3, d6, d5, d4));
	f32 bc = d4 - d3;
	f32 cb = d5 - d6;
	if (va <= 0.0f && bc >= 0.0f && cb >= 0.0f) return ts_mad(b, ts_sub(c, b), ts_k_ratio(bc, bc + cb));
	/* Project p into the triangle, by barycentric coordinates. */
	f32 s = va + vb;
	s = s + vc;
	return ts_mad(ts_mad(a, ab, ts_k_ratio(vb, s)), ac, ts_k_ratio(vc, s));
}

/* The point of a segment that is closest to p (Ericson, 5.1.2). */
TS_FN ts_v3 ts_k_closest_on_segment(ts_v3 p, ts_v3 from, ts_v3 to)
{
	ts_v3 u = ts_sub(to, from);
	f32 k = ts_k_ratio(ts_dot(ts_sub(p, from), u), ts_dot(u, u));
	return ts_mad(from, u, ts_clamp(k, 0.0f, 1.0f));
}

/* The point of a and b that is closer to p; of equal distances a. */
TS_FN ts_v3 ts_k_closer(ts_v3 p, ts_v3 a, ts_v3 b) { return ts_length(ts_sub(b, p)) < ts_length(ts_sub(a, p)) ? b : a; }

/* The closest point on the edges of a triangle; of equal distances on the first edge. */
TS_FN ts_v3 ts_k_closest_on_border(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 r = ts_k_closer(p, ts_k_closest_on_segment(p, a, b), ts_k_closest_on_segment(p, b, c));
	return ts_k_closer(p, r, ts_k_closest_on_segment(p, c, a));
}

/* cc = a + ((n x ab) |ac|^2 + (ac x n) |ab|^2) / (2 |n|^2), n = ab x ac; computed in units of the longer of ab and ac.
 * Returns a if there is no circle, or cc is 2^20 units away or more. */
TS_FN ts_v3 ts_k_circumcentre(ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Scale to units of the longer edge at a, so that products of degree four neither overflow nor vanish. */
	ts_v3 ab = ts_sub(b, a);
	ts_v3 ac = ts_sub(c, a);
	f32 unit = ts_max(ts_length(ab), ts_length(ac));
	if (!(unit > 0.0f)) return a;
	f32 inverse = 1.0f / unit;
	ab = ts_scale(ab, inverse);
	ac = ts_scale(ac, inverse);
	/* Return a where the corners lie on a line and there is no circle. */
	ts_v3 n = ts_cross(ab, ac);
	f32 twice = ts_flush(2.0f * ts_dot(n, n));
	if (!(twice > 0.0f)) return a;
	/* Move from a to the centre, unless it is 2^20 units away or more. */
	ts_v3 m = ts_mad(ts_scale(ts_cross(n, ab), ts_dot(ac, ac)), ts_cross(ac, n), ts_dot(ab, ab));
	ts_v3 offset = ts_scale(m, 1.0f / twice);
	return ts_length(offset) < 1048576.0f ? ts_mad(a, offset, unit) : a;
}

#endif
