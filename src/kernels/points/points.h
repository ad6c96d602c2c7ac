/* Points: the samples that an aligned piece touches, conservatively, row by row (EPR sections 3.3, 3.4; METHODS 2). */
#ifndef TS_KERNELS_POINTS_H
#define TS_KERNELS_POINTS_H
#include "../base/args.h"
#include "align.h"
#include "../base/closest.h"
#include "../raster/raster.h"
#include "../base/surface.h"

#define TS_ROWS_ts_points_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_piece, pieces, split_triangle) \
	ARG(IN, ts_align, frames, align_frame) \
	ARG(OUT_OPT, u32, offset, count_offset) /* counts, then their prefix sums */ \
	ARG(OUT_PARTS_OPT, u64, keys, points_key) \
	ARG(OUT_PARTS_OPT, ts_point, points, points_record) \
	ARG(TALLY_OPT, i64, n_points, 0) /* appended so far */ \
	ARG(VALUE, u64, room, none) /* points that the arrays can hold */ \
	ARG(VALUE, i32, half_size, none) /* of a lattice square, in 1/256: 129 safe, 128 exact, 0 its centre alone */ \
	ARG(VALUE, u32, paper_splat, none) /* sub-pixel pieces get a splat of their own area */ \
	ARG(VALUE, u32, snap, none) /* samples beside their piece move to its border */
TS_ARGS(ts_points_args);

#define TS_POINT_TINY 1u

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

/* Weights of a sample on the source triangle: areas in the lattice, from unsnapped corners; a sample beside the
 * triangle moves to its border (CONTRACT rule 22). */
TS_FN ts_v3 ts_k_lattice_weights(const ts_arrays *scene, TS_GLOBAL const ts_align *frame, u32 triangle, i32 x, i32 y)
{
	ts_v3 c = ts_load3(frame->c);
	ts_v3 u = ts_load3(frame->u);
	ts_v3 v = ts_load3(frame->v);
	ts_corners t = ts_k_corners(scene, triangle);
	ts_v2 p = ts_v2_make((f32)x + 0.5f, (f32)y + 0.5f);
	ts_v2 a = ts_k_lattice(c, u, v, frame->s, t.a);
	ts_v2 b = ts_k_lattice(c, u, v, frame->s, t.b);
	ts_v2 d = ts_k_lattice(c, u, v, frame->s, t.c);
	a = ts_v2_make(a.x - p.x, a.y - p.y);
	b = ts_v2_make(b.x - p.x, b.y - p.y);
	d = ts_v2_make(d.x - p.x, d.y - p.y);
	ts_v3 w;
	w.x = ts_max(ts_diff_of_products(b.x, d.y, b.y, d.x), 0.0f);
	w.y = ts_max(ts_diff_of_products(d.x, a.y, d.y, a.x), 0.0f);
	w.z = ts_max(ts_diff_of_products(a.x, b.y, a.y, b.x), 0.0f);
	f32 third = 0.3333333432674407958984375f;
	f32 sum = w.x + w.y;
	sum = ts_flush(sum + w.z);
	if (!(sum > 0.0f)) return ts_v3_make(third, third, third);
	return ts_v3_make(w.x / sum, w.y / sum, w.z / sum);
}

/* The sample touches the piece and is not cut away by its alpha mask. */
TS_FN bool ts_k_is_point(const ts_points_args *args, const ts_cover *cover, u64 piece, i32 x, i32 y)
{
	if (!ts_k_touches(cover, x, y)) return false;
	u32 triangle = args->pieces[piece].triangle;
	if ((args->scene.materials[args->scene.triangles[triangle].material].flags & TS_MASKED) == 0u) return true;
	TS_GLOBAL const ts_align *frame = &args->frames[piece];
	ts_v3 w = ts_k_lattice_weights(&args->scene, frame, triangle, x, y);
	ts_corners t = ts_k_corners(&args->scene, triangle);
	return !ts_k_is_cut(&args->scene, triangle, w, t.n, 1.0f / frame->s);
}

TS_FN u32 ts_k_points_of(const ts_points_args *args, u64 piece)
{
	if (!(args->frames[piece].s > 0.0f)) return 0u;
	ts_cover cover = ts_k_lattice_cover(&args->frames[piece], args->half_size);
	u32 count = 0u;
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			count += ts_k_is_point(args, &cover, piece, x, y) ? 1u : 0u;
		}
	}
	return count;
}

/* map over pieces: how many points */
TS_FN void ts_k_count_item(const ts_points_args *args, u64 i)
{
	args->offset[i] = ts_k_points_of(args, i);
}

/* l = 1/s (eq. 4); a sub-pixel piece is tiny: by the paper its splat is a square of its own area. */
TS_FN f32 ts_k_splat_length(const ts_points_args *args, TS_GLOBAL const ts_piece *piece, f32 s, u32 *flags)
{
	f32 area = ts_k_area(ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c));
	bool tiny = (area * s) * s < 1.0f;
	*flags = tiny && args->paper_splat == 0u ? TS_POINT_TINY : 0u;
	return tiny && args->paper_splat != 0u ? ts_sqrt(area) : 1.0f / s;
}

/* Integer lattice offsets from the anchor: p = c + (i/s) u + (j/s) v. */
TS_FN ts_v3 ts_k_lattice_point(TS_GLOBAL const ts_align *frame, i32 x, i32 y)
{
	f32 du = (f32)x / frame->s;
	f32 dv = (f32)y / frame->s;
	return ts_mad(ts_mad(ts_load3(frame->c), ts_load3(frame->u), du), ts_load3(frame->v), dv);
}

/* The sample lies in its piece: on the inner side of the edges, in the lattice, where their longest is an axis. In
 * space the sides of long thin pieces would be lost in rounding. */
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

/* Where the sample is as a point: on the lattice, or moved to the closest point of its piece. */
TS_FN ts_v3 ts_k_point_centre(const ts_points_args *args, u64 piece, i32 x, i32 y)
{
	TS_GLOBAL const ts_align *frame = &args->frames[piece];
	TS_GLOBAL const ts_piece *t = &args->pieces[piece];
	ts_v3 p = ts_k_lattice_point(frame, x, y);
	ts_v3 a = ts_load3(t->a);
	ts_v3 b = ts_load3(t->b);
	ts_v3 c = ts_load3(t->c);
	return args->snap == 0u || ts_k_is_in_piece(frame, a, b, c, x, y) ? p : ts_k_closest_on_border(p, a, b, c);
}

/* What a sample shows. */
TS_FN ts_surface ts_k_lattice_surface(const ts_arrays *scene, TS_GLOBAL const ts_align *frame, u32 triangle, i32 x, i32 y,
                                      ts_v3 centre, f32 length)
{
	ts_surface r = ts_k_surface(scene, triangle, ts_k_lattice_weights(scene, frame, triangle, x, y), length);
	r.p = centre;
	return r;
}

typedef struct {
	TS_GLOBAL const ts_align *frame;
	u64 piece;
	f32 length;
	u32 flags;
} ts_point_source;

TS_FN ts_point_source ts_k_point_source(const ts_points_args *args, u64 piece)
{
	ts_point_source r;
	r.frame = &args->frames[piece];
	r.piece = piece;
	r.length = ts_k_splat_length(args, &args->pieces[piece], r.frame->s, &r.flags);
	return r;
}

TS_FN void ts_k_point_put(const ts_points_args *args, const ts_point_source *from, i32 x, i32 y, u64 at)
{
	TS_GLOBAL ts_point *out = ts_at(args->points, at);
	ts_store3(out->centre, ts_k_point_centre(args, from->piece, x, y));
	out->length = ts_put(from->length);
	out->piece = (u32)from->piece;
	out->flags = from->flags;
	out->pad[0] = 0u;
	out->pad[1] = 0u;
	*ts_at(args->keys, at) = (from->piece << 32) | ((u64)(u32)(y + 32768) << 16) | (u64)(u32)(x + 32768);
}

/* emit over pieces */
TS_FN void ts_k_points_item(const ts_points_args *args, u64 i)
{
	u64 at = args->offset[i];
	if (args->offset[i + 1u] == (u32)at) return;
	ts_cover cover = ts_k_lattice_cover(&args->frames[i], args->half_size);
	ts_point_source from = ts_k_point_source(args, i);
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(args, &cover, i, x, y)) continue;
			if (at < args->room) ts_k_point_put(args, &from, x, y, at);
			at++;
		}
	}
}

/* scatter over pieces: the same points in the order of arrival, as the papers' GPUs append them. Those that find no
 * room are counted only. */
TS_FN void ts_k_points_append_item(const ts_points_args *args, u64 i)
{
	if (!(args->frames[i].s > 0.0f)) return;
	ts_cover cover = ts_k_lattice_cover(&args->frames[i], args->half_size);
	ts_point_source from = ts_k_point_source(args, i);
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(args, &cover, i, x, y)) continue;
			u64 at = (u64)ts_next_i64(args->n_points);
			if (at < args->room) ts_k_point_put(args, &from, x, y, at);
		}
	}
}

#endif
