/* Textures: bilinear filter with fixed-point weights, trilinear between two mip levels, an exact rule for the level
 * (CONTRACT rule 37). Texels are linear, 16 bits per channel, four channels in a u64, red lowest. */
#ifndef TS_KERNELS_BASE_TEXTURE_H
#define TS_KERNELS_BASE_TEXTURE_H
#include "kernels/base/scene.h"

typedef struct {
	f32 r, g, b, a;
} ts_rgba;
typedef struct {
	u32 r, g, b, a;
} ts_rgba16;

#define TS_REPEAT 0u
#define TS_MIRROR 1u
#define TS_CLAMP 2u

/* Wraps u, in units of the image's width, into [0, 1]; scaling comes later. */
TS_FN f32 ts_k_texture_wrap(f32 u, u32 wrap)
{
	if (wrap == TS_CLAMP) return ts_clamp(u, 0.0f, 1.0f);
	if (wrap == TS_REPEAT) return u - ts_floor(u);
	f32 turns = u * 0.5f;
	f32 pairs = ts_floor(turns) * 2.0f;
	f32 t = u - pairs;
	return t > 1.0f ? 2.0f - t : t;
}

/* Wraps the index of a neighbour, which may be one texel outside, by the same rule. */
TS_FN u32 ts_k_texture_neighbour(i32 i, i32 n, u32 wrap)
{
	if (wrap == TS_REPEAT) return (u32)(i < 0 ? n - 1 : i >= n ? i - n : i);
	return (u32)ts_min_i32(ts_max_i32(i, 0), n - 1);
}

TS_FN ts_rgba16 ts_k_texture_unpack(u64 t)
{
	ts_rgba16 r;
	r.r = (u32)(t & 0xffffu);
	r.g = (u32)((t >> 16) & 0xffffu);
	r.b = (u32)((t >> 32) & 0xffffu);
	r.a = (u32)(t >> 48);
	return r;
}

/* The mean of four texels. The weights sum to 65536, and 65536 * 65535 + 32768 for rounding fits 32 bits. */
TS_FN u32 ts_k_texture_mix4(u32 a, u32 b, u32 c, u32 d, u32 fx, u32 fy)
{
	u32 top = a * ((256u - fx) * (256u - fy)) + b * (fx * (256u - fy));
	u32 low = c * ((256u - fx) * fy) + d * (fx * fy);
	return (top + low + 32768u) >> 16;
}

/* The four texels around uv, as indices into a level of `width` by `height`: a b above c d. fx and fy are the weights,
 * in 1/256, of the right and the lower texels. */
typedef struct {
	u64 a, b, c, d;
	u32 fx, fy;
} ts_texels;

TS_FN ts_texels ts_k_texture_around(u32 width, u32 height, ts_v2 uv, TS_GLOBAL const u32 *wrap)
{
	/* Measure uv in 1/256 texel from the centre of the first texel, 128 from its border (CONTRACT rule 37). */
	i32 x = ts_fix(uv.x * (f32)width, 8, 30) - 128;
	i32 y = ts_fix(uv.y * (f32)height, 8, 30) - 128;
	/* Wrap the columns and the rows of the four neighbours. */
	u64 x0 = ts_k_texture_neighbour(x >> 8, (i32)width, wrap[0]);
	u64 x1 = ts_k_texture_neighbour((x >> 8) + 1, (i32)width, wrap[0]);
	u64 y0 = (u64)ts_k_texture_neighbour(y >> 8, (i32)height, wrap[1]) * width;
	u64 y1 = (u64)ts_k_texture_neighbour((y >> 8) + 1, (i32)height, wrap[1]) * width;
	ts_texels r;
	/* Name the texels; the fractions are the weights of the right and the lower ones. */
	r.a = y0 + x0;
	r.b = y0 + x1;
	r.c = y1 + x0;
	r.d = y1 + x1;
	r.fx = (u32)x & 255u;
	r.fy = (u32)y & 255u;
	return r;
}

/* The bilinear mean of the four texels that `at` names. */
TS_FN ts_rgba16 ts_k_texture_blend(const ts_texels *at, u64 texel_a, u64 texel_b, u64 texel_c, u64 texel_d)
{
	ts_rgba16 a = ts_k_texture_unpack(texel_a);
	ts_rgba16 b = ts_k_texture_unpack(texel_b);
	ts_rgba16 c = ts_k_texture_unpack(texel_c);
	ts_rgba16 d = ts_k_texture_unpack(texel_d);
	ts_rgba16 r;
	r.r = ts_k_texture_mix4(a.r, b.r, c.r, d.r, at->fx, at->fy);
	r.g = ts_k_texture_mix4(a.g, b.g, c.g, d.g, at->fx, at->fy);
	r.b = ts_k_texture_mix4(a.b, b.b, c.b, d.b, at->fx, at->fy);
	r.a = ts_k_texture_mix4(a.a, b.a, c.a, d.a, at->fx, at->fy);
	return r;
}

TS_FN ts_rgba16 ts_k_texture_bilinear(TS_GLOBAL const u64 *level, u32 width, u32 height, ts_v2 uv,
                                      TS_GLOBAL const u32 *wrap)
{
	ts_texels at = ts_k_texture_around(width, height, uv, wrap);
	return ts_k_texture_blend(&at, level[at.a], level[at.b], level[at.c], level[at.d]);
}

TS_FN u32 ts_k_texture_mix2(u32 a, u32 b, u32 f) { return (a * (256u - f) + b * f + 128u) >> 8; }

/* [0, 65535] to [0, 1], times 65537 / 2^32, which is nearly 1/65535. */
TS_FN f32 ts_k_texture_unit(u32 x) { return (f32)x * 0.00001525902189314365386962890625f; }

typedef struct {
	TS_GLOBAL const u64 *texels;
	u32 width, height;
} ts_texture_level;

TS_FN ts_texture_level ts_k_texture_finest(const ts_arrays *scene, TS_GLOBAL const ts_image *image)
{
	ts_texture_level r;
	r.texels = scene->texels + image->first_texel;
	r.width = image->width;
	r.height = image->height;
	return r;
}

TS_FN ts_texture_level ts_k_texture_coarser(ts_texture_level level)
{
	ts_texture_level r;
	r.texels = level.texels + (u64)level.width * level.height;
	r.width = level.width > 1u ? level.width >> 1 : 1u;
	r.height = level.height > 1u ? level.height >> 1 : 1u;
	return r;
}

/* The texture of a slot at uv, trilinear between two levels. lod: level in 1/256. */
TS_FN ts_rgba ts_k_texture_sample(const ts_arrays *scene, TS_GLOBAL const ts_slot *slot, ts_v2 uv, u32 lod)
{
	/* Limit the level to the coarsest, and wrap uv. */
	TS_GLOBAL const ts_image *image = &scene->images[slot->image];
	u32 last = (image->n_levels - 1u) * 256u;
	lod = lod > last ? last : lod;
	uv = ts_v2_make(ts_k_texture_wrap(uv.x, slot->wrap[0]), ts_k_texture_wrap(uv.y, slot->wrap[1]));
	/* Sample the finer of the two levels. */
	ts_texture_level level = ts_k_texture_finest(scene, image);
	for (u32 l = lod >> 8; l != 0u; l--) level = ts_k_texture_coarser(level);
	ts_rgba16 t = ts_k_texture_bilinear(level.texels, level.width, level.height, uv, slot->wrap);
	/* Mix in the coarser level by the fraction of the lod. */
	u32 f = lod & 255u;
	if (f != 0u) {
		level = ts_k_texture_coarser(level);
		ts_rgba16 next = ts_k_texture_bilinear(level.texels, level.width, level.height, uv, slot->wrap);
		t.r = ts_k_texture_mix2(t.r, next.r, f);
		t.g = ts_k_texture_mix2(t.g, next.g, f);
		t.b = ts_k_texture_mix2(t.b, next.b, f);
		t.a = ts_k_texture_mix2(t.a, next.a, f);
	}
	ts_rgba r;
	/* Turn 16 bits into [0, 1]. */
	r.r = ts_k_texture_unit(t.r);
	r.g = ts_k_texture_unit(t.g);
	r.b = ts_k_texture_unit(t.b);
	r.a = ts_k_texture_unit(t.a);
	return r;
}

/* The level of detail in 1/256 of a level: half the log2 of K, the number of texels that a square of `footprint` world
 * units a side covers, K = footprint^2 W H A_uv / A_ws. A sample has one level, in all directions. area is |(b-a) x
 * (c-a)|, uv_area that of its image in uv. */
TS_FN u32 ts_k_texture_lod(u32 width, u32 height, f32 footprint, f32 uv_area, f32 area)
{
	f32 texels = (f32)width * (f32)height;
	f32 density = texels * (uv_area / area);
	f32 k = (footprint * footprint) * density;
	f32 level = 0.5f * ts_log2(ts_max(1.0f, k));
	return (u32)ts_fix(level, 8, 12);
}

#endif
