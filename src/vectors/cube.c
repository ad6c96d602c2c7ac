/* Primitives of cube maps: places and texels (kernels/raster/cube.h). */
#include "kernels/vectors/vectors_texture.h"
#include "vectors/row.h"

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
