/* Deferred shaders over a G-buffer (SPEC 5.2, pass 3; slides "Phong Shading", "NPR Shading"): once a pixel, whatever
 * overlaps there. Phong is ambient light, Lambert's cosine and a highlight (r.v)^32; NPR paints in three tones without a
 * highlight, and outlines in black where the depth steps, where the sky begins and where the surface turns away. */
#ifndef TS_KERNELS_DEFERRED_H
#define TS_KERNELS_DEFERRED_H
#include "gbuffer.h"
#include "image.h"
#include "resolve.h"

#define TS_SHADER_IS_PHONG 0u
#define TS_SHADER_IS_NPR 1u

#define TS_HIGHLIGHT 0.25f       /* of the radiance of a diffuse white surface */
#define TS_TONES 3.0f
#define TS_OUTLINE_STEP 0.03125f /* of the depth */
#define TS_OUTLINE_TURN 0.1875f  /* cosine between normal and viewer */
#define TS_PER_PI 0.3183098733425140380859375f

typedef struct {
	TS_GLOBAL const ts_view *view;
	TS_GLOBAL const ts_gpixel *pixels; /* gbuffer.pixel */
	TS_GLOBAL const ts_light *lights;  /* lamp.light */
	TS_GLOBAL const ts_lamp *lamps;
	TS_GLOBAL const u32 *lit;          /* resolve.lit; NULL: there are no shadows */
	TS_GLOBAL f32 *radiance;           /* image.radiance */
	TS_GLOBAL u8 *srgb;                /* image.srgb */
	u32 n_lights, shader;
	f32 ambient, exposure;
} ts_deferred_args;

/* The cosine in equal tones. */
TS_FN f32 ts_k_tone(f32 cosine) { return ts_min(ts_floor(cosine * TS_TONES + 1.0f), TS_TONES) / TS_TONES; }

TS_FN f32 ts_k_highlight(ts_v3 n, ts_v3 v, ts_v3 l)
{
	f32 x = ts_max(ts_dot(ts_reflect(ts_neg(l), n), v), 0.0f);
	for (u32 k = 0u; k < 5u; k++) x = ts_flush(x * x);
	return TS_HIGHLIGHT * x;
}

/* One light: what Lambert's law and the highlight make of it. */
TS_FN ts_v3 ts_k_deferred_light(const ts_deferred_args *args, u64 i, u32 k, ts_v3 p, ts_v3 n, ts_v3 v, ts_v3 albedo)
{
	ts_v3 l;
	TS_GLOBAL const u32 *lit = args->lit != NULL ? args->lit + i * args->n_lights : NULL;
	f32 arrives = ts_k_light(&args->lights[k], p, &l) * ts_k_share(lit, args->lamps, k);
	f32 cosine = ts_flush(ts_dot(n, l));
	if (!(cosine > 0.0f) || !(arrives > 0.0f)) return ts_v3_make(0.0f, 0.0f, 0.0f);
	bool phong = args->shader == TS_SHADER_IS_PHONG;
	ts_v3 paint = ts_scale(albedo, phong ? cosine : ts_k_tone(cosine));
	f32 shine = phong ? ts_k_highlight(n, v, l) : 0.0f;
	ts_v3 all = ts_add(paint, ts_v3_make(shine, shine, shine));
	return ts_mul(all, ts_scale(ts_load3(args->lights[k].intensity), arrives * TS_PER_PI));
}

/* 1 - zn is proportional to 1 / z. */
TS_FN bool ts_k_steps(const ts_deferred_args *args, i32 width, i32 height, i32 x, i32 y, f32 near)
{
	if (x < 0 || y < 0 || x >= width || y >= height) return false;
	f32 far = 1.0f - args->pixels[(u64)y * (u64)width + (u64)x].depth;
	return near - far > TS_OUTLINE_STEP * near;
}

TS_FN bool ts_k_is_outline(const ts_deferred_args *args, u64 i, ts_v3 n, ts_v3 v)
{
	i32 width = (i32)args->view->width;
	i32 height = (i32)args->view->height;
	i32 x = (i32)(i % (u64)args->view->width);
	i32 y = (i32)(i / (u64)args->view->width);
	f32 near = 1.0f - args->pixels[i].depth;
	if (ts_dot(n, v) < TS_OUTLINE_TURN) return true;
	return ts_k_steps(args, width, height, x - 1, y, near) || ts_k_steps(args, width, height, x + 1, y, near) ||
	       ts_k_steps(args, width, height, x, y - 1, near) || ts_k_steps(args, width, height, x, y + 1, near);
}

TS_FN ts_v3 ts_k_deferred(const ts_deferred_args *args, u64 i)
{
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	if (pixel->depth == TS_SKY) return ts_k_background();
	ts_v3 p = ts_load3(pixel->position);
	ts_v3 n = ts_load3(pixel->normal);
	ts_v3 albedo = ts_load3(pixel->albedo);
	ts_v3 v = ts_normalize(ts_sub(ts_load3(args->view->eye), p));
	if (args->shader == TS_SHADER_IS_NPR && ts_k_is_outline(args, i, n, v)) return ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_v3 sum = ts_scale(albedo, args->ambient);
	for (u32 k = 0u; k < args->n_lights; k++) sum = ts_add(sum, ts_k_deferred_light(args, i, k, p, n, v, albedo));
	return sum;
}

/* map over pixels */
TS_FN void ts_k_deferred_item(const ts_deferred_args *args, u64 i)
{
	ts_k_show(args->radiance + i * 3u, args->srgb + i * 3u, ts_k_deferred(args, i), args->exposure);
}

typedef struct {
	ts_resolve_args of;                /* without what the eye sees of triangles */
	TS_GLOBAL const ts_gpixel *pixels; /* gbuffer.pixel */
} ts_deferred_lit_args;

/* map over pixels: the lights, a view each, that reach what is there */
TS_FN void ts_k_deferred_lit_item(const ts_deferred_lit_args *args, u64 i)
{
	ts_receiver at;
	at.p = ts_load3(args->pixels[i].position);
	at.n = ts_load3(args->pixels[i].normal);
	at.seen = args->pixels[i].depth != TS_SKY;
	for (u32 v = 0u; v < args->of.n_views; v++) {
		TS_GLOBAL const ts_offscreen *view = &args->of.views[v];
		bool reaches = at.seen && ts_k_reaches(&args->of, view, &at, args->of.views[0].offset);
		args->of.lit[i * args->of.n_lamps + view->light] = reaches ? 1u : 0u;
	}
}

#endif
