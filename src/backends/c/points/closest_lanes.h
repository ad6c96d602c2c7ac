/* Closest points as loops for vectors find them: without branches, with the bits of the kernels. */
#ifndef TS_BACKENDS_CLOSEST_LANES_H
#define TS_BACKENDS_CLOSEST_LANES_H
#include "../../../kernels/base/closest.h"
#include "../raster/lanes.h"

static inline u32 ts_all3(bool x, bool y, bool z)
{
	u32 r = x ? 1u : 0u;
	r = y ? r : 0u;
	return z ? r : 0u;
}

/* ts_k_closest_on_triangle without branches: the first region that holds p of a, b, the edge ab, c, the edges ac and
 * bc, the inside. */
static inline ts_v3 ts_closest_lane(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 ab = ts_sub(b, a);
	ts_v3 ac = ts_sub(c, a);
	ts_v3 ap = ts_sub(p, a);
	ts_v3 bp = ts_sub(p, b);
	ts_v3 cp = ts_sub(p, c);
	f32 d1 = ts_dot(ab, ap);
	f32 d2 = ts_dot(ac, ap);
	f32 d3 = ts_dot(ab, bp);
	f32 d4 = ts_dot(ac, bp);
	f32 d5 = ts_dot(ab, cp);
	f32 d6 = ts_dot(ac, cp);
	f32 va = ts_flush(ts_diff_of_products(d3, d6, d5, d4));
	f32 vb = ts_flush(ts_diff_of_products(d5, d2, d1, d6));
	f32 vc = ts_flush(ts_diff_of_products(d1, d4, d3, d2));
	f32 bc = d4 - d3;
	f32 cb = d5 - d6;
	f32 s = va + vb;
	s = s + vc;
	u32 on_bc = ts_all3(va <= 0.0f, bc >= 0.0f, cb >= 0.0f);
	u32 on_ac = ts_all3(vb <= 0.0f, d2 >= 0.0f, d6 <= 0.0f);
	u32 on_ab = ts_all3(vc <= 0.0f, d1 >= 0.0f, d3 <= 0.0f);
	ts_v3 r = ts_mad(ts_mad(a, ab, ts_k_ratio(vb, s)), ac, ts_k_ratio(vc, s));
	r = ts_choose_lane(on_bc, ts_mad(b, ts_sub(c, b), ts_k_ratio(bc, bc + cb)), r);
	r = ts_choose_lane(on_ac, ts_mad(a, ac, ts_k_ratio(d2, d2 - d6)), r);
	r = ts_choose_lane(ts_all3(d6 >= 0.0f, d5 <= d6, true), c, r);
	r = ts_choose_lane(on_ab, ts_mad(a, ab, ts_k_ratio(d1, d1 - d3)), r);
	r = ts_choose_lane(ts_all3(d3 >= 0.0f, d4 <= d3, true), b, r);
	return ts_choose_lane(ts_all3(d1 <= 0.0f, d2 <= 0.0f, true), a, r);
}

#endif
