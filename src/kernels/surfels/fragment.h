/* Fragments of surfels (NV40: Approximate EWA Filtering; METHODS 16, FIGURES 12):
 *     r3D = sqrt(a a + b b),  r2D = |d| / sigma,  r = min(r3D, r2D),  w = exp(-1/2 (r / ewa.sigma_k)^2) where r <= 1,
 * d the offset of the pixel's middle from the projected centre. Exact EWA weighs by the peak times exp(-1/2 d V^-1 d),
 * where d V^-1 d <= 4. Where r3D > 1 a fragment has the depth of the centre,
 * since its ray meets the plane outside the surfel. */
#ifndef TS_KERNELS_SURFELS_FRAGMENT_H
#define TS_KERNELS_SURFELS_FRAGMENT_H
#include "kernels/surfels/surfel_setup.h"

typedef struct {
	f32 z;        /* axial depth */
	f32 exponent; /* the weight is peak e^-exponent */
	f32 peak;
	bool inside; /* r3D <= 1 */
	bool covers; /* the surfel has a fragment here */
} ts_surfel_fragment;

/* The place where the ray at an offset meets the surfel's plane, if it does in front of the eye; r2 is r3D squared. */
typedef struct {
	f32 a, b, r2, z;
	bool meets, inside;
} ts_disc_hit;

TS_FN ts_disc_hit ts_k_disc_hit(const ts_disc *disc, f32 near, f32 dx, f32 dy)
{
	/* Find where the ray meets the plane: in front of the eye if 1 + G.d is above 0 (NV40: Perspectively Correct
	 * Rendering). */
	ts_disc_hit r;
	bool parallel = (disc->flags & TS_DISC_PARALLEL) != 0u;
	f32 tilt = disc->g[0] * dx + disc->g[1] * dy;
	f32 divisor = parallel ? 1.0f : 1.0f + tilt;
	r.meets = divisor > 0.0f && (disc->flags & TS_DISC_FLAT) == 0u;
	/* Find the plane coordinates by one division; about the farthest point, add the coordinates of that point. */
	bool crosses = (disc->flags & TS_DISC_CROSSES) != 0u;
	f32 inverse = 1.0f / (r.meets ? divisor : 1.0f);
	r.a = (disc->a[0] * dx + disc->a[1] * dy) * inverse + (crosses ? disc->conic[0] : 0.0f);
	r.b = (disc->b[0] * dx + disc->b[1] * dy) * inverse + (crosses ? disc->conic[1] : 0.0f);
	/* Find r3D^2 and the depth; inside the ellipse and beyond the near plane, the surfel covers the pixel. */
	r.r2 = r.a * r.a + r.b * r.b;
	r.z = disc->depth * (parallel ? 1.0f - tilt : inverse);
	r.inside = r.meets && r.r2 <= 1.0f && r.z >= near;
	return r;
}

TS_FN ts_v2 ts_k_disc_offset(const ts_disc *disc, i32 x, i32 y)
{
	return ts_v2_make((f32)(x - disc->pixel[0]) - disc->fraction[0], (f32)(y - disc->pixel[1]) - disc->fraction[1]);
}

/* The fragment of exact EWA. */
TS_FN void ts_k_fragment_gaussian(ts_surfel_fragment *r, const ts_disc *disc, ts_v2 d)
{
	f32 xx = disc->conic[0] * (d.x * d.x);
	f32 xy = disc->conic[1] * (d.x * d.y);
	f32 yy = disc->conic[2] * (d.y * d.y);
	f32 q = (xx + 2.0f * xy) + yy;
	r->covers = q <= 4.0f && disc->peak > 0.0f;
	r->exponent = 0.5f * q;
	r->peak = disc->peak;
}

TS_FN bool ts_k_has_screen(const ts_disc *disc, const ts_filter *filter)
{
	bool crosses = (disc->flags & TS_DISC_CROSSES) != 0u;
	return filter->per_sigma2 > 0.0f && filter->filter != TS_FILTER_OBJECT && !crosses;
}

/* The fragment of approximate EWA, or of one of its two filters. */
TS_FN void ts_k_fragment_radius(ts_surfel_fragment *r, const ts_disc *disc, const ts_filter *filter,
                                const ts_disc_hit *hit, ts_v2 d)
{
	bool object = hit->inside && filter->filter != TS_FILTER_SCREEN;
	f32 screen2 = (d.x * d.x + d.y * d.y) * filter->per_sigma2;
	bool screen = ts_k_has_screen(disc, filter) && screen2 <= 1.0f;
	f32 r2 = object ? hit->r2 : screen2;
	r2 = object && screen ? ts_min(hit->r2, screen2) : r2;
	r->covers = object || screen;
	r->exponent = r2 * filter->fall;
	r->peak = 1.0f;
}

TS_FN ts_surfel_fragment ts_k_surfel_fragment(const ts_disc *disc, const ts_filter *filter, f32 near, i32 x, i32 y)
{
	ts_surfel_fragment r;
	ts_v2 d = ts_k_disc_offset(disc, x, y);
	ts_disc_hit hit = ts_k_disc_hit(disc, near, d.x, d.y);
	if (filter->filter == TS_FILTER_EWA) {
		ts_k_fragment_gaussian(&r, disc, d);
	} else {
		ts_k_fragment_radius(&r, disc, filter, &hit, d);
	}
	r.inside = hit.inside;
	r.z = hit.inside ? hit.z : disc->depth;
	return r;
}

TS_FN f32 ts_k_fragment_weight(const ts_surfel_fragment *fragment)
{
	return fragment->peak * ts_exp(-fragment->exponent);
}

/* X and Y of the ray through a pixel's middle at depth 1; 0 in orthographic views. */
TS_FN ts_v2 ts_k_pixel_way(const ts_camera_k *view, i32 x, i32 y)
{
	f32 i = ((f32)x + 0.5f) - (f32)view->width * 0.5f;
	f32 j = (f32)view->height * 0.5f - ((f32)y + 0.5f);
	bool parallel = view->orthographic != 0u;
	return ts_v2_make(parallel ? 0.0f : i / view->focal, parallel ? 0.0f : j / view->focal);
}

/* The axial depth of a length epsilon along the ray through a pixel's middle. */
TS_FN f32 ts_k_pixel_shift(const ts_camera_k *view, f32 epsilon, i32 x, i32 y)
{
	ts_v2 q = ts_k_pixel_way(view, x, y);
	return epsilon / ts_sqrt((1.0f + q.x * q.x) + q.y * q.y);
}

#endif
