/* Corners snapped to 24.8 fixed point, their edge function (Pineda, A Parallel Algorithm for Polygon Rasterization,
 * 1988), and boxes of pixels (CONTRACT rules 15, 17, 19). y grows downward.
 * Numeric format: snapped coordinates are i32 with 8 fraction bits and |x| < 2^23; edges are i64 with |E| <= 2^49. */
#ifndef TS_KERNELS_RASTER_SNAP_H
#define TS_KERNELS_RASTER_SNAP_H
#include "kernels/raster/view.h"

typedef struct {
	i32 x, y;
} ts_snapped;

TS_FN ts_snapped ts_k_snap(ts_v2 p)
{
	ts_snapped r;
	r.x = ts_fix(p.x, 8, 23);
	r.y = ts_fix(p.y, 8, 23);
	return r;
}

/* Snaps first and then shifts by whole sub-pixels, so that all samples of a pixel see the same edges (eye_sample.h). */
TS_FN ts_snapped ts_k_snap_corner(const ts_camera_k *view, const ts_corner *p)
{
	ts_snapped r = ts_k_snap(ts_k_project(view, p));
	r.x += view->shift_x;
	r.y += view->shift_y;
	return r;
}

/* E > 0 on the inner side of a triangle whose area is positive. */
TS_FN i64 ts_k_edge(ts_snapped a, ts_snapped b, i32 x, i32 y)
{
	return (i64)(b.x - a.x) * (i64)(y - a.y) - (i64)(b.y - a.y) * (i64)(x - a.x);
}

/* Pixels [x0, x1] x [y0, y1]; empty if x1 < x0 or y1 < y0. */
typedef struct {
	i32 x0, y0, x1, y1;
} ts_box;

TS_FN ts_box ts_k_box_meet(ts_box a, ts_box b)
{
	ts_box r;
	r.x0 = ts_max_i32(a.x0, b.x0);
	r.y0 = ts_max_i32(a.y0, b.y0);
	r.x1 = ts_min_i32(a.x1, b.x1);
	r.y1 = ts_min_i32(a.y1, b.y1);
	return r;
}

TS_FN ts_box ts_k_view_box(const ts_camera_k *view)
{
	ts_box r;
	r.x0 = 0;
	r.y0 = 0;
	r.x1 = view->width - 1;
	r.y1 = view->height - 1;
	return r;
}

/* Pixels whose squares of half size `half_size`, in sub-pixels, meet the box of `n` snapped corners. 0: pixels whose
 * centres lie in the box; TS_SUB_CENTRE: those that the box touches; TS_SAFE_HALF: those that it may touch before
 * snapping. */
TS_FN ts_box ts_k_touched_box(const ts_snapped *v, u32 n, i32 half_size)
{
	/* Bound the corners. */
	i32 x0 = v[0].x, x1 = v[0].x, y0 = v[0].y, y1 = v[0].y;
	for (u32 i = 1u; i < n; i++) {
		x0 = ts_min_i32(x0, v[i].x);
		x1 = ts_max_i32(x1, v[i].x);
		y0 = ts_min_i32(y0, v[i].y);
		y1 = ts_max_i32(y1, v[i].y);
	}
	ts_box r;
	/* Take the pixels with centres in the closed box: round up to the first, down to the last (CONTRACT rule 19). */
	r.x0 = (x0 - half_size + TS_SUB_FIRST) >> 8;
	r.y0 = (y0 - half_size + TS_SUB_FIRST) >> 8;
	r.x1 = (x1 + half_size - TS_SUB_CENTRE) >> 8;
	r.y1 = (y1 + half_size - TS_SUB_CENTRE) >> 8;
	return r;
}

#endif
