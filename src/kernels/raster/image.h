/* The picture: mirrors show their reflection, everything else is shaded where the eye sees it, in what light reaches
 * it. */
#ifndef TS_KERNELS_IMAGE_H
#define TS_KERNELS_IMAGE_H
#include "../base/args.h"
#include "draw.h"
#include "../base/shade.h"
#include "../base/srgb.h"

#define TS_ROWS_ts_image_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(IN_OPT, u32, offset, mirror_pixel_offset) /* NULL: there are no mirrors */ \
	ARG(IN_OPT, f32, reflected, shade_radiance) \
	ARG(IN_OPT, u32, lit, shadow_test_lit) /* NULL: there are no shadows */ \
	ARG(IN_OPT, ts_lamp, lamps, lamp_shape) \
	ARG(OUT, f32, radiance, image_radiance) \
	ARG(OUT, u8, srgb, image_srgb) \
	ARG(VALUE, f32, exposure, none)
TS_ARGS(ts_image_args);

TS_FN ts_v3 ts_k_eye_radiance(const ts_image_args *args, u64 i)
{
	u64 key = args->depth_triangle[i];
	if (key == TS_EMPTY) return ts_k_background();
	ts_camera_k view = ts_k_view(args->view);
	i32 x = (i32)(i % (u64)view.width);
	i32 y = (i32)(i / (u64)view.width);
	ts_surface s = ts_k_surface_seen(&args->scene, &view, (u32)key, x, y);
	TS_GLOBAL const u32 *lit = args->lit != NULL ? args->lit + i * args->scene.n_lights : NULL;
	return ts_k_shade_lit(&args->scene, &s, ts_normalize(ts_sub(view.eye, s.p)), lit, args->lamps);
}

/* Three channels as they are, and as a display shows them. */
TS_FN void ts_k_show(TS_GLOBAL f32 *radiance, TS_GLOBAL u8 *srgb, ts_v3 value, f32 exposure)
{
	ts_store3(radiance, value);
	for (u32 channel = 0u; channel < 3u; channel++) {
		srgb[channel] = (u8)ts_srgb_byte(radiance[channel] * exposure);
	}
}

/* map over pixels */
TS_FN void ts_k_image_item(const ts_image_args *args, u64 i)
{
	bool mirror = args->offset != NULL && args->offset[i + 1u] != args->offset[i];
	ts_v3 radiance = mirror ? ts_load3(args->reflected + (u64)args->offset[i] * 3u) : ts_k_eye_radiance(args, i);
	ts_k_show(args->radiance + i * 3u, args->srgb + i * 3u, radiance, args->exposure);
}

#endif
