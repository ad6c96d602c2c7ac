/* Primitives of kernels/base/num.h and half.h: sanitizing, fixed point, conversions, hashes, elementary functions. */
#include "kernels/vectors/vectors_number.h"
#include "vectors/row.h"

static void clamped_chosen(u32 *out, const u32 *in)
{
	f32 x = flushed(A) < flushed(B) ? B : A;
	ts_set_f32(out, 0, flushed(C) < flushed(x) ? C : x);
}
FLOAT_ITEM(clamped_flushed, ts_clamp(flushed(A), flushed(B), flushed(C)))

/* With a comparison and a choice, which keeps a denormal, or with an instruction, which flushes it. */
FLOAT_ITEM(least_chosen, flushed(B) < flushed(A) ? B : A)
FLOAT_ITEM(least_flushed, ts_min(flushed(A), flushed(B)))
FLOAT_ITEM(greatest_chosen, flushed(A) < flushed(B) ? B : A)
FLOAT_ITEM(greatest_flushed, ts_max(flushed(A), flushed(B)))
/* IEEE 754-2019 orders the zeros. */
FLOAT_ITEM(least_builtin, A == B ? ts_u2f(in[0] | in[1]) : A < B ? A : B)
FLOAT_ITEM(greatest_builtin, A == B ? ts_u2f(in[0] & in[1]) : A < B ? B : A)

/* Orders the limits. */
static void relate_clamp(u32 *in, u32 random)
{
	(void)random;
	if (!(C < B)) return;
	u32 low = in[2];
	in[2] = in[1];
	in[1] = low;
}

/* Equal, opposite, or two zeros. */
static void relate_equal(u32 *in, u32 random)
{
	if ((random & 31) == 0) in[0] = random & 0x80000000u;
	if ((random & 7) == 0) in[1] = in[0] ^ (random >> 5 & 1) << 31;
}

typedef enum { AWAY, DOWN } rounding;

static double whole(double y, rounding how) { return how == AWAY ? floor(y + 0.5) : floor(y); }

static i32 fixed(f32 x, i32 frac, i32 bits, rounding how)
{
	if (isnan(x)) return 0;
	double y = whole(ldexp(fabs((double)x), frac), how), limit = ldexp(1, bits) - 1;
	y = y > limit ? limit : y;
	return (i32)(x < 0 ? -y : y);
}

WORD_ITEM(fix_away, fixed(A, ts_row_i32(in, 1), ts_row_i32(in, 2), AWAY))
WORD_ITEM(fix_down, fixed(A, ts_row_i32(in, 1), ts_row_i32(in, 2), DOWN))

/* The formats in use, and values that would fill 31 bits. */
static void relate_fix(u32 *in, u32 random)
{
	static const u32 format[][2] = {{8, 23}, {8, 30}, {8, 12}, {24, 25}, {0, 23}, {16, 31}};
	u32 k = random % 6;
	in[1] = format[k][0];
	in[2] = format[k][1];
	if ((random >> 16 & 3) == 0) return;
	/* Few enough bits below the point for a tie. */
	i32 exponent = 127 - (i32)in[1] + (i32)(random >> 18 & 15);
	u32 kept = (u32)(exponent - 126 + (i32)in[1]);
	u32 mask = kept < 24 ? 0x7fffffu >> (kept - 1) : 0;
	in[0] = (in[0] & 0x80000000u) | (u32)exponent << 23 | (((in[0] & 0x7fffffu) & ~mask) | (mask + 1) >> 1);
}

/* Rounding towards zero, nothing becomes infinite. */
static f32 half(f32 x, rounding how)
{
	int e = ilogb((double)x) < -14 ? -14 : ilogb((double)x);
	double y = ldexp(whole(ldexp(fabs((double)x), 10 - e), how), e - 10);
	y = y < 65536 ? y : how == DOWN ? 65504 : INFINITY;
	return copysignf((f32)y, x);
}

static f32 half_flushed(f32 x, f32 size) { return size < 0x1p-14f ? copysignf(0.0f, x) : ts_half(x); }

FLOAT_ITEM(half_away, half(A, AWAY))
FLOAT_ITEM(half_down, half(A, DOWN))
FLOAT_ITEM(half_flushed_before, half_flushed(A, ts_abs(A)))
FLOAT_ITEM(half_flushed_after, half_flushed(A, ts_abs(ts_half(A))))
FLOAT_ITEM(half_reordered, ts_abs(A) < 0x1p-14f ? A : ts_half(A))

/* Three times in four from half the least to twice the largest, and half of these ties. */
static void relate_half(u32 *in, u32 random)
{
	if ((random & 3) == 0) return;
	u32 exponent = 102 + (random >> 3) % 42, mantissa = in[0];
	u32 tie = exponent < 113 ? 125 - exponent : 12;
	if ((random & 4) != 0) mantissa = (mantissa >> tie | 1u) << tie;
	in[0] = (in[0] & 0x80000000u) | exponent << 23 | (mantissa & 0x7fffffu);
}

WORD_ITEM(floor_i32_truncate, ts_f2i(A))
FLOAT_ITEM(nearest_reordered, A)
FLOAT_ITEM(nearest_builtin, rintf(A))
FLOAT_ITEM(nearest_away, roundf(A) + 0.0f)

#define TURN 6.283185307179586476925286766559

static double reduced(f32 t) { return ts_abs(t) < 4194304.0f ? t - rint(t) : 0; }

FLOAT_ITEM(logarithm_builtin, A >= FLT_MIN ? (f32)log2(A) : -126.0f)
FLOAT_ITEM(exponential_builtin, A<-87.33654f ? 0 : A> 88.72283f ? ts_exp(A) : (f32)exp((double)A))
FLOAT_ITEM(sine_builtin, (f32)sin(TURN *reduced(A)))
FLOAT_ITEM(cosine_builtin, (f32)cos(TURN *reduced(A)))

FLOAT_ITEM(angle_builtin, (f32)atan2((double)A, (double)B))

/* Three times in four the sizes differ by less than a factor of four. */
static void relate_angle(u32 *in, u32 random)
{
	if ((random & 3) == 0 || in[0] == 0 || in[1] == 0) return;
	in[0] = (in[0] & 0x80ffffffu) | 0x3f000000u;
	in[1] = (in[1] & 0x80ffffffu) | 0x3f000000u;
}

static const f32 san_edges[] = {0x1p-39f, 0x1p62f, -0x1p-39f, -0x1p62f, FLT_MAX, FLT_MIN};
static const f32 put_edges[] = {0x1p-100f, -0x1p-100f, FLT_MIN, -FLT_MIN};
/* clang-format off */
static const f32 half_edges[] = { 0x1p-25f, -0x1p-25f, 0x1p-24f, 0x1.8p-24f, 0x1.4p-23f, 0x1.ff8p-15f, 0x1.ffcp-15f,
	0x1p-14f, 0x1.002p0f, 0x1.006p0f, -0x1.002p0f, 65504, 65520, -65520, 65536, FLT_MAX };
static const f32 int_edges[] = { 0x1p31f, -0x1p31f, 0x1p24f, -0x1p24f, 0x1p23f, -0x1p23f, 1, -1, 2, -2, 100, -100 };
static const f32 rint_edges[] = { 0.5f, 1.5f, 2.5f, 3.5f, -0.5f, -1.5f, -2.5f, 2097151.5f, 0x1.fffffep21f };
static const f32 log_edges[] = { FLT_MIN, 0x1.6a09e6p0f, 0x1.6a09e6p-1f, 1, 2, 0.5f, 0x1p-100f, FLT_MAX };
static const f32 exp_edges[] = { 88.7228317f, -87.3365402f, 89, -88, 0.34657359f, -0.34657359f, 1, -1, 128, -128 };
static const f32 turn_edges[] = { 0x1p22f, -0x1p22f, 0.125f, 0.25f, 0.375f, 0.5f, 0.625f, 0.75f, 0.875f, 1, -0.125f };

const ts_vector ts_vectors_number[] = {
	{ PRIMITIVE(min), "4", "b < a ? b : a", { FINITE("a", 1), FINITE("b", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_BUILTIN, least_builtin }, { TS_FAULT_FLUSH, least_chosen },
	    { TS_FAULT_FLUSH, least_flushed } }, .relate = relate_equal },
	{ PRIMITIVE(max), "4", "a < b ? b : a", { FINITE("a", 1), FINITE("b", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_BUILTIN, greatest_builtin }, { TS_FAULT_FLUSH, greatest_chosen },
	    { TS_FAULT_FLUSH, greatest_flushed } }, .relate = relate_equal },
	{ PRIMITIVE(clamp), "4", "min(max(x, low), high)", { FINITE("x", 1), FINITE("low", 1), FINITE("high", 1) },
	  GIVES(F32, 1),
	  { { TS_FAULT_FLUSH, clamped_chosen }, { TS_FAULT_FLUSH, clamped_flushed } }, .relate = relate_clamp },
	{ PRIMITIVE(abs), "4", "x without its sign", { FINITE("x", 1) }, GIVES(F32, 1) },
	{ PRIMITIVE(san), "10", "a float from outside", { ANY("x", 1) }, GIVES(F32, 1), EDGES(san_edges) },
	{ PRIMITIVE(put), "11, 12", "what every stored float passes: tiny ones, -0 and NaN become +0, infinities finite",
	  { ANY("x", 1) }, GIVES(F32, 1), EDGES(put_edges) },
	{ PRIMITIVE(fix), "13, 15", "x * 2^frac to the nearest integer, ties to even, saturating at 2^bits - 1",
	  { ANY("x", 1), INTEGER("frac", 1, 0, 24), INTEGER("bits", 1, 12, 31) }, GIVES(I32, 1),
	  { { TS_FAULT_AWAY, fix_away }, { TS_FAULT_TRUNCATE, fix_down } }, .relate = relate_fix },
	{ PRIMITIVE(to_half), "13", "bits of the nearest binary16 as a float: ties to even, infinite from 65520 on",
	  { FINITE("x", 1) }, GIVES(U32, 1),
	  { { TS_FAULT_AWAY, half_away }, { TS_FAULT_TRUNCATE, half_down }, { TS_FAULT_FLUSH_HALF, half_flushed_before },
	    { TS_FAULT_FLUSH_HALF, half_flushed_after }, { TS_FAULT_REORDER, half_reordered } },
	  EDGES(half_edges), .relate = relate_half },
	{ PRIMITIVE(f2i), "4", "truncating, saturating, NaN gives 0", { ANY("x", 1) }, GIVES(I32, 1),
	  EDGES(int_edges) },
	{ PRIMITIVE(floor_i32), "14", "the pixel that holds x",
	  { { "x", TS_VECTOR_F32, 1, 88, 255, true } }, GIVES(I32, 1),
	  { { TS_FAULT_TRUNCATE, floor_i32_truncate } }, EDGES(int_edges) },
	{ PRIMITIVE(rint), "4", "(x + 1.5 * 2^23) - 1.5 * 2^23, for |x| < 2^22",
	  { { "x", TS_VECTOR_F32, 1, 0, 148, true } }, GIVES(F32, 1),
	  { { TS_FAULT_REORDER, nearest_reordered }, { TS_FAULT_AWAY, nearest_away },
	    { TS_FAULT_BUILTIN, nearest_builtin } },
	  EDGES(rint_edges) },
	{ PRIMITIVE(pcg), "29", "the hash", { ALL_U32("v", 1) }, GIVES(U32, 1) },
	{ PRIMITIVE(random), "29", "pcg(id ^ pcg(stream ^ pcg(seed)))",
	  { ALL_U32("id", 1), UNSIGNED("stream", 1, 1, 7), ALL_U32("seed", 1) }, GIVES(U32, 1) },
	{ PRIMITIVE(uniform), "29", "(h >> 8) * 2^-24", { ALL_U32("h", 1) }, GIVES(F32, 1) },
	{ PRIMITIVE(log2), "9", "ts_log2", { ANY("x", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_BUILTIN, logarithm_builtin } }, EDGES(log_edges) },
	{ PRIMITIVE(exp), "9", "ts_exp", { { "x", TS_VECTOR_F32, 1, 103, 133, true } }, GIVES(F32, 1),
	  { { TS_FAULT_BUILTIN, exponential_builtin } }, EDGES(exp_edges) },
	{ PRIMITIVE(sin_turn), "9", "sine of t turns", { { "t", TS_VECTOR_F32, 1, 88, 255, true } }, GIVES(F32, 1),
	  { { TS_FAULT_BUILTIN, sine_builtin } }, EDGES(turn_edges) },
	{ PRIMITIVE(cos_turn), "9", "cosine of t turns", { { "t", TS_VECTOR_F32, 1, 88, 255, true } }, GIVES(F32, 1),
	  { { TS_FAULT_BUILTIN, cosine_builtin } }, EDGES(turn_edges) },
	{ PRIMITIVE(atan2), "9", "ts_atan2: the angle of (x, y)", { SANE("y", 1), SANE("x", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_BUILTIN, angle_builtin } }, .relate = relate_angle },
	{ 0 },
};
/* clang-format on */
