/* Primitives: operations that IEEE 754 defines, one each, and the two that compilers like to fuse (CONTRACT rules 4 to
 * 6). */
#include "kernels/vectors/vectors_number.h"
#include "vectors/row.h"

FLOAT_ITEM(add_flush, flushed(flushed(A) + flushed(B)))
FLOAT_ITEM(sub_flush, flushed(flushed(A) - flushed(B)))
FLOAT_ITEM(mul_flush, flushed_result((double)flushed(A) * flushed(B)))
FLOAT_ITEM(quotient_flush, flushed_result((double)flushed(A) / flushed(B)))

static void quotient_reciprocal(u32 *out, const u32 *in)
{
	f32 r = 1.0f / B;
	ts_set_f32(out, 0, A * r);
}

FLOAT_ITEM(root_flush, ts_sqrt(flushed(A)))

static void root_reciprocal(u32 *out, const u32 *in)
{
	f32 r = 1.0f / ts_sqrt(A);
	ts_set_f32(out, 0, A * r);
}

FLOAT_ITEM(multiply_add_fused, fmaf(A, B, C))

static void multiply_add_flush(u32 *out, const u32 *in)
{
	f32 p = flushed_result((double)flushed(A) * flushed(B));
	ts_set_f32(out, 0, flushed(p + flushed(C)));
}

FLOAT_ITEM(multiply_subtract_fused, fmaf(-A, B, C))

static void multiply_subtract_flush(u32 *out, const u32 *in)
{
	f32 p = flushed_result((double)flushed(A) * flushed(B));
	ts_set_f32(out, 0, flushed(flushed(C) - p));
}

WORD_ITEM(compare_flush, ts_k_vector_order(flushed(A), flushed(B)))

FLOAT_ITEM(round_down_flush, ts_floor(flushed(A)))
FLOAT_ITEM(round_down_truncate, truncf(A))

/* |x| towards zero: cut below a float's 24 bits. */
static f32 truncated(u64 x, bool negative)
{
	u32 n = 0;
	while (x >> n >= 1u << 24) n++;
	f32 y = (f32)(x >> n << n);
	return negative ? -y : y;
}

static u64 magnitude(i64 x) { return x < 0 ? 0 - (u64)x : (u64)x; }

FLOAT_ITEM(from_i32_truncate, truncated(magnitude(ts_row_i32(in, 0)), ts_row_i32(in, 0) < 0))
FLOAT_ITEM(from_u32_truncate, truncated(in[0], false))
FLOAT_ITEM(from_i64_truncate, truncated(magnitude(ts_row_i64(in, 0)), ts_row_i64(in, 0) < 0))
FLOAT_ITEM(from_i64_twice, (f32)(double)ts_row_i64(in, 0))

/* So near the middle between two floats that a double cannot distinguish it. */
static void relate_i64(u32 *in, u32 random)
{
	if ((random & 3) != 0) return;
	u64 middle = ((u64)random | 1u << 31) << 31 | 1ull << 38;
	ts_set_u64(in, 0, (middle & ~((1ull << 38) - 1)) + (random >> 2 & 1 ? 1 : 0) - (random >> 3 & 1 ? 1 : 0));
}

FLOAT_ITEM(third_reciprocal, A *(1.0f / 3.0f))
FLOAT_ITEM(third_flush, flushed_result((double)flushed(A) / 3))

static void set_constants(u32 *out, f32 one_by_one, f32 at_once)
{
	ts_set_f32(out, 0, one_by_one);
	ts_set_f32(out, 1, at_once);
}

static void constants_reordered(u32 *out, const u32 *in)
{
	f32 both = TS_VECTOR_FACTOR * TS_VECTOR_OTHER;
	set_constants(out, A * both, A * both);
}

static void constants_one_by_one(u32 *out, const u32 *in)
{
	f32 once = A * TS_VECTOR_FACTOR;
	set_constants(out, once * TS_VECTOR_OTHER, once * TS_VECTOR_OTHER);
}

static void constants_flush(u32 *out, const u32 *in)
{
	f32 both = TS_VECTOR_FACTOR * TS_VECTOR_OTHER, once = flushed_result((double)flushed(A) * TS_VECTOR_FACTOR);
	set_constants(out, flushed_result((double)once * TS_VECTOR_OTHER), flushed_result((double)flushed(A) * both));
}

static const f32 whole_edges[] = {0.5f, 1.0f, 1.5f, 2.0f, 8388607.5f, 8388608.0f, 16777216.0f, -0.5f, -1.0f};

/* clang-format off */
const ts_vector ts_vectors_arithmetic[] = {
	{ PRIMITIVE(add), "4", "a + b", { FINITE("a", 1), FINITE("b", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_FLUSH, add_flush } } },
	{ PRIMITIVE(sub), "4", "a - b", { FINITE("a", 1), FINITE("b", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_FLUSH, sub_flush } } },
	{ PRIMITIVE(mul), "4", "a * b", { FINITE("a", 1), FINITE("b", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_FLUSH, mul_flush } } },
	{ PRIMITIVE(div), "4", "a / b, correctly rounded", { FINITE("a", 1), FINITE("b", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_RECIPROCAL, quotient_reciprocal }, { TS_FAULT_FLUSH, quotient_flush } } },
	{ PRIMITIVE(sqrt), "4", "square root of a, correctly rounded", { POSITIVE("a", 1, 0, 254) }, GIVES(F32, 1),
	  { { TS_FAULT_ROOT, root_reciprocal }, { TS_FAULT_FLUSH, root_flush } } },
	{ PRIMITIVE(muladd), "4, 5", "a * b + c, rounded twice", { FINITE("a", 1), FINITE("b", 1), FINITE("c", 1) },
	  GIVES(F32, 1), { { TS_FAULT_FMA, multiply_add_fused }, { TS_FAULT_FLUSH, multiply_add_flush } } },
	{ PRIMITIVE(mulsub), "4, 5", "c - a * b, rounded twice", { FINITE("a", 1), FINITE("b", 1), FINITE("c", 1) },
	  GIVES(F32, 1),
	  { { TS_FAULT_FMA, multiply_subtract_fused }, { TS_FAULT_FLUSH, multiply_subtract_flush } } },
	{ PRIMITIVE(compare), "4", "1 if a < b, 2 if a == b, 4 if a > b", { FINITE("a", 1), FINITE("b", 1) },
	  GIVES(U32, 1), { { TS_FAULT_FLUSH, compare_flush } } },
	{ PRIMITIVE(floor), "4", "the largest whole number that is not above a", { FINITE("a", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_TRUNCATE, round_down_truncate }, { TS_FAULT_FLUSH, round_down_flush } }, EDGES(whole_edges) },
	{ PRIMITIVE(i32_to_f32), "4", "to the nearest float, ties to even", { INTEGER("a", 1, INT32_MIN, INT32_MAX) },
	  GIVES(F32, 1), { { TS_FAULT_TRUNCATE, from_i32_truncate } } },
	{ PRIMITIVE(u32_to_f32), "4", "to the nearest float, ties to even", { ALL_U32("a", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_TRUNCATE, from_u32_truncate } } },
	{ PRIMITIVE(i64_to_f32), "4, 22", "to the nearest float, ties to even, rounded once",
	  { { "a", TS_VECTOR_I64, 1, INT64_MIN, INT64_MAX, true } }, GIVES(F32, 1),
	  { { TS_FAULT_TRUNCATE, from_i64_truncate }, { TS_FAULT_TWICE, from_i64_twice } }, .relate = relate_i64 },
	{ PRIMITIVE(third), "4", "a / 3, where the compiler knows the 3", { FINITE("a", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_RECIPROCAL, third_reciprocal }, { TS_FAULT_FLUSH, third_flush } } },
	{ PRIMITIVE(constants), "4, 6", "(a c) d and a (c d); the compiler knows c = 0x1.19999ap+0 and d = 0x1.b33334p+0",
	  { { "a", TS_VECTOR_F32, 1, 0, 252, true } }, GIVES(F32, 2),
	  { { TS_FAULT_REORDER, constants_reordered }, { TS_FAULT_REORDER, constants_one_by_one },
	    { TS_FAULT_FLUSH, constants_flush } } },
	{ 0 },
};
/* clang-format on */
