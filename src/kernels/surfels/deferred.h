/* Deferred shaders over a G-buffer (NV40: Phong Shading, NV40: NPR Shading; METHODS 16): a pixel is shaded once,
 * however many surfels overlap there. Phong is ambient light, Lambert's cosine and a highlight (r.v)^32. NPR paints in
 * three tones without a highlight, and draws a black outline where the surface ends in front of a farther surface or
 * the sky. */
#ifndef TS_KERNELS_SURFELS_DEFERRED_H
#define TS_KERNELS_SURFELS_DEFERRED_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/base/srgb.h"
#include "kernels/raster/gpixel.h"
#include "kernels/raster/shadow_map.h"

#define TS_HIGHLIGHT 0.25f /* relative to the radiance of a diffuse white surface */
#define TS_TONES 3.0f
#define TS_OUTLINE_STEP 0.03125f   /* relative to the depth */
#define TS_OUTLINE_DROP 0.0078125f /* below the surface's plane, relative to the distance to the eye */

#define TS_ROWS_ts_deferred_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, ts_light, lights, lamp_light) \
	ARG(IN, ts_lamp, lamps, lamp_shape) \
	ARG(IN_OPT, u32, lit, shadow_test_lit) /* NULL: there are no shadows */ \
	ARG(OUT, f32, radiance, image_radiance) \
	ARG(OUT, u8, srgb, image_srgb) \
	ARG(TALLY, i64, tally, 0) /* [0] shading operations: pixels with a surface */ \
	ARG(VALUE, u32, n_lights, none) \
	ARG(VALUE, u32, npr, none) /* not 0: tones and outlines, not Phong's shading */ \
	ARG(VALUE, f32, ambient, none) \
	ARG(VALUE, f32, exposure, none)
TS_ARGS(ts_deferred_args);

/* The cosine, rounded up to the next of TS_TONES equal tones; at a bound, to the brighter one. */
TS_FN f32 ts_k_tone(f32 cosine) { return ts_min(ts_floor(cosine * TS_TONES + 1.0f), TS_TONES) / TS_TONES; }

/* The highlight (r.v)^32 (Phong 1975), r the reflected direction of the light, by five squarings. */
TS_FN f32 ts_k_highlight(ts_v3 n, ts_v3 v, ts_v3 l)
{
	f32 x = ts_max(ts_dot(ts_reflect(ts_neg(l), n), v), 0.0f);
	for (u32 k = 0u; k < 5u; k++) x = ts_flush(x * x);
	return TS_HIGHLIGHT * x;
}

/* The radiance that a share of one light adds, by Lambert's law and the highlight. */
TS_FN ts_v3 ts_k_shade_by(TS_GLOBAL const ts_light *light, f32 share, u32 npr, ts_v3 p, ts_v3 n, ts_v3 v, ts_v3 albedo)
{
	ts_v3 l;
	f32 arrives = ts_k_light(light, p, &l) * share;
	f32 cosine = ts_flush(ts_dot(n, l));
	if (!(cosine > 0.0f) || !(arrives > 0.0f)) return ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_v3 paint = ts_scale(albedo, npr != 0u ? ts_k_tone(cosine) : cosine);
	f32 shine = npr != 0u ? 0.0f : ts_k_highlight(n, v, l);
	ts_v3 all = ts_add(paint, ts_v3_make(shine, shine, shine));
	return ts_mul(all, ts_scale(ts_load3(light->intensity), arrives * TS_PER_PI));
}

/* The radiance that light k adds at a pixel. */
TS_FN ts_v3 ts_k_deferred_light(const ts_deferred_args *args, u64 i, u32 k, ts_v3 p, ts_v3 n, ts_v3 v, ts_v3 albedo)
{
	TS_GLOBAL const u32 *lit = args->lit != NULL ? args->lit + i * args->n_lights : NULL;
	return ts_k_shade_by(&args->lights[k], ts_k_share(lit, args->lamps, k), args->npr, p, n, v, albedo);
}

/* A pixel and a neighbour: how much farther the neighbour is (1 - zn is proportional to 1 / z); how far it lies below
 * the plane of the surface, which is 0 on a floor however steep the view; and the bounds that both must pass for the
 * surface to end there. */
typedef struct {
	f32 farther, step, below, drop;
	i32 x, y;
	bool is, sky;
} ts_border;

/* The border to neighbour k: 0 left, 1 right, 2 above, 3 below. */
TS_FN ts_border ts_k_border(const ts_deferred_args *args, u64 i, u32 k)
{
	/* Find the neighbour; beyond the image there is none, and the pixel stands in for it. */
	ts_border r;
	r.x = (i32)(i % (u64)args->view->width) + (k == 0u ? -1 : k == 1u ? 1 : 0);
	r.y = (i32)(i / (u64)args->view->width) + (k == 2u ? -1 : k == 3u ? 1 : 0);
	r.is = r.x >= 0 && r.y >= 0 && r.x < (i32)args->view->width && r.y < (i32)args->view->height;
	TS_GLOBAL const ts_gpixel *at = &args->pixels[i];
	TS_GLOBAL const ts_gpixel *next = r.is ? &args->pixels[(u64)r.y * (u64)args->view->width + (u64)r.x] : at;
	/* Compare 1 - zn, which is proportional to 1 / z, so that the step is relative to the depth. */
	f32 near = 1.0f - at->depth;
	f32 far = 1.0f - next->depth;
	r.farther = near - far;
	r.step = TS_OUTLINE_STEP * near;
	/* Find how far the neighbour lies below the tangent plane: a floor that continues has no outline, however steep the
	 * view. */
	r.below = ts_dot(ts_load3(at->normal), ts_sub(ts_load3(at->position), ts_load3(next->position)));
	r.drop = TS_OUTLINE_DROP * ts_length(ts_sub(ts_load3(args->view->eye), ts_load3(at->position)));
	r.sky = next->depth == TS_SKY;
	return r;
}

/* Whether the surface ends before the neighbour. */
TS_FN bool ts_k_ends(const ts_border *next)
{
	return next->is && next->farther > next->step && (next->sky || next->below > next->drop);
}

TS_FN bool ts_k_is_outline(const ts_deferred_args *args, u64 i)
{
	for (u32 k = 0u; k < 4u; k++) {
		ts_border next = ts_k_border(args, i, k);
		if (ts_k_ends(&next)) return true;
	}
	return false;
}

TS_FN ts_v3 ts_k_deferred(const ts_deferred_args *args, u64 i)
{
	/* Show the background where no surfel is. */
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	if (pixel->depth == TS_SKY) return ts_k_background();
	/* Read the blended attributes, which are shaded once per pixel (NV40: Deferred Shading). */
	ts_v3 p = ts_load3(pixel->position);
	ts_v3 n = ts_load3(pixel->normal);
	ts_v3 albedo = ts_load3(pixel->albedo);
	ts_v3 v = ts_normalize(ts_sub(ts_load3(args->view->eye), p));
	/* Draw outlines in black (NV40: NPR Shading). */
	if (args->npr != 0u && ts_k_is_outline(args, i)) return ts_v3_make(0.0f, 0.0f, 0.0f);
	/* Add ambient light, then the lights in order (NV40: Phong Shading). */
	ts_v3 sum = ts_scale(albedo, args->ambient);
	for (u32 k = 0u; k < args->n_lights; k++) sum = ts_add(sum, ts_k_deferred_light(args, i, k, p, n, v, albedo));
	return sum;
}

/* map over pixels */
TS_FN void ts_k_deferred_item(const ts_deferred_args *args, u64 i)
{
	if (args->pixels[i].depth != TS_SKY) ts_add_i64(&args->tally[0], 1);
	ts_k_show(args->radiance + i * 3u, args->srgb + i * 3u, ts_k_deferred(args, i), args->exposure);
}

#define TS_ROWS_ts_deferred_lit_args(ARG) \
	ARG(INNER, ts_shadow_test_args, of, none) /* without the eye's triangles; cubes are those of point lights */ \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, ts_light, lights, lamp_light) /* each with a view in order, or the six of a cube */
TS_ARGS(ts_deferred_lit_args);

TS_FN ts_receiver ts_k_deferred_receiver(TS_GLOBAL const ts_gpixel *pixel)
{
	ts_receiver r;
	r.p = ts_load3(pixel->position);
	r.n = ts_load3(pixel->normal);
	r.seen = pixel->depth != TS_SKY;
	return r;
}

/* map over pixels: the lights that reach the surface there */
TS_FN void ts_k_deferred_lit_item(const ts_deferred_lit_args *args, u64 i)
{
	u32 v = 0u;
	ts_shadow_test_args of = args->of;
	ts_receiver at = ts_k_deferred_receiver(&args->pixels[i]);
	for (u32 k = 0u; k < of.n_lamps; k++) {
		of.cubes = ts_k_has_cube(&args->lights[k]) ? 1u : 0u;
		TS_GLOBAL const ts_offscreen *view = ts_k_asked_view(&of, v, &at);
		bool reaches = at.seen && ts_k_reaches(&of, view, &at, of.views[0].offset);
		of.lit[i * of.n_lamps + k] = reaches ? 1u : 0u;
		v += of.cubes != 0u ? 6u : 1u;
	}
}

#endif
