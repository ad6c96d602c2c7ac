/* Margins of deferred.h, for ports that round otherwise (PORTING 7): how near deferred shading was to another answer.
 * This second pass takes the G-buffer as given and changes no decision. A step is 8 ulps of the compared numbers. */
#ifndef TS_KERNELS_SURFELS_DEFERRED_MARGIN_H
#define TS_KERNELS_SURFELS_DEFERRED_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/raster/shadow_map_margin.h"
#include "kernels/surfels/deferred.h"

#define TS_ROWS_ts_deferred_margin_args(ARG) \
	ARG(INNER, ts_deferred_args, of, none) \
	ARG(OUT, f32, margin, deferred_margin)
TS_ARGS(ts_deferred_margin_args);

/* The least margin of the tests by which the surface ends before a neighbour, or the greatest of those by which it does
 * not. */
TS_FN f32 ts_k_border_margin(const ts_border *next)
{
	bool farther = next->farther > next->step;
	bool below = next->sky || next->below > next->drop;
	f32 step = (next->step / TS_OUTLINE_STEP) * TS_MARGIN_ROUNDING;
	f32 drop = (next->drop / TS_OUTLINE_DROP) * TS_MARGIN_ROUNDING;
	f32 of_step = ts_abs(next->farther - next->step) / step;
	f32 of_drop = next->sky || drop == 0.0f ? TS_MARGIN_NOWHERE : ts_abs(next->below - next->drop) / drop;
	if (farther && below) return ts_min(of_step, of_drop);
	return ts_max(farther ? 0.0f : of_step, below ? 0.0f : of_drop);
}

/* The margin of an outline: it disappears only if the surface continues to all neighbours, and appears if the surface
 * ends before any of them. */
TS_FN f32 ts_k_outline_margin(const ts_deferred_args *args, u64 i, bool outline)
{
	f32 r = outline ? 0.0f : TS_MARGIN_NOWHERE;
	for (u32 k = 0u; k < 4u; k++) {
		ts_border next = ts_k_border(args, i, k);
		if (!next.is) continue;
		f32 margin = ts_k_border_margin(&next);
		if (!outline) r = ts_min(r, margin);
		if (outline && ts_k_ends(&next)) r = ts_max(r, margin);
	}
	return r;
}

/* The margin of the cosine against 0, where highlights and the first tone begin; for NPR also against the other tones;
 * in steps of the cosine. */
TS_FN f32 ts_k_cosine_margin(TS_GLOBAL const ts_light *light, f32 share, u32 npr, ts_v3 p, ts_v3 n, f32 step)
{
	ts_v3 l;
	f32 arrives = ts_k_light(light, p, &l) * share;
	f32 cosine = ts_dot(n, l);
	if (!(arrives > 0.0f)) return TS_MARGIN_NOWHERE;
	f32 tones = cosine * TS_TONES;
	f32 nearest = ts_clamp(ts_floor(tones + 0.5f), 0.0f, TS_TONES - 1.0f);
	f32 apart = npr != 0u ? ts_abs(tones - nearest) / TS_TONES : ts_abs(cosine);
	return apart / step;
}

/* The margin of light k at a pixel. */
TS_FN f32 ts_k_deferred_light_margin(const ts_deferred_args *args, u64 i, u32 k)
{
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	TS_GLOBAL const u32 *lit = args->lit != NULL ? args->lit + i * args->n_lights : NULL;
	return ts_k_cosine_margin(&args->lights[k], ts_k_share(lit, args->lamps, k), args->npr, ts_load3(pixel->position),
	                          ts_load3(pixel->normal), TS_MARGIN_ROUNDING);
}

/* map over pixels */
TS_FN void ts_k_deferred_margin_item(const ts_deferred_margin_args *args, u64 i)
{
	const ts_deferred_args *of = &args->of;
	bool sky = of->pixels[i].depth == TS_SKY;
	bool npr = of->npr != 0u && !sky;
	bool outline = npr && ts_k_is_outline(of, i);
	f32 least = npr ? ts_k_outline_margin(of, i, outline) : TS_MARGIN_NOWHERE;
	for (u32 k = 0u; k < of->n_lights && !sky && !outline; k++)
		least = ts_min(least, ts_k_deferred_light_margin(of, i, k));
	args->margin[i] = ts_put(least);
}

#define TS_ROWS_ts_deferred_lit_margin_args(ARG) \
	ARG(INNER, ts_deferred_lit_args, of, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(MIN, u64, margin, shadow_test_margin) /* [2] per pixel and light */
TS_ARGS(ts_deferred_lit_margin_args);

/* map over pixels, as ts_k_deferred_lit_item */
TS_FN void ts_k_deferred_lit_margin_item(const ts_deferred_lit_margin_args *args, u64 i)
{
	/* Leave out the sky, which receives no light. */
	u32 v = 0u;
	ts_shadow_test_args of = args->of.of;
	ts_receiver at = ts_k_deferred_receiver(&args->of.pixels[i]);
	if (!at.seen) return;
	/* Find how far rounding may move the surface. */
	ts_camera_k eye = ts_k_view(args->view);
	f32 moves = ts_k_receiver_step(&eye, &at);
	for (u32 k = 0u; k < of.n_lamps; k++) {
		/* Judge the one map that the light's test reads: its only view, or the face of its cube into which the position
		 * falls. */
		of.cubes = ts_k_has_cube(&args->of.lights[k]) ? 1u : 0u;
		TS_GLOBAL const ts_offscreen *view = ts_k_asked_view(&of, v, &at);
		ts_k_reach_margin(&of, view, &at, moves, of.views[0].offset, args->margin + (i * of.n_lamps + k) * 2u);
		v += of.cubes != 0u ? 6u : 1u;
	}
}

#endif
