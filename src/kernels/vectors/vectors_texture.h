/* Primitives of cube maps (cube.h), and of textures and display values (texture.h, srgb.h). */
#ifndef TS_KERNELS_VECTORS_VECTORS_TEXTURE_H
#define TS_KERNELS_VECTORS_VECTORS_TEXTURE_H
#include "kernels/base/srgb.h"
#include "kernels/base/texture.h"
#include "kernels/raster/cube.h"
#include "kernels/vectors/vectors_row.h"

TS_VECTOR_WORD(cube_face, ts_k_cube_place(ts_row_v3(in, 0u)).face)

TS_VECTOR(cube_place)
{
	ts_cube_place place = ts_k_cube_place(ts_row_v3(in, 0u));
	ts_set_v2(out, ts_v2_make(place.s, place.t));
}

TS_VECTOR_WORD(cube_texel, ts_k_cube_texel(TS_A, in[1]))

TS_VECTOR_FLOAT(texture_wrap, ts_k_texture_wrap(TS_A, in[1]))
TS_VECTOR_WORD(texture_neighbour, ts_k_texture_neighbour(ts_row_i32(in, 0u), ts_row_i32(in, 1u), in[2]))
TS_VECTOR_WORD(texture_mix4, ts_k_texture_mix4(in[0], in[1], in[2], in[3], in[4], in[5]))
TS_VECTOR_WORD(texture_mix2, ts_k_texture_mix2(in[0], in[1], in[2]))

TS_FN void ts_put_texel(TS_GLOBAL u32 *out, ts_rgba16 t)
{
	out[0] = t.r;
	out[1] = t.g;
	out[2] = t.b;
	out[3] = t.a;
}

TS_VECTOR(texture_blend)
{
	ts_texels at;
	at.a = at.b = at.c = at.d = 0UL;
	at.fx = in[8];
	at.fy = in[9];
	ts_rgba16 t =
		ts_k_texture_blend(&at, ts_row_u64(in, 0u), ts_row_u64(in, 2u), ts_row_u64(in, 4u), ts_row_u64(in, 6u));
	ts_put_texel(out, t);
}

TS_FN u64 ts_row_texel(TS_GLOBAL const u32 *in, u64 at) { return ts_row_u64(in, 2u * (u32)at); }

TS_FN void ts_k_vector_sample(TS_GLOBAL u32 *out, TS_GLOBAL const u32 *in, ts_v2 uv)
{
	ts_texels at = ts_k_texture_around(2u, 2u, uv, in + 10);
	ts_rgba16 t = ts_k_texture_blend(&at, ts_row_texel(in, at.a), ts_row_texel(in, at.b), ts_row_texel(in, at.c),
	                                 ts_row_texel(in, at.d));
	ts_put_texel(out, t);
}
TS_VECTOR(texture_bilinear) { ts_k_vector_sample(out, in, ts_row_v2(in, 8u)); }

TS_VECTOR_WORD(texture_lod, ts_k_texture_lod(in[0], in[1], ts_row_f32(in, 2u), ts_row_f32(in, 3u), ts_row_f32(in, 4u)))

TS_VECTOR_WORD(srgb, ts_srgb_byte(TS_A))

#endif
