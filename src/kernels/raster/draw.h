/* Draws triangles into a buffer of keys depth << 32 | triangle (the eye and MVR's cube faces), or of depths alone
 * (MVR's shadow maps). Standard rasterization, axial depth; of equal depths the lowest triangle wins (CONTRACT rules
 * 18, 22, 24). */
#ifndef TS_KERNELS_RASTER_DRAW_H
#define TS_KERNELS_RASTER_DRAW_H
#include "kernels/base/band.h"
#include "kernels/base/surface.h"
#include "kernels/raster/clip.h"
#include "kernels/raster/offscreen.h"
#include "kernels/raster/raster.h"
#include "kernels/raster/target.h"

/* Width, in world units, of the part of the triangle that the fragment's colour stands for. */
TS_FN f32 ts_k_fragment_footprint(const ts_camera_k *view, const ts_corners *t, const ts_fragment *fragment)
{
	if (view->orthographic != 0u) return ts_k_footprint(1.0f / view->focal, view->back, t->n);
	ts_v3 p = ts_blend(fragment->w, t->a, t->b, t->c);
	return ts_k_footprint((fragment->z / view->focal) * view->side, ts_sub(p, view->eye), t->n);
}

TS_FN ts_fragment ts_k_view_fragment(const ts_camera_k *view, const ts_setup *t, const ts_edges *e, const ts_corner *a,
                                     const ts_corner *b, const ts_corner *c)
{
	return view->orthographic != 0u ? ts_k_fragment_parallel(t, e, a, b, c) : ts_k_fragment(t, e, a, b, c);
}

/* Draws one triangle of the fan of a clipped polygon. A pixel on a diagonal of the fan belongs to one of two triangles,
 * as on any shared edge (CONTRACT rule 18). */
TS_FN void ts_k_draw_fan(const ts_arrays *scene, const ts_camera_k *view, const ts_corners *t, u32 triangle,
                         const ts_corner *a, const ts_corner *b, const ts_corner *c, const ts_band *band,
                         const ts_target *target)
{
	ts_snapped v[3];
	/* Snap the corners; a triangle without area covers nothing (CONTRACT rules 15, 17 and 18). */
	v[0] = ts_k_snap_corner(view, a);
	v[1] = ts_k_snap_corner(view, b);
	v[2] = ts_k_snap_corner(view, c);
	ts_setup setup = ts_k_setup(v[0], v[1], v[2]);
	if (setup.area == 0) return;
	/* Begin at the box's upper left pixel; a band takes some of the rows. */
	ts_box box = ts_k_box_meet(ts_k_touched_box(v, 3u, 0), ts_k_view_box(view));
	ts_walk walk = ts_k_walk(&setup, box.x0, box.y0 + band->first);
	for (u32 k = 0u; k < 3u; k++) walk.down[k] *= band->step;
	bool masked = ts_k_is_masked(scene, triangle);
	for (i32 j = box.y0 + band->first; j <= box.y1; j += band->step, ts_k_step(&walk.at, walk.down)) {
		/* Visit the row's pixels whose centres the triangle covers (CONTRACT rule 18). */
		ts_edges e = walk.at;
		for (i32 i = box.x0; i <= box.x1; i++, ts_k_step(&e, walk.right)) {
			if (!ts_k_walk_covers(&walk, &e)) continue;
			/* Interpolate, drop what the alpha mask cuts away, and offer the depth (CONTRACT rules 22 and 24). */
			ts_fragment f = ts_k_view_fragment(view, &setup, &e, a, b, c);
			if (masked && ts_k_is_cut(scene, triangle, f.w, t->n, ts_k_fragment_footprint(view, t, &f))) continue;
			ts_k_draw_texel(target, (u64)j * (u64)view->width + (u64)i, f.z, triangle);
		}
	}
}

/* Draws a band of the rows of one triangle, facing and not degenerate, into one view. */
TS_CALL void ts_k_draw(const ts_arrays *scene, const ts_camera_k *view, const ts_corners *t, u32 triangle,
                       const ts_band *band, const ts_target *target)
{
	ts_polygon polygon = ts_k_polygon(view, t->a, t->b, t->c);
	if (ts_k_is_outside(view, &polygon)) return;
	ts_k_clip_to_range(view, &polygon);
	for (u32 k = 2u; k < polygon.n; k++) {
		ts_k_draw_fan(scene, view, t, triangle, &polygon.corner[0], &polygon.corner[k - 1u], &polygon.corner[k], band,
		              target);
	}
}

/* The fragment of a triangle at a pixel that the triangle covers: the same bits as when it was drawn. */
TS_CALL ts_fragment ts_k_fragment_at(const ts_camera_k *view, const ts_corners *t, i32 i, i32 j)
{
	/* Clip as ts_k_draw does, so that the fan has the same bits. */
	ts_polygon polygon = ts_k_polygon(view, t->a, t->b, t->c);
	ts_k_clip_to_range(view, &polygon);
	ts_fragment r;
	/* Return depth 0 if no triangle of the fan covers the pixel. */
	r.z = 0.0f;
	r.w = ts_v3_make(1.0f, 0.0f, 0.0f);
	for (u32 k = 2u; k < polygon.n; k++) {
		/* Set up the triangle of the fan as ts_k_draw_fan does. */
		const ts_corner *a = &polygon.corner[0];
		const ts_corner *b = &polygon.corner[k - 1u];
		const ts_corner *c = &polygon.corner[k];
		ts_setup setup = ts_k_setup(ts_k_snap_corner(view, a), ts_k_snap_corner(view, b), ts_k_snap_corner(view, c));
		if (setup.area == 0) continue;
		/* Return the fragment of the triangle that covers the pixel's centre. */
		ts_edges e = ts_k_edges(&setup, i * TS_SUB_PIXELS + TS_SUB_CENTRE, j * TS_SUB_PIXELS + TS_SUB_CENTRE);
		if (ts_k_covers(&setup, &e)) return ts_k_view_fragment(view, &setup, &e, a, b, c);
	}
	return r;
}

/* ts_k_fragment_at for a triangle that may not be drawn there: z is 0 where the triangle does not cover the pixel's
 * centre, or its alpha mask cuts it away. */
TS_FN ts_fragment ts_k_fragment_drawn(const ts_arrays *scene, const ts_camera_k *view, u32 triangle, i32 i, i32 j)
{
	ts_corners t = ts_k_corners(scene, triangle);
	ts_fragment r = ts_k_fragment_at(view, &t, i, j);
	if (!(r.z > 0.0f) || !ts_k_is_masked(scene, triangle)) return r;
	if (ts_k_is_cut(scene, triangle, r.w, t.n, ts_k_fragment_footprint(view, &t, &r))) r.z = 0.0f;
	return r;
}

/* The surface of a triangle that a view sees at a pixel: the input of deferred shading. */
TS_FN ts_surface ts_k_surface_seen(const ts_arrays *scene, const ts_camera_k *view, u32 triangle, i32 x, i32 y)
{
	ts_corners t = ts_k_corners(scene, triangle);
	ts_fragment f = ts_k_fragment_at(view, &t, x, y);
	return ts_k_surface(scene, triangle, f.w, ts_k_fragment_footprint(view, &t, &f));
}

#endif
