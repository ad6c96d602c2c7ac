/* MVR: reflective pixels look up the mip-mapped cube faces (METHODS 3). */
#ifndef TS_KERNELS_POINTS_MIRROR_H
#define TS_KERNELS_POINTS_MIRROR_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/points/samples.h"
#include "kernels/raster/cube.h"
#include "kernels/raster/mip.h"

#define TS_ROWS_ts_mirror_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(IN, ts_pixel, pixels, mirror_pixel_record) \
	ARG(IN, f32, mip, cube_face_mip) /* of the batch */ \
	ARG(SUM, f32, radiance, shade_radiance) \
	ARG(VALUE, u32, first_cube, none) \
	ARG(VALUE, u32, n_cubes, none)     /* the batch */ \
	ARG(VALUE, u32, supersample, none) /* 25 nearest look-ups in level 0, as EPR does */
TS_ARGS(ts_mirror_args);

/* One cube's chain. */
typedef struct {
	TS_GLOBAL const f32 *texels;
	u32 n;
} ts_mip_cube;

TS_FN ts_v3 ts_k_mip_texel(const ts_mip_cube *cube, u32 level, u64 index)
{
	return ts_load3(cube->texels + (ts_k_mip_texels(cube->n, level) + index) * 4u);
}

/* The value of texel (i, j) of a face; outside the face, of the texel into which its extended position falls. */
TS_FN ts_v3 ts_k_mip_tap(const ts_mip_cube *cube, u32 level, u32 face, i32 i, i32 j)
{
	i32 n = (i32)ts_k_mip_size(cube->n, level);
	if (i >= 0 && j >= 0 && i < n && j < n) {
		return ts_k_mip_texel(cube, level, ((u64)face * (u64)n + (u64)j) * (u64)n + (u64)i);
	}
	f32 s = (f32)(2 * i + 1) / (f32)n - 1.0f;
	f32 t = (f32)(2 * j + 1) / (f32)n - 1.0f;
	ts_cube_place place = ts_k_cube_place(ts_k_cube_direction(face, s, t));
	return ts_k_mip_texel(cube, level, ts_k_cube_index(place, (u32)n));
}

/* a + (b - a) f (CONTRACT rule 39). */
TS_FN ts_v3 ts_k_lerp(ts_v3 a, ts_v3 b, f32 f) { return ts_mad(a, ts_sub(b, a), f); }

/* The bilinear mean of four texels of a level; x and y are texels from the centre of the first, hence the - 1/2. */
TS_FN ts_v3 ts_k_mip_bilinear(const ts_mip_cube *cube, u32 level, ts_cube_place place)
{
	f32 n = (f32)ts_k_mip_size(cube->n, level);
	f32 x = ((place.s + 1.0f) * 0.5f) * n - 0.5f;
	f32 y = ((place.t + 1.0f) * 0.5f) * n - 0.5f;
	f32 fx = x - ts_floor(x);
	f32 fy = y - ts_floor(y);
	i32 i = ts_floor_i32(x);
	i32 j = ts_floor_i32(y);
	ts_v3 top =
		ts_k_lerp(ts_k_mip_tap(cube, level, place.face, i, j), ts_k_mip_tap(cube, level, place.face, i + 1, j), fx);
	ts_v3 low = ts_k_lerp(ts_k_mip_tap(cube, level, place.face, i, j + 1),
	                      ts_k_mip_tap(cube, level, place.face, i + 1, j + 1), fx);
	return ts_k_lerp(top, low, fy);
}

/* The reflected direction at (x, y) pixels from the pixel's centre. */
TS_FN ts_v3 ts_k_mirror_direction(TS_GLOBAL const ts_pixel *pixel, ts_v3 eye, f32 x, f32 y)
{
	return ts_k_offset_ray(pixel, eye, ts_v2_make(x, y)).direction;
}

/* The mip level log2(n/2 max(|dr/dx|, |dr/dy|)): texels that the reflected direction r crosses from half a pixel on one
 * side to half a pixel on the other; a face of n texels spans 2 (Williams, Pyramidal Parametrics, 1983). */
TS_FN f32 ts_k_mirror_level(TS_GLOBAL const ts_pixel *pixel, ts_v3 eye, u32 n)
{
	ts_v3 dx = ts_sub(ts_k_mirror_direction(pixel, eye, 0.5f, 0.0f), ts_k_mirror_direction(pixel, eye, -0.5f, 0.0f));
	ts_v3 dy = ts_sub(ts_k_mirror_direction(pixel, eye, 0.0f, 0.5f), ts_k_mirror_direction(pixel, eye, 0.0f, -0.5f));
	f32 change = ts_max(ts_length(dx), ts_length(dy));
	f32 texels = ((f32)n * 0.5f) * change;
	f32 level = ts_log2(ts_max(1.0f, texels));
	return ts_min(level, (f32)(ts_k_mip_levels(n) - 1u));
}

TS_FN ts_v3 ts_k_mirror_trilinear(const ts_mip_cube *cube, TS_GLOBAL const ts_pixel *pixel, ts_v3 eye)
{
	f32 level = ts_k_mirror_level(pixel, eye, cube->n);
	u32 low = (u32)ts_floor_i32(level);
	f32 f = level - (f32)low;
	ts_cube_place place = ts_k_cube_place(ts_k_mirror_direction(pixel, eye, 0.0f, 0.0f));
	ts_v3 sharp = ts_k_mip_bilinear(cube, low, place);
	if (!(f > 0.0f)) return sharp;
	return ts_k_lerp(sharp, ts_k_mip_bilinear(cube, low + 1u, place), f);
}

/* The mean of the 25 samples' nearest texels, as EPR filters (EPR 4.1.3). */
TS_FN ts_v3 ts_k_mirror_supersample(const ts_mip_cube *cube, TS_GLOBAL const ts_pixel *pixel, ts_v3 eye)
{
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	for (u32 k = 0u; k < TS_N_SAMPLES; k++) {
		ts_cube_place place = ts_k_cube_place(ts_k_sample_ray(pixel, eye, k).direction);
		sum = ts_add(sum, ts_k_mip_texel(cube, 0u, ts_k_cube_index(place, cube->n)));
	}
	f32 count = (f32)TS_N_SAMPLES;
	return ts_v3_make(sum.x / count, sum.y / count, sum.z / count);
}

/* map over reflective pixels; those whose cube is in the batch look it up */
TS_FN void ts_k_mirror_item(const ts_mirror_args *args, u64 i)
{
	/* Leave out pixels whose cube is in another batch. */
	TS_GLOBAL const ts_pixel *pixel = &args->pixels[i];
	u32 r = pixel->reflector;
	if (r < args->first_cube || r >= args->first_cube + args->n_cubes) return;
	/* Find the cube's texels. */
	ts_mip_cube cube;
	cube.texels = args->mip + ts_k_mip_first(args->cubes, args->first_cube, r) * 4u;
	cube.n = args->cubes[r].n;
	/* Look the reflection up; a mirror without a cube shows the background. */
	ts_v3 radiance = ts_k_background();
	ts_v3 eye = ts_load3(args->view->eye);
	if (cube.n != 0u) {
		radiance = args->supersample != 0u ? ts_k_mirror_supersample(&cube, pixel, eye)
		                                   : ts_k_mirror_trilinear(&cube, pixel, eye);
	}
	ts_store3(args->radiance + i * 3u, ts_mul(radiance, ts_v3_make(pixel->tint_r, pixel->tint_g, pixel->tint_b)));
}

#endif
