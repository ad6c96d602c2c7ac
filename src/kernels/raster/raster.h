/* Triangle rasterization: clip, project, snap to 24.8 fixed point, cover by integer edge functions; standard (top-left
 * rule) and conservative (CONTRACT rules 14 to 23). y grows downward.
 * Numeric format: snapped coordinates are i32 with 8 fraction bits and |x| < 2^23; edges are i64 with |E| <= 2^49. */
#ifndef TS_KERNELS_RASTER_H
#define TS_KERNELS_RASTER_H
#include "view.h"

#define TS_MAX_CORNERS 8
typedef struct {
	ts_corner corner[TS_MAX_CORNERS];
	u32 n;
} ts_polygon;

TS_FN ts_polygon ts_k_polygon(const ts_camera_k *view, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_polygon r;
	r.n = 3u;
	r.corner[0] = ts_k_to_view(view, a);
	r.corner[1] = ts_k_to_view(view, b);
	r.corner[2] = ts_k_to_view(view, c);
	r.corner[0].w.x = 1.0f;
	r.corner[1].w.y = 1.0f;
	r.corner[2].w.z = 1.0f;
	return r;
}

/* The half space x X + y Y + z Z + d >= 0. */
typedef struct {
	f32 x, y, z, d;
} ts_plane;

TS_FN ts_plane ts_plane_make(f32 x, f32 y, f32 z, f32 d)
{
	ts_plane r;
	r.x = x;
	r.y = y;
	r.z = z;
	r.d = d;
	return r;
}

TS_FN f32 ts_k_plane_side(const ts_plane *plane, const ts_corner *p)
{
	f32 x = plane->x * p->x;
	f32 y = plane->y * p->y;
	f32 z = plane->z * p->z;
	f32 s = x + y;
	f32 t = s + z;
	return ts_flush(t + plane->d);
}

/* Cuts from the inside to the outside corner, so that both triangles of an edge get the same bits (rule 16). */
TS_FN ts_corner ts_k_cut(const ts_corner *in, f32 d_in, const ts_corner *out, f32 d_out)
{
	f32 t = d_in / (d_in - d_out);
	ts_corner r;
	r.x = in->x + (out->x - in->x) * t;
	r.y = in->y + (out->y - in->y) * t;
	r.z = in->z + (out->z - in->z) * t;
	r.w = ts_mad(in->w, ts_sub(out->w, in->w), t);
	return r;
}

/* Rounding can make an edge in the plane change sides at every corner. Corners that no longer fit lie in the plane and
 * are dropped. */
TS_FN void ts_k_push(ts_polygon *polygon, ts_corner corner)
{
	if (polygon->n < TS_MAX_CORNERS) polygon->corner[polygon->n++] = corner;
}

/* Clips against one plane, by Sutherland and Hodgman. */
TS_FN void ts_k_clip(ts_polygon *polygon, ts_plane plane)
{
	ts_polygon r;
	r.n = 0u;
	for (u32 i = 0u; i < polygon->n; i++) {
		const ts_corner *p = &polygon->corner[i];
		const ts_corner *q = &polygon->corner[i + 1u < polygon->n ? i + 1u : 0u];
		f32 dp = ts_k_plane_side(&plane, p);
		f32 dq = ts_k_plane_side(&plane, q);
		if (dp >= 0.0f) ts_k_push(&r, *p);
		if (dp >= 0.0f && dq < 0.0f) ts_k_push(&r, ts_k_cut(p, dp, q, dq));
		if (dp < 0.0f && dq >= 0.0f) ts_k_push(&r, ts_k_cut(q, dq, p, dp));
	}
	*polygon = r;
}

TS_FN bool ts_k_all_behind(const ts_polygon *polygon, ts_plane plane)
{
	for (u32 i = 0u; i < polygon->n; i++) {
		if (ts_k_plane_side(&plane, &polygon->corner[i]) >= 0.0f) return false;
	}
	return true;
}

TS_FN bool ts_k_any_behind(const ts_polygon *polygon, ts_plane plane)
{
	for (u32 i = 0u; i < polygon->n; i++) {
		if (ts_k_plane_side(&plane, &polygon->corner[i]) < 0.0f) return true;
	}
	return false;
}

/* Side plane `side` (-x +x -y +y) of the frustum, `pixels` from the image's middle. */
TS_FN ts_plane ts_k_side_plane(const ts_camera_k *view, u32 side, f32 pixels)
{
	f32 sign = (side & 1u) == 0u ? view->focal : -view->focal;
	f32 z = view->orthographic != 0u ? 0.0f : pixels;
	f32 d = view->orthographic != 0u ? pixels : 0.0f;
	return side < 2u ? ts_plane_make(sign, 0.0f, z, d) : ts_plane_make(0.0f, sign, z, d);
}

/* Whether no part of the polygon can reach the image. */
TS_FN bool ts_k_is_outside(const ts_camera_k *view, const ts_polygon *polygon)
{
	if (ts_k_all_behind(polygon, ts_plane_make(0.0f, 0.0f, 1.0f, -view->near))) return true;
	for (u32 side = 0u; side < 4u; side++) {
		f32 pixels = (f32)(side < 2u ? view->width : view->height) * 0.5f;
		if (ts_k_all_behind(polygon, ts_k_side_plane(view, side, pixels))) return true;
	}
	return false;
}

/* Clips against the near plane, then the sides at the end of the snapping range (CONTRACT rule 16). */
TS_FN void ts_k_clip_to_range(const ts_camera_k *view, ts_polygon *polygon)
{
	ts_plane near = ts_plane_make(0.0f, 0.0f, 1.0f, -view->near);
	if (ts_k_any_behind(polygon, near)) ts_k_clip(polygon, near);
	for (u32 side = 0u; side < 4u; side++) {
		f32 pixels = 32767.0f - (f32)(side < 2u ? view->width : view->height) * 0.5f;
		ts_plane plane = ts_k_side_plane(view, side, pixels);
		if (polygon->n != 0u && ts_k_any_behind(polygon, plane)) ts_k_clip(polygon, plane);
	}
}

TS_FN ts_v2 ts_k_project(const ts_camera_k *view, const ts_corner *p)
{
	f32 z = view->orthographic != 0u ? 1.0f : p->z;
	f32 x = (view->focal * p->x) / z;
	f32 y = (view->focal * p->y) / z;
	return ts_v2_make((f32)view->width * 0.5f + x, (f32)view->height * 0.5f - y);
}

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

TS_FN bool ts_k_is_top_left(ts_snapped a, ts_snapped b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

/* A snapped triangle turned to positive area; corner k is corner from[k] of the source. */
typedef struct {
	ts_snapped v[3];
	u32 from[3];
	i64 area;
} ts_setup;

TS_FN ts_setup ts_k_setup(ts_snapped a, ts_snapped b, ts_snapped c)
{
	ts_setup r;
	i64 area = ts_k_edge(a, b, c.x, c.y);
	bool turn = area < 0;
	r.v[0] = a;
	r.v[1] = turn ? c : b;
	r.v[2] = turn ? b : c;
	r.from[0] = 0u;
	r.from[1] = turn ? 2u : 1u;
	r.from[2] = turn ? 1u : 2u;
	r.area = turn ? -area : area;
	return r;
}

/* Edge k lies opposite corner k. */
typedef struct {
	i64 e[3];
} ts_edges;

TS_FN ts_edges ts_k_edges(const ts_setup *t, i32 x, i32 y)
{
	ts_edges r;
	r.e[0] = ts_k_edge(t->v[1], t->v[2], x, y);
	r.e[1] = ts_k_edge(t->v[2], t->v[0], x, y);
	r.e[2] = ts_k_edge(t->v[0], t->v[1], x, y);
	return r;
}

/* Whether the place of the edges is inside, or on a top or left edge (rule 18). */
TS_FN bool ts_k_covers(const ts_setup *t, const ts_edges *e)
{
	for (u32 k = 0u; k < 3u; k++) {
		ts_snapped a = t->v[k == 2u ? 0u : k + 1u];
		ts_snapped b = t->v[k == 0u ? 2u : k - 1u];
		if (e->e[k] < 0 || (e->e[k] == 0 && !ts_k_is_top_left(a, b))) return false;
	}
	return true;
}

/* Coverage from pixel to pixel: edges are integers, so steps are exact. */
typedef struct {
	ts_edges at;
	i64 right[3], down[3]; /* steps */
	i64 least[3];          /* least value that is inside: 0 for a top or left edge, otherwise 1 */
} ts_walk;

TS_FN ts_walk ts_k_walk(const ts_setup *t, i32 i, i32 j)
{
	ts_walk r;
	r.at = ts_k_edges(t, i * 256 + 128, j * 256 + 128);
	for (u32 k = 0u; k < 3u; k++) {
		ts_snapped a = t->v[k == 2u ? 0u : k + 1u];
		ts_snapped b = t->v[k == 0u ? 2u : k - 1u];
		r.right[k] = ((i64)a.y - b.y) * 256;
		r.down[k] = ((i64)b.x - a.x) * 256;
		r.least[k] = ts_k_is_top_left(a, b) ? 0 : 1;
	}
	return r;
}

TS_FN void ts_k_step(ts_edges *e, const i64 step[3])
{
	e->e[0] += step[0];
	e->e[1] += step[1];
	e->e[2] += step[2];
}

TS_FN bool ts_k_walk_covers(const ts_walk *w, const ts_edges *e)
{
	return e->e[0] >= w->least[0] && e->e[1] >= w->least[1] && e->e[2] >= w->least[2];
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

/* Pixels whose centre is within `half` of the box of `n` snapped corners; half 0 for centres, 128 or 129 for
 * squares. */
TS_FN ts_box ts_k_touched_box(const ts_snapped *v, u32 n, i32 half_size)
{
	i32 x0 = v[0].x, x1 = v[0].x, y0 = v[0].y, y1 = v[0].y;
	for (u32 i = 1u; i < n; i++) {
		x0 = ts_min_i32(x0, v[i].x);
		x1 = ts_max_i32(x1, v[i].x);
		y0 = ts_min_i32(y0, v[i].y);
		y1 = ts_max_i32(y1, v[i].y);
	}
	ts_box r;
	r.x0 = (x0 - half_size + 127) >> 8;
	r.y0 = (y0 - half_size + 127) >> 8;
	r.x1 = (x1 + half_size - 128) >> 8;
	r.y1 = (y1 + half_size - 128) >> 8;
	return r;
}

/* The square of half size h around (x, y) meets the half plane of edge a, b; turned: the polygon's area is negative. */
TS_FN bool ts_k_square_meets(ts_snapped a, ts_snapped b, bool turned, i32 x, i32 y, i64 half_size)
{
	i64 e = ts_k_edge(a, b, x, y);
	i64 dx = b.x - a.x;
	i64 dy = b.y - a.y;
	i64 reach = half_size * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
	return (turned ? -e : e) + reach >= 0;
}

/* A convex polygon of snapped corners for the conservative test: its edges and its box (CONTRACT rule 19). */
typedef struct {
	ts_snapped v[TS_MAX_CORNERS];
	u32 n;
	bool turned;
	ts_box touched;
	i32 half_size;
} ts_cover;

TS_FN void ts_k_cover_finish(ts_cover *c, i32 half_size)
{
	i64 area = 0;
	for (u32 i = 2u; i < c->n; i++) area += ts_k_edge(c->v[0], c->v[i - 1u], c->v[i].x, c->v[i].y);
	c->turned = area < 0;
	c->half_size = half_size;
	c->touched = ts_k_touched_box(c->v, c->n, half_size);
}

/* Does the pixel touch the polygon? The pixel lies in c->touched (rule 19). */
TS_FN bool ts_k_touches(const ts_cover *c, i32 i, i32 j)
{
	for (u32 k = 0u; k < c->n; k++) {
		ts_snapped b = c->v[k + 1u < c->n ? k + 1u : 0u];
		if (!ts_k_square_meets(c->v[k], b, c->turned, i * 256 + 128, j * 256 + 128, c->half_size)) return false;
	}
	return true;
}

/* Inside where x i + y j + c >= 0. */
typedef struct {
	i64 x, y, c;
} ts_line;
typedef struct {
	ts_line edge[TS_MAX_CORNERS];
	u32 n;
} ts_lines;

/* ts_k_touches as lines: e grows by 256 dx and 256 dy from texel to texel (rule 19). */
TS_FN void ts_k_lines(ts_lines *r, const ts_cover *cover)
{
	i64 sign = cover->turned ? -1 : 1;
	r->n = cover->n;
	for (u32 k = 0u; k < cover->n; k++) {
		ts_snapped a = cover->v[k];
		ts_snapped b = cover->v[k + 1u < cover->n ? k + 1u : 0u];
		i64 dx = b.x - a.x;
		i64 dy = b.y - a.y;
		i64 reach = cover->half_size * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
		r->edge[k].x = -sign * dy * 256;
		r->edge[k].y = sign * dx * 256;
		r->edge[k].c = sign * (dx * (128 - a.y) - dy * (128 - a.x)) + reach;
	}
}

TS_FN bool ts_k_inside_lines(const ts_lines *l, i32 i, i32 j)
{
	for (u32 k = 0u; k < l->n; k++) {
		if (l->edge[k].x * i + l->edge[k].y * j + l->edge[k].c < 0) return false;
	}
	return true;
}

/* The samples of a row that touch: none, or all from first to last, since the polygon is convex. */
typedef struct {
	i32 first, last;
} ts_span;

/* The floor of a / b, b > 0. */
TS_FN i64 ts_k_floor_quotient(i64 a, i64 b)
{
	i64 q = a / b;
	return q * b > a ? q - 1 : q;
}

/* The part of row j of `box` that the triangle may touch: each edge, as a line, cuts the row. */
TS_FN ts_span ts_k_touched_row(const ts_lines *l, ts_box box, i32 j)
{
	i64 first = box.x0;
	i64 last = box.x1;
	for (u32 k = 0u; k < l->n; k++) {
		i64 x = l->edge[k].x;
		i64 c = l->edge[k].y * j + l->edge[k].c;
		if (x == 0 && c < 0) last = first - 1;
		i64 at = x > 0 ? -ts_k_floor_quotient(c, x) : x < 0 ? ts_k_floor_quotient(c, -x) : 0;
		if (x > 0 && at > first) first = at;
		if (x < 0 && at < last) last = at;
	}
	ts_span r;
	r.first = first <= box.x1 ? (i32)first : box.x1 + 1;
	r.last = first <= last ? (i32)last : r.first - 1;
	return r;
}

/* A covered pixel: axial depth, and perspective weights of the source triangle's corners (rule 22): b_k = E_k / sum E,
 * z = 1 / sum b/z, w = z sum (b/z) w. */
typedef struct {
	f32 z;
	ts_v3 w;
} ts_fragment;

TS_FN ts_fragment ts_k_fragment(const ts_setup *t, const ts_edges *e, const ts_corner *a, const ts_corner *b,
                                const ts_corner *c)
{
	const f32 z[3] = {a->z, b->z, c->z};
	const ts_v3 corner[3] = {a->w, b->w, c->w};
	f32 sum = 0.0f;
	ts_v3 w = ts_v3_make(0.0f, 0.0f, 0.0f);
	f32 area = (f32)t->area;
	for (u32 k = 0u; k < 3u; k++) {
		u32 from = t->from[k];
		f32 share = (f32)e->e[k] / area;
		f32 over_z = share / z[from];
		sum = sum + over_z;
		w = ts_mad(w, corner[from], over_z);
	}
	ts_fragment r;
	r.z = ts_put(1.0f / sum);
	r.w = ts_scale(w, r.z);
	return r;
}

/* ts_k_fragment for an orthographic view: z = sum b z, w = sum b w. */
TS_FN ts_fragment ts_k_fragment_parallel(const ts_setup *t, const ts_edges *e, const ts_corner *a, const ts_corner *b,
                                         const ts_corner *c)
{
	f32 area = (f32)t->area;
	f32 share[3];
	for (u32 k = 0u; k < 3u; k++) share[t->from[k]] = (f32)e->e[k] / area;
	ts_v3 by = ts_v3_make(share[0], share[1], share[2]);
	ts_fragment r;
	r.z = ts_put(ts_blend1(by, a->z, b->z, c->z));
	r.w = ts_blend(by, a->w, b->w, c->w);
	return r;
}

#endif
