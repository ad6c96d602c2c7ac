/* Density of the points from the resolution of the off-screen views (iVIR section 3.1, eqs 2 and 3; METHODS 9), and
 * that of VIR: s = max_v sqrt(1 / A_P(v)) samples per world unit over the views v that may see the triangle, A_P the
 * area on the triangle that one pixel of v covers: z^3 / (f^2 h) at axial depth z, h the distance of v from the
 * plane. */
#ifndef TS_KERNELS_POINTS_VIEW_DENSITY_H
#define TS_KERNELS_POINTS_VIEW_DENSITY_H
#include "kernels/points/density.h"
#include "kernels/raster/clip.h"
#include "kernels/raster/offscreen.h"

/* Rates: by which each texel whose centre sees the triangle gets a sample (watertight); at the least depth of the part
 * in the frustum (exact); at the point closest to the view (the paper); VIR's worst case. */
#define TS_RATE_EYE 0u /* EPR: see density.h */
#define TS_RATE_WATERTIGHT 1u
#define TS_RATE_EXACT 2u
#define TS_RATE_PAPER 3u
#define TS_RATE_VIR 4u

#define TS_LEAST_COSINE 0.001000000047497451305389404296875f /* between the normal and the way to the view */

/* Samples per world unit, and the ratio of the needs at both ends of the triangle. */
typedef struct {
	f32 s, uneven;
} ts_need;

/* f sqrt(h / z^3) = sqrt(1 / A_P) at a point p of the plane with the unit normal n. */
TS_FN f32 ts_k_pixel_rate(const ts_camera_k *view, ts_v3 n, ts_v3 p, f32 z)
{
	ts_v3 way = ts_sub(view->eye, p);
	f32 h = ts_max(ts_abs(ts_dot(n, way)), ts_length(way) * TS_LEAST_COSINE);
	return (view->focal / z) * ts_sqrt(ts_flush(h / z));
}

/* sqrt(1 / A_P) of an orthographic view: A_P = 1 / (f^2 |cos|). */
TS_FN f32 ts_k_parallel_rate(const ts_camera_k *view, ts_v3 n, u32 rate)
{
	if (rate == TS_RATE_VIR) return view->focal;
	f32 cosine = ts_max(ts_abs(ts_dot(n, view->back)), TS_LEAST_COSINE);
	return view->focal * ts_sqrt(cosine);
}

/* The part of the triangle that lies in the frustum widened by a pixel on each side. */
TS_FN ts_polygon ts_k_in_frustum(const ts_camera_k *view, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_polygon r = ts_k_polygon(view, a, b, c);
	ts_k_clip_to_sides(view, &r, (f32)view->width * 0.5f + 1.0f, (f32)view->height * 0.5f + 1.0f);
	return r;
}

#define TS_ROUNDING 9.5367431640625e-7f /* 2^-20 of the largest coordinate: bound of a sample's rounding error */

/* The greatest absolute coordinate. */
TS_FN f32 ts_k_largest(ts_v3 p) { return ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z)); }

/* Every texel whose centre sees a triangle at p gets a sample of the triangle, if the lattice's spacing is a <= 1 /
 * (sqrt(2) most), where `most` is the greatest number of pixels per world unit. Proof: the nearest sample q of the
 * lattice is within a / sqrt(2) of p. Its square contains p, so q is emitted. Moved to the closest point of the
 * triangle, which is convex, q comes no farther from p. The way from p to q lies in the triangle, so in the image it is
 * no longer than most a / sqrt(2) <= 1/2, and q is in p's texel. The proof does not hold within near / (2 f) of the
 * near plane, where q may lie before the plane; without `points.snap`; for pieces that `cull` drops; and for capped
 * densities. A reserve of 1/64 covers rounding in the image; another covers the rounding of samples, up to a quarter of
 * a pixel. */
TS_FN f32 ts_k_watertight_rate(const ts_camera_k *view, f32 most, ts_v3 a, ts_v3 b, ts_v3 c)
{
	f32 largest = ts_max(ts_k_largest(view->eye), ts_max(ts_k_largest(a), ts_max(ts_k_largest(b), ts_k_largest(c))));
	f32 moved = ts_min(most * (largest * TS_ROUNDING), 0.25f);
	return (most * 1.43631064891815185546875f) / (1.0f - 2.0f * moved); /* sqrt(2) 65/64 */
}

/* Pixels per world unit: the largest singular value from the plane to the image, at most f d / z^2 = f (1/z) (d/z).
 * Each of the two factors is greatest at a corner, but their product need not be; so the product of the greatest
 * factors is taken. */
TS_FN ts_need ts_k_watertight(const ts_camera_k *view, const ts_polygon *polygon, ts_v3 a, ts_v3 b, ts_v3 c)
{
	f32 nearest = 0.0f;
	f32 widest = 0.0f;
	f32 least = 0.0f;
	for (u32 k = 0u; k < polygon->n; k++) {
		/* Take both factors and their product at each corner. */
		const ts_corner *p = &polygon->corner[k];
		f32 over_z = 1.0f / ts_max(p->z, view->near);
		f32 d = ts_length(ts_v3_make(p->x, p->y, p->z)) * over_z;
		f32 here = over_z * d;
		nearest = ts_max(nearest, over_z);
		widest = ts_max(widest, d);
		least = k == 0u ? here : ts_min(least, here);
	}
	/* Bound the product by the greatest factors, and compare with the least product. */
	f32 most = nearest * widest;
	ts_need r;
	r.s = ts_k_watertight_rate(view, view->focal * most, a, b, c);
	r.uneven = least > 0.0f ? most / least : 1.0f;
	return r;
}

/* The rate of the part of a triangle that lies in the frustum: watertight, or at the least depth of the part. */
TS_FN ts_need ts_k_clipped_rate(const ts_camera_k *view, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c, u32 rate)
{
	/* Clip to the frustum; what lies outside needs no samples. */
	ts_polygon polygon = ts_k_in_frustum(view, a, b, c);
	ts_need r;
	r.s = 0.0f;
	r.uneven = 1.0f;
	if (polygon.n == 0u) return r;
	if (rate == TS_RATE_WATERTIGHT) return ts_k_watertight(view, &polygon, a, b, c);
	/* Find the nearest corner, the first on ties. */
	f32 z = polygon.corner[0].z;
	u32 nearest = 0u;
	for (u32 k = 1u; k < polygon.n; k++) {
		nearest = polygon.corner[k].z < z ? k : nearest;
		z = ts_min(z, polygon.corner[k].z);
	}
	/* Take the area of a pixel there (iVIR 3.1, eq. 2). */
	ts_v3 p = ts_blend(polygon.corner[nearest].w, a, b, c);
	r.s = ts_k_pixel_rate(view, n, p, ts_max(z, view->near));
	return r;
}

/* The rate at the point q closest to the view. If q lies beside the image or behind the view, where there are no
 * pixels, it counts as if in the image's corner. VIR reads only the distance of q: the depth is taken to be that of a
 * point at this distance in the middle of the farther border. */
TS_FN f32 ts_k_closest_rate(const ts_camera_k *view, const f32 reach[2], ts_v3 n, ts_v3 q, u32 rate)
{
	f32 corner = 1.0f + (reach[0] * reach[0] + reach[1] * reach[1]); /* 1 / cos^2 */
	f32 distance = ts_max(ts_length(ts_sub(q, view->eye)), view->near);
	if (rate == TS_RATE_VIR) {
		f32 farther = ts_max(reach[0], reach[1]);
		return (view->focal * ts_sqrt(1.0f + farther * farther)) / distance;
	}
	f32 least = ts_max(distance / ts_sqrt(corner), view->near);
	return ts_k_pixel_rate(view, n, q, ts_max(ts_k_to_view(view, q).z, least));
}

/* The density that view v needs, at the rate of args->rate. */
TS_CALL ts_need ts_k_one_view_density(const ts_density_args *args, u32 v, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Assume the same need all over the triangle; only watertight rates vary. */
	TS_GLOBAL const ts_offscreen *offscreen = &args->views[v];
	ts_camera_k view = ts_k_offscreen(offscreen);
	ts_need r;
	r.uneven = 1.0f;
	if (view.orthographic != 0u) {
		/* Take the one rate of an orthographic view, whose pixels cover the same area everywhere. */
		bool watertight = args->rate == TS_RATE_WATERTIGHT;
		r.s = watertight ? ts_k_watertight_rate(&view, view.focal, a, b, c) : ts_k_parallel_rate(&view, n, args->rate);
	} else if (args->rate < TS_RATE_PAPER) {
		/* Take the rate of the part that lies in the frustum. */
		r = ts_k_clipped_rate(&view, n, a, b, c, args->rate);
	} else {
		/* Take the rate at the point closest to the view, as the papers do. */
		f32 reach[2];
		reach[0] = offscreen->reach[0];
		reach[1] = offscreen->reach[1];
		r.s = ts_k_closest_rate(&view, reach, n, ts_k_closest_on_triangle(view.eye, a, b, c), args->rate);
	}
	return r;
}

/* The largest need of the views of [first, end) whose bits in `words` are set; 0 if there is none. */
TS_FN ts_need ts_k_views_density(const ts_density_args *args, TS_GLOBAL const u64 *words, u32 first, u32 end, ts_v3 a,
                                 ts_v3 b, ts_v3 c)
{
	ts_v3 n = ts_normalize(ts_cross(ts_sub(b, a), ts_sub(c, a)));
	ts_need r;
	r.s = 0.0f;
	r.uneven = 1.0f;
	for (u32 v = first; v < end; v++) {
		if (!ts_k_offscreen_bit(words, v)) continue;
		ts_need one = ts_k_one_view_density(args, v, n, a, b, c);
		r = one.s > r.s ? one : r;
	}
	return r;
}

/* The largest need of all views that may see the triangle. */
TS_FN ts_need ts_k_view_density(const ts_density_args *args, TS_GLOBAL const u64 *words, ts_v3 a, ts_v3 b, ts_v3 c)
{
	return ts_k_views_density(args, words, 0u, args->n_views, a, b, c);
}

#endif
