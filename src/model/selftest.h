/* Does this file compute as the numeric contract says (CONTRACT rule 8)? Each primitive gets operands for which a
 * contracted, flushed, re-associated or otherwise approximate evaluation has other bits than the IEEE result. Operands
 * are volatile, so that nothing is folded while compiling. Included last, so that a file's pragmas hold here too. */
#ifndef TS_MODEL_SELFTEST_H
#define TS_MODEL_SELFTEST_H
#include "kernels/base/compat.h"

/* Bits of the result, in the order of the primitives' names. */
enum {
	TS_BAD_FMA = 1,
	TS_BAD_FTZ = 2,
	TS_BAD_DAZ = 4,
	TS_BAD_ROUNDING = 8,
	TS_BAD_ASSOCIATION = 16,
	TS_BAD_DIVISION = 32,
	TS_BAD_ROOT = 64,
	TS_BAD_SHIFT = 128,
	TS_BAD_CONVERSION = 256,
	TS_BAD_ZERO = 512,
	TS_BAD_NAN = 1024,
	TS_BAD_LANES = 2048,
};

static inline f32 ts_selftest_load(u32 bits)
{
	volatile u32 v = bits;
	return ts_u2f(v);
}

/* The value, which is needed here and by itself: not as an element of a vector. */
static inline u32 ts_selftest_bits(f32 value)
{
	volatile u32 v = ts_f2u(value);
	return v;
}

static inline f32 ts_selftest_multiply_add(f32 a, f32 b, f32 c)
{
	f32 p = a * b;
	return p + c;
}

/* (1 + 2^-12)^2 - (1 + 2^-11) is 0 after rounding the product, 2^-24 before. Computed for two numbers, because a
 * compiler would not contract one common product. */
static inline unsigned ts_selftest_contraction(void)
{
	f32 a = ts_selftest_load(0x3f800800u), b = ts_selftest_load(0x3f800800u);
	f32 plus = ts_selftest_multiply_add(a, a, ts_selftest_load(0xbf801000u));
	f32 minus = ts_selftest_load(0x3f801000u) - b * b;
	return ts_f2u(plus) == 0u && ts_f2u(minus) == 0u ? 0 : TS_BAD_FMA;
}

static inline unsigned ts_selftest_denormals(void)
{
	f32 result = ts_selftest_load(0x00800000u) * ts_selftest_load(0x3f000000u);
	f32 operand = ts_selftest_load(0x00400000u) * ts_selftest_load(0x40000000u);
	bool positive = ts_selftest_load(0x00000001u) > 0.0f;
	unsigned bad = ts_f2u(result) == 0x00400000u ? 0 : TS_BAD_FTZ;
	return ts_f2u(operand) == 0x00800000u && positive ? bad : bad | TS_BAD_DAZ;
}

/* 1 + 2^-23 + 2^-24 lies half-way between two floats: the even one is larger; 1 + 2^-24: the even one is smaller. */
static inline unsigned ts_selftest_rounding(void)
{
	f32 tiny = ts_selftest_load(0x33800000u), odd = ts_selftest_load(0x3f800001u), one = ts_selftest_load(0x3f800000u);
	bool up = ts_f2u(odd + tiny) == 0x3f800002u && ts_f2u(-odd - tiny) == 0xbf800002u;
	bool down = ts_f2u(one + tiny) == 0x3f800000u && ts_f2u(-one - tiny) == 0xbf800000u;
	return up && down ? 0 : TS_BAD_ROUNDING;
}

/* (1.5 + 1.5 * 2^23) - 1.5 * 2^23 rounds to 2. */
static inline unsigned ts_selftest_association(void)
{
	f32 magic = ts_selftest_load(0x4b400000u);
	f32 constant = ts_selftest_load(0x3fc00000u) + 12582912.0f;
	f32 rounded = ts_selftest_load(0x3fc00000u) + magic;
	rounded = rounded - magic;
	constant = constant - 12582912.0f;
	return ts_f2u(rounded) == 0x40000000u && ts_f2u(constant) == 0x40000000u ? 0 : TS_BAD_ASSOCIATION;
}

/* Several quotients by one divisor, so that a compiler gains by multiplying by the reciprocal; then 3/7, 9/7, 11/7 and
 * 13/7 have other bits. */
static inline unsigned ts_selftest_division(void)
{
	f32 seven = ts_selftest_load(0x40e00000u);
	f32 a = ts_selftest_load(0x40400000u) / seven, b = ts_selftest_load(0x41100000u) / seven;
	f32 c = ts_selftest_load(0x41300000u) / seven, d = ts_selftest_load(0x41500000u) / seven;
	u32 difference = ts_selftest_bits(a) ^ 0x3edb6db7u;
	difference |= ts_selftest_bits(b) ^ 0x3fa49249u;
	difference |= ts_selftest_bits(c) ^ 0x3fc92492u;
	difference |= ts_selftest_bits(d) ^ 0x3fedb6dbu;
	return difference == 0 ? 0 : TS_BAD_DIVISION;
}

static inline unsigned ts_selftest_root(void)
{
	f32 two = ts_sqrt(ts_selftest_load(0x40000000u)), three = ts_sqrt(ts_selftest_load(0x40400000u));
	return ts_f2u(two) == 0x3fb504f3u && ts_f2u(three) == 0x3fddb3d7u ? 0 : TS_BAD_ROOT;
}

static inline unsigned ts_selftest_integers(void)
{
	volatile i32 negative = -5;
	volatile i32 tie = 0x01000001;                           /* 2^24 + 1 */
	volatile i64 wide = ((i64)1 << 40) + ((i64)1 << 16) + 1; /* above half-way: rounding twice gives the even one */
	unsigned bad = negative >> 1 == -3 ? 0 : TS_BAD_SHIFT;
	bool nearest = ts_f2u((f32)tie) == 0x4b800000u && ts_f2u((f32)wide) == 0x53800001u;
	return nearest ? bad : bad | TS_BAD_CONVERSION;
}

/* -0 + 0 and 0 - 0 are 0. */
static inline unsigned ts_selftest_zero(void)
{
	f32 sum = ts_selftest_load(0x80000000u) + 0.0f, difference = 0.0f - ts_selftest_load(0u);
	return ts_f2u(sum) == 0u && ts_f2u(difference) == 0u ? 0 : TS_BAD_ZERO;
}

/* NaN is neither below 1 nor above, nor equal to itself, and no product of it is 0. */
static inline unsigned ts_selftest_nan(void)
{
	f32 nan = ts_selftest_load(0x7fc00000u), one = ts_selftest_load(0x3f800000u);
	f32 lesser = nan < one ? nan : one, greater = one > nan ? nan : one;
	bool kept = ts_f2u(lesser) == 0x3f800000u && ts_f2u(greater) == 0x3f800000u;
	return kept && nan != nan && (ts_f2u(nan * 0.0f) & 0x7fffffffu) > 0x7f800000u ? 0 : TS_BAD_NAN;
}

/* The same operations in a loop over lanes, for which compilers choose vector instructions. */
static inline unsigned ts_selftest_lanes(void)
{
	enum { TS_LANES_OF_SELFTEST = 32 };
	f32 a[TS_LANES_OF_SELFTEST], b[TS_LANES_OF_SELFTEST], c[TS_LANES_OF_SELFTEST];
	u32 difference = 0;
	for (u32 i = 0; i < TS_LANES_OF_SELFTEST; i++) {
		a[i] = ts_selftest_load(0x3f800800u);
		b[i] = ts_selftest_load(0x40e00000u);
		c[i] = ts_selftest_load(0xbf801000u);
	}
	for (u32 i = 0; i < TS_LANES_OF_SELFTEST; i++) c[i] = a[i] * a[i] + c[i];
	for (u32 i = 0; i < TS_LANES_OF_SELFTEST; i++) a[i] = 3.0f / b[i];
	for (u32 i = 0; i < TS_LANES_OF_SELFTEST; i++) b[i] = 11.0f / ts_sqrt(b[i]);
	for (u32 i = 0; i < TS_LANES_OF_SELFTEST; i++) {
		difference |= ts_f2u(c[i]) | (ts_f2u(a[i]) ^ 0x3edb6db7u) | (ts_f2u(b[i]) ^ 0x40850b23u);
	}
	return difference == 0 ? 0 : TS_BAD_LANES;
}

static inline unsigned ts_selftest_all(void)
{
	return ts_selftest_contraction() | ts_selftest_denormals() | ts_selftest_rounding() | ts_selftest_association() |
	       ts_selftest_division() | ts_selftest_root() | ts_selftest_integers() | ts_selftest_zero() |
	       ts_selftest_nan() | ts_selftest_lanes();
}

/* A file's answer, which ts_selftest asks of each that is linked: what is in this section has no other list. Aligned,
 * so that nothing is between two of them. */
typedef struct {
	const char *file;
	unsigned (*bad)(void);
} ts_selftest_of;
#define TS_SELFTEST_OF(file, bad) \
	__attribute__((used, section("ts_selftests"), \
	               aligned(sizeof(ts_selftest_of)))) static const ts_selftest_of selftest_of_file = {file, bad};

#endif
