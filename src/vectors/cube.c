/* Primitives of cube maps and of what is written to them: places, texels, keys (kernels/raster/cube.h, CONTRACT rule
 * 24). */
#include "../kernels/vectors/vectors_texture.h"
#include "row.h"

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

static f32 depth_of_24_bits(f32 depth) { return (f32)(rint(fmin((double)depth, 1) * 16777215) / 16777215); }

WIDE_ITEM(key_depth24, ts_k_vector_packed(depth_of_24_bits(A), in[1]))

/* Of each only the 24 bits of depth below sign and the highest of the exponent count. */
static void key_min_depth24(u32 *out, const u32 *in)
{
	u64 a = ts_row_u64(in, 0), b = ts_row_u64(in, 2);
	u32 da = (u32)(a >> 38), db = (u32)(b >> 38);
	ts_set_u64(out, 0, db < da || (db == da && (u32)b < (u32)a) ? b : a);
}

static void key_min_narrow(u32 *out, const u32 *in)
{
	u64 a = ts_row_u64(in, 0), b = ts_row_u64(in, 2);
	ts_set_u64(out, 0, (b >> 32) < (a >> 32) ? b : a);
}

/* Equal depths, or depths a step apart. */
static void relate_keys(u32 *in, u32 random)
{
	in[1] &= 0x7fffffffu;
	in[3] &= 0x7fffffffu;
	if ((random & 3) == 0) in[3] = in[1];
	if ((random & 3) == 1) in[3] = in[1] ^ 1;
}

static const f32 texel_edges[] = {-1.0f, 1.0f, 0.5f, -0.5f};
static const f32 depth_edges[] = {0x1p-100f, 1.0f, 0.5f, 0.25f};

/* clang-format off */
#define WIDE(name) { name, TS_VECTOR_U64, 1, INT64_MIN, INT64_MAX, false }
/* clang-format on */

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
	{ PRIMITIVE(key), "12, 24", "bits of put(depth) << 32 | payload", { POSITIVE("depth", 1, 0, 254),
	    UNSIGNED("payload", 1, 0, UINT32_MAX - 1) }, GIVES(U64, 1),
	  { { TS_FAULT_DEPTH24, key_depth24 } }, EDGES(depth_edges) },
	{ PRIMITIVE(key_min), "24, 25", "the smaller of two keys", { WIDE("a"), WIDE("b") }, GIVES(U64, 1),
	  { { TS_FAULT_DEPTH24, key_min_depth24 }, { TS_FAULT_NARROW, key_min_narrow } }, .relate = relate_keys },
	{ PRIMITIVE(point_key), "ts_k_points_item", "triangle << 32 | (y + 2^15) << 16 | x + 2^15",
	  { ALL_U32("triangle", 1), INTEGER("x", 1, -32768, 32767), INTEGER("y", 1, -32768, 32767) },
	  GIVES(U64, 1) },
	{ 0 },
};
/* clang-format on */
