/* Primitives of textures, cube maps and display values (kernels/base/texture.h, srgb.h, kernels/raster/cube.h). */
#include "kernels/vectors/vectors_texture.h"
#include "vectors/row.h"

/* At most one texel outside. */
static void relate_neighbour(u32 *in, u32 random)
{
	u32 n = in[1];
	in[0] = (random & 7) == 0 ? 0u - 1u : (random & 7) == 1 ? n : (random >> 3) % n;
}

/* uv on the lattice of 1/256 texel, cut instead of rounded. */
static void bilinear_truncate(u32 *out, const u32 *in)
{
	f32 u = floorf(ts_row_f32(in, 8) * 512.0f), v = floorf(ts_row_f32(in, 9) * 512.0f);
	ts_k_vector_sample(out, in, ts_v2_make(u * 0.001953125f, v * 0.001953125f));
}

/* Half-way between two weights. */
static void relate_bilinear(u32 *in, u32 random)
{
	if ((random & 3) != 0) return;
	ts_set_f32(in, 8, ((f32)(random >> 8 & 511) + 0.5f) / 512.0f);
	ts_set_f32(in, 9, ((f32)(random >> 17 & 511) + 0.5f) / 512.0f);
}

static void lod_by(u32 *out, const u32 *in, bool builtin)
{
	f32 texels = (f32)in[0] * (f32)in[1];
	f32 r = 1.0f / ts_row_f32(in, 4);
	f32 density = texels * (builtin ? ts_row_f32(in, 3) / ts_row_f32(in, 4) : ts_row_f32(in, 3) * r);
	f32 k = ts_max(1.0f, (ts_row_f32(in, 2) * ts_row_f32(in, 2)) * density);
	out[0] = (u32)ts_fix(0.5f * (builtin ? (f32)log2(k) : ts_log2(k)), 8, 12);
}

static void lod_reciprocal(u32 *out, const u32 *in) { lod_by(out, in, false); }
static void lod_builtin(u32 *out, const u32 *in) { lod_by(out, in, true); }

/* 2^(n / 256) by square roots, the same on every machine. */
static double power_of_two(u32 n)
{
	double r = ldexp(1, (int)(n / 256)), root = 2;
	for (u32 bit = 128; bit != 0; bit >>= 1) {
		root = sqrt(root);
		if ((n & bit) != 0) r *= root;
	}
	return r;
}

/* A level that is not 0, half-way between two of its steps as near as floats come. */
static void relate_lod(u32 *in, u32 random)
{
	if (in[4] == 0) in[4] = 0x3f800000u;
	if ((random & 3) == 0) return;
	in[0] = 1024;
	in[1] = 512;
	double k = power_of_two(2 * (random >> 8 & 4095) + 1);
	f32 area = ts_row_f32(in, 4);
	f32 uv = (f32)(k * (double)area / (1024 * 512.0));
	in[2] = 0x3f800000u;
	if (uv > 0x1p-38f && uv < 0x1p9f) in[3] = ts_f2u(uv) + (random >> 2 & 1) - (random >> 3 & 1);
}

static u32 srgb_encoded(f32 l)
{
	f32 x = l > 0 ? ts_min(l, 1) : 0;
	f32 e = x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1 / 2.4f) - 0.055f;
	return (u32)(e * 255.0f + 0.5f);
}

WORD_ITEM(srgb_builtin, srgb_encoded(A))

static const f32 wrap_edges[] = {1, 2, 3, -1, -2, -3, 0x1p-39f, -0x1p-39f, 0x1p-24f, -0x1p-24f, 0x1p24f, 8388607.5f};

#define WRAP(name, count) UNSIGNED(name, count, TS_REPEAT, TS_CLAMP)
#define CHANNELS(name, count) UNSIGNED(name, count, 0, 65535)
#define FRACTIONS(name, count) UNSIGNED(name, count, 0, 255)

/* clang-format off */
const ts_vector ts_vectors_texture[] = {
	{ PRIMITIVE(texture_wrap), "ts_k_texture_wrap", "u to [0, 1]; wrap 0 repeats, 1 mirrors, 2 clamps", { SANE("u", 1),
	    WRAP("wrap", 1) }, GIVES(F32, 1), EDGES(wrap_edges) },
	{ PRIMITIVE(texture_neighbour), "ts_k_texture_neighbour", "texel i of n, one outside at most",
	  { INTEGER("i", 1, -1, 16384), INTEGER("n", 1, 1, 16384), WRAP("wrap", 1) }, GIVES(U32, 1),
	  .relate = relate_neighbour },
	{ PRIMITIVE(texture_mix4), "ts_k_texture_mix4", "four texels by weights of 1/256 in x and y",
	  { CHANNELS("texels", 4), FRACTIONS("f", 2) }, GIVES(U32, 1) },
	{ PRIMITIVE(texture_mix2), "ts_k_texture_mix2", "two levels by a weight of 1/256",
	  { CHANNELS("texels", 2), FRACTIONS("f", 1) }, GIVES(U32, 1) },
	{ PRIMITIVE(texture_blend), "ts_k_texture_blend", "bilinear mean of four texels; f in 1/256",
	  { { "texels", TS_VECTOR_U64, 4, INT64_MIN, INT64_MAX, false }, UNSIGNED("f", 2, 0, 255) }, GIVES(U32, 4) },
	{ PRIMITIVE(texture_bilinear), "ts_k_texture_bilinear",
	  "channels of an image of 2 x 2 texels, u64 with red lowest, at uv",
	  { { "texels", TS_VECTOR_U64, 4, INT64_MIN, INT64_MAX, false }, POSITIVE("uv", 2, 88, 126), WRAP("wrap", 2) },
	  GIVES(U32, 4), { { TS_FAULT_TRUNCATE, bilinear_truncate } }, .relate = relate_bilinear },
	{ PRIMITIVE(texture_lod), "ts_k_texture_lod",
	  "level in 1/256 for a footprint in a triangle of `area` and `uv_area`",
	  { UNSIGNED("size", 2, 1, 16384), POSITIVE("footprint", 1, 107, 137), POSITIVE("uv_area", 1, 88, 137),
	    POSITIVE("area", 1, 97, 147) }, GIVES(U32, 1),
	  { { TS_FAULT_RECIPROCAL, lod_reciprocal }, { TS_FAULT_BUILTIN, lod_builtin } }, .relate = relate_lod },
	{ PRIMITIVE(srgb), "ts_srgb_byte", "8-bit sRGB value of a linear one", { ANY("l", 1) }, GIVES(U32, 1),
	  { { TS_FAULT_BUILTIN, srgb_builtin } }, EDGES(ts_srgb_threshold) },
	{ 0 },
};
/* clang-format on */

static void cube_place_reciprocal(u32 *out, const u32 *in)
{
	ts_v3 d = ts_row_v3(in, 0);
	u32 face = ts_k_cube_place(d).face;
	f32 major = ts_max(ts_max(ts_abs(d.x), ts_abs(d.y)), ts_abs(d.z));
	f32 r = 1.0f / (major > 0.0f ? major : 1.0f);
	ts_set_v2(out, ts_v2_make(ts_dot(ts_k_cube_row(face, 0), d) * r, -ts_dot(ts_k_cube_row(face, 1), d) * r));
}

/* Two or three of the same size. */
static void relate_direction(u32 *in, u32 random)
{
	u32 k = random & 3, sign = random >> 3 << 31;
	if ((random & 4) != 0) return;
	if (k < 3) in[(k + 1) % 3] = in[k] == 0 ? 0 : in[k] ^ sign;
	if (k == 3) in[1] = in[2] = in[0];
}

/* On the line between two texels, or a step beside it. */
static void relate_texel(u32 *in, u32 random)
{
	if ((random & 1) == 0) return;
	in[1] = 1u << (random >> 1 & 7);
	f32 s = (f32)(random >> 8 & (2 * in[1] - 1)) / (f32)in[1] - 1.0f;
	in[0] = s == 0 ? 0 : ts_f2u(s) + (random >> 4 & 1) - (random >> 5 & 1);
}

static const f32 texel_edges[] = {-1.0f, 1.0f, 0.5f, -0.5f};

/* clang-format off */
const ts_vector ts_vectors_cube[] = {
	{ PRIMITIVE(cube_face), "ts_k_cube_place",
	  "face 0 to 5, +X -X +Y -Y +Z -Z, of a direction; X before Y before Z where equal",
	  { SANE("d", 3) }, GIVES(U32, 1), .relate = relate_direction },
	{ PRIMITIVE(cube_place), "ts_k_cube_place", "(s, t) of a direction on its face, -1 to 1", { SANE("d", 3) },
	  GIVES(F32, 2), { { TS_FAULT_RECIPROCAL, cube_place_reciprocal } }, .relate = relate_direction },
	{ PRIMITIVE(cube_texel), "14", "min(n - 1, floor((s + 1) / 2 * n)), not below 0",
	  { { "s", TS_VECTOR_F32, 1, 88, 127, true }, UNSIGNED("n", 1, 1, 4096) }, GIVES(U32, 1),
	  EDGES(texel_edges), .relate = relate_texel },
	{ 0 },
};
/* clang-format on */
