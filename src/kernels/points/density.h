/* Density of the points from the eye's resolution (EPR section 4.1.1, eqs 2 and 3; METHODS 2): s = min(rho f_e / min_r
 * d_r, max_r f_r / d_rt) samples per world unit over the reflectors r that may see the triangle. */
#ifndef TS_KERNELS_POINTS_DENSITY_H
#define TS_KERNELS_POINTS_DENSITY_H
#include "kernels/base/area.h"
#include "kernels/base/args.h"
#include "kernels/base/closest.h"
#include "kernels/raster/visibility.h"

#define TS_ROWS_ts_density_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, bits, visibility_bits) \
	ARG(OUT, f32, whole, split_triangle_density) \
	ARG(OUT, u32, offset, split_offset) /* pieces before each triangle: counts, then their prefix sums */ \
	ARG(OUT, ts_piece, pieces, split_piece) \
	ARG(OUT, f32, scale, split_density) \
	ARG(TALLY, i64, n_capped, 0)  /* pieces whose density was lowered at the end of splitting */ \
	ARG(TALLY, i64, n_limited, 1) /* triangles whose density the densest cube limits */ \
	ARG(VALUE, f32, rho, none)    /* samples per pixel side */ \
	ARG(VALUE, u32, n_cubes, none) \
	ARG(VALUE, u32, n_words, none) \
	ARG(VALUE, u32, paper, none) \
	ARG(VALUE, u32, cap, none)      /* not 0: the densest cube limits the density */ \
	ARG(VALUE, u32, greatest, none) /* side of the cubes that limit the density; 0: each cube's own */ \
	ARG(VALUE, u32, offaxis, none) \
	ARG(VALUE, u32, ball, none) \
	ARG(VALUE, u32, split, none) \
	ARG(IN_OPT, ts_offscreen, views, offscreen_view) /* their resolution counts; NULL: the eye's */ \
	ARG(VALUE, u32, n_views, none) \
	ARG(VALUE, u32, rate, none)   /* TS_RATE_* of view_density.h */ \
	ARG(VALUE, u32, shadow, none) /* TS_SHADOW_* of shadow_density.h: the eye limits the density */
TS_ARGS(ts_density_args);

#define TS_LEAST_AXIAL 0.015625f /* least cosine off the eye's axis: 2^-6 */

/* Length of the shortest way of light from the triangle to the eye by the ball of a reflector. */
TS_FN f32 ts_k_path_length(ts_v3 eye, ts_v3 centre, f32 radius, ts_v3 a, ts_v3 b, ts_v3 c, bool paper)
{
	/* Go straight to the eye from inside the ball. */
	if (ts_length(ts_sub(eye, centre)) <= radius) return ts_length(ts_sub(eye, ts_k_closest_on_triangle(eye, a, b, c)));
	/* Begin at the circumcentre (the paper), or at the triangle's point closest to the ball. */
	ts_v3 t = paper ? ts_k_circumcentre(a, b, c) : ts_k_closest_on_triangle(centre, a, b, c);
	ts_v3 cp = t;
	for (u32 step = 0u; step < 2u; step++) {
		/* Find cp, the ball's point closest to the line from t to the eye (EPR 4.1.1). */
		ts_v3 near = ts_k_closest_on_segment(centre, t, eye);
		ts_v3 out = ts_sub(near, centre);
		f32 distance = ts_length(out);
		bool meets = distance <= radius;
		if (meets && (paper || step == 1u)) return ts_length(ts_sub(eye, t));
		cp = meets ? near : ts_mad(centre, out, radius / distance);
		/* Stop there (the paper), or move t once to the triangle's point closest to cp. */
		if (paper) break;
		if (step == 0u) t = ts_k_closest_on_triangle(cp, a, b, c);
	}
	/* Add both parts of the way: d_er + d_rt (EPR 4.1.1, eq. 2). */
	return ts_length(ts_sub(eye, cp)) + ts_length(ts_sub(cp, t));
}

/* The length that a ball adds to the way. A ball turns the normal by w / R over a width of w, and the ray by twice
 * that. So a beam that is one wide at a distance of one from the eye is d_er + d_rt + 2 d_er d_rt / R wide on the
 * triangle, where the ray meets the ball head on. Where it meets the ball at a cosine c, the last term is divided by c
 * one way across the ray and multiplied by c the other way. Since c + 1 / c >= 2, the product of the two widths is
 * least head on. */
TS_FN f32 ts_k_ball_spread(f32 radius, f32 to_eye, f32 to_triangle)
{
	f32 from_eye = ts_max(to_eye - radius, 0.0f);
	f32 from_triangle = ts_max(to_triangle - radius, 0.0f);
	return ts_flush((2.0f * from_eye) * (from_triangle / radius));
}

/* Samples per world unit on a triangle, and whether the densest cube limits them. */
typedef struct {
	f32 s;
	u32 limited;
} ts_eye_density;

/* The density of triangle a b c, which the reflectors in `words` may see; 0 if there is none. */
TS_FN ts_eye_density ts_k_density(const ts_density_args *args, TS_GLOBAL const u64 *words, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_camera_k view = ts_k_view(args->view);
	f32 shortest = 0.0f;
	f32 densest = 0.0f;
	bool any = false;
	for (u32 r = 0u; r < args->n_cubes; r++) {
		if (ts_k_cube_bits(words, r) == 0u) continue;
		TS_GLOBAL const ts_face *cube = &args->cubes[r];
		ts_v3 centre = ts_load3(cube->centre);
		/* Keep both distances at R/1024 at least, since they are divisors. */
		f32 least = ts_flush(cube->radius * TS_NEAR_OF_RADIUS);
		f32 to_triangle = ts_length(ts_sub(ts_k_closest_on_triangle(centre, a, b, c), centre));
		/* Measure the light's way to the eye, with the variants for balls and off the axis. */
		f32 way = ts_k_path_length(view.eye, centre, cube->radius, a, b, c, args->paper != 0u);
		f32 distance = ts_length(ts_sub(centre, view.eye));
		if (args->ball != 0u && cube->radius > 0.0f) way = way + ts_k_ball_spread(cube->radius, distance, to_triangle);
		if (args->offaxis != 0u) {
			ts_corner p = ts_k_to_view(&view, centre);
			bool ahead = p.z > 0.0f && distance > 0.0f; /* behind the eye there are no pixels */
			way = way * ts_clamp(ahead ? p.z / distance : 1.0f, TS_LEAST_AXIAL, 1.0f);
		}
		/* Keep the shortest way (EPR 4.1.1, eq. 3) and the densest cube. */
		way = ts_max(way, least);
		u32 side = args->greatest != 0u ? args->greatest : cube->n;
		f32 need = ((f32)side * 0.5f) / ts_max(to_triangle, least);
		shortest = any ? ts_min(shortest, way) : way;
		densest = any ? ts_max(densest, need) : need;
		any = true;
	}
	ts_eye_density d;
	/* Sample at the eye's rate, at most at that of the densest cube (EPR 3.2). */
	d.s = any ? (args->rho * view.focal) / shortest : 0.0f;
	d.limited = args->cap != 0u && densest < d.s ? 1u : 0u;
	d.s = d.limited != 0u ? densest : d.s;
	return d;
}

#endif
