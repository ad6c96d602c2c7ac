/* IEEE 754 operations rounded once from wider ones: an independent truth for arithmetic vectors. A double holds the
 * sum, product, quotient or root of floats, rounded to odd, with enough bits to be rounded again (Boldo and Melquiond
 * 2008). */
#ifndef TS_TESTS_VECTORS_ROUNDED_H
#define TS_TESTS_VECTORS_ROUNDED_H
#include <float.h>
#include <math.h>
#include <string.h>
#include "vectors/row.h"

/* y rounded to odd, when the exact value lies `error` beyond it. */
static inline double to_odd(double y, double error)
{
	u64 u;
	memcpy(&u, &y, sizeof u);
	if (error == 0 || (u & 1) != 0) return y;
	u += (error > 0) == (y > 0) ? 1 : -1ull;
	memcpy(&y, &u, sizeof y);
	return y;
}

static inline f32 radd(f32 a, f32 b)
{
	double x = a, y = b, s = x + y, t = s - x;
	return (f32)to_odd(s, (x - (s - t)) + (y - t));
}
static inline f32 rsub(f32 a, f32 b) { return radd(a, -b); }
static inline f32 rmul(f32 a, f32 b) { return (f32)((double)a * b); }
static inline f32 rdiv(f32 a, f32 b)
{
	double q = (double)a / b, rest = fma(-q, b, a);
	return (f32)to_odd(q, b < 0 ? -rest : rest);
}
static inline f32 rsqrt(f32 a)
{
	double r = sqrt((double)a);
	return (f32)to_odd(r, fma(-r, r, a));
}

static inline f32 rdot(ts_v3 a, ts_v3 b) { return radd(radd(rmul(a.x, b.x), rmul(a.y, b.y)), rmul(a.z, b.z)); }
static inline f32 rdiff(f32 a, f32 b, f32 c, f32 d) { return rsub(rmul(a, b), rmul(c, d)); }
static inline f32 rmad(f32 a, f32 b, f32 s) { return radd(a, rmul(b, s)); }
static inline ts_v3 rmad3(ts_v3 a, ts_v3 b, f32 s)
{
	return ts_v3_make(rmad(a.x, b.x, s), rmad(a.y, b.y, s), rmad(a.z, b.z, s));
}
static inline f32 stored(f32 x) { return fabsf(x) < 0x1p-100f ? 0 : x; }

static inline i64 saturated(double y, double low, double high)
{
	return (i64)(isnan(y) ? 0 : y < low ? low : y > high ? high : y);
}
static inline i64 fixed(f32 x, i32 frac, i32 bits)
{
	double limit = ldexp(1, bits) - 1;
	return saturated(rint(ldexp((double)x, frac)), -limit, limit);
}

#endif
