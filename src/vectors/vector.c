/* Primitives of kernels/base/vec.h. The fused forms are those that compilers choose: gcc and clang fuse the later
 * product, some the earlier one. */
#include "kernels/vectors/vectors_number.h"
#include "vectors/row.h"

static f32 products_fused_first(f32 a, f32 b, f32 c, f32 d)
{
	f32 cd = c * d;
	return fmaf(a, b, -cd);
}
static f32 products_fused_last(f32 a, f32 b, f32 c, f32 d)
{
	f32 ab = a * b;
	return fmaf(-c, d, ab);
}
FLOAT_ITEM(products_first, products_fused_first(A, B, C, ts_row_f32(in, 3)))
FLOAT_ITEM(products_last, products_fused_last(A, B, C, ts_row_f32(in, 3)))

static f32 dot_last(ts_v3 a, ts_v3 b)
{
	f32 x = a.x * b.x;
	return fmaf(a.z, b.z, fmaf(a.y, b.y, x));
}
static f32 dot_first(ts_v3 a, ts_v3 b)
{
	f32 y = a.y * b.y;
	return fmaf(a.z, b.z, fmaf(a.x, b.x, y));
}
static f32 dot_reordered(ts_v3 a, ts_v3 b)
{
	f32 x = a.x * b.x;
	f32 y = a.y * b.y;
	f32 z = a.z * b.z;
	f32 s = y + z;
	return x + s;
}
static ts_v3 mad_fused(ts_v3 a, ts_v3 b, f32 s)
{
	return ts_v3_make(fmaf(b.x, s, a.x), fmaf(b.y, s, a.y), fmaf(b.z, s, a.z));
}

FLOAT_ITEM(dot_fused_last, dot_last(ts_row_v3(in, 0), ts_row_v3(in, 3)))
FLOAT_ITEM(dot_fused_first, dot_first(ts_row_v3(in, 0), ts_row_v3(in, 3)))
FLOAT_ITEM(dot_other_order, dot_reordered(ts_row_v3(in, 0), ts_row_v3(in, 3)))

static void cross_by(u32 *out, const u32 *in, f32 (*difference)(f32, f32, f32, f32))
{
	ts_v3 a = ts_row_v3(in, 0), b = ts_row_v3(in, 3);
	ts_set_v3(out, ts_v3_make(difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z),
	                          difference(a.x, b.y, a.y, b.x)));
}
static void cross_first(u32 *out, const u32 *in) { cross_by(out, in, products_fused_first); }
static void cross_last(u32 *out, const u32 *in) { cross_by(out, in, products_fused_last); }

FLOAT_ITEM(length_last, ts_sqrt(dot_last(ts_row_v3(in, 0), ts_row_v3(in, 0))))
FLOAT_ITEM(length_first, ts_sqrt(dot_first(ts_row_v3(in, 0), ts_row_v3(in, 0))))

static void normalized_by(u32 *out, const u32 *in, f32 square)
{
	ts_v3 a = ts_row_v3(in, 0);
	f32 l = ts_sqrt(ts_flush(square));
	f32 d = l > 0.0f ? l : 1.0f;
	ts_set_v3(out, ts_v3_make(a.x / d, a.y / d, a.z / d));
}
static void normalized_last(u32 *out, const u32 *in)
{
	normalized_by(out, in, dot_last(ts_row_v3(in, 0), ts_row_v3(in, 0)));
}
static void normalized_first(u32 *out, const u32 *in)
{
	normalized_by(out, in, dot_first(ts_row_v3(in, 0), ts_row_v3(in, 0)));
}
static void normalized_reciprocal(u32 *out, const u32 *in)
{
	f32 l = ts_length(ts_row_v3(in, 0));
	f32 r = 1.0f / (l > 0.0f ? l : 1.0f);
	ts_set_v3(out, ts_scale(ts_row_v3(in, 0), r));
}

static void mad_by_fma(u32 *out, const u32 *in)
{
	ts_set_v3(out, mad_fused(ts_row_v3(in, 0), ts_row_v3(in, 3), ts_row_f32(in, 6)));
}

static void reflect_last(u32 *out, const u32 *in)
{
	ts_v3 i = ts_row_v3(in, 0), n = ts_row_v3(in, 3);
	ts_set_v3(out, mad_fused(i, n, -2.0f * dot_last(i, n)));
}
static void reflect_first(u32 *out, const u32 *in)
{
	ts_v3 i = ts_row_v3(in, 0), n = ts_row_v3(in, 3);
	ts_set_v3(out, mad_fused(i, n, -2.0f * dot_first(i, n)));
}

static void blend_last(u32 *out, const u32 *in)
{
	ts_v3 w = ts_row_v3(in, 0);
	ts_set_v3(out, mad_fused(mad_fused(ts_scale(ts_row_v3(in, 3), w.x), ts_row_v3(in, 6), w.y), ts_row_v3(in, 9), w.z));
}
static void blend_first(u32 *out, const u32 *in)
{
	ts_v3 w = ts_row_v3(in, 0);
	ts_set_v3(out, mad_fused(mad_fused(ts_scale(ts_row_v3(in, 6), w.y), ts_row_v3(in, 3), w.x), ts_row_v3(in, 9), w.z));
}

/* Nearly equal products, so that their difference is mostly rounding. */
static void relate_products(u32 *in, u32 random)
{
	if ((random & 3) == 0) return;
	in[2] = in[0];
	in[3] = in[1];
	u32 k = random >> 2 & 3;
	u32 m = in[k] & 0x7fffffu;
	if (m != 0 && m != 0x7fffffu) in[k] += (random & 16) != 0 ? 1u : 0u - 1u;
}

/* clang-format off */
const ts_vector ts_vectors_vector[] = {
	{ PRIMITIVE(diff_of_products), "6", "a b - c d", { SANE("a", 1), SANE("b", 1), SANE("c", 1), SANE("d", 1) },
	  GIVES(F32, 1), { { TS_FAULT_FMA, products_first }, { TS_FAULT_FMA, products_last } },
	  .relate = relate_products },
	{ PRIMITIVE(dot), "6", "(a0 b0 + a1 b1) + a2 b2", { SANE("a", 3), SANE("b", 3) }, GIVES(F32, 1),
	  { { TS_FAULT_FMA, dot_fused_last }, { TS_FAULT_FMA, dot_fused_first }, { TS_FAULT_REORDER, dot_other_order } } },
	{ PRIMITIVE(cross), "6", "a x b, each a difference of products", { SANE("a", 3), SANE("b", 3) },
	  GIVES(F32, 3), { { TS_FAULT_FMA, cross_first }, { TS_FAULT_FMA, cross_last } } },
	{ PRIMITIVE(mad), "6", "a + b s", { SANE("a", 3), SANE("b", 3), SANE("s", 1) }, GIVES(F32, 3),
	  { { TS_FAULT_FMA, mad_by_fma } } },
	{ PRIMITIVE(length), "6, 11", "ts_length", { SANE("a", 3) }, GIVES(F32, 1),
	  { { TS_FAULT_FMA, length_last }, { TS_FAULT_FMA, length_first } } },
	{ PRIMITIVE(normalize), "6, 12", "ts_normalize: three divisions; zero stays zero", { SANE("a", 3) },
	  GIVES(F32, 3), { { TS_FAULT_RECIPROCAL, normalized_reciprocal }, { TS_FAULT_FMA, normalized_last },
	    { TS_FAULT_FMA, normalized_first } } },
	{ PRIMITIVE(reflect), "6", "i - 2 (i.n) n", { WORLD("i", 3), WORLD("n", 3) }, GIVES(F32, 3),
	  { { TS_FAULT_FMA, reflect_last }, { TS_FAULT_FMA, reflect_first } } },
	{ PRIMITIVE(blend), "6, 22", "(w0 a + w1 b) + w2 c", { SANE("w", 3), SANE("a", 3), SANE("b", 3), SANE("c", 3) },
	  GIVES(F32, 3), { { TS_FAULT_FMA, blend_last }, { TS_FAULT_FMA, blend_first } } },
	{ 0 },
};
/* clang-format on */
