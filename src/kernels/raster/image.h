/* The picture: mirrors show their reflection; every other surface that the eye sees is shaded by the light that reaches
 * it. */
#ifndef TS_KERNELS_RASTER_IMAGE_H
#define TS_KERNELS_RASTER_IMAGE_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/base/srgb.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"

#define TS_ROWS_ts_image_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(IN_OPT, u32, offset, mirror_pixel_offset) /* NULL: there are no mirrors */ \
	ARG(IN_OPT, f32, reflected, shade_radiance) \
	ARG(IN_OPT, u32, lit, shadow_test_lit) /* NULL: there are no shadows */ \
	ARG(IN_OPT, ts_lamp, lamps, lamp_shape) \
	ARG(OUT, f32, radiance, image_radiance) \
	ARG(OUT_OPT, u8, srgb, image_srgb) /* NULL: for samples, which have no display value */ \
	ARG(VALUE, f32, exposure, none) \
	ARG(VALUE, u32, samples, none) /* of a pixel */
TS_ARGS(ts_image_args);

TS_FN ts_v3 ts_k_eye_radiance(const ts_image_args *args, u64 i)
{
	u64 key = args->depth_triangle[i];
	if (key == TS_EMPTY) return ts_k_background();
	ts_eye_place at = ts_k_eye_place(args->view, args->samples, i);
	ts_surface s = ts_k_surface_seen(&args->scene, &at.view, (u32)key, at.x, at.y);
	TS_GLOBAL const u32 *lit = args->lit != NULL ? args->lit + i * args->scene.n_lights : NULL;
	return ts_k_shade_lit(&args->scene, &s, ts_normalize(ts_sub(at.view.eye, s.p)), lit, args->lamps);
}

/* map over pixels and their samples */
TS_FN void ts_k_image_item(const ts_image_args *args, u64 i)
{
	bool mirror = args->offset != NULL && args->offset[i + 1u] != args->offset[i];
	ts_v3 radiance = mirror ? ts_load3(args->reflected + (u64)args->offset[i] * 3u) : ts_k_eye_radiance(args, i);
	TS_GLOBAL u8 *srgb = args->srgb != NULL ? args->srgb + i * 3u : NULL;
	ts_k_show(args->radiance + i * 3u, srgb, radiance, args->exposure);
}

#define TS_ROWS_ts_resolve_args(ARG) \
	ARG(IN, f32, samples, image_sample_radiance) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(OUT, f32, radiance, image_radiance) \
	ARG(OUT, u8, srgb, image_srgb) \
	ARG(VALUE, u64, n_pixels, none) \
	ARG(VALUE, f32, exposure, none) \
	ARG(VALUE, f32, gain, none) /* factor of display values, except the sky's */
TS_ARGS(ts_resolve_args);

/* map over pixels: the mean of the samples, in linear light and in order, and its display value */
TS_FN void ts_k_image_resolve_item(const ts_resolve_args *args, u64 i)
{
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_v3 shown = sum;
	for (u32 sample = 0u; sample < TS_N_EYE_SAMPLES; sample++) {
		u64 at = (u64)sample * args->n_pixels + i;
		ts_v3 radiance = ts_load3(args->samples + at * 3u);
		sum = ts_add(sum, radiance);
		shown = ts_mad(shown, radiance, args->depth_triangle[at] == TS_EMPTY ? 1.0f : args->gain);
	}
	ts_store3(args->radiance + i * 3u, ts_scale(sum, 0.25f));
	ts_k_display(args->srgb + i * 3u, ts_scale(shown, 0.25f), args->exposure);
}

#endif
