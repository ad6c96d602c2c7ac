/* A splat in a view: the square as a box of texels, its piece as a cover, and the distance of its plane (EPR section
 * 3.5; METHODS 2). */
#ifndef TS_KERNELS_SPLAT_BOX_H
#define TS_KERNELS_SPLAT_BOX_H
#include "../raster/clip.h"
#include "../raster/cover.h"

TS_FN ts_cover ts_k_cover_of(const ts_camera_k *view, const ts_polygon *polygon, i32 half_size)
{
	ts_cover r;
	r.n = polygon->n;
	for (u32 k = 0u; k < polygon->n; k++) r.v[k] = ts_k_snap(ts_k_project(view, &polygon->corner[k]));
	ts_k_cover_finish(&r, half_size);
	return r;
}

/* The piece in the view of a face. n = 0: the face does not see it. */
TS_FN ts_cover ts_k_splat_triangle(const ts_camera_k *view, TS_GLOBAL const ts_piece *piece)
{
	ts_polygon t = ts_k_polygon(view, ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c));
	ts_k_clip_to_range(view, &t);
	if (t.n == 0u) {
		ts_cover none;
		none.n = 0u;
		return none;
	}
	return ts_k_cover_of(view, &t, 129);
}

TS_FN ts_box ts_k_extent_box(ts_v2 lo, ts_v2 hi)
{
	ts_box r;
	r.x0 = ts_floor_i32(lo.x);
	r.y0 = ts_floor_i32(lo.y);
	r.x1 = ts_floor_i32(hi.x);
	r.y1 = ts_floor_i32(hi.y);
	return r;
}

/* The box of texels around the projected square c +- (l/2) u +- (l/2) v, after clipping at the near plane; empty if the
 * square lies behind that plane. */
TS_FN ts_box ts_k_splat_box(const ts_camera_k *view, ts_v3 c, ts_v3 u, ts_v3 v, f32 length)
{
	f32 half_length = length * 0.5f;
	ts_v3 du = ts_scale(u, half_length);
	ts_v3 dv = ts_scale(v, half_length);
	ts_polygon square;
	square.n = 4u;
	square.corner[0] = ts_k_to_view(view, ts_sub(ts_sub(c, du), dv));
	square.corner[1] = ts_k_to_view(view, ts_sub(ts_add(c, du), dv));
	square.corner[2] = ts_k_to_view(view, ts_add(ts_add(c, du), dv));
	square.corner[3] = ts_k_to_view(view, ts_add(ts_sub(c, du), dv));
	ts_plane near = ts_plane_make(0.0f, 0.0f, 1.0f, -view->near);
	if (ts_k_any_behind(&square, near)) ts_k_clip(&square, near);
	ts_box none;
	none.x0 = 0;
	none.y0 = 0;
	none.x1 = -1;
	none.y1 = -1;
	if (square.n == 0u) return none;
	ts_v2 lo = ts_k_project(view, &square.corner[0]);
	ts_v2 hi = lo;
	for (u32 k = 1u; k < square.n; k++) {
		ts_v2 p = ts_k_project(view, &square.corner[k]);
		lo = ts_v2_make(ts_min(lo.x, p.x), ts_min(lo.y, p.y));
		hi = ts_v2_make(ts_max(hi.x, p.x), ts_max(hi.y, p.y));
	}
	return ts_k_box_meet(ts_k_extent_box(lo, hi), ts_k_view_box(view));
}

/* Distance at which the ray through a texel's centre meets the piece's plane, at most a tile's length from the distance
 * of the point. Where the ray does not meet the plane, the distance is that of the point. */
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
