/* Does this process compute as the numeric contract says (CONTRACT rule 8)? Each primitive gets operands for which a
 * contracted, flushed, re-associated or otherwise approximate evaluation has other bits than the IEEE result. Compiled
 * with the flags of the kernels; operands are volatile, so that nothing is folded while compiling. */
#include "../kernels/base/compat.h"
#include <stdio.h>
#include "core.h"

/* Bits of the answer, in the order of their names. */
enum {
	FMA = 1,
	FTZ = 2,
	DAZ = 4,
	ROUNDING = 8,
	ASSOCIATION = 16,
	DIVISION = 32,
	ROOT = 64,
	SHIFT = 128,
	CONVERSION = 256,
};

static const char *const names[] = {
	"multiply-add (contracted to FMA)",
	"tiny results (flushed to zero)",
	"tiny operands (read as zero)",
	"rounding (not to nearest even)",
	"addition (re-associated)",
	"division (not correctly rounded)",
	"square root (not correctly rounded)",
	"right shift of a negative (not arithmetic)",
	"integer to float (not to nearest even)",
};

static f32 load(u32 bits)
{
	volatile u32 v = bits;
	return ts_u2f(v);
}

static f32 multiply_add(f32 a, f32 b, f32 c)
{
	f32 p = a * b;
	return p + c;
}

/* (1 + 2^-12)^2 - (1 + 2^-11) is 0 after rounding the product, 2^-24 before. */
static unsigned test_contraction(void)
{
	f32 a = load(0x3f800800u), b = load(0x3f800800u); /* two, or the common product would not be contracted */
	f32 plus = multiply_add(a, a, load(0xbf801000u));
	f32 minus = load(0x3f801000u) - b * b;
	return ts_f2u(plus) == 0u && ts_f2u(minus) == 0u ? 0 : FMA;
}

static unsigned test_denormals(void)
{
	f32 result = load(0x00800000u) * load(0x3f000000u);
	f32 operand = load(0x00400000u) * load(0x40000000u);
	bool positive = load(0x00000001u) > 0.0f;
	unsigned bad = ts_f2u(result) == 0x00400000u ? 0 : FTZ;
	return ts_f2u(operand) == 0x00800000u && positive ? bad : bad | DAZ;
}

/* 1 + 2^-23 + 2^-24 lies half-way between two floats: the even one is larger; 1 + 2^-24: the even one is smaller. */
static unsigned test_rounding(void)
{
	f32 tiny = load(0x33800000u), odd = load(0x3f800001u), one = load(0x3f800000u);
	bool up = ts_f2u(odd + tiny) == 0x3f800002u && ts_f2u(-odd - tiny) == 0xbf800002u;
	bool down = ts_f2u(one + tiny) == 0x3f800000u && ts_f2u(-one - tiny) == 0xbf800000u;
	return up && down ? 0 : ROUNDING;
}

/* (1.5 + 1.5 * 2^23) - 1.5 * 2^23 rounds to 2. */
static unsigned test_association(void)
{
	f32 magic = load(0x4b400000u);
	f32 constant = load(0x3fc00000u) + 12582912.0f;
	f32 rounded = load(0x3fc00000u) + magic;
	rounded = rounded - magic;
	constant = constant - 12582912.0f;
	return ts_f2u(rounded) == 0x40000000u && ts_f2u(constant) == 0x40000000u ? 0 : ASSOCIATION;
}

/* Several quotients by one divisor, so that multiplying by its reciprocal would pay; 3, 9, 11 and 13 sevenths tell. */
static unsigned test_division(void)
{
	f32 seven = load(0x40e00000u);
	f32 a = load(0x40400000u) / seven, b = load(0x41100000u) / seven;
	f32 c = load(0x41300000u) / seven, d = load(0x41500000u) / seven;
	u32 difference = ts_f2u(a) ^ 0x3edb6db7u;
	difference |= ts_f2u(b) ^ 0x3fa49249u;
	difference |= ts_f2u(c) ^ 0x3fc92492u;
	difference |= ts_f2u(d) ^ 0x3fedb6dbu;
	return difference == 0 ? 0 : DIVISION;
}

static unsigned test_root(void)
{
	f32 two = ts_sqrt(load(0x40000000u)), three = ts_sqrt(load(0x40400000u));
	return ts_f2u(two) == 0x3fb504f3u && ts_f2u(three) == 0x3fddb3d7u ? 0 : ROOT;
}

static unsigned test_integers(void)
{
	volatile i32 negative = -5;
	volatile i32 tie = 0x01000001;                           /* 2^24 + 1 */
	volatile i64 wide = ((i64)1 << 40) + ((i64)1 << 16) + 1; /* above half-way: rounding twice would go to even */
	unsigned bad = negative >> 1 == -3 ? 0 : SHIFT;
	bool nearest = ts_f2u((f32)tie) == 0x4b800000u && ts_f2u((f32)wide) == 0x53800001u;
	return nearest ? bad : bad | CONVERSION;
}

unsigned ts_selftest(void)
{
	unsigned bad = 0;
#pragma omp parallel num_threads((int)ts_threads_all()) reduction(| : bad)
	bad |= test_contraction() | test_denormals() | test_rounding() | test_association() | test_division() |
	       test_root() | test_integers();
	return bad;
}

ts_status ts_selftest_require(void)
{
	unsigned bad = ts_selftest();
	if (!bad) return TS_OK;
	char text[512] = "";
	for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
		if (bad >> i & 1) {
			size_t used = strlen(text);
			snprintf(text + used, sizeof text - used, "%s%s", used ? ", " : "", names[i]);
		}
	}
	return ts_fail("self-test: this build or process breaks the numeric contract in %s; build with the flags of the "
	               "Makefile and leave the floating-point environment at its default",
	               text);
}
