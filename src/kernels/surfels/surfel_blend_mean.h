/* Normalization (NV40: 3-Pass Deferred Shading; METHODS 16): the blended sums divided by the sum of weights, as the
 * G-buffer that meshes have too, so that any deferred shader can shade it, once per pixel. Where normals cancel, the
 * normal is that of the heaviest fragment; where no surfel's ellipse is met, the depth is that of the heaviest
 * fragment. */
#ifndef TS_KERNELS_SURFELS_SURFEL_BLEND_MEAN_H
#define TS_KERNELS_SURFELS_SURFEL_BLEND_MEAN_H
#include "kernels/base/args.h"
#include "kernels/raster/gpixel.h"
#include "kernels/surfels/surfel_blend.h"

#define TS_LEAST_NORMAL TS_LEAST_SLANT /* length of the mean of unit normals */

#define TS_ROWS_ts_surfel_blend_mean_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_disc, discs, surfel_setup_disc) \
	ARG(IN, f32, epsilon, surfel_setup_epsilon) \
	ARG(IN, u64, keys, surfel_depth_surfel) \
	ARG(IN, i64, sums, surfel_blend_sum) \
	ARG(IN, u64, heaviest, surfel_blend_heaviest) \
	ARG(OUT, ts_gpixel, pixels, gbuffer_pixel)
TS_ARGS(ts_surfel_blend_mean_args);

/* Axial depth of the nearest surfel at a pixel. */
TS_FN f32 ts_k_pixel_depth(const ts_surfel_blend_mean_args *args, const ts_camera_k *view, u64 i, i32 x, i32 y)
{
	u64 key = args->keys[i];
	if (key == TS_EMPTY) return args->discs[(u32)args->heaviest[i]].depth;
	f32 shift = ts_k_pixel_shift(view, args->epsilon[0], x, y);
	return ts_max(ts_u2f((u32)(key >> 32)) - shift, view->near);
}

TS_FN ts_v3 ts_k_mean(TS_GLOBAL const i64 *sums, f32 weight)
{
	return ts_v3_make((f32)sums[0] / weight, (f32)sums[1] / weight, (f32)sums[2] / weight);
}

/* map over pixels */
TS_FN void ts_k_surfel_blend_mean_item(const ts_surfel_blend_mean_args *args, u64 i)
{
	/* Find the pixel and its sums. */
	ts_camera_k view = ts_k_view(args->view);
	i32 x = (i32)(i % (u64)view.width);
	i32 y = (i32)(i / (u64)view.width);
	TS_GLOBAL const i64 *sums = args->sums + i * TS_BLEND_SUMS;
	TS_GLOBAL ts_gpixel *pixel = &args->pixels[i];
	ts_v3 zero = ts_v3_make(0.0f, 0.0f, 0.0f);
	/* Store the sky where there is no fragment, or all weights were rounded to 0. */
	if (args->heaviest[i] == TS_EMPTY || sums[TS_BLEND_WEIGHT] <= 0) {
		ts_k_gpixel_store(pixel, zero, TS_SKY, zero, zero);
		return;
	}
	/* Divide by the sum of weights (NV40: 3-Pass Deferred Shading). */
	f32 weight = (f32)sums[TS_BLEND_WEIGHT];
	ts_v3 albedo = ts_k_mean(sums, weight);
	ts_v3 n = ts_k_mean(sums + 3, weight);
	/* Take the heaviest fragment's normal where normals cancel: a mean shorter than 1e-6 has no direction. */
	if (ts_length(n) < TS_LEAST_NORMAL) n = ts_load3(args->discs[(u32)args->heaviest[i]].normal);
	/* Place the position on the pixel's ray, at the depth of the nearest surfel. */
	f32 z = ts_k_pixel_depth(args, &view, i, x, y);
	ts_v2 way = ts_k_pixel_way(&view, x, y);
	ts_v3 across = ts_mad(ts_scale(view.right, way.x), view.up, way.y);
	ts_v3 p = ts_mad(view.eye, ts_sub(across, view.back), z);
	ts_k_gpixel_store(pixel, p, ts_k_screen_depth(view.near, z), ts_normalize(n), albedo);
}

#endif
