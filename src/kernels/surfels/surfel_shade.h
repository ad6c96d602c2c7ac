/* Shading before blending (NV40: 3-Pass Shading, Per-Pixel Phong Shading; METHODS 16): the second pass blends shaded
 * colours in place of attributes.
 *
 *     flat     a surfel is shaded once, at its centre; where an ellipse covers a pixel only the nearest surfel counts
 *     gouraud  a surfel is shaded once, at its centre
 *     phong    a surfel is shaded once per fragment, where the ray meets its plane, by its linear field of normals
 *
 * Colours are those of a frame buffer: exposed, and clamped to [0,1]. There are no shadows and no outlines; deferred.h
 * finds these in the blended G-buffer. */
#ifndef TS_KERNELS_SURFELS_SURFEL_SHADE_H
#define TS_KERNELS_SURFELS_SURFEL_SHADE_H
#include "kernels/base/args.h"
#include "kernels/surfels/deferred.h"
#include "kernels/surfels/normal_field.h"
#include "kernels/surfels/surfel_blend.h"

#define TS_SHADING_FLAT 1u
#define TS_SHADING_GOURAUD 2u
#define TS_SHADING_PHONG 3u

#define TS_ROWS_ts_surfel_shade_args(ARG) \
	ARG(INNER, ts_surfel_blend_args, of, none) \
	ARG(IN, ts_light, lights, lamp_light) \
	ARG(IN_OPT, f32, slopes, normal_field_slope) /* of phong */ \
	ARG(TALLY, i64, shaded, 2)                   /* shading operations */ \
	ARG(VALUE, u32, n_lights, none) \
	ARG(VALUE, u32, shading, none) /* TS_SHADING_* */ \
	ARG(VALUE, u32, npr, none)     /* see ts_deferred_args */ \
	ARG(VALUE, f32, ambient, none) \
	ARG(VALUE, f32, exposure, none)
TS_ARGS(ts_surfel_shade_args);

/* The place at which a surfel is shaded. */
typedef struct {
	ts_v3 p, n;
} ts_shading_place;

/* The place of a surfel's centre. */
TS_FN ts_shading_place ts_k_centre_place(TS_GLOBAL const ts_surfel *surfel, const ts_disc *disc)
{
	ts_shading_place r;
	r.p = ts_load3(surfel->centre);
	r.n = ts_v3_make(disc->normal[0], disc->normal[1], disc->normal[2]);
	return r;
}

/* The place where the ray of a pixel meets the surfel's plane; the centre if that place is beside the ellipse, or the
 * normals cancel. */
TS_FN ts_shading_place ts_k_fragment_place(TS_GLOBAL const ts_surfel *surfel, const ts_disc *disc,
                                           TS_GLOBAL const f32 *slopes, f32 near, i32 x, i32 y)
{
	ts_v2 d = ts_k_disc_offset(disc, x, y);
	ts_disc_hit hit = ts_k_disc_hit(disc, near, d.x, d.y);
	ts_shading_place r = ts_k_centre_place(surfel, disc);
	if (!hit.inside) return r;
	r.p = ts_mad(ts_mad(r.p, ts_load3(surfel->u), hit.a), ts_load3(surfel->v), hit.b);
	ts_v3 n = ts_mad(ts_mad(r.n, ts_load3(slopes), hit.a), ts_load3(slopes + 3), hit.b);
	if (ts_length(n) >= TS_LEAST_SLANT) r.n = ts_normalize(n);
	return r;
}

/* The shaded attributes of a surfel at a place, which are added times its weight. */
TS_FN ts_attributes ts_k_shaded_colour(const ts_surfel_shade_args *args, const ts_camera_k *view, u64 i,
                                       const ts_shading_place *at)
{
	ts_attributes r;
	/* Take the surfel's own colour as albedo, clamped as where attributes are blended. */
	TS_GLOBAL const f32 *colour = args->of.surfels[i].colour;
	ts_v3 albedo =
		ts_v3_make(ts_clamp(colour[0], 0.0f, 1.0f), ts_clamp(colour[1], 0.0f, 1.0f), ts_clamp(colour[2], 0.0f, 1.0f));
	/* Add ambient light, then the lights in order, without shadows (NV40: Per-Pixel Phong Shading). */
	ts_v3 v = ts_normalize(ts_sub(view->eye, at->p));
	ts_v3 sum = ts_scale(albedo, args->ambient);
	for (u32 k = 0u; k < args->n_lights; k++) {
		sum = ts_add(sum, ts_k_shade_by(&args->lights[k], 1.0f, args->npr, at->p, at->n, v, albedo));
	}
	/* Expose and clamp the colour, as frame buffers hold it. */
	r.value[0] = ts_clamp(sum.x * args->exposure, 0.0f, 1.0f);
	r.value[1] = ts_clamp(sum.y * args->exposure, 0.0f, 1.0f);
	r.value[2] = ts_clamp(sum.z * args->exposure, 0.0f, 1.0f);
	/* Keep the normal that was shaded with. */
	r.value[3] = at->n.x;
	r.value[4] = at->n.y;
	r.value[5] = at->n.z;
	return r;
}

/* Whether a visible fragment counts: for flat only that of the nearest surfel. */
TS_FN bool ts_k_shows(u32 shading, u64 key, u32 surfel)
{
	return shading != TS_SHADING_FLAT || key == TS_EMPTY || (u32)key == surfel;
}

/* scatter over surfels */
TS_FN void ts_k_surfel_shade_item(const ts_surfel_shade_args *args, u64 i)
{
	/* Leave out surfels that are not drawn. */
	const ts_surfel_blend_args *of = &args->of;
	ts_camera_k view = ts_k_view(of->view);
	ts_disc disc = of->discs[i];
	if (disc.high[0] < disc.low[0]) return;
	/* Shade once, at the centre (NV40: 3-Pass Shading). */
	bool phong = args->shading == TS_SHADING_PHONG;
	ts_shading_place at = ts_k_centre_place(&of->surfels[i], &disc);
	ts_attributes colour = ts_k_shaded_colour(args, &view, i, &at);
	i64 n = 0;
	for (i32 y = disc.low[1]; y <= disc.high[1]; y++) {
		for (i32 x = disc.low[0]; x <= disc.high[0]; x++) {
			/* Take the fragments that the visibility pass allows; for flat shading only those of the nearest surfel. */
			u64 pixel = (u64)y * (u64)view.width + (u64)x;
			u64 key = of->keys[pixel];
			ts_surfel_fragment f = ts_k_surfel_fragment(&disc, &of->filter, view.near, x, y);
			if (!f.covers || !ts_k_is_visible(&of->filter, key, f.z)) continue;
			if (!ts_k_shows(args->shading, key, (u32)i)) continue;
			/* Shade again for each fragment, by the field of normals (NV40: Phong Shading for PBR). */
			if (phong) {
				at = ts_k_fragment_place(&of->surfels[i], &disc, args->slopes + i * TS_FIELD_SLOPES, view.near, x, y);
				colour = ts_k_shaded_colour(args, &view, i, &at);
			}
			/* Blend the shaded colour. */
			ts_k_blend_add(of, pixel, (u32)i, &colour, ts_k_fragment_weight(&f));
			n++;
		}
	}
	/* Count shading operations, fragments, and the pixels of the box. */
	ts_add_i64(&args->shaded[0], phong ? n : 1);
	ts_add_i64(&of->tally[0], n);
	ts_add_i64(&of->tally[1], (i64)(disc.high[0] - disc.low[0] + 1) * (i64)(disc.high[1] - disc.low[1] + 1));
}

#define TS_ROWS_ts_surfel_shade_image_args(ARG) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(OUT, f32, radiance, image_radiance) \
	ARG(OUT, u8, srgb, image_srgb) \
	ARG(VALUE, f32, exposure, none)
TS_ARGS(ts_surfel_shade_image_args);

/* The radiance of a pixel whose colours were exposed before they were blended. */
TS_FN ts_v3 ts_k_surfel_shown(TS_GLOBAL const ts_gpixel *pixel, f32 exposure)
{
	if (pixel->depth == TS_SKY) return ts_k_background();
	return ts_scale(ts_load3(pixel->albedo), 1.0f / exposure);
}

/* map over pixels */
TS_FN void ts_k_surfel_shade_image_item(const ts_surfel_shade_image_args *args, u64 i)
{
	ts_v3 shown = ts_k_surfel_shown(&args->pixels[i], args->exposure);
	ts_k_show(args->radiance + i * 3u, args->srgb + i * 3u, shown, args->exposure);
}

#endif
