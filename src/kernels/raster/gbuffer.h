/* The G-buffer of screen-space methods (SSAGH section 3; METHODS 11): what the eye sees in each pixel. */
#ifndef TS_KERNELS_RASTER_GBUFFER_H
#define TS_KERNELS_RASTER_GBUFFER_H
#include "kernels/base/args.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"
#include "kernels/raster/gpixel.h"
#include "kernels/raster/patch.h"

#define TS_ROWS_ts_gbuffer_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(OUT, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(VALUE, u32, samples, none) /* of a pixel */
TS_ARGS(ts_gbuffer_args);

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
