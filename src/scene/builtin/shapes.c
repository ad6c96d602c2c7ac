/* Walls, blocks, turned, bent and framed shapes over the grid of mesh.c. */
#include "scene/builtin/mesh.h"

typedef struct {
	ts_v3 o, s, t;
	ts_v3 n;
	f32 length_s, length_t;
} plane_shape;

static plane_shape make_plane(ts_v3 o, ts_v3 es, ts_v3 et)
{
	plane_shape p = {o, es, et, ts_normalize(ts_cross(es, et)), ts_length(es), ts_length(et)};
	return p;
}

static void plane(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const plane_shape *p = shape;
	c->p = ts_mad(ts_mad(p->o, p->s, s), p->t, t);
	c->n = p->n;
	c->uv = ts_v2_make(s * p->length_s, (1.0f - t) * p->length_t);
}

void ts_mesh_plane(ts_mesh *mesh, ts_v3 o, ts_v3 es, ts_v3 et, u32 ns, u32 nt)
{
	plane_shape p = make_plane(o, es, et);
	ts_mesh_grid(mesh, ns, nt, 0, plane, &p);
}

enum { MAX_HOLES = 7, MAX_BREAKS = 2 * MAX_HOLES + 2 };

/* The borders of the holes along one axis, sorted, without repetition, from 0 to length. */
static u32 find_breaks(f32 *breaks, const ts_hole *holes, u32 n_holes, u32 axis, f32 length)
{
	u32 n = 2;
	breaks[0] = 0.0f;
	breaks[1] = length;
	for (u32 k = 0; k < 2 * n_holes; k++) {
		f32 x = k & 1u ? holes[k / 2].hi[axis] : holes[k / 2].lo[axis];
		u32 at = 0;
		while (at < n && breaks[at] < x) at++;
		if (at < n && breaks[at] == x) continue;
		for (u32 i = n; i > at; i--) breaks[i] = breaks[i - 1];
		breaks[at] = x;
		n++;
	}
	return n;
}

static bool in_hole(const ts_hole *holes, u32 n_holes, f32 x, f32 y)
{
	for (u32 k = 0; k < n_holes; k++) {
		if (x > holes[k].lo[0] && x < holes[k].hi[0] && y > holes[k].lo[1] && y < holes[k].hi[1]) return true;
	}
	return false;
}

typedef struct {
	plane_shape whole;
	f32 lo[2], hi[2];
} wall_shape;

static void wall(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const wall_shape *w = shape;
	f32 x = s < 1.0f ? w->lo[0] + (w->hi[0] - w->lo[0]) * s : w->hi[0];
	f32 y = t < 1.0f ? w->lo[1] + (w->hi[1] - w->lo[1]) * t : w->hi[1];
	plane(c, &w->whole, x / w->whole.length_s, y / w->whole.length_t);
}

void ts_mesh_wall(ts_mesh *mesh, ts_v3 o, ts_v3 es, ts_v3 et, f32 step, const ts_hole *holes, u32 n_holes)
{
	f32 x[MAX_BREAKS], y[MAX_BREAKS];
	wall_shape w = {.whole = make_plane(o, es, et)};
	u32 nx = find_breaks(x, holes, n_holes, 0, w.whole.length_s);
	u32 ny = find_breaks(y, holes, n_holes, 1, w.whole.length_t);
	for (u32 j = 0; j + 1 < ny; j++) {
		for (u32 i = 0; i + 1 < nx; i++) {
			if (in_hole(holes, n_holes, (x[i] + x[i + 1]) * 0.5f, (y[j] + y[j + 1]) * 0.5f)) continue;
			w.lo[0] = x[i];
			w.hi[0] = x[i + 1];
			w.lo[1] = y[j];
			w.hi[1] = y[j + 1];
			ts_mesh_grid(mesh, ts_mesh_segments(mesh, (x[i + 1] - x[i]) / step, 1),
			             ts_mesh_segments(mesh, (y[j + 1] - y[j]) / step, 1), 0, wall, &w);
		}
	}
}

/* One face of a block: es and et along its sides, en outwards. */
typedef struct {
	ts_v3 centre, es, et, en;
	f32 hs, ht, hn, r;
	u32 k;
} block_shape;

/* Along a side of 2k + 1 cells: k of a rounded edge, one flat, k of the other edge. Returns the flat part's coordinate
 * and how far around the edge (-1 to 1). */
static f32 block_side(f32 *around, f32 s, u32 k, f32 flat)
{
	u32 cells = 2 * k + 1;
	i32 i = ts_floor_i32(s * (f32)cells + 0.5f);
	bool low = i <= (i32)k;
	f32 steps = (f32)(low ? (i32)k - i : i - (i32)k - 1);
	f32 part = k > 0 ? ts_sin_turn(steps / (f32)k * 0.125f) / ts_cos_turn(steps / (f32)k * 0.125f) : 0.0f;
	*around = low ? -part : part;
	return low ? -flat : flat;
}

static void block_face(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const block_shape *b = shape;
	f32 as, at;
	f32 x = block_side(&as, s, b->k, b->hs - b->r);
	f32 y = block_side(&at, t, b->k, b->ht - b->r);
	c->n = ts_normalize(ts_add(b->en, ts_add(ts_scale(b->es, as), ts_scale(b->et, at))));
	ts_v3 inner = ts_mad(ts_mad(ts_mad(b->centre, b->es, x), b->et, y), b->en, b->hn - b->r);
	c->p = ts_mad(inner, c->n, b->r);
	c->uv = ts_v2_make(x + b->hs + as * b->r, b->ht - y - at * b->r);
}

void ts_mesh_block(ts_mesh *mesh, ts_v3 centre, ts_v3 half, f32 r, u32 k)
{
	static const ts_v3 axis[3] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
	const f32 h[3] = {half.x, half.y, half.z};
	const f32 round = k > 0 ? ts_min(r, ts_min(ts_min(half.x, half.y), half.z) * 0.875f) : 0.0f;
	/* s, t, n and the signs of s and n, so that n = s x t and t points up where it can */
	static const struct {
		u32 s, t, n;
		f32 ss, sn;
	} face[6] = {{2, 1, 0, -1.0f, 1.0f}, {2, 1, 0, 1.0f, -1.0f}, {0, 2, 1, -1.0f, 1.0f},
	             {0, 2, 1, 1.0f, -1.0f}, {0, 1, 2, 1.0f, 1.0f},  {0, 1, 2, -1.0f, -1.0f}};
	for (u32 f = 0; f < 6; f++) {
		block_shape b = {centre,
		                 ts_scale(axis[face[f].s], face[f].ss),
		                 axis[face[f].t],
		                 ts_scale(axis[face[f].n], face[f].sn),
		                 h[face[f].s],
		                 h[face[f].t],
		                 h[face[f].n],
		                 round,
		                 k};
		ts_mesh_grid(mesh, 2 * k + 1, 2 * k + 1, 0, block_face, &b);
	}
}

typedef struct {
	const f32 (*profile)[2];
	u32 n;
	f32 girth;
} lathe_shape;

static void lathe(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const lathe_shape *l = shape;
	f32 at = t * (f32)(l->n - 1);
	f32 r = t < 1.0f ? ts_mesh_spline(&l->profile[0][0], 2, l->n, at) : l->profile[l->n - 1][0];
	f32 y = ts_mesh_spline(&l->profile[0][1], 2, l->n, at);
	f32 turn = s < 1.0f ? s : 0.0f;
	c->p = ts_v3_make(r * ts_cos_turn(turn), y, -r * ts_sin_turn(turn));
	c->uv = ts_v2_make(s * l->girth, -(y + r));
}

void ts_mesh_lathe(ts_mesh *mesh, const f32 (*profile)[2], u32 n_points, u32 na, f32 between)
{
	f32 widest = 0.0f;
	for (u32 i = 0; i < n_points; i++) widest = ts_max(widest, profile[i][0]);
	for (u32 first = 0; first + 1 < n_points;) {
		u32 last = first + 1;
		while (last + 1 < n_points &&
		       (profile[last][0] != profile[last + 1][0] || profile[last][1] != profile[last + 1][1]))
			last++;
		lathe_shape l = {profile + first, last - first + 1, widest * 6.28125f};
		u32 flags = TS_GRID_WRAP_S | (profile[first][0] == 0.0f ? TS_GRID_POLE_T0 : 0);
		flags |= profile[last][0] == 0.0f ? TS_GRID_POLE_T1 : 0;
		bool both = (flags & TS_GRID_POLE_T0) != 0 && (flags & TS_GRID_POLE_T1) != 0;
		u32 nt = ts_mesh_segments(mesh, (f32)(last - first) * between, 1);
		ts_mesh_grid(mesh, na, both && nt < 2 ? 2 : nt, flags, lathe, &l);
		first = last + 1;
	}
}

typedef struct {
	const ts_v3 *points;
	u32 n;
	f32 radius;
	ts_v3 side;
} tube_shape;

static ts_v3 tube_at(const tube_shape *tube, f32 t)
{
	f32 at = t * (f32)(tube->n - 1);
	const ts_v3 *p = tube->points;
	return ts_v3_make(ts_mesh_spline(&p->x, 3, tube->n, at), ts_mesh_spline(&p->y, 3, tube->n, at),
	                  ts_mesh_spline(&p->z, 3, tube->n, at));
}

static void tube(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const tube_shape *b = shape;
	f32 eps = 0.0078125f;
	ts_v3 along = ts_normalize(ts_sub(tube_at(b, ts_min(t + eps, 1.0f)), tube_at(b, ts_max(t - eps, 0.0f))));
	ts_v3 u = ts_normalize(ts_cross(b->side, along));
	ts_v3 v = ts_cross(along, u);
	f32 turn = s < 1.0f ? s : 0.0f;
	c->n = ts_add(ts_scale(u, ts_cos_turn(turn)), ts_scale(v, ts_sin_turn(turn)));
	c->p = ts_mad(tube_at(b, t), c->n, b->radius);
	c->uv = ts_v2_make(s * b->radius * 6.28125f, t * ts_length(ts_sub(b->points[b->n - 1], b->points[0])));
}

void ts_mesh_tube(ts_mesh *mesh, const ts_v3 *points, u32 n_points, f32 radius, ts_v3 side, u32 na, u32 nl)
{
	tube_shape shape = {points, n_points, radius, side};
	ts_mesh_grid(mesh, na, nl, TS_GRID_WRAP_S, tube, &shape);
}

void ts_mesh_rod(ts_mesh *mesh, ts_v3 a, ts_v3 b, f32 radius, u32 na)
{
	ts_v3 along = ts_sub(b, a);
	ts_v3 points[2] = {a, b};
	bool level = ts_abs(along.y) < ts_length(along) * 0.75f;
	ts_mesh_tube(mesh, points, 2, radius, level ? ts_v3_make(0.0f, 1.0f, 0.0f) : ts_v3_make(1.0f, 0.0f, 0.0f), na, 1);
}

typedef struct {
	ts_v3 s, t;
	f32 hs, ht;
	const f32 (*profile)[2];
	u32 n;
	f32 relief;
} frame_shape;

static void frame_side(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const frame_shape *f = shape;
	f32 at = t * (f32)(f->n - 1);
	u32 i = (u32)ts_min_i32(ts_floor_i32(at), (i32)f->n - 2);
	f32 out = f->profile[i][0] + (f->profile[i + 1][0] - f->profile[i][0]) * (at - (f32)i);
	f32 z = f->profile[i][1] + (f->profile[i + 1][1] - f->profile[i][1]) * (at - (f32)i);
	f32 x = (2.0f * s - 1.0f) * (f->hs + out);
	f32 bump = (1.0f - ts_cos_turn(t)) * (1.0f + ts_sin_turn(x * 14.0f) * ts_cos_turn(x * 5.0f + t)) * 0.25f;
	c->p = ts_add(ts_scale(f->s, x), ts_scale(f->t, -(f->ht + out)));
	c->p.z = z + bump * f->relief;
	c->uv = ts_v2_make(x + f->hs, t * 0.125f);
}

void ts_mesh_frame(ts_mesh *mesh, f32 hx, f32 hy, const f32 (*profile)[2], u32 n_points, f32 relief, u32 n_along)
{
	static const f32 turned[4][2] = {{1.0f, 0.0f}, {0.0f, 1.0f}, {-1.0f, 0.0f}, {0.0f, -1.0f}};
	u32 nt = relief > 0.0f ? ts_mesh_segments(mesh, 2.0f * (f32)(n_points - 1), n_points - 1) : n_points - 1;
	nt = nt / (n_points - 1) * (n_points - 1);
	for (u32 k = 0; k < 4; k++) {
		ts_v3 s = ts_v3_make(turned[k][0], turned[k][1], 0.0f);
		frame_shape f = {s, ts_v3_make(-s.y, s.x, 0.0f), k % 2 ? hy : hx, k % 2 ? hx : hy, profile, n_points, relief};
		ts_mesh_grid(mesh, n_along, nt, relief > 0.0f ? 0 : TS_GRID_FLAT, frame_side, &f);
	}
}
