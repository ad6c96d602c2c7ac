/* Closest points for vector loops: without branches, with the bits of the kernels. */
#ifndef TS_BACKENDS_C_POINTS_CLOSEST_LANES_H
#define TS_BACKENDS_C_POINTS_CLOSEST_LANES_H
#include "backends/c/raster/lanes.h"
#include "kernels/base/closest.h"

static inline u32 ts_all3(bool x, bool y, bool z)
{
	u32 r = x ? 1u : 0u;
	r = y ? r : 0u;
	return z ? r : 0u;
}

/* The point from + by * part / whole. */
typedef struct {
	ts_v3 from, by;
	f32 part, whole;
} ts_along;

static inline ts_along ts_choose_along(u32 first, ts_along a, ts_along b)
{
	return (ts_along){ts_choose_lane(first, a.from, b.from), ts_choose_lane(first, a.by, b.by),
	                  first != 0u ? a.part : b.part, first != 0u ? a.whole : b.whole};
}

/* Dot products of the sides ab and ac with p - a: d1, d2; with p - b: d3, d4; with p - c: d5, d6. */
typedef struct {
	f32 d1, d2, d3, d4, d5, d6;
} ts_side_dots;

/* The closest point by the first region that contains p: a, b, the edge ab, c, the edges ac and bc, the inside. One
 * division serves all edges, and one more the inside. Whatever the six numbers are, the result is on the triangle: by
 * cases of sign and order, none of va, vb and vc is negative where no test holds. Rounding preserves this, since
 * products and differences are rounded monotonically: a rounded sign is the true one, or 0. */
static inline ts_v3 ts_closest_by_dots(ts_side_dots d, ts_v3 a, ts_v3 b, ts_v3 c, ts_v3 ab, ts_v3 ac)
{
	f32 va = ts_flush(ts_diff_of_products(d.d3, d.d6, d.d5, d.d4));
	f32 vb = ts_flush(ts_diff_of_products(d.d5, d.d2, d.d1, d.d6));
	f32 vc = ts_flush(ts_diff_of_products(d.d1, d.d4, d.d3, d.d2));
	f32 bc = d.d4 - d.d3;
	f32 cb = d.d5 - d.d6;
	f32 s = va + vb;
	s = s + vc;
	u32 on_bc = ts_all3(va <= 0.0f, bc >= 0.0f, cb >= 0.0f);
	u32 on_ac = ts_all3(vb <= 0.0f, d.d2 >= 0.0f, d.d6 <= 0.0f);
	u32 on_ab = ts_all3(vc <= 0.0f, d.d1 >= 0.0f, d.d3 <= 0.0f);
	ts_along at = {a, ab, vb, s};
	at = ts_choose_along(on_bc, (ts_along){b, ts_sub(c, b), bc, bc + cb}, at);
	at = ts_choose_along(on_ac, (ts_along){a, ac, d.d2, d.d2 - d.d6}, at);
	at = ts_choose_along(on_ab, (ts_along){a, ab, d.d1, d.d1 - d.d3}, at);
	ts_v3 edge = ts_mad(at.from, at.by, ts_k_ratio(at.part, at.whole));
	ts_v3 r = ts_mad(edge, ac, ts_k_ratio(vc, s));
	r = ts_choose_lane(on_bc, edge, r);
	r = ts_choose_lane(on_ac, edge, r);
	r = ts_choose_lane(ts_all3(d.d6 >= 0.0f, d.d5 <= d.d6, true), c, r);
	r = ts_choose_lane(on_ab, edge, r);
	r = ts_choose_lane(ts_all3(d.d3 >= 0.0f, d.d4 <= d.d3, true), b, r);
	return ts_choose_lane(ts_all3(d.d1 <= 0.0f, d.d2 <= 0.0f, true), a, r);
}

/* ts_k_closest_on_triangle without branches. */
static inline ts_v3 ts_closest_lane(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 ab = ts_sub(b, a);
	ts_v3 ac = ts_sub(c, a);
	ts_v3 ap = ts_sub(p, a);
	ts_v3 bp = ts_sub(p, b);
	ts_v3 cp = ts_sub(p, c);
	ts_side_dots d = {.d1 = ts_dot(ab, ap),
	                  .d2 = ts_dot(ac, ap),
	                  .d3 = ts_dot(ab, bp),
	                  .d4 = ts_dot(ac, bp),
	                  .d5 = ts_dot(ab, cp),
	                  .d6 = ts_dot(ac, cp)};
	return ts_closest_by_dots(d, a, b, c, ab, ac);
}

#endif
