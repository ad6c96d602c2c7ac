/* Specular reflection of gathered light (SSAGH eq. 6; METHODS 11). The microfacet BRDF of glTF 2.0 is D V F. Its
 * distribution of normals D becomes a spherical Gaussian, turned from half vectors to directions of light (Wang, Ren,
 * Gong, Snyder and Guo 2009). Its product with a lobe of light, by eq. 3, is a Gaussian again, which is integrated with
 * the cosine like diffuse light. V and F change little within a lobe, so their values at the middle of the product are
 * taken. */
#ifndef TS_KERNELS_HULLS_GLOSS_H
#define TS_KERNELS_HULLS_GLOSS_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/hulls/direct.h"
#include "kernels/hulls/hull.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"
#include "kernels/raster/gpixel.h"

#define TS_ROWS_ts_gloss_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(OUT, ts_gloss, pixels, gloss_pixel) \
	ARG(VALUE, u32, samples, none) /* of a pixel */
TS_ARGS(ts_gloss_args);

TS_FN void ts_k_gloss(TS_GLOBAL ts_gloss *gloss, const ts_arrays *scene, const ts_camera_k *view, u64 key, i32 x, i32 y)
{
	ts_store3(gloss->f0, ts_v3_make(0.0f, 0.0f, 0.0f));
	gloss->alpha_squared = 1.0f;
	if (key == TS_EMPTY) return;
	ts_surface s = ts_k_surface_seen(scene, view, (u32)key, x, y);
	gloss->alpha_squared = ts_put(ts_k_alpha_squared(s.roughness));
	if ((s.flags & TS_UNLIT) == 0u) ts_store3(gloss->f0, ts_k_f0(&s));
}

/* map over pixels and their samples */
TS_FN void ts_k_gloss_item(const ts_gloss_args *args, u64 i)
{
	ts_eye_place at = ts_k_eye_place(args->view, args->samples, i);
	ts_k_gloss(&args->pixels[i], &args->scene, &at.view, args->depth_triangle[i], at.x, at.y);
}

/* A surface that reflects to the eye, and the integral to use. */
typedef struct {
	ts_sg lobe;
	ts_v3 n, v, f0;
	f32 alpha_squared;
	u32 cosine, printed;
} ts_glossy;

TS_FN ts_glossy ts_k_glossy(TS_GLOBAL const ts_gpixel *pixel, TS_GLOBAL const ts_gloss *gloss, ts_v3 eye, u32 cosine,
                            u32 printed)
{
	ts_glossy r;
	r.n = ts_load3(pixel->normal);
	r.v = ts_normalize(ts_sub(eye, ts_load3(pixel->position)));
	r.f0 = ts_load3(gloss->f0);
	r.alpha_squared = gloss->alpha_squared;
	r.lobe = ts_k_gloss_lobe(r.n, r.v, r.alpha_squared);
	r.cosine = cosine;
	r.printed = printed;
	return r;
}

/* V F for light from l; the cosines to the normal are at least 2^-10. */
TS_FN ts_v3 ts_k_gloss_factor(const ts_glossy *at, ts_v3 l)
{
	f32 n_l = ts_max(ts_dot(at->n, l), TS_LEAST_GGX_COSINE);
	f32 n_v = ts_max(ts_abs(ts_dot(at->n, at->v)), TS_LEAST_GGX_COSINE);
	ts_v3 h = ts_normalize(ts_add(l, at->v));
	f32 v_h = ts_clamp(ts_dot(at->v, h), 0.0f, 1.0f);
	return ts_scale(ts_k_schlick(at->f0, v_h), ts_k_smith(n_l, n_v, at->alpha_squared));
}

/* The light that the surface reflects, from the product of a lobe of exitance and the surface's lobe. If the product
 * has no axis, V and F take the light from above. Anything but a number from 0 to 2^62 counts as 0. */
TS_FN ts_v3 ts_k_gloss_reflected(const ts_glossy *at, const ts_sg *both)
{
	f32 integral = ts_k_sg_cosine(both->lambda, ts_dot(at->n, both->phi), at->cosine, at->printed);
	f32 sent = ts_flush((both->mu * integral) * TS_PER_PI);
	if (!(sent > 0.0f && sent < TS_MOST_INPUT)) return ts_v3_make(0.0f, 0.0f, 0.0f);
	return ts_scale(ts_k_gloss_factor(at, both->lambda > 0.0f ? both->phi : at->n), sent);
}

#define TS_ROWS_ts_gloss_hull_args(ARG) \
	ARG(INNER, ts_hull_args, of, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_gloss, gloss, gloss_pixel) \
	ARG(IN, u32, box, hull_box) \
	ARG(OUT, f32, specular, indirect_specular)
TS_ARGS(ts_gloss_hull_args);

/* map over pixels and their samples: reflects the lobes of their boxes */
TS_FN void ts_k_gloss_hull_item(const ts_gloss_hull_args *args, u64 i)
{
	/* Begin without light; the sky, and pixels without a box, stay so. */
	u32 box = args->box[i];
	TS_GLOBAL f32 *specular = args->specular + i * 3u;
	ts_store3(specular, ts_v3_make(0.0f, 0.0f, 0.0f));
	if (box == TS_NONE) return;
	/* Find the lobe of the pixel's surface, and the shares of the box's corners. */
	ts_v3 eye = ts_load3(args->view->eye);
	ts_glossy at = ts_k_glossy(&args->of.pixels[i], &args->gloss[i], eye, args->of.cosine, args->of.printed);
	u32 x = (u32)(i % args->of.width);
	u32 y = (u32)(i / args->of.width % args->of.height);
	ts_shares shares = ts_k_box_shares(&args->of, box, x, y);
	/* Reflect the lobe of each colour channel: its product with the surface's lobe (SSAGH eq. 3), integrated with the
	 * cosine (SSAGH eq. 6). */
	for (u32 channel = 0u; channel < 3u; channel++) {
		ts_sg light = ts_k_hull_lobe(&args->of, box, &shares, channel);
		ts_sg both = ts_k_sg_product(&light, &at.lobe);
		ts_v3 sent = ts_k_gloss_reflected(&at, &both);
		specular[channel] = ts_put(channel == 0u ? sent.x : channel == 1u ? sent.y : sent.z);
	}
}

#define TS_ROWS_ts_gloss_direct_args(ARG) \
	ARG(INNER, ts_direct_args, of, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_gloss, gloss, gloss_pixel) \
	ARG(OUT, f32, specular, indirect_specular) \
	ARG(VALUE, u32, cosine, none)  /* TS_COSINE_* */ \
	ARG(VALUE, u32, vmf, none)     /* hull.sharpness=vmf */ \
	ARG(VALUE, u32, printed, none) /* hull.integrals=printed */
TS_ARGS(ts_gloss_direct_args);

/* The part of a triangle that a pixel sees: its solid angle, and the solid angle times the mean direction. */
typedef struct {
	ts_v3 ways;
	f32 angle;
} ts_gloss_seen;

/* Adds a triangle, seen from the origin. */
TS_FN void ts_k_gloss_see(ts_gloss_seen *sum, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 p = ts_v3_make(0.0f, 0.0f, 0.0f);
	f32 angle = ts_k_solid_angle(p, a, b, c);
	ts_v3 ways = ts_k_ways(p, a, b, c);
	sum->angle = sum->angle + angle;
	sum->ways = ts_mad(sum->ways, ways, angle / 3.0f);
}

/* Sums the part of a triangle above the horizon of n, clipped by Sutherland and Hodgman's algorithm (1974), as a fan
 * from the first corner of that part. A triangle in the surface's own plane is not above the horizon, whatever rounding
 * does. */
TS_FN ts_gloss_seen ts_k_gloss_above(ts_v3 p, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Start without corners and without light. */
	ts_gloss_seen sum;
	ts_v3 first = ts_sub(a, p);
	ts_v3 last = first;
	u32 corners = 0u;
	sum.ways = ts_v3_make(0.0f, 0.0f, 0.0f);
	sum.angle = 0.0f;
	for (u32 i = 0u; i < 6u; i++) {
		/* Visit every edge twice: for its first end, then for its cut by the horizon (Sutherland and Hodgman 1974). */
		ts_v3 from = ts_sub(i < 2u ? a : i < 4u ? b : c, p);
		ts_v3 to = ts_sub(i < 2u ? b : i < 4u ? c : a, p);
		f32 d_from = ts_flush(ts_dot(n, from));
		f32 d_to = ts_flush(ts_dot(n, to));
		/* Keep ends above the horizon, and cuts. A height of 0 is below, so that a triangle in the surface's own plane
		 * vanishes. */
		bool cuts = i % 2u != 0u;
		if (cuts ? (d_from > 0.0f) == (d_to > 0.0f) : !(d_from > 0.0f)) continue;
		/* Cut from the upper end, so that two triangles with a common edge cut it at the same place. */
		ts_v3 at = !cuts           ? from
		           : d_from > 0.0f ? ts_mad(from, ts_sub(to, from), ts_k_form_share(d_from, d_to))
		                           : ts_mad(to, ts_sub(from, to), ts_k_form_share(d_to, d_from));
		/* Add the next triangle of the fan about the first corner. */
		if (corners == 0u) first = at;
		if (corners > 1u) ts_k_gloss_see(&sum, first, last, at);
		last = at;
		corners = corners + 1u;
	}
	return sum;
}

/* The reflection of one triangle of light, by the lobe that a corner would fit to this triangle alone. */
TS_FN ts_v3 ts_k_gloss_direct(const ts_glossy *at, TS_GLOBAL const ts_patch *patch, ts_v3 p, u32 vmf)
{
	ts_v3 a = ts_load3(patch->a);
	if (!ts_k_is_in_front(p, a, ts_load3(patch->normal))) return ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_gloss_seen seen = ts_k_gloss_above(p, at->n, a, ts_load3(patch->b), ts_load3(patch->c));
	ts_sg light = ts_k_fit(seen.angle, seen.ways, vmf);
	ts_sg both = ts_k_sg_product(&light, &at->lobe);
	return ts_mul(ts_k_gloss_reflected(at, &both), ts_load3(patch->exitance));
}

TS_FN ts_v3 ts_k_gloss_direct_point(const ts_glossy *at, TS_GLOBAL const ts_light *point, ts_v3 p, u32 vmf)
{
	ts_v3 way;
	f32 w = ts_k_light(point, p, &way) * TS_PI_F32;
	ts_sg light = ts_k_fit(w, ts_scale(way, w), vmf);
	ts_sg both = ts_k_sg_product(&light, &at->lobe);
	return ts_mul(ts_k_gloss_reflected(at, &both), ts_load3(point->intensity));
}

/* map over pixels and their samples: reflects every triangle of light */
TS_FN void ts_k_gloss_direct_item(const ts_gloss_direct_args *args, u64 i)
{
	/* Read the pixel; the sky reflects nothing. */
	TS_GLOBAL const ts_gpixel *pixel = &args->of.pixels[i];
	ts_v3 p = ts_load3(pixel->position);
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	bool sky = pixel->depth == TS_SKY;
	u64 end = sky ? 0u : args->of.n_patches;
	/* Reflect every triangle of light, in order (SSAGH 5). */
	ts_glossy at = ts_k_glossy(pixel, &args->gloss[i], ts_load3(args->view->eye), args->cosine, args->printed);
	for (u64 k = 0u; k < end; k++) sum = ts_add(sum, ts_k_gloss_direct(&at, &args->of.patches[k], p, args->vmf));
	/* Reflect the lights without extent, which have no triangles. */
	for (u32 k = 0u; k < args->of.n_lamps && !sky; k++) {
		if (args->of.shapes[k].radius > 0.0f) continue;
		sum = ts_add(sum, ts_k_gloss_direct_point(&at, &args->of.lamps[k], p, args->vmf));
	}
	ts_store3(args->specular + i * 3u, sum);
}

#endif
