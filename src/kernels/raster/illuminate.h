/* MVR: deferred shading of every texel of the cube faces, and their mip chain (METHODS 3). */
#ifndef TS_KERNELS_RASTER_ILLUMINATE_H
#define TS_KERNELS_RASTER_ILLUMINATE_H
#include "kernels/base/shade.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/texel_place.h"

/* Radiance of a triangle that the centre of a cube sees through a texel. */
TS_FN ts_v3 ts_k_texel_radiance(const ts_illuminate_args *args, const ts_texel_place *place, u32 triangle)
{
	ts_camera_k view = ts_k_cube_view(&args->cubes[place->cube], place->face);
	ts_surface s = ts_k_surface_seen(&args->scene, &view, triangle, (i32)place->x, (i32)place->y);
	return ts_k_shade(&args->scene, &s, ts_normalize(ts_sub(view.eye, s.p)));
}

/* map over texels of the batch */
TS_FN void ts_k_illuminate_item(const ts_illuminate_args *args, u64 i)
{
	ts_texel_place place = ts_k_texel_place(args, i);
	u64 key = args->depth_triangle[i];
	ts_v3 radiance = key != TS_EMPTY ? ts_k_texel_radiance(args, &place, (u32)key) : ts_k_background();
	TS_GLOBAL f32 *out = args->mip + (ts_k_mip_first(args->cubes, args->first_cube, place.cube) + place.inside) * 4u;
	ts_store3(out, radiance);
	out[3] = 1.0f;
}

/* map over texels of one level of one cube, the first of the batch: ((a + b) + (c + d)) / 4, indices clamped */
TS_FN void ts_k_mip_item(const ts_illuminate_args *args, u64 i)
{
	/* Find the face, row and column of the texel. */
	u32 n = args->cubes[args->first_cube].n;
	u32 above = ts_k_mip_size(n, args->level - 1u);
	u32 size = ts_k_mip_size(n, args->level);
	u64 face = i / ((u64)size * size);
	u32 y = (u32)(i / size) % size;
	u32 x = (u32)(i % size);
	/* Find the face in the finer level, and the texel in this one. */
	TS_GLOBAL const f32 *from = args->mip + (ts_k_mip_texels(n, args->level - 1u) + face * above * above) * 4u;
	TS_GLOBAL f32 *out = args->mip + (ts_k_mip_texels(n, args->level) + i) * 4u;
	/* Choose the four finer texels, within the level. */
	u64 x0 = 2u * x;
	u64 x1 = x0 + 1u < above ? x0 + 1u : above - 1u;
	u64 y0 = 2u * y;
	u64 y1 = y0 + 1u < above ? y0 + 1u : above - 1u;
	for (u32 channel = 0u; channel < 4u; channel++) {
		/* Average the four, a b above c d, in pairs (CONTRACT rule 39). */
		f32 a = from[(y0 * above + x0) * 4u + channel];
		f32 b = from[(y0 * above + x1) * 4u + channel];
		f32 c = from[(y1 * above + x0) * 4u + channel];
		f32 d = from[(y1 * above + x1) * 4u + channel];
		f32 top = a + b;
		f32 low = c + d;
		out[channel] = ts_put((top + low) * 0.25f);
	}
}

#endif
