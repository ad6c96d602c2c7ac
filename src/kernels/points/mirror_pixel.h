/* Reflective pixels of the eye: the surface, and its change to the neighbouring pixels (EPR section 4.1.3; METHODS 2).
 * Gradients are central differences inside the same object, one-sided at its border, otherwise 0. Differences are taken
 * from pixel to pixel; for several samples per pixel, across the square that a sample stands for. */
#ifndef TS_KERNELS_POINTS_MIRROR_PIXEL_H
#define TS_KERNELS_POINTS_MIRROR_PIXEL_H
#include "kernels/base/args.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"

#define TS_ROWS_ts_mirror_pixel_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(OUT, u32, offset, mirror_pixel_offset) /* counts, then their prefix sums */ \
	ARG(OUT, ts_pixel, pixels, mirror_pixel_record) \
	ARG(VALUE, u32, samples, none) /* of a pixel */
TS_ARGS(ts_mirror_pixel_args);

TS_FN u32 ts_k_seen_reflector(const ts_arrays *scene, u64 key)
{
	return key == TS_EMPTY ? TS_NONE : ts_k_reflector_of(scene, (u32)key);
}

/* map over pixels and their samples: 1 where a reflector is seen */
TS_FN void ts_k_mirror_pixel_count_item(const ts_mirror_pixel_args *args, u64 i)
{
	args->offset[i] = ts_k_seen_reflector(&args->scene, args->depth_triangle[i]) != TS_NONE ? 1u : 0u;
}

typedef struct {
	ts_v3 p, n;
	bool seen;
} ts_glance;

/* The surface that the eye sees beside a sample's pixel, if it is on the given reflector. The normal is turned to the
 * viewer. */
TS_FN ts_glance ts_k_glance(const ts_mirror_pixel_args *args, const ts_eye_place *at, i32 right, i32 down,
                            u32 reflector)
{
	/* Find the pixel; outside the image nothing is seen. */
	const ts_camera_k *view = &at->view;
	i32 x = at->x + right;
	i32 y = at->y + down;
	ts_glance r;
	r.seen = false;
	r.p = ts_v3_make(0.0f, 0.0f, 0.0f);
	r.n = r.p;
	if (x < 0 || y < 0 || x >= view->width || y >= view->height) return r;
	/* Leave out a pixel that shows no reflector, or another. */
	u64 key = args->depth_triangle[at->first + (u64)y * (u64)view->width + (u64)x];
	if (ts_k_seen_reflector(&args->scene, key) != reflector) return r;
	/* Compute the surface at the pixel's centre again, without its material. */
	u32 triangle = (u32)key;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	ts_fragment f = ts_k_fragment_at(view, &t, x, y);
	ts_sample s = ts_k_sample(&args->scene, triangle, f.w, t.n, ts_k_fragment_footprint(view, &t, &f));
	ts_surface surface = ts_k_surface_geometry(&args->scene, &s, t.n);
	/* Turn the normal to the viewer. */
	r.seen = true;
	r.p = surface.p;
	r.n = ts_k_facing_normal(&surface, ts_sub(view->eye, surface.p));
	return r;
}

/* The change from pixel to pixel: half the central difference, or a one-sided difference, or 0. */
TS_FN ts_v3 ts_k_gradient(ts_v3 before, bool has_before, ts_v3 here, ts_v3 after, bool has_after, f32 side)
{
	if (has_before && has_after) return ts_scale(ts_sub(after, before), 0.5f * side);
	if (has_after) return ts_scale(ts_sub(after, here), side);
	if (has_before) return ts_scale(ts_sub(here, before), side);
	return ts_v3_make(0.0f, 0.0f, 0.0f);
}

/* A pixel and its neighbours. */
#define TS_HERE 0u
#define TS_LEFT 1u
#define TS_RIGHT 2u
#define TS_ABOVE 3u
#define TS_BELOW 4u
#define TS_N_GLANCES 5u

TS_FN void ts_k_pixel_gradients(TS_GLOBAL ts_pixel *out, const ts_glance glance[TS_N_GLANCES], f32 side)
{
	ts_glance here = glance[TS_HERE], left = glance[TS_LEFT], right = glance[TS_RIGHT];
	ts_glance above = glance[TS_ABOVE], below = glance[TS_BELOW];
	ts_store3(out->position_dx, ts_k_gradient(left.p, left.seen, here.p, right.p, right.seen, side));
	ts_store3(out->normal_dx, ts_k_gradient(left.n, left.seen, here.n, right.n, right.seen, side));
	ts_store3(out->position_dy, ts_k_gradient(above.p, above.seen, here.p, below.p, below.seen, side));
	ts_store3(out->normal_dy, ts_k_gradient(above.n, above.seen, here.n, below.n, below.seen, side));
}

/* Writes the record of element i. tint: the surface's base colour; side: side of the square that a sample stands for,
 * in pixels. */
TS_FN void ts_k_mirror_pixel_write(const ts_mirror_pixel_args *args, u64 i, const ts_glance glance[TS_N_GLANCES],
                                   ts_v3 tint, f32 side)
{
	TS_GLOBAL ts_pixel *out = &args->pixels[args->offset[i]];
	ts_store3(out->position, glance[TS_HERE].p);
	ts_store3(out->normal, glance[TS_HERE].n);
	out->index = (u32)i;
	out->reflector = ts_k_seen_reflector(&args->scene, args->depth_triangle[i]);
	out->tint_r = ts_put(tint.x);
	out->tint_g = ts_put(tint.y);
	out->tint_b = ts_put(tint.z);
	out->pad = 0u;
	ts_k_pixel_gradients(out, glance, side);
}

/* emit over pixels and their samples */
TS_FN void ts_k_mirror_pixel_item(const ts_mirror_pixel_args *args, u64 i)
{
	if (args->offset[i + 1u] == args->offset[i]) return;
	ts_eye_place at = ts_k_eye_place(args->view, args->samples, i);
	u32 reflector = ts_k_seen_reflector(&args->scene, args->depth_triangle[i]);
	ts_glance glance[TS_N_GLANCES];
	for (u32 k = 0u; k < TS_N_GLANCES; k++) {
		i32 right = k == TS_RIGHT ? 1 : k == TS_LEFT ? -1 : 0;
		i32 down = k == TS_BELOW ? 1 : k == TS_ABOVE ? -1 : 0;
		glance[k] = ts_k_glance(args, &at, right, down, reflector);
	}
	ts_v3 tint = ts_k_surface_seen(&args->scene, &at.view, (u32)args->depth_triangle[i], at.x, at.y).base;
	ts_k_mirror_pixel_write(args, i, glance, tint, at.view.side);
}

#endif
