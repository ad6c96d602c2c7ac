/* The numeric contract: exact conversions, sanitizing, random numbers and elementary functions.
 * Built from + - * / sqrt on binary32 and integers only, so every conforming device gives the same bits.
 * Domains and errors were measured over every float of the domain; see each function. */
#ifndef TS_KERNELS_BASE_NUM_H
#define TS_KERNELS_BASE_NUM_H
#include "kernels/base/compat.h"

#define TS_NONE 0xffffffffu
#define TS_EMPTY 0xffffffffffffffffUL

/* The binary32 next to pi, 2 pi, 4 pi, pi / 2, 1 / pi, 1 / (2 pi), 1 / 3, sqrt(3) and half of that; TS_PI is the double
 * of tools. */
#define TS_PI_F32 3.1415927410125732421875f
#define TS_TWO_PI 6.283185482025146484375f
#define TS_FOUR_PI 12.56637096405029296875f
#define TS_HALF_PI 1.57079637050628662109375f
#define TS_PER_PI 0.3183098733425140380859375f
#define TS_PER_TWO_PI 0.15915493667125701904296875f
#define TS_THIRD 0.3333333432674407958984375f
#define TS_ROOT_3 1.73205077648162841796875f
#define TS_HALF_ROOT_3 0.866025388240814208984375f

/* Near planes lie at 1/1024 of the radius or half extent of what a view is made for: so near that they cut off nothing
 * of weight, and yet above 0, since depths are divisors. */
#define TS_NEAR_OF_RADIUS 0.0009765625f

/* Bits of floats without their sign: 2^-39 and 2^62, the bounds of input (rule 10); 2^-100, below which numbers are
 * flushed (rule 11); infinity, above which lie the NaNs. */
#define TS_LEAST_INPUT_BITS 0x2c000000u
#define TS_MOST_INPUT_BITS 0x5e800000u
#define TS_MOST_INPUT 4611686018427387904.0f
#define TS_FLUSH_BITS 0x0d800000u
#define TS_INFINITE_BITS 0x7f800000u

/* 1.5 * 2^23. Floats of this size have steps of 1, so adding this number rounds to an integer, which stands in the low
 * bits of the sum; subtracting it again leaves the integer as a float. */
#define TS_ROUNDER 12582912.0f
#define TS_ROUNDER_BITS 0x4b400000u

TS_FN f32 ts_min(f32 a, f32 b) { return b < a ? b : a; }
TS_FN f32 ts_max(f32 a, f32 b) { return a < b ? b : a; }
TS_FN f32 ts_clamp(f32 x, f32 lo, f32 hi) { return ts_min(ts_max(x, lo), hi); }
TS_FN f32 ts_abs(f32 x) { return ts_u2f(ts_f2u(x) & 0x7fffffffu); }
TS_FN i32 ts_min_i32(i32 a, i32 b) { return b < a ? b : a; }
TS_FN i32 ts_max_i32(i32 a, i32 b) { return a < b ? b : a; }

/* A float from outside: NaN, -0 and |x| < 2^-39 become +0, |x| > 2^62 becomes +-2^62 (rule 10). */
TS_FN f32 ts_san(f32 x)
{
	u32 u = ts_f2u(x);
	u32 m = u & 0x7fffffffu;
	u32 r = m < TS_LEAST_INPUT_BITS ? 0u : u;
	u32 big = (u & 0x80000000u) | TS_MOST_INPUT_BITS;
	r = m > TS_MOST_INPUT_BITS ? big : r;
	r = m > TS_INFINITE_BITS ? 0u : r;
	return ts_u2f(r);
}

/* |x| < 2^-100 and -0 become +0, by integers: the same whether or not the hardware flushes denormals (rule 11). */
TS_FN f32 ts_flush(f32 x)
{
	u32 u = ts_f2u(x);
	return ts_u2f((u & 0x7fffffffu) < TS_FLUSH_BITS ? 0u : u);
}

/* Every float leaves a kernel through ts_put (rule 12): as ts_flush, NaN as +0, an infinity as the greatest float. */
TS_FN f32 ts_put(f32 x)
{
	u32 u = ts_f2u(x);
	u32 size = u & 0x7fffffffu;
	u32 kept = size == TS_INFINITE_BITS ? u - 1u : u;
	return ts_u2f(size < TS_FLUSH_BITS || size > TS_INFINITE_BITS ? 0u : kept);
}

/* x * 2^frac to the nearest integer, ties to even, saturating at +-(2^bits - 1); NaN gives 0. Branch-free. */
TS_FN i32 ts_fix(f32 x, i32 frac, i32 bits)
{
	/* Split x into 24 bits of mantissa and a shift; 150 is the exponent's bias of 127 and 23 fraction bits. */
	u32 u = ts_f2u(x);
	u32 mantissa = (u & 0x7fffffu) | 0x800000u;
	i32 shift = (i32)((u >> 23) & 255u) - 150 + frac;
	/* Bound the shifts: 8 bits to the left exceed every limit, 25 bits to the right leave nothing. */
	i32 left = ts_min_i32(ts_max_i32(shift, 0), 8);
	i32 right = ts_min_i32(ts_max_i32(-shift, 0), 25);
	/* Round to nearest, ties to even: add half a unit less one, plus the last bit that stays. */
	u32 limit = (1u << (u32)bits) - 1u;
	u32 half_ulp = (1u << (u32)right) >> 1;
	u32 odd = (mantissa >> (u32)right) & 1u;
	u32 round = right != 0 ? half_ulp - 1u + odd : 0u;
	u32 q = ((mantissa << (u32)left) + round) >> (u32)right;
	/* Saturate, give 0 for NaN, and restore the sign. */
	q = q > limit ? limit : q;
	q = (u & 0x7fffffffu) > TS_INFINITE_BITS ? 0u : q;
	return (u & 0x80000000u) != 0u ? -(i32)q : (i32)q;
}

/* To an integer: truncates, saturates; NaN gives 0. */
TS_FN i32 ts_f2i(f32 x)
{
	if (x >= 2147483648.0f) return 2147483647;
	if (x <= -2147483648.0f) return -2147483647 - 1;
	return x == x ? (i32)x : 0;
}

/* The pixel that contains x. */
TS_FN i32 ts_floor_i32(f32 x) { return ts_f2i(ts_floor(x)); }

/* floor(x), clamped to -1 and `most`. Without branches, so that loops become vector code. */
TS_FN i32 ts_k_floor_within(f32 x, f32 most)
{
	f32 near_by = ts_max(-1.0f, ts_min(x, most));
	return (i32)ts_max(near_by, 0.0f) - (near_by < 0.0f ? 1 : 0);
}

/* To the nearest integer, ties to even, for |x| < 2^22 (rule 9). */
TS_FN f32 ts_rint(f32 x)
{
	f32 shifted = x + TS_ROUNDER;
	return shifted - TS_ROUNDER;
}

/* PCG-RXS-M-XS (O'Neill 2014) used as a hash, as by Jarzynski and Olano, Hash Functions for GPU Rendering, 2020. */
TS_FN u32 ts_pcg(u32 v)
{
	u32 s = v * 747796405u + 2891336453u;
	u32 w = ((s >> ((s >> 28) + 4u)) ^ s) * 277803737u;
	return (w >> 22) ^ w;
}

/* Streams (rule 29): 1 cull, 2 light, 3 view, 4 VPL, 5 scene generator, 6 tests, 7 sample sets, 8 particles, 9 items
 * and 10 pixels of a truth that is computed in part, 11 texels that are compared with rays. */
TS_FN u32 ts_random(u32 id, u32 stream, u32 seed) { return ts_pcg(id ^ ts_pcg(stream ^ ts_pcg(seed))); }

/* Uniform in [0,1), a multiple of 2^-24. */
TS_FN f32 ts_uniform(u32 h) { return (f32)(h >> 8) * 5.9604644775390625e-8f; }

/* Domains of ts_log2 and ts_exp: from 2^-126 on, the least normal number; between the least x for which e^x is normal
 * and the greatest for which it is finite. */
#define TS_LOG2_LEAST 1.1754943508222875079687365372222456778186655567720875215087517062784172594547271728515625e-38f
#define TS_LOG2_LEAST_BITS 0x00800000u
#define TS_EXP_LEAST -87.33654022216796875f
#define TS_EXP_MOST 88.72283172607421875f
#define TS_LOG2_E 1.44269502162933349609375f

/* clang-format off */
/* log2 x for x in [2^-126, max], within 2.2 ulp; -126 below the domain and for NaN. */
TS_FN f32 ts_log2(f32 x)
{
	/* Replace what is below the domain by 2^-126, whose logarithm is -126. */
	u32 u = x >= TS_LOG2_LEAST ? ts_f2u(x) : TS_LOG2_LEAST_BITS;
	/* Split x into 2^k (1 + f), with 1 + f in [sqrt(1/2), sqrt(2)): 0x3f3504f3 are the bits of sqrt(1/2). */
	i32 k = (i32)(u - 0x3f3504f3u) >> 23;
	f32 f = ts_u2f(u - ((u32)k << 23));
	f = f - 1.0f;
	/* Evaluate (log2(1 + f) - f log2 e) / f^2 by Horner's rule. */
	f32 p = -9.879513084888458251953125e-2f;
	p = p * f; p = p + 0.17998139560222625732421875f;
	p = p * f; p = p - 0.19302268326282501220703125f;
	p = p * f; p = p + 0.2059147357940673828125f;
	p = p * f; p = p - 0.23950590193271636962890625f;
	p = p * f; p = p + 0.2884725630283355712890625f;
	p = p * f; p = p - 0.36069905757904052734375f;
	p = p * f; p = p + 0.480900824069976806640625f;
	p = p * f; p = p - 0.721347332000732421875f;
	/* Add f log2 e in two parts, the small one first, so that its bits are not lost. */
	f32 f2 = f * f;
	f32 low = f * 1.925963033500011079013347625732421875e-8f;
	f32 a = p * f2;
	a = a + low;
	f32 high = f * TS_LOG2_E;
	f32 s = a + high;
	return s + (f32)k;
}

/* e^x within 0.96 ulp for x in [-87.33654, 88.72283]; +0 below the domain, its largest value above it and for NaN. */
TS_FN f32 ts_exp(f32 x)
{
	/* Clamp x to the domain; NaN becomes its upper end. */
	f32 top = x < TS_EXP_MOST ? x : TS_EXP_MOST;
	f32 in = top > TS_EXP_LEAST ? top : TS_EXP_LEAST;
	/* Split x into n ln 2 + r, n the integer nearest to x / ln 2. */
	f32 t = in * TS_LOG2_E;
	f32 shifted = t + TS_ROUNDER;
	u32 n = ts_f2u(shifted) - TS_ROUNDER_BITS;
	f32 whole = shifted - TS_ROUNDER;
	/* Subtract n ln 2 in two parts (Cody and Waite 1980): the first, 355/512, has few bits: its product is exact. */
	f32 high = whole * 0.693359375f;
	f32 low = whole * -0.000212194441701285541057586669921875f;
	f32 r = in - high;
	r = r - low;
	/* Evaluate e^r by Horner's rule. */
	f32 p = 1.95779386558569967746734619140625e-4f;
	p = p * r; p = p + 1.393576501868665218353271484375e-3f;
	p = p * r; p = p + 8.333886973559856414794921875e-3f;
	p = p * r; p = p + 4.1666455566883087158203125e-2f;
	p = p * r; p = p + 0.16666664183139801025390625f;
	p = p * r; p = p + 0.5f;
	f32 r2 = r * r;
	p = p * r2;
	p = p + r;
	p = p + 1.0f;
	/* Multiply by 2^n: add n to the exponent's bits. Below the domain the value is 0. */
	return top >= TS_EXP_LEAST ? ts_u2f(ts_f2u(p) + (n << 23)) : 0.0f;
}

/* sin (quarter 0) or cos (quarter 1) of t turns, |error| <= 7.5e-8; |t| >= 2^22 counts as 0. */
TS_FN f32 ts_sincos_turn(f32 t, u32 quarter)
{
	/* Drop whole turns, which is exact. */
	t = ts_abs(t) < 4194304.0f ? t : 0.0f;
	f32 r = t - ts_rint(t);
	/* Reduce to s, at most 1/8 turn from the nearest quarter turn, whose number is q. */
	f32 g = r * 4.0f;
	f32 shifted = g + TS_ROUNDER;
	u32 q = ts_f2u(shifted) - TS_ROUNDER_BITS + quarter;
	f32 whole = shifted - TS_ROUNDER;
	f32 back = whole * 0.25f;
	f32 s = r - back;
	/* Evaluate the sine as 2 pi s and a polynomial in s^2. */
	f32 z = s * s;
	f32 a = -75.83747100830078125f;
	a = a * z; a = a + 81.6046142578125f;
	a = a * z; a = a - 41.34175872802734375f;
	f32 sz = s * z;
	f32 high = s * TS_TWO_PI;
	a = a * sz;
	a = a + high;
	/* Evaluate the cosine. */
	f32 c = 58.7647247314453125f;
	c = c * z; c = c - 85.4282379150390625f;
	c = c * z; c = c + 64.93917083740234375f;
	c = c * z; c = c - 19.739208221435546875f;
	c = c * z; c = c + 1.0f;
	/* Choose by the quarter: one of the two, and its sign. */
	f32 v = (q & 1u) != 0u ? c : a;
	return (q & 2u) != 0u ? -v : v;
}
TS_FN f32 ts_sin_turn(f32 t) { return ts_sincos_turn(t, 0u); }
TS_FN f32 ts_cos_turn(f32 t) { return ts_sincos_turn(t, 1u); }

/* The angle of (x, y) in (-pi, pi], within 2.13 ulp, of sanitized coordinates; that of (0, 0) is 0, and ratios below
 * 2^-100 count as 0. */
TS_FN f32 ts_atan2(f32 y, f32 x)
{
	/* Reduce to an angle of at most pi / 4: divide the lesser coordinate by the greater. */
	f32 ax = ts_abs(x);
	f32 ay = ts_abs(y);
	bool steep = ay > ax;
	f32 less = steep ? ax : ay;
	f32 more = steep ? ay : ax;
	f32 a = less / (more > 0.0f ? more : 1.0f);
	a = ts_flush(a);
	/* Evaluate the arc tangent as a and a polynomial in a^2. */
	f32 z = a * a;
	f32 p = 2.9202033765614032745361328125e-3f;
	p = p * z; p = p - 1.636600308120250701904296875e-2f;
	p = p * z; p = p + 4.32087592780590057373046875e-2f;
	p = p * z; p = p - 7.551951706409454345703125e-2f;
	p = p * z; p = p + 0.10665880143642425537109375f;
	p = p * z; p = p - 0.14211022853851318359375f;
	p = p * z; p = p + 0.19993768632411956787109375f;
	p = p * z; p = p - 0.333331525325775146484375f;
	f32 az = a * z;
	f32 r = p * az;
	r = r + a;
	/* Mirror the angle into the octant of (x, y). */
	f32 other = TS_HALF_PI - r;
	r = steep ? other : r;
	f32 back = TS_PI_F32 - r;
	r = x < 0.0f ? back : r;
	return y < 0.0f ? -r : r;
}
/* clang-format on */

#endif
