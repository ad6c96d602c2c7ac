/* The G-buffer of screen-space methods (SSAGH section 3; METHODS 11). Its depth is zn = 1 - near / z, with the far
 * plane at infinity, so that 1 - zn is proportional to 1 / z; thresholds and interpolation of hulls rely on that. zn is
 * 1 for the sky, and for nothing else. */
#ifndef TS_KERNELS_GBUFFER_H
#define TS_KERNELS_GBUFFER_H
#include "../base/args.h"
#include "eye_sample.h"
#include "rsm.h"

#define TS_ROWS_ts_gbuffer_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(OUT, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(VALUE, u32, samples, none) /* of a pixel */
TS_ARGS(ts_gbuffer_args);

#define TS_SKY 1.0f
#define TS_DEEPEST 0.999999940395355224609375f /* 1 - 2^-24: the last number before the sky */

/* zn of an axial depth. */
TS_FN f32 ts_k_screen_depth(f32 near, f32 z)
{
	f32 inverse = near / z;
	return ts_clamp(1.0f - inverse, 0.0f, TS_DEEPEST);
}

TS_FN void ts_k_gpixel_store(TS_GLOBAL ts_gpixel *pixel, ts_v3 p, f32 depth, ts_v3 n, ts_v3 albedo)
{
	ts_store3(pixel->position, p);
	pixel->depth = ts_put(depth);
	ts_store3(pixel->normal, n);
	ts_store3(pixel->albedo, albedo);
	pixel->pad0 = 0u;
	pixel->pad1 = 0u;
}

/* The record of pixel (x, y): the surface of the triangle that its key of eye.depth_triangle names, or the sky. */
TS_FN void ts_k_gpixel(TS_GLOBAL ts_gpixel *pixel, const ts_arrays *scene, const ts_camera_k *view, u64 key, i32 x,
                       i32 y)
{
	ts_v3 zero = ts_v3_make(0.0f, 0.0f, 0.0f);
	if (key == TS_EMPTY) {
		ts_k_gpixel_store(pixel, zero, TS_SKY, zero, zero);
		return;
	}
	ts_surface s = ts_k_surface_seen(scene, view, (u32)key, x, y);
	ts_v3 n = ts_k_facing_normal(&s, ts_sub(view->eye, s.p));
	f32 depth = ts_k_screen_depth(view->near, ts_u2f((u32)(key >> 32)));
	ts_k_gpixel_store(pixel, s.p, depth, n, ts_k_albedo(&s));
}

/* map over pixels and their samples */
TS_FN void ts_k_gbuffer_item(const ts_gbuffer_args *args, u64 i)
{
	ts_eye_place at = ts_k_eye_place(args->view, args->samples, i);
	ts_k_gpixel(&args->pixels[i], &args->scene, &at.view, args->depth_triangle[i], at.x, at.y);
}

#endif
