/* Margins of surfel_depth.h and surfel_blend.h, for ports that round otherwise (PORTING 7): how near each surfel was to
 * being seen, blended or hidden otherwise. This second pass changes no decision. A step is what changes of 8 ulps make:
 * of the surfel's distances from the eye and from the origin, which move its image and its depth; of its radius, which
 * changes its shape; and of each result. Boxes are taken as given: outside a box nothing is covered, except where boxes
 * cut off exact EWA, or those of surfel_setup.bounds=botsch cut off ellipses. */
#ifndef TS_KERNELS_SURFELS_SURFEL_MARGIN_H
#define TS_KERNELS_SURFELS_SURFEL_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/raster/margin_bounds.h"
#include "kernels/surfels/surfel_blend.h"

#define TS_ROWS_ts_surfel_margin_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_surfel, surfels, scene_surfel) \
	ARG(IN, ts_disc, discs, surfel_setup_disc) \
	ARG(IN, f32, epsilon, surfel_setup_epsilon) \
	ARG(IN, u64, keys, surfel_depth_surfel) \
	ARG(IN_OPT, u64, heaviest, surfel_blend_heaviest) /* NULL: margins of surfel_depth */ \
	ARG(MIN, u64, margin, none)                       /* [2] per pixel, f32 bits */ \
	ARG(VALUE, ts_filter, filter, none)
TS_ARGS(ts_surfel_margin_args);

/* A surfel as it is drawn, or would be; its margin of being drawn or not, in steps; the size of a step in the depth of
 * its centre and in pixels of its image; and its radius in pixels. */
typedef struct {
	ts_disc disc;
	bool drawn;
	f32 fate, deep, off, wide;
} ts_nearly;

/* A surfel at a pixel, and the size of a step in its plane, in r3D^2, in the depth there, in the number that the screen
 * filter or exact EWA compares with 1, and in the weight; and the distance of its peak from 0 in steps. */
typedef struct {
	ts_surfel_fragment is;
	ts_disc_hit hit;
	f32 a_step, b_step, r2_step, z_step, flat, flat_step, weight_step, peak_margin;
} ts_nearly_there;

/* The least margin of all tests if the surfel is drawn, otherwise the greatest margin of the tests that kept it out. */
TS_FN f32 ts_k_disc_fate(const ts_camera_k *view, const ts_filter *filter, const ts_disc_frame *frame, f32 slant,
                         f32 deep, f32 distance)
{
	/* Find the margin of facing the eye: a step turns the direction to the eye by deep / distance. */
	f32 turned = (ts_abs(slant) * distance) / deep;
	/* Find the margins against the near plane: of the centre, which decides whether the surfel crosses the plane, and
	 * of the point that stands for it. */
	f32 centre = frame->c.z - (frame->a * frame->u.z + frame->b * frame->v.z);
	f32 crossing = frame->crosses ? ts_abs(centre - view->near) / deep : TS_MARGIN_NOWHERE;
	f32 before = ts_abs(frame->c.z - view->near) / deep;
	/* Find the margin of staying away from the eye's plane, which exact EWA needs; a step is 32 ulps of 1. */
	bool close = filter->filter == TS_FILTER_EWA && view->orthographic == 0u && frame->c.z > 0.0f;
	f32 room = close ? 1.0f - ts_k_disc_closeness(frame, filter) : 1.0f;
	f32 closing = close ? ts_abs(room) / (4.0f * TS_MARGIN_ROUNDING) : TS_MARGIN_NOWHERE;
	/* Combine them: the surfel is drawn if all tests hold. */
	bool faces = slant > 0.0f;
	bool behind = frame->c.z >= view->near;
	bool affine = room > 0.0f;
	if (faces && behind && affine) return ts_min(turned, ts_min(ts_min(before, crossing), closing));
	return ts_max(faces ? 0.0f : turned, ts_max(behind ? 0.0f : before, affine ? 0.0f : closing));
}

/* The margin of a surfel's being drawn. A surfel that is neither drawn nor within the margin of being drawn gets an
 * empty box. */
TS_FN ts_nearly ts_k_nearly(const ts_surfel_margin_args *args, const ts_camera_k *view, u32 i)
{
	/* Set up the surfel again, and find its slant, distance and radius. */
	TS_GLOBAL const ts_surfel *surfel = &args->surfels[i];
	ts_disc_frame frame = ts_k_disc_frame(view, &args->filter, surfel);
	ts_v3 centre = ts_load3(surfel->centre);
	ts_v3 n = ts_k_disc_normal(surfel);
	f32 slant = ts_k_disc_slant(view, centre, n);
	f32 distance = ts_length(ts_sub(centre, view->eye));
	f32 radius = ts_sqrt(ts_max(ts_flush(ts_dot(frame.u, frame.u)), ts_flush(ts_dot(frame.v, frame.v))));
	/* Take the disc that was drawn, and find how near that decision was. */
	ts_nearly r;
	r.disc = args->discs[i];
	r.drawn = r.disc.low[0] <= r.disc.high[0];
	r.deep = TS_MARGIN_ROUNDING * ((distance + ts_length(centre)) + radius);
	r.fate = ts_k_disc_fate(view, &args->filter, &frame, slant, r.deep, distance);
	/* Make the disc of a surfel that is nearly drawn, to find the pixels that it would cover. */
	if (!r.drawn && r.fate <= TS_MARGIN_REACH && frame.c.z > 0.0f) {
		ts_k_disc_clear(&r.disc);
		ts_k_disc_make(&r.disc, view, &args->filter, &frame, n, slant);
	}
	/* Convert the step and the radius to pixels. */
	f32 z = ts_max(frame.z, view->near);
	r.off = (r.deep * view->focal) / z;
	r.wide = (radius * view->focal) / z;
	return r;
}

TS_FN f32 ts_k_sizes(const f32 *row) { return ts_abs(row[0]) + ts_abs(row[1]); }

/* Sets the steps of the ray cast: those of the centre's image, of the divisor, and of the results. */
TS_FN void ts_k_nearly_hit(ts_nearly_there *r, const ts_nearly *surfel, ts_v2 d)
{
	/* Find the change of 1 + G.d, as the offset moves and as the sum is rounded. */
	const ts_disc *disc = &surfel->disc;
	bool parallel = (disc->flags & TS_DISC_PARALLEL) != 0u;
	f32 tilt = ts_abs(disc->g[0] * d.x) + ts_abs(disc->g[1] * d.y);
	f32 leaning = ts_k_sizes(disc->g) * surfel->off + TS_MARGIN_ROUNDING * (1.0f + tilt);
	/* Find the relative change of the quotients, and the move of the offset divided by 1 + G.d. */
	f32 nearer = ts_max(r->hit.z / disc->depth, 0.0f); /* 1 / divisor */
	f32 divided = parallel ? TS_MARGIN_ROUNDING : leaning * nearer;
	f32 by = parallel ? surfel->off : surfel->off * nearer;
	/* Set the steps of a and b, by the 1-norms of A and B. */
	f32 from = (disc->flags & TS_DISC_CROSSES) != 0u ? 1.0f : 0.0f; /* greatest |a| or |b| of the farthest point */
	r->a_step = ts_k_sizes(disc->a) * by + (ts_abs(r->hit.a) + from) * divided;
	r->b_step = ts_k_sizes(disc->b) * by + (ts_abs(r->hit.b) + from) * divided;
	/* Set the steps of r3D^2 and of the depth, to first order. */
	f32 rounding = TS_MARGIN_ROUNDING * (r->hit.r2 + from);
	r->r2_step = 2.0f * (ts_abs(r->hit.a) * r->a_step + ts_abs(r->hit.b) * r->b_step) + rounding;
	r->z_step = surfel->deep + (parallel ? disc->depth * leaning : ts_abs(r->hit.z) * divided);
}

/* Sets the steps of exact EWA: of d V^-1 d as the centre moves, and as V changes. */
TS_FN void ts_k_nearly_gaussian(ts_nearly_there *r, const ts_filter *filter, const ts_nearly *surfel, ts_v2 d)
{
	/* Find V^-1 d, half the gradient of d V^-1 d. */
	const ts_disc *disc = &surfel->disc;
	f32 x = disc->conic[0] * d.x + disc->conic[1] * d.y;
	f32 y = disc->conic[1] * d.x + disc->conic[2] * d.y;
	f32 both = ts_abs(x) + ts_abs(y);
	/* Bound the change of V, and the change of d V^-1 d that V, the move of d and rounding make. */
	f32 v = TS_MARGIN_ROUNDING * ((4.0f * filter->object2) * (surfel->wide * surfel->wide) + filter->screen2);
	f32 q_step = ((both * both) * v + (2.0f * both) * surfel->off) + (2.0f * TS_MARGIN_ROUNDING) * r->is.exponent;
	/* Set the number that is compared with 1, a quarter of d V^-1 d, and its step. */
	r->flat = r->is.exponent * 0.5f;
	r->flat_step = q_step * 0.25f;
	/* Set the step of the weight: of its exponent, its peak, and rounding. */
	f32 axes = (ts_k_sizes(disc->a) + ts_k_sizes(disc->b)) * (TS_MARGIN_ROUNDING * surfel->wide);
	f32 peak = axes + (0.5f * v) * (disc->conic[0] + disc->conic[2]);
	r->weight_step = (0.5f * q_step + peak) + TS_MARGIN_ROUNDING;
	/* Set the margin of the peak against 0, where the fragment disappears. */
	f32 det = ts_diff_of_products(disc->conic[0], disc->conic[2], disc->conic[1], disc->conic[1]);
	f32 peak_step = ((2.0f * filter->object2) * (surfel->wide * surfel->wide)) * ts_sqrt(ts_flush(ts_max(det, 0.0f)));
	r->peak_margin = peak_step > 0.0f ? disc->peak / (peak_step * TS_MARGIN_ROUNDING) : TS_MARGIN_NOWHERE;
}

/* Sets the steps of the approximation: of r2D^2, and of the lesser radius. */
TS_FN void ts_k_nearly_radius(ts_nearly_there *r, const ts_filter *filter, const ts_nearly *surfel, ts_v2 d)
{
	f32 square = d.x * d.x + d.y * d.y;
	f32 far = 2.0f * (ts_abs(d.x) + ts_abs(d.y));
	r->flat = square * filter->per_sigma2;
	r->flat_step = (far * surfel->off) * filter->per_sigma2 + TS_MARGIN_ROUNDING * r->flat;
	bool object = r->hit.inside && filter->filter != TS_FILTER_SCREEN;
	bool lesser = !ts_k_has_screen(&surfel->disc, filter) || r->hit.r2 < r->flat;
	f32 r2_step = object && lesser ? r->r2_step : r->flat_step;
	r->weight_step = r2_step * filter->fall + TS_MARGIN_ROUNDING;
	r->peak_margin = TS_MARGIN_NOWHERE;
}

TS_FN ts_nearly_there ts_k_nearly_there(const ts_surfel_margin_args *args, const ts_camera_k *view,
                                        const ts_nearly *surfel, i32 x, i32 y)
{
	ts_nearly_there r;
	ts_v2 d = ts_k_disc_offset(&surfel->disc, x, y);
	r.is = ts_k_surfel_fragment(&surfel->disc, &args->filter, view->near, x, y);
	r.hit = ts_k_disc_hit(&surfel->disc, view->near, d.x, d.y);
	ts_k_nearly_hit(&r, surfel, d);
	if (args->filter.filter == TS_FILTER_EWA) {
		ts_k_nearly_gaussian(&r, &args->filter, surfel, d);
	} else {
		ts_k_nearly_radius(&r, &args->filter, surfel, d);
	}
	return r;
}

/* The margins of r3D against 1, and of the depth against the near plane: the lesser if the fragment is inside,
 * otherwise the greater of those that keep it out. */
TS_FN f32 ts_k_inside_margin(const ts_nearly_there *there, f32 near)
{
	const ts_disc_hit *hit = &there->hit;
	if (!hit->meets) return TS_MARGIN_NOWHERE;
	f32 rim = ts_abs(hit->r2 - 1.0f) / there->r2_step;
	f32 before = ts_abs(hit->z - near) / there->z_step;
	if (hit->inside) return ts_min(rim, before);
	return ts_max(hit->r2 > 1.0f ? rim : 0.0f, hit->z < near ? before : 0.0f);
}

/* The change in depth that a step makes to the nearest surfel of a pixel. */
TS_FN f32 ts_k_nearest_step(const ts_surfel_margin_args *args, const ts_camera_k *view, u64 key, i32 x, i32 y)
{
	ts_nearly nearest = ts_k_nearly(args, view, (u32)key);
	return ts_k_nearly_there(args, view, &nearest, x, y).z_step;
}

TS_FN void ts_k_least_step(TS_GLOBAL u64 *least, f32 margin)
{
	if (margin <= TS_MARGIN_REACH) ts_min_u64(least, (u64)ts_f2u(ts_put(margin)));
}

/* Margins of a pixel: the nearest surfel may drop out, another may come in or be as near. */
TS_FN void ts_k_surfel_depth_margin_pixel(const ts_surfel_margin_args *args, const ts_camera_k *view, u32 i,
                                          const ts_nearly *surfel, i32 x, i32 y)
{
	/* See whether the surfel covers the pixel, and whether it is the nearest there. */
	u64 pixel = (u64)y * (u64)view->width + (u64)x;
	u64 key = args->keys[pixel];
	ts_nearly_there there = ts_k_nearly_there(args, view, surfel, x, y);
	f32 rim = ts_k_inside_margin(&there, view->near);
	bool shows = surfel->drawn && there.hit.inside;
	bool nearest = key != TS_EMPTY && (u32)key == i;
	/* Find how near the surfel is to covering the pixel, or to not covering it. */
	f32 comes = ts_max(there.hit.inside ? 0.0f : rim, surfel->drawn ? 0.0f : surfel->fate);
	f32 turns = shows ? ts_min(rim, surfel->fate) : comes;
	if (!shows && turns > TS_MARGIN_REACH) return;
	/* Find how far it lies behind the nearest surfel; far behind it changes nothing. */
	f32 z = there.hit.z + ts_k_pixel_shift(view, args->epsilon[0], x, y);
	f32 behind = key == TS_EMPTY || nearest ? 0.0f : z - ts_u2f((u32)(key >> 32));
	if (behind > z * TS_MARGIN_NEAR) return;
	/* Measure this distance in steps of both depths. */
	f32 step = there.z_step + z * TS_MARGIN_ROUNDING;
	if (behind > 0.0f) step = step + ts_k_nearest_step(args, view, key, x, y);
	f32 tie = ts_max(behind, 0.0f) / step;
	/* Lower the pixel's margins: for surfels that may come or go, and for another depth that may be the nearest. */
	if (nearest || (!shows && tie <= 1.0f)) ts_k_least_step(&args->margin[pixel * 2u], turns);
	if (!nearest && shows) ts_k_least_step(&args->margin[pixel * 2u + 1u], tie);
}

/* scatter over surfels */
TS_FN void ts_k_surfel_depth_margin_item(const ts_surfel_margin_args *args, u64 i)
{
	ts_camera_k view = ts_k_view(args->view);
	ts_nearly surfel = ts_k_nearly(args, &view, (u32)i);
	for (i32 y = surfel.disc.low[1]; y <= surfel.disc.high[1]; y++) {
		for (i32 x = surfel.disc.low[0]; x <= surfel.disc.high[0]; x++) {
			ts_k_surfel_depth_margin_pixel(args, &view, (u32)i, &surfel, x, y);
		}
	}
}

/* The tests of a surfel at a pixel: each with its decision and its margin in steps; for the depth, that of the centre
 * and that of the ray. */
typedef struct {
	bool inside, covers, before[2];
	f32 inside_margin, covers_margin, before_margin[2];
} ts_blend_tests;

/* The margin of a depth, whose step is `step`, against the depth that the visibility pass allows. */
TS_FN f32 ts_k_before_margin(const ts_surfel_margin_args *args, const ts_camera_k *view, f32 z, f32 step, i32 x, i32 y)
{
	u64 key = args->keys[(u64)y * (u64)view->width + (u64)x];
	f32 limit = ts_u2f((u32)(key >> 32));
	if (key == TS_EMPTY || ts_abs(z - limit) > limit * TS_MARGIN_NEAR) return TS_MARGIN_NOWHERE;
	f32 both = step + ts_k_nearest_step(args, view, key, x, y);
	return ts_abs(z - limit) / (both + limit * TS_MARGIN_ROUNDING);
}

TS_FN ts_blend_tests ts_k_blend_tests(const ts_surfel_margin_args *args, const ts_camera_k *view,
                                      const ts_nearly *surfel, const ts_nearly_there *there, i32 x, i32 y)
{
	/* Find whether the screen filter or exact EWA applies, and whether the pixel is within it. */
	ts_blend_tests r;
	u64 key = args->keys[(u64)y * (u64)view->width + (u64)x];
	bool ewa = args->filter.filter == TS_FILTER_EWA;
	bool filtered = ewa ? surfel->disc.peak > 0.0f : ts_k_has_screen(&surfel->disc, &args->filter);
	bool within = there->flat <= 1.0f;
	f32 of_flat = there->flat_step > 0.0f ? ts_abs(there->flat - 1.0f) / there->flat_step : TS_MARGIN_NOWHERE;
	/* Set the test of r3D. */
	r.inside = there->hit.inside;
	r.inside_margin = ts_k_inside_margin(there, view->near);
	/* Set the test of r2D or of exact EWA: it holds by the least margin of its parts, or fails by the greatest of those
	 * that fail. */
	r.covers = filtered && within;
	r.covers_margin = r.covers ? ts_min(of_flat, there->peak_margin)
	                           : ts_max(within ? 0.0f : of_flat, filtered ? 0.0f : there->peak_margin);
	/* Set the test of the depth for the centre and for the ray; r3D decides which of the two counts. */
	r.before[0] = ts_k_is_visible(&args->filter, key, surfel->disc.depth);
	r.before_margin[0] = ts_k_before_margin(args, view, surfel->disc.depth, surfel->deep, x, y);
	r.before[1] = ts_k_is_visible(&args->filter, key, there->hit.z);
	r.before_margin[1] = ts_k_before_margin(args, view, there->hit.z, there->z_step, x, y);
	return r;
}

/* Whether the surfel is blended if the tests in `turned` are decided otherwise: 1 stands for the test of r3D, 2 for
 * that of r2D or exact EWA, 4 for that of the depth. *margin becomes the greatest margin of those tests. */
TS_FN bool ts_k_is_blended(const ts_filter *filter, const ts_blend_tests *tests, u32 turned, f32 *margin)
{
	bool inside = tests->inside != ((turned & 1u) != 0u);
	bool flat = tests->covers != ((turned & 2u) != 0u);
	u32 k = inside ? 1u : 0u;
	bool before = tests->before[k] != ((turned & 4u) != 0u);
	bool of_object = filter->filter == TS_FILTER_MIN || filter->filter == TS_FILTER_OBJECT;
	f32 most = (turned & 1u) != 0u ? tests->inside_margin : 0.0f;
	most = ts_max(most, (turned & 2u) != 0u ? tests->covers_margin : 0.0f);
	*margin = ts_max(most, (turned & 4u) != 0u ? tests->before_margin[k] : 0.0f);
	return before && ((inside && of_object) || (flat && filter->filter != TS_FILTER_OBJECT));
}

/* How near the surfel is to being blended if it is not, or to being left out if it is. */
TS_FN f32 ts_k_blended_margin(const ts_filter *filter, const ts_nearly *surfel, const ts_blend_tests *tests)
{
	f32 margin;
	bool blended = surfel->drawn && ts_k_is_blended(filter, tests, 0u, &margin);
	f32 least = blended ? surfel->fate : TS_MARGIN_NOWHERE;
	for (u32 turned = 0u; turned < 8u; turned++) {
		if (ts_k_is_blended(filter, tests, turned, &margin) == blended) continue;
		least = ts_min(least, surfel->drawn ? margin : ts_max(margin, surfel->fate));
	}
	return least;
}

/* Distance of the surfel's weight below that of the heaviest, in steps. */
TS_FN f32 ts_k_weight_margin(const ts_surfel_margin_args *args, const ts_camera_k *view, const ts_nearly_there *there,
                             u64 heaviest, i32 x, i32 y)
{
	f32 most = ts_u2f(~(u32)(heaviest >> 32));
	f32 below = most - ts_k_fragment_weight(&there->is);
	if (below > most * TS_MARGIN_NEAR) return TS_MARGIN_NOWHERE;
	ts_nearly other = ts_k_nearly(args, view, (u32)heaviest);
	f32 step = ts_k_nearly_there(args, view, &other, x, y).weight_step + there->weight_step;
	return below / (most * step);
}

TS_FN void ts_k_blend_margin_pixel(const ts_surfel_margin_args *args, const ts_camera_k *view, u32 i,
                                   const ts_nearly *surfel, i32 x, i32 y)
{
	u64 pixel = (u64)y * (u64)view->width + (u64)x;
	u64 heaviest = args->heaviest[pixel];
	f32 margin;
	ts_nearly_there there = ts_k_nearly_there(args, view, surfel, x, y);
	ts_blend_tests tests = ts_k_blend_tests(args, view, surfel, &there, x, y);
	ts_k_least_step(&args->margin[pixel * 2u], ts_k_blended_margin(&args->filter, surfel, &tests));
	bool blended = surfel->drawn && ts_k_is_blended(&args->filter, &tests, 0u, &margin);
	if (!blended || heaviest == TS_EMPTY || (u32)heaviest == i) return;
	ts_k_least_step(&args->margin[pixel * 2u + 1u], ts_k_weight_margin(args, view, &there, heaviest, x, y));
}

/* scatter over surfels */
TS_FN void ts_k_surfel_blend_margin_item(const ts_surfel_margin_args *args, u64 i)
{
	ts_camera_k view = ts_k_view(args->view);
	ts_nearly surfel = ts_k_nearly(args, &view, (u32)i);
	for (i32 y = surfel.disc.low[1]; y <= surfel.disc.high[1]; y++) {
		for (i32 x = surfel.disc.low[0]; x <= surfel.disc.high[0]; x++) {
			ts_k_blend_margin_pixel(args, &view, (u32)i, &surfel, x, y);
		}
	}
}

#endif
