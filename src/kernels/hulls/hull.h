/* The light of each pixel from the hull (SSAGH sections 3 and 4; METHODS 11): the lobes of its box, interpolated
 * between the corners, and integrated with the cosine of the pixel's own normal.
 *
 * The box is drawn over [low, high + 1] of the grid as two triangles with a common edge from top left to bottom right.
 * Its corners gather in the middle of pixels, in the box or where the rectangle ends (hull.corners); lobes are
 * interpolated between these pixels and constant beyond. Interpolation is perspective-correct: corners are weighted by
 * 1 / z, which is proportional to 1 - zn. E = mu A_h(lambda, n.phi) / pi, since mu is exitance, and radiance is
 * exitance divided by pi. */
#ifndef TS_KERNELS_HULLS_HULL_H
#define TS_KERNELS_HULLS_HULL_H
#include "kernels/base/args.h"
#include "kernels/hulls/corner_lobes.h"
#include "kernels/hulls/hull_choice.h"
#include "kernels/raster/gpixel.h"

#define TS_ROWS_ts_hull_args(ARG) \
	ARG(INNER, ts_choice_args, choice, none) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, ts_moment, moments, corner_moment) \
	ARG(IN, ts_lobes, lobes, corner_lobes) \
	ARG(OUT, u32, box, hull_box) \
	ARG(OUT, f32, irradiance, indirect_irradiance) \
	ARG(TALLY, i64, n_unlit, 0) /* pixels without a box, except the sky */ \
	ARG(VALUE, u32, width, none) \
	ARG(VALUE, u32, height, none) \
	ARG(VALUE, u32, cosine, none)     /* TS_COSINE_* */ \
	ARG(VALUE, u32, by_moments, none) /* hull.interpolation=moments */ \
	ARG(VALUE, u32, vmf, none)        /* hull.sharpness=vmf */ \
	ARG(VALUE, u32, printed, none)    /* hull.integrals=printed */ \
	ARG(VALUE, u32, rectangle, none)  /* hull.corners=rectangle */
TS_ARGS(ts_hull_args);

/* Shares of the corners of a box: top left, top right, bottom left, bottom right. Their sum is 1, or 0 if all corners
 * are in the sky. */
typedef struct {
	f32 of[4];
} ts_shares;

/* The place of pixel i between the pixels at which two corners gather: 0 up to the first, 1 from the last on. Where
 * both gather at one pixel, that pixel is at 0. */
TS_FN f32 ts_k_box_place(u32 i, u32 pixels, u32 grid, u32 low, u32 high)
{
	f32 first = (f32)ts_k_resample(low, grid, pixels);
	f32 last = (f32)ts_k_resample(high, grid, pixels);
	return ts_clamp(((f32)i - first) / ts_max(last - first, 1.0f), 0.0f, 1.0f);
}

/* Shares on the screen, before perspective. In the upper right triangle, where s is above t, they are 1 - s, s - t, 0
 * and t; in the lower left one 1 - t, 0, t - s and s. */
TS_FN ts_shares ts_k_box_weights(const ts_hull_args *args, u32 b, u32 x, u32 y)
{
	TS_GLOBAL const ts_segment *box = &args->choice.boxes[b];
	u32 right = ts_k_box_end(box->high[0], args->choice.grid, args->rectangle);
	u32 bottom = ts_k_box_end(box->high[1], args->choice.grid, args->rectangle);
	f32 s = ts_k_box_place(x, args->width, args->choice.grid, box->low[0], right);
	f32 t = ts_k_box_place(y, args->height, args->choice.grid, box->low[1], bottom);
	ts_shares r;
	r.of[0] = 1.0f - ts_max(s, t);
	r.of[1] = ts_max(s - t, 0.0f);
	r.of[2] = ts_max(t - s, 0.0f);
	r.of[3] = ts_min(s, t);
	return r;
}

TS_FN ts_shares ts_k_box_shares(const ts_hull_args *args, u32 b, u32 x, u32 y)
{
	TS_GLOBAL const ts_moment *corner = &args->moments[(u64)b * 4u];
	ts_shares r = ts_k_box_weights(args, b, x, y);
	f32 sum = 0.0f;
	for (u32 k = 0u; k < 4u; k++) {
		r.of[k] = r.of[k] * (1.0f - corner[k].depth);
		sum = sum + r.of[k];
	}
	for (u32 k = 0u; k < 4u; k++) r.of[k] = r.of[k] / (sum > 0.0f ? sum : 1.0f);
	return r;
}

/* The blend of a channel's lobes; its axis is not yet a unit vector. A corner without light has no sharpness, so its
 * share does not count for lambda; its mu and phi are 0. */
TS_FN ts_sg ts_k_lobes_blend(TS_GLOBAL const ts_lobes *corner, const ts_shares *shares, u32 channel)
{
	ts_sg g = ts_sg_make(0.0f, 0.0f, ts_v3_make(0.0f, 0.0f, 0.0f));
	f32 lit = 0.0f;
	for (u32 k = 0u; k < 4u; k++) {
		f32 share = corner[k].mu[channel] > 0.0f ? shares->of[k] : 0.0f;
		lit = lit + share;
		g.mu = g.mu + shares->of[k] * corner[k].mu[channel];
		g.lambda = g.lambda + share * corner[k].lambda[channel];
		g.phi = ts_mad(g.phi, ts_load3(corner[k].phi + channel * 3u), shares->of[k]);
	}
	g.lambda = lit > 0.0f ? g.lambda / lit : 1.0f;
	return g;
}

TS_FN ts_sg ts_k_lobe_of_lobes(TS_GLOBAL const ts_lobes *corner, const ts_shares *shares, u32 channel)
{
	ts_sg g = ts_k_lobes_blend(corner, shares, channel);
	g.phi = ts_normalize(g.phi);
	return g;
}

TS_FN ts_sg ts_k_lobe_of_moments(TS_GLOBAL const ts_moment *corner, const ts_shares *shares, u32 channel, u32 vmf)
{
	f32 m = 0.0f;
	ts_v3 directions = ts_v3_make(0.0f, 0.0f, 0.0f);
	for (u32 k = 0u; k < 4u; k++) {
		m = m + shares->of[k] * corner[k].sum[channel];
		directions = ts_mad(directions, ts_load3(corner[k].direction + channel * 3u), shares->of[k]);
	}
	return ts_k_fit(m, directions, vmf);
}

/* The irradiance of a lobe, at least 0 and below 2^62, the bound of input (rule 10). Eqs 9 and 10 as printed divide by
 * lambda squared, which may be nearly 0; NaN and infinity count as 0. */
TS_FN f32 ts_k_lobe_irradiance(const ts_hull_args *args, const ts_sg *g, ts_v3 n)
{
	f32 integral = ts_k_sg_cosine(g->lambda, ts_dot(n, g->phi), args->cosine, args->printed);
	f32 e = ts_flush((g->mu * integral) * TS_PER_PI);
	return e > 0.0f && e < TS_MOST_INPUT ? e : 0.0f;
}

TS_FN ts_sg ts_k_hull_lobe(const ts_hull_args *args, u32 b, const ts_shares *shares, u32 channel)
{
	u64 first = (u64)b * 4u;
	if (args->by_moments != 0u) return ts_k_lobe_of_moments(args->moments + first, shares, channel, args->vmf);
	return ts_k_lobe_of_lobes(args->lobes + first, shares, channel);
}

/* Returns the pixel's box, and sets its light to 0. */
TS_FN u32 ts_k_hull_box(const ts_hull_args *args, u64 i, u32 x, u32 y)
{
	ts_grid_place at;
	at.x = ts_k_resample(x, args->width, args->choice.grid);
	at.y = ts_k_resample(y, args->height, args->choice.grid);
	at.depth = args->pixels[i].depth;
	bool sky = at.depth == TS_SKY;
	u32 box = sky ? TS_NONE : ts_k_choose_box(&args->choice, at);
	args->box[i] = box;
	ts_store3(args->irradiance + i * 3u, ts_v3_make(0.0f, 0.0f, 0.0f));
	if (!sky && box == TS_NONE) ts_add_i64(args->n_unlit, 1);
	return box;
}

/* map over pixels and their samples, one picture below the other (eye_sample.h) */
TS_FN void ts_k_hull_item(const ts_hull_args *args, u64 i)
{
	u32 x = (u32)(i % args->width);
	u32 y = (u32)(i / args->width % args->height);
	u32 box = ts_k_hull_box(args, i, x, y);
	if (box == TS_NONE) return;
	ts_shares shares = ts_k_box_shares(args, box, x, y);
	ts_v3 n = ts_load3(args->pixels[i].normal);
	for (u32 channel = 0u; channel < 3u; channel++) {
		ts_sg g = ts_k_hull_lobe(args, box, &shares, channel);
		args->irradiance[i * 3u + channel] = ts_put(ts_k_lobe_irradiance(args, &g, n));
	}
}

#endif
