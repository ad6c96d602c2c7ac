/* A splat in a view: the square as a box of texels, its piece as a cover, and the distance of its plane (EPR section
 * 3.5; METHODS 2). */
#ifndef TS_KERNELS_POINTS_SPLAT_BOX_H
#define TS_KERNELS_POINTS_SPLAT_BOX_H
#include "kernels/raster/clip.h"
#include "kernels/raster/cover.h"

/* A clipped polygon as a cover: its corners projected and snapped. */
TS_FN ts_cover ts_k_cover_of(const ts_camera_k *view, const ts_polygon *polygon, i32 half_size)
{
	ts_cover r;
	r.n = polygon->n;
	for (u32 k = 0u; k < polygon->n; k++) r.v[k] = ts_k_snap(ts_k_project(view, &polygon->corner[k]));
	ts_k_cover_finish(&r, half_size);
	return r;
}

/* The piece in the view of a face, for the safe test whatever points.conservative says. The piece is clipped to the
 * range of snapping, not to the face, so that its own edges stay (CONTRACT rules 16 and 19). n = 0: nothing is left. */
TS_FN ts_cover ts_k_splat_triangle(const ts_camera_k *view, TS_GLOBAL const ts_piece *piece)
{
	ts_polygon t = ts_k_polygon(view, ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c));
	ts_k_clip_to_range(view, &t);
	if (t.n == 0u) {
		ts_cover none;
		none.n = 0u;
		return none;
	}
	return ts_k_cover_of(view, &t, TS_SAFE_HALF);
}

/* The square of a point of a piece, c +- (l/2) u +- (l/2) v; `slack` bounds the rounding of its corners. */
typedef struct {
	ts_v3 c, u, v;
	f32 length, slack;
} ts_square;

/* 2^-19 of the greatest coordinate, in world units: more than rounding moves the corners of a square, so that squares
 * of one piece that meet leave no gap. */
TS_FN f32 ts_k_piece_slack(TS_GLOBAL const ts_piece *piece)
{
	f32 most = 0.0f;
	for (u32 k = 0u; k < 3u; k++) {
		most = ts_max(most, ts_max(ts_abs(piece->a[k]), ts_max(ts_abs(piece->b[k]), ts_abs(piece->c[k]))));
	}
	return most * 0.0000019073486328125f;
}

TS_FN ts_square ts_k_square(TS_GLOBAL const ts_piece *piece, TS_GLOBAL const ts_align *frame, ts_v3 c, f32 length)
{
	ts_square r;
	r.c = c;
	r.u = ts_load3(frame->u);
	r.v = ts_load3(frame->v);
	r.length = length;
	r.slack = ts_k_piece_slack(piece);
	return r;
}

/* The widest inset of a box from a texel's border: half a texel, less 1/256 for the rounding of projected corners. */
#define TS_SPLAT_INSET 0.49609375f

/* How far a box reaches into a texel that belongs to it, in texels, if the square's nearest corner is at z: less by the
 * image of the slack, but at least 0, where the box already takes every texel that it touches. */
TS_FN f32 ts_k_box_inset(f32 widest, f32 focal, f32 slack, f32 z) { return ts_max(widest - (focal * slack) / z, 0.0f); }

/* The texels whose centres lie in the bounding box of the projected square, after clipping at the near plane; with
 * `widest` 0, all that the box touches. Empty if the square lies behind that plane. */
TS_FN ts_box ts_k_splat_box(const ts_camera_k *view, const ts_square *s, f32 widest)
{
	/* Make the square c -+ (l/2) u -+ (l/2) v in the view (EPR 3.5). */
	f32 half_length = s->length * 0.5f;
	ts_v3 du = ts_scale(s->u, half_length);
	ts_v3 dv = ts_scale(s->v, half_length);
	ts_polygon square;
	square.n = 4u;
	square.corner[0] = ts_k_to_view(view, ts_sub(ts_sub(s->c, du), dv));
	square.corner[1] = ts_k_to_view(view, ts_sub(ts_add(s->c, du), dv));
	square.corner[2] = ts_k_to_view(view, ts_add(ts_add(s->c, du), dv));
	square.corner[3] = ts_k_to_view(view, ts_add(ts_sub(s->c, du), dv));
	/* Clip at the near plane, and at no side, as nothing is snapped. Nothing is left of a square behind the plane. */
	ts_k_clip_behind(view, &square, ts_k_near_plane(view));
	ts_box r;
	r.x0 = 0;
	r.y0 = 0;
	r.x1 = -1;
	r.y1 = -1;
	if (square.n == 0u) return r;
	/* Bound the projected corners, and find the nearest depth. */
	ts_v2 lo = ts_k_project(view, &square.corner[0]);
	ts_v2 hi = lo;
	f32 z = square.corner[0].z;
	for (u32 k = 1u; k < square.n; k++) {
		ts_v2 p = ts_k_project(view, &square.corner[k]);
		lo = ts_v2_make(ts_min(lo.x, p.x), ts_min(lo.y, p.y));
		hi = ts_v2_make(ts_max(hi.x, p.x), ts_max(hi.y, p.y));
		z = ts_min(z, square.corner[k].z);
	}
	/* Take texels whose centres lie in the box: half a texel in, less what rounding moves. */
	f32 inset = ts_k_box_inset(widest, view->focal, s->slack, z);
	r.x0 = ts_floor_i32(lo.x + inset);
	r.y0 = ts_floor_i32(lo.y + inset);
	r.x1 = ts_floor_i32(hi.x - inset);
	r.y1 = ts_floor_i32(hi.y - inset);
	return ts_k_box_meet(r, ts_k_view_box(view));
}

/* Distance at which the ray through a texel's centre meets the piece's plane, at most a tile's length from the distance
 * of the point. Where the ray does not meet the plane, the distance is that of the point. n has any length and either
 * sign. */
TS_FN f32 ts_k_plane_distance(const ts_camera_k *view, ts_v3 n, ts_v3 c, f32 distance, f32 length, i32 i, i32 j)
{
	f32 x = ((f32)i + 0.5f) - (f32)view->width * 0.5f;
	f32 y = (f32)view->height * 0.5f - ((f32)j + 0.5f);
	ts_v3 d = ts_mad(ts_mad(ts_scale(view->back, -view->focal), view->right, x), view->up, y);
	f32 along = ts_flush(ts_dot(n, d));
	f32 t = along != 0.0f ? ts_dot(n, ts_sub(c, view->eye)) / along : 0.0f;
	f32 met = t * ts_length(d);
	return met > 0.0f ? ts_clamp(met, distance - length, distance + length) : distance;
}

#endif
