/* Vectors, with one float operation per statement and sums from left to right (rules 5 and 6). */
#ifndef TS_KERNELS_BASE_VEC_H
#define TS_KERNELS_BASE_VEC_H
#include "kernels/base/num.h"

typedef struct {
	f32 x, y;
} ts_v2;
typedef struct {
	f32 x, y, z;
} ts_v3;

TS_FN ts_v2 ts_v2_make(f32 x, f32 y)
{
	ts_v2 r;
	r.x = x;
	r.y = y;
	return r;
}
TS_FN ts_v3 ts_v3_make(f32 x, f32 y, f32 z)
{
	ts_v3 r;
	r.x = x;
	r.y = y;
	r.z = z;
	return r;
}
TS_FN ts_v3 ts_load3(TS_GLOBAL const f32 *p) { return ts_v3_make(p[0], p[1], p[2]); }
TS_FN void ts_store3(TS_GLOBAL f32 *p, ts_v3 a)
{
	p[0] = ts_put(a.x);
	p[1] = ts_put(a.y);
	p[2] = ts_put(a.z);
}

TS_FN ts_v3 ts_add(ts_v3 a, ts_v3 b) { return ts_v3_make(a.x + b.x, a.y + b.y, a.z + b.z); }
TS_FN ts_v3 ts_sub(ts_v3 a, ts_v3 b) { return ts_v3_make(a.x - b.x, a.y - b.y, a.z - b.z); }
TS_FN ts_v3 ts_mul(ts_v3 a, ts_v3 b) { return ts_v3_make(a.x * b.x, a.y * b.y, a.z * b.z); }
TS_FN ts_v3 ts_scale(ts_v3 a, f32 s) { return ts_v3_make(a.x * s, a.y * s, a.z * s); }
TS_FN ts_v3 ts_neg(ts_v3 a) { return ts_v3_make(-a.x, -a.y, -a.z); }
/* a + b * s */
TS_FN ts_v3 ts_mad(ts_v3 a, ts_v3 b, f32 s) { return ts_add(a, ts_scale(b, s)); }

TS_FN f32 ts_dot(ts_v3 a, ts_v3 b)
{
	f32 x = a.x * b.x;
	f32 y = a.y * b.y;
	f32 z = a.z * b.z;
	f32 s = x + y;
	return s + z;
}

TS_FN f32 ts_diff_of_products(f32 a, f32 b, f32 c, f32 d)
{
	f32 ab = a * b;
	f32 cd = c * d;
	return ab - cd;
}

TS_FN ts_v3 ts_cross(ts_v3 a, ts_v3 b)
{
	return ts_v3_make(ts_diff_of_products(a.y, b.z, a.z, b.y), ts_diff_of_products(a.z, b.x, a.x, b.z),
	                  ts_diff_of_products(a.x, b.y, a.y, b.x));
}

TS_FN f32 ts_length(ts_v3 a) { return ts_sqrt(ts_flush(ts_dot(a, a))); }

/* Zero stays zero. */
TS_FN ts_v3 ts_normalize(ts_v3 a)
{
	f32 l = ts_length(a);
	f32 d = l > 0.0f ? l : 1.0f;
	return ts_v3_make(a.x / d, a.y / d, a.z / d);
}

TS_FN ts_v3 ts_min3(ts_v3 a, ts_v3 b) { return ts_v3_make(ts_min(a.x, b.x), ts_min(a.y, b.y), ts_min(a.z, b.z)); }
TS_FN ts_v3 ts_max3(ts_v3 a, ts_v3 b) { return ts_v3_make(ts_max(a.x, b.x), ts_max(a.y, b.y), ts_max(a.z, b.z)); }

/* i - 2 (i.n) n */
TS_FN ts_v3 ts_reflect(ts_v3 i, ts_v3 n)
{
	f32 d = ts_dot(i, n);
	return ts_mad(i, n, -2.0f * d);
}

/* w.x a + w.y b + w.z c */
TS_FN ts_v3 ts_blend(ts_v3 w, ts_v3 a, ts_v3 b, ts_v3 c)
{
	return ts_add(ts_add(ts_scale(a, w.x), ts_scale(b, w.y)), ts_scale(c, w.z));
}
TS_FN f32 ts_blend1(ts_v3 w, f32 a, f32 b, f32 c)
{
	f32 x = w.x * a;
	f32 y = w.y * b;
	f32 z = w.z * c;
	f32 s = x + y;
	return s + z;
}

#endif
