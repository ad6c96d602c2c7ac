/* A surfel in a view (NV40: Perspectively Correct Rendering; METHODS 16): the map from a pixel to the plane coordinates
 * (a, b) and the depth at which its ray meets the surfel, the box of pixels that the surfel may cover, and the Gaussian
 * of exact EWA.
 *
 * The map from pixels to (a, b) is projective. About the projected centre, with d the pixel's offset from there,
 *     (a, b) = (A.d, B.d) / (1 + G.d),    depth = depth of the centre / (1 + G.d),
 * where rows A and B are the inverse of the Jacobian J of the projection at the centre, and G = -(u_z A + v_z B) / c_z.
 * In an orthographic view (a, b) is not divided, and depth = depth of the centre (1 - G.d). However small the surfel is
 * in the image, no term cancels: the centre is kept as a pixel and a fraction of a pixel, from products without
 * rounding. View space is X, Y and the axial depth z; y grows downward in the image.
 *
 * Bounds: offsets along an axis are J_a a + J_b b over 1 + (u_z a + v_z b) / c_z with a a + b b <= 1. Their extremes
 * are the roots of A x^2 - 2 B x + C = 0, A = 1 - U.U, B = -J.U, C = -J.J, with U = (u_z, v_z) / c_z. If A <= 0 the
 * surfel reaches the eye's plane, and may cover the whole image.
 *
 * For a surfel that crosses the near plane with its centre before the plane, the farthest point takes the place of the
 * centre, and the (a, b) of that point are added. The centre then has no image, so the screen filter does not apply. */
#ifndef TS_KERNELS_SURFELS_SURFEL_SETUP_H
#define TS_KERNELS_SURFELS_SURFEL_SETUP_H
#include "kernels/base/args.h"
#include "kernels/raster/view.h"

#define TS_FILTER_MIN 0u    /* r = min(r3D, r2D) */
#define TS_FILTER_OBJECT 1u /* r3D */
#define TS_FILTER_SCREEN 2u /* r2D */
#define TS_FILTER_EWA 3u    /* exact */

#define TS_DISC_FLAT 1u     /* seen from the side: no footprint of its own */
#define TS_DISC_PARALLEL 2u /* of an orthographic view */
#define TS_DISC_CROSSES 4u  /* about its farthest point, whose (a, b) are in `conic` */
#define TS_LEAST_SLANT 0.0000009999999974752427078783512115478515625f /* 1e-6 */
#define TS_FARTHEST_PIXEL 1048576.0f
#define TS_A_LITTLE 0.0625f /* pixels */
#define TS_A_LITTLE_MORE 1.0009765625f

typedef struct {
	u32 filter;     /* TS_FILTER_* */
	u32 botsch;     /* not 0: bounds are a square of half side r f / z */
	u32 opens;      /* ewa.outline=filter */
	f32 per_sigma2; /* 1 / sigma^2, sigma the radius of the screen filter in pixels; 0: there is none */
	f32 reach;      /* the greater of sigma and half the least side of a box, pixels */
	f32 fall;       /* 1 / (2 ewa.sigma_k^2) */
	f32 object2;    /* ewa.sigma_k^2 */
	f32 screen2;    /* ewa.sigma_h^2 of exact EWA */
} ts_filter;

/* Whether a surfel is drawn, or why not. */
#define TS_DISC_DRAWN 0u
#define TS_DISC_TURNED 1u /* the surfel turns its back */
/* The surfel is before the near plane. Exact EWA, and the screen filter alone, ask only for its centre; exact EWA also
 * leaves out a surfel that reaches the eye's plane. */
#define TS_DISC_BEFORE 2u
#define TS_DISC_BESIDE 3u /* the surfel is beside the image */

/* A float as the sum of two floats of 12 bits (Veltkamp 1968); 4097 is 2^12 + 1. */
TS_FN ts_v2 ts_k_halves(f32 a)
{
	f32 scaled = 4097.0f * a;
	f32 rest = scaled - a;
	f32 high = scaled - rest;
	return ts_v2_make(high, a - high);
}

/* a b = x + y without rounding (Dekker 1971), where the size of the product is above 2^-76, so that no part is
 * denormal. */
TS_FN ts_v2 ts_k_product(f32 a, f32 b)
{
	ts_v2 p = ts_k_halves(a);
	ts_v2 q = ts_k_halves(b);
	f32 x = a * b;
	f32 high = p.x * q.x;
	f32 y = high - x;
	f32 left = p.x * q.y;
	y = y + left;
	f32 right = p.y * q.x;
	y = y + right;
	f32 low = p.y * q.y;
	return ts_v2_make(x, y + low);
}

/* f c / z - k, where k is near f c / z and a plain difference would cancel: (f c - k z) / z with exact products. */
TS_FN f32 ts_k_beyond(f32 f, f32 c, f32 z, f32 k)
{
	ts_v2 p = ts_k_product(f, c);
	ts_v2 q = ts_k_product(k, z);
	f32 high = p.x - q.x;
	f32 low = p.y - q.y;
	return (high + low) / z;
}

/* Least and greatest offset of the ellipse along an axis of the image: the roots above, with c for -C. */
TS_FN ts_v2 ts_k_extent(f32 j_a, f32 j_b, f32 u, f32 v)
{
	f32 a = (1.0f - u * u) - v * v;
	if (!(a > 0.0f)) return ts_v2_make(-TS_FARTHEST_PIXEL, TS_FARTHEST_PIXEL);
	f32 b = -(j_a * u + j_b * v);
	f32 c = j_a * j_a + j_b * j_b;
	f32 root = ts_sqrt(ts_flush(b * b + a * c));
	return ts_v2_make((b - root) / a, (b + root) / a);
}

/* The surfel's axes and their images. */
typedef struct {
	ts_corner c;        /* the centre in view space, or the farthest point */
	f32 a, b;           /* plane coordinates of c */
	bool crosses;       /* c is the farthest point */
	ts_v3 u, v;         /* axes in view space */
	f32 z;              /* the divisor; orthographic: 1 */
	f32 xa, xb, ya, yb; /* J */
} ts_disc_frame;

TS_FN ts_v3 ts_k_view_axis(const ts_camera_k *view, ts_v3 d)
{
	return ts_v3_make(ts_dot(view->right, d), ts_dot(view->up, d), -ts_dot(view->back, d));
}

/* The derivative of f X / z along the axis: f (X' z - X z') / z^2. */
TS_FN f32 ts_k_slope(f32 f, f32 axis, f32 z, f32 centre, f32 axis_z)
{
	f32 across = ts_diff_of_products(axis, z, centre, axis_z);
	return ((f * across) / z) / z;
}

/* Sets the images of the axes at c. */
TS_FN void ts_k_disc_slopes(ts_disc_frame *r, const ts_camera_k *view)
{
	bool parallel = view->orthographic != 0u;
	r->z = parallel ? 1.0f : r->c.z;
	f32 uz = parallel ? 0.0f : r->u.z;
	f32 vz = parallel ? 0.0f : r->v.z;
	r->xa = ts_k_slope(view->focal, r->u.x, r->z, r->c.x, uz);
	r->xb = ts_k_slope(view->focal, r->v.x, r->z, r->c.x, vz);
	r->ya = -ts_k_slope(view->focal, r->u.y, r->z, r->c.y, uz);
	r->yb = -ts_k_slope(view->focal, r->v.y, r->z, r->c.y, vz);
}

/* Moves c from a centre before the near plane to the farthest point of the surfel, for the filters that can use that
 * point: the ellipse alone, or the minimum of both radii. That point has (a, b) = (u_z, v_z) / |(u_z, v_z)|. */
TS_FN void ts_k_disc_cross(ts_disc_frame *r, const ts_filter *filter)
{
	f32 deeper = ts_sqrt(ts_flush(r->u.z * r->u.z + r->v.z * r->v.z));
	r->crosses = filter->filter < TS_FILTER_SCREEN && deeper > 0.0f;
	if (!r->crosses) return;
	r->a = r->u.z / deeper;
	r->b = r->v.z / deeper;
	r->c.x = r->c.x + (r->a * r->u.x + r->b * r->v.x);
	r->c.y = r->c.y + (r->a * r->u.y + r->b * r->v.y);
	r->c.z = r->c.z + deeper;
}

TS_FN ts_disc_frame ts_k_disc_frame(const ts_camera_k *view, const ts_filter *filter, TS_GLOBAL const ts_surfel *surfel)
{
	ts_disc_frame r;
	r.c = ts_k_to_view(view, ts_load3(surfel->centre));
	r.u = ts_k_view_axis(view, ts_load3(surfel->u));
	r.v = ts_k_view_axis(view, ts_load3(surfel->v));
	r.a = r.b = 0.0f;
	r.crosses = false;
	if (r.c.z < view->near) ts_k_disc_cross(&r, filter);
	ts_k_disc_slopes(&r, view);
	return r;
}

/* Cosine between the normal and the direction to the eye; if it is not above 0, the surfel turns its back. */
TS_FN f32 ts_k_disc_slant(const ts_camera_k *view, ts_v3 centre, ts_v3 n)
{
	ts_v3 way = view->orthographic != 0u ? view->back : ts_normalize(ts_sub(view->eye, centre));
	return ts_flush(ts_dot(n, way));
}

/* Sets the pixel of the projected centre, and the offset of the centre from that pixel's middle. */
TS_FN void ts_k_disc_place(ts_disc *disc, const ts_camera_k *view, const ts_disc_frame *frame)
{
	f32 half_width = (f32)view->width * 0.5f;
	f32 half_height = (f32)view->height * 0.5f;
	disc->pixel[0] = ts_floor_i32(half_width + (view->focal * frame->c.x) / frame->z);
	disc->pixel[1] = ts_floor_i32(half_height - (view->focal * frame->c.y) / frame->z);
	f32 i = ((f32)disc->pixel[0] + 0.5f) - half_width;
	f32 j = ((f32)disc->pixel[1] + 0.5f) - half_height;
	disc->fraction[0] = ts_put(ts_k_beyond(view->focal, frame->c.x, frame->z, i));
	disc->fraction[1] = ts_put(ts_k_beyond(view->focal, -frame->c.y, frame->z, j));
	disc->depth = ts_put(frame->c.z);
}

/* Sets A, B and G. G has the depth of c in orthographic views, too, where the divisor z of J is 1. */
TS_FN void ts_k_disc_map(ts_disc *disc, const ts_disc_frame *f)
{
	f32 det = ts_flush(ts_diff_of_products(f->xa, f->yb, f->xb, f->ya));
	disc->flags = disc->flags | (det == 0.0f ? TS_DISC_FLAT : 0u);
	bool flat = (disc->flags & TS_DISC_FLAT) != 0u;
	disc->a[0] = flat ? 0.0f : ts_put(f->yb / det);
	disc->a[1] = flat ? 0.0f : ts_put(-f->xb / det);
	disc->b[0] = flat ? 0.0f : ts_put(-f->ya / det);
	disc->b[1] = flat ? 0.0f : ts_put(f->xa / det);
	f32 uz = f->u.z / f->c.z;
	f32 vz = f->v.z / f->c.z;
	disc->g[0] = ts_put(-(uz * disc->a[0] + vz * disc->b[0]));
	disc->g[1] = ts_put(-(uz * disc->a[1] + vz * disc->b[1]));
}

/* Sets the inverse of V = ewa.sigma_k^2 J J^T + ewa.sigma_h^2 I, and the peak |det(ewa.sigma_k J)| / sqrt(det V). */
TS_FN void ts_k_disc_gaussian(ts_disc *disc, const ts_filter *filter, const ts_disc_frame *f)
{
	f32 xx = filter->object2 * (f->xa * f->xa + f->xb * f->xb) + filter->screen2;
	f32 xy = filter->object2 * (f->xa * f->ya + f->xb * f->yb);
	f32 yy = filter->object2 * (f->ya * f->ya + f->yb * f->yb) + filter->screen2;
	f32 det = ts_flush(ts_diff_of_products(xx, yy, xy, xy));
	bool none = filter->filter != TS_FILTER_EWA || !(det > 0.0f);
	f32 d = none ? 1.0f : det;
	f32 area = filter->object2 * ts_abs(ts_diff_of_products(f->xa, f->yb, f->xb, f->ya));
	disc->conic[0] = none ? 0.0f : ts_put(yy / d);
	disc->conic[1] = none ? 0.0f : ts_put(-xy / d);
	disc->conic[2] = none ? 0.0f : ts_put(xx / d);
	disc->peak = none ? 0.0f : ts_put(ts_min(area / ts_sqrt(d), 1.0f));
}

/* Sets the pixels along an axis whose middles are from `least` to `most` of the centre, at least `room` to both sides,
 * and a little more for rounding. The low side is rounded up, by -floor(-x), and the high side down. */
TS_FN void ts_k_disc_side(ts_disc *disc, u32 axis, f32 least, f32 most, f32 room, i32 n)
{
	f32 before = ts_min(least, -room) * TS_A_LITTLE_MORE - TS_A_LITTLE;
	f32 behind = ts_max(most, room) * TS_A_LITTLE_MORE + TS_A_LITTLE;
	f32 from = ts_clamp(before + disc->fraction[axis], -TS_FARTHEST_PIXEL, TS_FARTHEST_PIXEL);
	f32 to = ts_clamp(behind + disc->fraction[axis], -TS_FARTHEST_PIXEL, TS_FARTHEST_PIXEL);
	disc->low[axis] = ts_max_i32(disc->pixel[axis] - ts_floor_i32(-from), 0);
	disc->high[axis] = ts_min_i32(disc->pixel[axis] + ts_floor_i32(to), n - 1);
}

/* The extent of exact EWA along an axis: twice ewa.sigma_k of the ellipse, plus twice ewa.sigma_h. */
TS_FN ts_v2 ts_k_blurred(const ts_filter *filter, ts_v2 ellipse, f32 j_a, f32 j_b, f32 u, f32 v)
{
	f32 s = 2.0f * ts_sqrt(filter->object2);
	f32 room = 2.0f * ts_sqrt(filter->screen2);
	ts_v2 wide = ts_k_extent(s * j_a, s * j_b, s * u, s * v);
	return ts_v2_make(ts_min(ellipse.x, wide.x - room), ts_max(ellipse.y, wide.y + room));
}

/* The square of how near the ellipse, or twice ewa.sigma_k of it, comes to the eye's plane: from 1 on it reaches the
 * plane, and no affine approximation exists. */
TS_FN f32 ts_k_disc_closeness(const ts_disc_frame *f, const ts_filter *filter)
{
	f32 uz = f->u.z / f->c.z;
	f32 vz = f->v.z / f->c.z;
	return (uz * uz + vz * vz) * ts_max(4.0f * filter->object2, 1.0f);
}

/* The extent along an axis, from c's image, of a surfel that crosses the near plane: of its coordinates in view, at
 * depths from near to that of c. Rows get c, u and v negated, since y grows downward in the image. */
TS_FN ts_v2 ts_k_crossing(const ts_camera_k *view, const ts_disc_frame *f, f32 c, f32 u, f32 v)
{
	f32 reach = ts_sqrt(ts_flush(u * u + v * v)) * TS_A_LITTLE_MORE;
	f32 middle = c - (f->a * u + f->b * v);
	f32 low = middle - reach;
	f32 high = middle + reach;
	bool parallel = view->orthographic != 0u;
	f32 least = low / (parallel ? 1.0f : low < 0.0f ? view->near : f->z);
	f32 most = high / (parallel ? 1.0f : high > 0.0f ? view->near : f->z);
	f32 from = c / f->z;
	return ts_v2_make(view->focal * (least - from), view->focal * (most - from));
}

TS_FN void ts_k_disc_box(ts_disc *disc, const ts_camera_k *view, const ts_filter *filter, const ts_disc_frame *f)
{
	/* Find the slopes of depth, which are 0 in orthographic views, and the square of the slides. */
	f32 uz = view->orthographic != 0u ? 0.0f : f->u.z / f->z;
	f32 vz = view->orthographic != 0u ? 0.0f : f->v.z / f->z;
	f32 radius = ts_sqrt(ts_max(ts_flush(ts_dot(f->u, f->u)), ts_flush(ts_dot(f->v, f->v))));
	f32 square = (radius * view->focal) / f->z;
	bool flat = (disc->flags & TS_DISC_FLAT) != 0u;
	/* Bound the ellipse, or take that square (NV40: Perspectively Correct Rendering). */
	ts_v2 x = ts_k_extent(f->xa, f->xb, uz, vz);
	ts_v2 y = ts_k_extent(f->ya, f->yb, uz, vz);
	if (filter->botsch != 0u) x = y = ts_v2_make(-square, square);
	/* Bound the part beyond the near plane of a surfel that crosses the plane, whichever bounds are chosen; without a
	 * footprint only the room of the screen filter is left. */
	if (f->crosses) {
		x = ts_k_crossing(view, f, f->c.x, f->u.x, f->v.x);
		y = ts_k_crossing(view, f, -f->c.y, -f->u.y, -f->v.y);
	}
	if (flat) x = y = ts_v2_make(0.0f, 0.0f);
	/* Widen the bounds for exact EWA. */
	if (filter->filter == TS_FILTER_EWA) {
		x = ts_k_blurred(filter, x, f->xa, f->xb, uz, vz);
		y = ts_k_blurred(filter, y, f->ya, f->yb, uz, vz);
	}
	/* Convert the bounds to pixels of the image. */
	ts_k_disc_side(disc, 0u, x.x, x.y, filter->reach, view->width);
	ts_k_disc_side(disc, 1u, y.x, y.y, filter->reach, view->height);
}

TS_FN void ts_k_disc_clear(ts_disc *disc)
{
	for (u32 k = 0u; k < 2u; k++) {
		disc->pixel[k] = 0;
		disc->fraction[k] = 0.0f;
		disc->a[k] = disc->b[k] = disc->g[k] = 0.0f;
		disc->low[k] = 0;
		disc->high[k] = -1;
	}
	for (u32 k = 0u; k < 3u; k++) disc->conic[k] = disc->normal[k] = 0.0f;
	disc->depth = disc->peak = 0.0f;
	disc->flags = disc->pad = 0u;
}

TS_FN bool ts_k_disc_is_near(const ts_disc *disc)
{
	f32 x = ts_abs((f32)disc->pixel[0]);
	f32 y = ts_abs((f32)disc->pixel[1]);
	return x < TS_FARTHEST_PIXEL && y < TS_FARTHEST_PIXEL;
}

TS_FN ts_v3 ts_k_disc_normal(TS_GLOBAL const ts_surfel *surfel)
{
	return ts_normalize(ts_cross(ts_load3(surfel->u), ts_load3(surfel->v)));
}

/* Fills a disc, which is clear, with a surfel that is in front of the eye and faces it. Returns TS_DISC_DRAWN or
 * TS_DISC_BESIDE. */
TS_FN u32 ts_k_disc_make(ts_disc *disc, const ts_camera_k *view, const ts_filter *filter, const ts_disc_frame *frame,
                         ts_v3 n, f32 slant)
{
	/* Set the flags and the normal; with a cosine below 1e-6 the surfel has no footprint of its own. */
	bool parallel = view->orthographic != 0u;
	disc->flags = (slant < TS_LEAST_SLANT ? TS_DISC_FLAT : 0u) | (parallel ? TS_DISC_PARALLEL : 0u);
	disc->flags = disc->flags | (frame->crosses ? TS_DISC_CROSSES : 0u);
	disc->normal[0] = ts_put(n.x);
	disc->normal[1] = ts_put(n.y);
	disc->normal[2] = ts_put(n.z);
	/* Set the projected centre, the map to the plane, and the Gaussian of exact EWA. */
	ts_k_disc_place(disc, view, frame);
	ts_k_disc_map(disc, frame);
	ts_k_disc_gaussian(disc, filter, frame);
	/* Keep (a, b) of the farthest point in `conic`, which is free, since exact EWA draws no such surfel. */
	if (frame->crosses) {
		disc->conic[0] = ts_put(frame->a);
		disc->conic[1] = ts_put(frame->b);
	}
	/* Set the box, unless the centre is 2^20 pixels off or more; then the box stays empty. */
	if (ts_k_disc_is_near(disc)) ts_k_disc_box(disc, view, filter, frame);
	/* Clear the disc if its box is empty. */
	bool drawn = disc->low[0] <= disc->high[0] && disc->low[1] <= disc->high[1];
	if (!drawn) ts_k_disc_clear(disc);
	return drawn ? TS_DISC_DRAWN : TS_DISC_BESIDE;
}

/* Returns one of TS_DISC_*. A surfel that is not drawn has an empty box, and its other fields are 0. */
TS_FN u32 ts_k_disc(ts_disc *disc, const ts_camera_k *view, const ts_filter *filter, TS_GLOBAL const ts_surfel *surfel)
{
	/* Leave out a surfel that turns its back, or is seen from the side. */
	ts_v3 n = ts_k_disc_normal(surfel);
	f32 slant = ts_k_disc_slant(view, ts_load3(surfel->centre), n);
	ts_k_disc_clear(disc);
	if (!(slant > 0.0f)) return TS_DISC_TURNED;
	/* Leave out a surfel before the near plane; one that crosses the plane has its farthest point tested. */
	ts_disc_frame frame = ts_k_disc_frame(view, filter, surfel);
	if (!(frame.c.z >= view->near)) return TS_DISC_BEFORE;
	/* Leave out a surfel of which exact EWA has no affine approximation. */
	bool parallel = view->orthographic != 0u;
	bool affine = parallel || filter->filter != TS_FILTER_EWA || ts_k_disc_closeness(&frame, filter) < 1.0f;
	if (!affine) return TS_DISC_BEFORE;
	return ts_k_disc_make(disc, view, filter, &frame, n, slant);
}

#define TS_ROWS_ts_surfel_setup_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_surfel, surfels, scene_surfel) \
	ARG(OUT, ts_disc, discs, surfel_setup_disc) \
	ARG(TALLY, i64, tally, 0) /* by TS_DISC_* */ \
	ARG(VALUE, ts_filter, filter, none)
TS_ARGS(ts_surfel_setup_args);

/* map over surfels */
TS_FN void ts_k_surfel_setup_item(const ts_surfel_setup_args *args, u64 i)
{
	ts_disc disc;
	ts_camera_k view = ts_k_view(args->view);
	u32 fate = ts_k_disc(&disc, &view, &args->filter, &args->surfels[i]);
	args->discs[i] = disc;
	ts_add_i64(&args->tally[fate], 1);
}

#endif
