/* The lattice of samples in the plane of a piece: its frame, the samples that the piece touches by the conservative
 * test, and the surface that a sample shows (EPR sections 3.2, 3.3; METHODS 2). */
#ifndef TS_KERNELS_RASTER_LATTICE_H
#define TS_KERNELS_RASTER_LATTICE_H
#include "kernels/base/area.h"
#include "kernels/base/closest.h"
#include "kernels/base/surface.h"
#include "kernels/raster/cover.h"

/* The lattice coordinates of a point p of the plane. */
TS_FN ts_v2 ts_k_lattice(ts_v3 c, ts_v3 u, ts_v3 v, f32 s, ts_v3 p)
{
	ts_v3 d = ts_sub(p, c);
	return ts_v2_make(s * ts_dot(u, d) + 0.5f, s * ts_dot(v, d) + 0.5f);
}

/* T_epr = S T_align moves a piece into its own plane, its centroid onto a sample, its longest edge along x (EPR section
 * 3.2, eq. 1). A corner p is at s (u.(p - c), v.(p - c)) + (1/2, 1/2), snapped to 24.8. */
TS_FN void ts_k_lattice_align(TS_GLOBAL const ts_piece *piece, f32 s, TS_GLOBAL ts_align *out)
{
	ts_v3 corner[3];
	corner[0] = ts_load3(piece->a);
	corner[1] = ts_load3(piece->b);
	corner[2] = ts_load3(piece->c);
	/* Lay u along the longest edge, and v across it in the plane: T_align of EPR 3.2, eq. 1. */
	f32 length;
	u32 edge = ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
	ts_v3 u = ts_normalize(ts_sub(corner[edge == 2u ? 0u : edge + 1u], corner[edge]));
	ts_v3 n = ts_normalize(ts_cross(ts_sub(corner[1], corner[0]), ts_sub(corner[2], corner[0])));
	ts_v3 v = ts_normalize(ts_cross(n, u));
	/* Put the origin at the centroid. */
	ts_v3 sum = ts_add(ts_add(corner[0], corner[1]), corner[2]);
	ts_v3 c = ts_scale(sum, TS_THIRD);
	/* Store the frame; s is the scale S of the same equation. */
	ts_store3(out->c, c);
	ts_store3(out->u, u);
	ts_store3(out->v, v);
	out->s = ts_put(s);
	out->pad0 = 0u;
	out->pad1 = 0u;
	out->pad2[0] = 0u;
	out->pad2[1] = 0u;
	/* Snap the corners: by the + 1/2 of ts_k_lattice the centroid is the middle of sample (0, 0). */
	for (u32 k = 0u; k < 3u; k++) {
		ts_v2 q = ts_k_lattice(c, u, v, s, corner[k]);
		out->q[k * 2u] = ts_fix(q.x, 8, 23);
		out->q[k * 2u + 1u] = ts_fix(q.y, 8, 23);
	}
}

TS_FN ts_cover ts_k_lattice_cover(TS_GLOBAL const ts_align *frame, i32 half_size)
{
	ts_cover r;
	r.n = 3u;
	for (u32 k = 0u; k < 3u; k++) {
		r.v[k].x = frame->q[k * 2u];
		r.v[k].y = frame->q[k * 2u + 1u];
	}
	ts_k_cover_finish(&r, half_size);
	return r;
}

/* Weights of a sample on a triangle in lattice coordinates, by areas. A sample beside the triangle gets weights of its
 * border (CONTRACT rule 22). */
TS_FN ts_v3 ts_k_weights_around(ts_v2 a, ts_v2 b, ts_v2 d, i32 x, i32 y)
{
	/* Move the origin to the sample's centre. */
	ts_v2 p = ts_v2_make((f32)x + 0.5f, (f32)y + 0.5f);
	a = ts_v2_make(a.x - p.x, a.y - p.y);
	b = ts_v2_make(b.x - p.x, b.y - p.y);
	d = ts_v2_make(d.x - p.x, d.y - p.y);
	ts_v3 w;
	/* Take twice the areas opposite the corners; beside the triangle some are negative and become 0. */
	w.x = ts_max(ts_diff_of_products(b.x, d.y, b.y, d.x), 0.0f);
	w.y = ts_max(ts_diff_of_products(d.x, a.y, d.y, a.x), 0.0f);
	w.z = ts_max(ts_diff_of_products(a.x, b.y, a.y, b.x), 0.0f);
	/* Divide by their sum; a triangle without area has a third of each corner. */
	f32 third = TS_THIRD;
	f32 sum = w.x + w.y;
	sum = ts_flush(sum + w.z);
	if (!(sum > 0.0f)) return ts_v3_make(third, third, third);
	return ts_v3_make(w.x / sum, w.y / sum, w.z / sum);
}

/* Weights of a sample on the source triangle, from unsnapped corners. */
TS_FN ts_v3 ts_k_lattice_weights(const ts_arrays *scene, TS_GLOBAL const ts_align *frame, u32 triangle, i32 x, i32 y)
{
	ts_v3 c = ts_load3(frame->c);
	ts_v3 u = ts_load3(frame->u);
	ts_v3 v = ts_load3(frame->v);
	ts_corners t = ts_k_corners(scene, triangle);
	ts_v2 a = ts_k_lattice(c, u, v, frame->s, t.a);
	ts_v2 b = ts_k_lattice(c, u, v, frame->s, t.b);
	ts_v2 d = ts_k_lattice(c, u, v, frame->s, t.c);
	return ts_k_weights_around(a, b, d, x, y);
}

/* The sample touches the piece and is not cut away by its alpha mask. */
TS_FN bool ts_k_is_sample(const ts_arrays *scene, TS_GLOBAL const ts_piece *piece, TS_GLOBAL const ts_align *frame,
                          const ts_cover *cover, i32 x, i32 y)
{
	if (!ts_k_touches(cover, x, y)) return false;
	u32 triangle = piece->triangle;
	if ((scene->materials[scene->triangles[triangle].material].flags & TS_MASKED) == 0u) return true;
	ts_v3 w = ts_k_lattice_weights(scene, frame, triangle, x, y);
	ts_corners t = ts_k_corners(scene, triangle);
	return !ts_k_is_cut(scene, triangle, w, t.n, 1.0f / frame->s);
}

/* The place of sample (x, y) in the world: c + (x/s) u + (y/s) v. */
TS_FN ts_v3 ts_k_lattice_point(TS_GLOBAL const ts_align *frame, i32 x, i32 y)
{
	f32 du = (f32)x / frame->s;
	f32 dv = (f32)y / frame->s;
	return ts_mad(ts_mad(ts_load3(frame->c), ts_load3(frame->u), du), ts_load3(frame->v), dv);
}

/* Whether the sample lies in its piece: on the inner side of all edges. The test is made in the lattice, where the
 * longest edge lies along an axis; in space rounding would decide for long thin pieces. */
TS_FN bool ts_k_is_in_piece(TS_GLOBAL const ts_align *frame, ts_v3 a, ts_v3 b, ts_v3 c, i32 x, i32 y)
{
	ts_v3 corner[3];
	corner[0] = a;
	corner[1] = b;
	corner[2] = c;
	ts_v2 q[3];
	for (u32 k = 0u; k < 3u; k++) {
		q[k] = ts_k_lattice(ts_load3(frame->c), ts_load3(frame->u), ts_load3(frame->v), frame->s, corner[k]);
		q[k] = ts_v2_make(q[k].x - ((f32)x + 0.5f), q[k].y - ((f32)y + 0.5f));
	}
	return ts_diff_of_products(q[0].x, q[1].y, q[0].y, q[1].x) >= 0.0f &&
	       ts_diff_of_products(q[1].x, q[2].y, q[1].y, q[2].x) >= 0.0f &&
	       ts_diff_of_products(q[2].x, q[0].y, q[2].y, q[0].x) >= 0.0f;
}

/* The position of the sample as a point: on the lattice, or with snap, if it lies beside its piece, the closest point
 * of the piece's border. */
TS_FN ts_v3 ts_k_sample_centre(TS_GLOBAL const ts_piece *piece, TS_GLOBAL const ts_align *frame, bool snap, i32 x,
                               i32 y)
{
	ts_v3 p = ts_k_lattice_point(frame, x, y);
	ts_v3 a = ts_load3(piece->a);
	ts_v3 b = ts_load3(piece->b);
	ts_v3 c = ts_load3(piece->c);
	return !snap || ts_k_is_in_piece(frame, a, b, c, x, y) ? p : ts_k_closest_on_border(p, a, b, c);
}

/* The surface that a sample shows. */
TS_FN ts_surface ts_k_lattice_surface(const ts_arrays *scene, TS_GLOBAL const ts_align *frame, u32 triangle, i32 x,
                                      i32 y, ts_v3 centre, f32 length)
{
	ts_surface r = ts_k_surface(scene, triangle, ts_k_lattice_weights(scene, frame, triangle, x, y), length);
	r.p = centre;
	return r;
}

#endif
