/* The grid that all shapes of the built-in scenes are made of: see mesh.h. */
#include "scene/builtin/mesh.h"
#include <stdlib.h>
#include "model/core.h"

u32 ts_mesh_segments(const ts_mesh *mesh, f32 base, u32 least)
{
	i32 n = ts_floor_i32(base * mesh->detail + 0.5f);
	return n < (i32)least ? least : (u32)n;
}

bool ts_mesh_shows(const ts_mesh *mesh, f32 detail) { return mesh->detail >= detail; }

f32 ts_mesh_random(const ts_mesh *mesh, u32 id) { return ts_uniform(ts_random(id, 5u, mesh->seed)); }

ts_place ts_place_at(f32 x, f32 y, f32 z, f32 turns)
{
	f32 c = ts_cos_turn(turns), s = ts_sin_turn(turns);
	ts_place place = {ts_v3_make(x, y, z), ts_v3_make(c, 0.0f, -s), ts_v3_make(0.0f, 1.0f, 0.0f),
	                  ts_v3_make(s, 0.0f, c)};
	return place;
}

ts_place ts_place_world(void) { return ts_place_at(0.0f, 0.0f, 0.0f, 0.0f); }

static ts_v3 turn(const ts_place *place, ts_v3 v)
{
	return ts_add(ts_add(ts_scale(place->x, v.x), ts_scale(place->y, v.y)), ts_scale(place->z, v.z));
}

ts_place ts_place_in(const ts_place *outer, ts_place inner)
{
	inner.o = ts_add(outer->o, turn(outer, inner.o));
	inner.x = turn(outer, inner.x);
	inner.y = turn(outer, inner.y);
	inner.z = turn(outer, inner.z);
	return inner;
}

ts_place ts_place_along(ts_v3 origin, ts_v3 up)
{
	ts_v3 y = ts_normalize(up);
	ts_v3 side = ts_abs(y.x) < 0.75f ? ts_v3_make(1.0f, 0.0f, 0.0f) : ts_v3_make(0.0f, 0.0f, 1.0f);
	ts_v3 z = ts_normalize(ts_cross(side, y));
	ts_place place = {origin, ts_cross(y, z), y, z};
	return place;
}

/* The slope at a point between the steps before and after it: none at an extreme, and never steep enough to
 * overshoot. */
static f32 slope(f32 before, f32 after)
{
	if (before * after <= 0.0f) return 0.0f;
	f32 limit = 2.0f * ts_min(ts_abs(before), ts_abs(after));
	return ts_clamp((before + after) * 0.5f, -limit, limit);
}

f32 ts_mesh_spline(const f32 *values, u32 stride, u32 n, f32 at)
{
	u32 i = (u32)ts_min_i32(ts_max_i32(ts_floor_i32(at), 0), (i32)n - 2);
	f32 t = at - (f32)i;
	f32 b = values[i * stride], c = values[(i + 1) * stride];
	f32 step = c - b;
	f32 m0 = slope(i > 0 ? b - values[(i - 1) * stride] : step, step);
	f32 m1 = slope(step, i + 2 < n ? values[(i + 2) * stride] - c : step);
	f32 k3 = m0 + m1 - 2.0f * step;
	f32 k2 = 3.0f * step - 2.0f * m0 - m1;
	return ((k3 * t + k2) * t + m0) * t + b;
}

static u32 add_vertex(ts_mesh *mesh, const ts_corner *corner)
{
	f32 u = ts_put(corner->uv.x + mesh->shift.x), w = ts_put(corner->uv.y + mesh->shift.y);
	ts_vertex v = {.colour = {1.0f, 1.0f, 1.0f, 1.0f}, .uv = {u, w, u, w}};
	ts_store3(v.position, ts_add(mesh->place.o, turn(&mesh->place, corner->p)));
	ts_store3(v.normal, ts_normalize(turn(&mesh->place, corner->n)));
	return ts_build_vertex(mesh->build, &v);
}

static void add_triangle(ts_mesh *mesh, u32 a, u32 b, u32 c)
{
	ts_build_triangle(mesh->build, a, b, c, mesh->material);
}

/* Difference of two neighbours of corner i along an axis of n cells; wraps where the surface closes. */
static ts_v3 step_between(const ts_corner *row, u32 i, u32 n, u32 stride, bool wrap)
{
	u32 before = i > 0 ? i - 1 : wrap ? n - 1 : 0;
	u32 after = i < n ? i + 1 : wrap ? 1 : n;
	return ts_sub(row[after * stride].p, row[before * stride].p);
}

static void make_normals(ts_corner *corner, u32 ns, u32 nt, u32 flags)
{
	for (u32 j = 0; j <= nt; j++) {
		for (u32 i = 0; i <= ns; i++) {
			ts_corner *c = &corner[j * (ns + 1) + i];
			if (ts_dot(c->n, c->n) > 0.0f) continue;
			u32 row = j == 0 && (flags & TS_GRID_POLE_T0) != 0    ? 1
			          : j == nt && (flags & TS_GRID_POLE_T1) != 0 ? nt - 1
			                                                      : j;
			ts_v3 ds = step_between(corner + row * (ns + 1), i, ns, 1, (flags & TS_GRID_WRAP_S) != 0);
			ts_v3 dt = step_between(corner + i, j, nt, ns + 1, false);
			c->n = ts_normalize(ts_cross(ds, dt));
		}
	}
}

static ts_corner *sample(u32 ns, u32 nt, u32 flags, ts_mesh_surface *surface, const void *shape)
{
	ts_corner *corner = ts_alloc_zero((size_t)(ns + 1) * (nt + 1), sizeof *corner, "a part of a built-in scene");
	if (corner == NULL) return NULL;
	for (u32 j = 0; j <= nt; j++) {
		for (u32 i = 0; i <= ns; i++) {
			surface(&corner[j * (ns + 1) + i], shape, (f32)i / (f32)ns, (f32)j / (f32)nt);
		}
	}
	if ((flags & TS_GRID_FLAT) == 0) make_normals(corner, ns, nt, flags);
	return corner;
}

static void add_cells(ts_mesh *mesh, u32 first, u32 ns, u32 nt, u32 flags)
{
	for (u32 j = 0; j < nt; j++) {
		bool low = j == 0 && (flags & TS_GRID_POLE_T0) != 0;
		bool high = j == nt - 1 && (flags & TS_GRID_POLE_T1) != 0;
		for (u32 i = 0; i < ns; i++) {
			u32 a = first + j * (ns + 1) + i, b = a + 1, c = b + ns + 1, d = a + ns + 1;
			if (!low) add_triangle(mesh, a, b, high ? d : c);
			if (!high) add_triangle(mesh, a, c, d);
		}
	}
}

static void add_flat_cells(ts_mesh *mesh, ts_corner *corner, u32 ns, u32 nt)
{
	for (u32 j = 0; j < nt; j++) {
		for (u32 i = 0; i < ns; i++) {
			ts_corner c[4] = {corner[j * (ns + 1) + i], corner[j * (ns + 1) + i + 1],
			                  corner[(j + 1) * (ns + 1) + i + 1], corner[(j + 1) * (ns + 1) + i]};
			ts_v3 n = ts_normalize(ts_cross(ts_sub(c[2].p, c[0].p), ts_sub(c[3].p, c[1].p)));
			u32 v[4];
			for (u32 k = 0; k < 4; k++) {
				c[k].n = n;
				v[k] = add_vertex(mesh, &c[k]);
			}
			add_triangle(mesh, v[0], v[1], v[2]);
			add_triangle(mesh, v[0], v[2], v[3]);
		}
	}
}

void ts_mesh_grid(ts_mesh *mesh, u32 ns, u32 nt, u32 flags, ts_mesh_surface *surface, const void *shape)
{
	mesh->n += 2ul * ns * nt;
	mesh->n -= (flags & TS_GRID_POLE_T0) != 0 ? ns : 0;
	mesh->n -= (flags & TS_GRID_POLE_T1) != 0 ? ns : 0;
	if (mesh->build == NULL || ts_build_failed(mesh->build)) return;
	ts_corner *corner = sample(ns, nt, flags, surface, shape);
	if (corner == NULL) {
		ts_build_adopt(mesh->build);
		return;
	}
	if ((flags & TS_GRID_FLAT) != 0) {
		add_flat_cells(mesh, corner, ns, nt);
	} else {
		u32 first = add_vertex(mesh, &corner[0]);
		for (u32 i = 1; i < (ns + 1) * (nt + 1); i++) add_vertex(mesh, &corner[i]);
		add_cells(mesh, first, ns, nt, flags);
	}
	free(corner);
}

static u32 add_between(ts_mesh *mesh, const ts_corner *a, const ts_corner *b)
{
	ts_corner c = {ts_scale(ts_add(a->p, b->p), 0.5f),
	               ts_scale(ts_add(a->n, b->n), 0.5f),
	               {(a->uv.x + b->uv.x) * 0.5f, (a->uv.y + b->uv.y) * 0.5f}};
	return add_vertex(mesh, &c);
}

/* A cell of corners v as `n` triangles: 2; 3, with one more corner on its lower border; or 4, around its middle. */
static void add_cell(ts_mesh *mesh, const ts_corner *row, u32 ns, const u32 v[4], u32 n)
{
	if (n == 2) {
		add_triangle(mesh, v[0], v[1], v[2]);
		add_triangle(mesh, v[0], v[2], v[3]);
	} else if (n == 3) {
		u32 border = add_between(mesh, &row[0], &row[1]);
		add_triangle(mesh, v[0], border, v[3]);
		add_triangle(mesh, border, v[1], v[2]);
		add_triangle(mesh, border, v[2], v[3]);
	} else {
		u32 middle = add_between(mesh, &row[0], &row[ns + 2]);
		for (u32 k = 0; k < 4; k++) add_triangle(mesh, v[k], v[(k + 1) % 4], middle);
	}
}

void ts_mesh_fill(ts_mesh *mesh, u32 n, f32 aspect, ts_mesh_surface *surface, const void *shape)
{
	u32 nt = (u32)ts_max_i32(ts_floor_i32(ts_sqrt((f32)n * 0.5f / aspect)), 1);
	u32 ns = n / (2u * nt);
	u32 odd = n & 1u;
	u32 stars = n / 2u - ns * nt;
	mesh->n += n;
	if (mesh->build == NULL || ts_build_failed(mesh->build)) return;
	ts_corner *corner = sample(ns, nt, 0, surface, shape);
	if (corner == NULL) {
		ts_build_adopt(mesh->build);
		return;
	}
	u32 first = add_vertex(mesh, &corner[0]);
	for (u32 i = 1; i < (ns + 1) * (nt + 1); i++) add_vertex(mesh, &corner[i]);
	for (u32 k = 0; k < ns * nt; k++) {
		u32 at = k / ns * (ns + 1) + k % ns;
		u32 a = first + at;
		u32 v[4] = {a, a + 1, a + ns + 2, a + ns + 1};
		add_cell(mesh, &corner[at], ns, v, k < odd ? 3 : k < odd + stars ? 4 : 2);
	}
	free(corner);
}
