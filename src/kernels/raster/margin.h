/* Margins: how near each decision was to another answer, for ports that may decide otherwise (PORTING 7). Margin stages
 * are a second pass and change no decision. Standard rasterization has two: the distance of a pixel's centre from the
 * edges that matter there, and the distance of the winning depth from the depth that nearly won. */
#ifndef TS_KERNELS_RASTER_MARGIN_H
#define TS_KERNELS_RASTER_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"
#include "kernels/raster/margin_bounds.h"

/* Two minima per pixel, as f32 bits: the distance to an edge, in 1/256 pixel along the axes; and how far another depth
 * lies behind, in units of the change of both depths per such step in the image. In maps of depths alone the triangle
 * of the winning depth is not known: the unit is the change of the other depth, since a depth that comes no nearer than
 * the winner cannot replace it. */
#define TS_ROWS_ts_margin_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN_OPT, ts_view, view, eye_view) /* of the eye */ \
	ARG(IN_OPT, ts_face, cubes, cube_size_face) \
	ARG(IN_OPT, ts_offscreen, views, offscreen_view) \
	ARG(IN_OPT, u64, depth_triangle, none) /* what was decided: keys, or depths alone */ \
	ARG(IN_OPT, u32, depths, depth_map_depth) \
	ARG(MIN, u64, margin, none) /* [2] per pixel */ \
	ARG(VALUE, u32, first_unit, none) \
	ARG(VALUE, u32, n_units, none) /* the batch: cubes, or views */ \
	ARG(VALUE, u32, samples, none) /* of a pixel of the eye */
TS_ARGS(ts_margin_args);

/* The decision at a pixel. ts_k_is_other is true for every other triangle; in maps of depths alone, for every other
 * depth. */
typedef struct {
	f32 z;
	u32 triangle;
	bool is_empty, is_known;
} ts_shown;

TS_FN ts_shown ts_k_shown(const ts_margin_args *args, u64 pixel)
{
	u64 key = args->depth_triangle != NULL ? args->depth_triangle[pixel] : (u64)args->depths[pixel] << 32;
	ts_shown r;
	r.is_known = args->depth_triangle != NULL;
	r.is_empty = (u32)(key >> 32) == TS_NONE;
	r.triangle = (u32)key;
	r.z = r.is_empty ? 0.0f : ts_u2f((u32)(key >> 32));
	return r;
}

TS_FN bool ts_k_is_other(const ts_shown *shown, u32 triangle, f32 z)
{
	if (shown->is_empty) return false;
	return shown->is_known ? shown->triangle != triangle : shown->z != z;
}

/* Least distance to an edge line, positive inside: |E| / (|dx| + |dy|). */
TS_FN f32 ts_k_edge_distance(const ts_setup *t, const ts_edges *e)
{
	f32 least = 0.0f;
	for (u32 k = 0u; k < 3u; k++) {
		ts_snapped a = t->v[k == 2u ? 0u : k + 1u];
		ts_snapped b = t->v[k == 0u ? 2u : k - 1u];
		i32 dx = b.x - a.x;
		i32 dy = b.y - a.y;
		f32 d = (f32)e->e[k] / (f32)((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
		least = k == 0u ? d : ts_min(least, d);
	}
	return least;
}

/* Twice the change of the depth z per step of 1/256 pixel in x and in y: z^2 |grad(1/z)|, orthographic |grad z|. The
 * factor is two because the corners may step apart. */
TS_FN f32 ts_k_depth_step(const ts_camera_k *view, const ts_setup *t, const ts_corner *a, const ts_corner *b,
                          const ts_corner *c, f32 z)
{
	bool parallel = view->orthographic != 0u;
	const ts_corner *corner[3];
	corner[0] = a;
	corner[1] = b;
	corner[2] = c;
	/* Add up the gradient of 1 / z, or of z in an orthographic view, from the three corners. */
	f32 area = (f32)t->area;
	f32 x = 0.0f;
	f32 y = 0.0f;
	for (u32 k = 0u; k < 3u; k++) {
		ts_snapped p = t->v[k == 2u ? 0u : k + 1u];
		ts_snapped q = t->v[k == 0u ? 2u : k - 1u];
		f32 own = corner[t->from[k]]->z;
		f32 over = parallel ? area / own : area * own;
		x = x - (f32)(q.y - p.y) / over;
		y = y + (f32)(q.x - p.x) / over;
	}
	/* Turn the gradient into a step of z, since dz = -z^2 d(1 / z). */
	return (parallel ? 2.0f : 2.0f * (z * z)) * (ts_abs(x) + ts_abs(y));
}

/* ts_k_depth_step of a triangle at a pixel, on the triangle of its fan that covers the pixel; 0: none does. */
TS_FN f32 ts_k_depth_step_at(const ts_arrays *scene, const ts_camera_k *view, u32 triangle, i32 i, i32 j)
{
	/* Clip as the drawing did. */
	ts_corners t = ts_k_corners(scene, triangle);
	ts_polygon polygon = ts_k_polygon(view, t.a, t.b, t.c);
	ts_k_clip_to_range(view, &polygon);
	for (u32 k = 2u; k < polygon.n; k++) {
		/* Set up the triangle of the fan. */
		const ts_corner *a = &polygon.corner[0];
		const ts_corner *b = &polygon.corner[k - 1u];
		const ts_corner *c = &polygon.corner[k];
		ts_setup setup = ts_k_setup(ts_k_snap_corner(view, a), ts_k_snap_corner(view, b), ts_k_snap_corner(view, c));
		if (setup.area == 0) continue;
		/* Return the step of the triangle that covers the pixel's centre. */
		ts_edges e = ts_k_edges(&setup, i * TS_SUB_PIXELS + TS_SUB_CENTRE, j * TS_SUB_PIXELS + TS_SUB_CENTRE);
		if (ts_k_covers(&setup, &e)) {
			return ts_k_depth_step(view, &setup, a, b, c, ts_k_view_fragment(view, &setup, &e, a, b, c).z);
		}
	}
	return 0.0f;
}

/* A triangle near a pixel's centre. */
typedef struct {
	u32 triangle;
	i32 x, y;
	ts_fragment f;
	f32 footprint, distance, step;
} ts_near;

/* Sets the distance to 0 where the alpha is near its cutoff. Returns whether the mask leaves the fragment. */
TS_FN bool ts_k_margin_mask(const ts_arrays *scene, const ts_corners *t, ts_near *near)
{
	ts_sample s = ts_k_sample(scene, near->triangle, near->f.w, t->n, near->footprint);
	if ((s.material->flags & TS_MASKED) == 0u) return true;
	f32 above = ts_k_alpha(scene, &s) - s.material->alpha_cutoff;
	near->distance = above < TS_MARGIN_ALPHA ? 0.0f : near->distance;
	return above > -TS_MARGIN_ALPHA;
}

/* Offers a triangle's two margins at a pixel that it is near to. */
TS_FN void ts_k_margin_pixel(const ts_arrays *scene, const ts_camera_k *view, const ts_corners *t, ts_near *near,
                             ts_shown shown, TS_GLOBAL u64 *margin)
{
	/* Leave out a triangle so far behind that it cannot matter. */
	if (!(near->f.z > 0.0f)) return;
	bool other = ts_k_is_other(&shown, near->triangle, near->f.z);
	f32 behind = other ? near->f.z - shown.z : 0.0f;
	if (behind > 4.0f * near->step + near->f.z * TS_MARGIN_NEAR || !ts_k_margin_mask(scene, t, near)) return;
	/* Measure how far the triangle is behind: in steps of both depths, plus rounding. */
	f32 apart = 0.0f;
	if (other) {
		f32 step = near->step;
		if (shown.is_known) step = step + ts_k_depth_step_at(scene, view, shown.triangle, near->x, near->y);
		apart = ts_max(behind, 0.0f) / (step + near->f.z * TS_MARGIN_ROUNDING);
	}
	/* Offer the distance to an edge if a step may bring the triangle to the front, and how far behind a triangle is
	 * that covers the centre. */
	if (apart <= 1.0f) ts_min_u64(&margin[0], (u64)ts_f2u(ts_put(ts_abs(near->distance))));
	if (other && near->distance >= 0.0f) ts_min_u64(&margin[1], (u64)ts_f2u(ts_put(apart)));
}

/* Visits the pixels near one triangle of the fan of a clipped polygon. */
TS_FN void ts_k_margin_fan(const ts_margin_args *args, const ts_camera_k *view, const ts_corners *t, u32 triangle,
                           const ts_corner *a, const ts_corner *b, const ts_corner *c, u64 first)
{
	ts_snapped v[3];
	/* Set the triangle up as ts_k_draw_fan does. */
	v[0] = ts_k_snap_corner(view, a);
	v[1] = ts_k_snap_corner(view, b);
	v[2] = ts_k_snap_corner(view, c);
	ts_setup setup = ts_k_setup(v[0], v[1], v[2]);
	if (setup.area == 0) return;
	/* Visit the triangle's box, grown by the 4 sub-pixels of TS_MARGIN_REACH. */
	ts_box box = ts_k_box_meet(ts_k_touched_box(v, 3u, 4), ts_k_view_box(view));
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			/* Leave out pixels farther outside the triangle than that. */
			ts_edges e = ts_k_edges(&setup, i * TS_SUB_PIXELS + TS_SUB_CENTRE, j * TS_SUB_PIXELS + TS_SUB_CENTRE);
			f32 distance = ts_k_edge_distance(&setup, &e);
			if (distance < -TS_MARGIN_REACH) continue;
			ts_near near;
			/* Describe the triangle at the pixel. */
			near.triangle = triangle;
			near.x = i;
			near.y = j;
			near.f = ts_k_view_fragment(view, &setup, &e, a, b, c);
			near.footprint = ts_k_fragment_footprint(view, t, &near.f);
			near.distance = distance;
			near.step = ts_k_depth_step(view, &setup, a, b, c, near.f.z);
			/* Compare the triangle with what the pixel shows. */
			u64 pixel = first + (u64)j * (u64)view->width + (u64)i;
			ts_k_margin_pixel(&args->scene, view, t, &near, ts_k_shown(args, pixel), args->margin + pixel * 2u);
		}
	}
}

/* Visits the pixels near a triangle, as ts_k_draw clips it. first: first texel of the view. */
TS_FN void ts_k_margin_draw(const ts_margin_args *args, const ts_camera_k *view, const ts_corners *t, u32 triangle,
                            u64 first)
{
	ts_polygon polygon = ts_k_polygon(view, t->a, t->b, t->c);
	if (ts_k_is_outside(view, &polygon)) return;
	ts_k_clip_to_range(view, &polygon);
	for (u32 k = 2u; k < polygon.n; k++) {
		ts_k_margin_fan(args, view, t, triangle, &polygon.corner[0], &polygon.corner[k - 1u], &polygon.corner[k],
		                first);
	}
}

/* scatter over triangles, for each sample of the pixels, as ts_k_eye_item */
TS_FN void ts_k_eye_margin_item(const ts_margin_args *args, u64 i)
{
	u32 triangle = (u32)(i % args->scene.n_triangles);
	u32 sample = (u32)(i / args->scene.n_triangles);
	ts_camera_k view = ts_k_eye_view(args->view, args->samples, sample);
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (ts_k_is_degenerate(t.n) || !ts_k_is_facing(&args->scene, triangle, &t, view.eye)) return;
	ts_k_margin_draw(args, &view, &t, triangle, (u64)sample * (u64)args->view->width * (u64)args->view->height);
}

/* scatter over triangles, as ts_k_cube_face_item */
TS_FN void ts_k_cube_face_margin_item(const ts_margin_args *args, u64 i)
{
	/* Drop a triangle without area. */
	u32 triangle = (u32)i;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (args->n_units == 0u || ts_k_is_degenerate(t.n)) return;
	u64 first_texel = args->cubes[args->first_unit].offset;
	for (u32 r = args->first_unit; r < args->first_unit + args->n_units; r++) {
		/* Visit the faces of the cubes that may show the triangle. */
		TS_GLOBAL const ts_face *cube = &args->cubes[r];
		if (!ts_k_may_show(&args->scene, cube, triangle, &t)) continue;
		for (u32 face = 0u; face < 6u; face++) {
			ts_camera_k view = ts_k_cube_view(cube, face);
			ts_k_margin_draw(args, &view, &t, triangle, cube->offset - first_texel + (u64)face * cube->n * cube->n);
		}
	}
}

/* scatter over triangles, as ts_k_depth_map_item */
TS_FN void ts_k_depth_map_margin_item(const ts_margin_args *args, u64 i)
{
	u32 triangle = (u32)i;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (args->n_units == 0u || ts_k_is_degenerate(t.n)) return;
	u64 first_texel = args->views[args->first_unit].offset;
	for (u32 v = args->first_unit; v < args->first_unit + args->n_units; v++) {
		TS_GLOBAL const ts_offscreen *offscreen = &args->views[v];
		if (!ts_k_offscreen_may_show(&args->scene, offscreen, triangle, &t)) continue;
		ts_camera_k view = ts_k_offscreen(offscreen);
		ts_k_margin_draw(args, &view, &t, triangle, offscreen->offset - first_texel);
	}
}

#endif
