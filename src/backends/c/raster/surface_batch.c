/* Surfaces side by side: the corners' attributes are copied, then vectorized loops compute ts_k_surface from them. */
#include "backends/c/raster/surface_batch.h"
#include <string.h>
#include "backends/wide.h"

enum { N = TS_ABREAST, UV_SETS = 2 };
enum { BASE, METALLIC_ROUGHNESS, NORMAL_MAP, OCCLUSION, EMISSIVE, SLOTS };

/* A vertex as floats: blended attributes stand at its end. */
enum { VERTEX = sizeof(ts_vertex) / sizeof(f32), BLENDED = 16, NORMAL = 0, TANGENT = 4, COLOUR = 12 };

/* Attributes of corners. */
typedef struct {
	ts_lanes3 normal, tangent, colour; /* blended */
	ts_lanes3 ab, ac;                  /* edges */
	f32 handedness[N];
	ts_uv_batch uv[UV_SETS];
	f32 area[N];
	u32 mirror[N]; /* 1: the surface belongs to a reflector */
} corners;

static inline void copy_blends(corners *to, u32 i, const ts_vertex *const v[3], ts_v3 w)
{
	f32 a[VERTEX], b[VERTEX], c[VERTEX], r[BLENDED];
	memcpy(a, v[0], sizeof a);
	memcpy(b, v[1], sizeof b);
	memcpy(c, v[2], sizeof c);
	const u32 first = VERTEX - BLENDED;
	for (u32 k = 0; k < BLENDED; k++) r[k] = ts_blend1(w, a[first + k], b[first + k], c[first + k]);
	ts_set_lane3(&to->normal, i, ts_load3(r + NORMAL));
	ts_set_lane3(&to->tangent, i, ts_load3(r + TANGENT));
	ts_set_lane3(&to->colour, i, ts_load3(r + COLOUR));
}

static inline void copy_uv(ts_uv_batch *to, u32 i, const ts_vertex *const v[3], u32 set)
{
	for (u32 k = 0; k < 3; k++) {
		to->u[k][i] = v[k]->uv[2 * set];
		to->v[k][i] = v[k]->uv[2 * set + 1];
	}
}

static inline void copy_edges(corners *to, u32 i, const ts_vertex *const v[3])
{
	ts_v3 a = ts_load3(v[0]->position);
	ts_set_lane3(&to->ab, i, ts_sub(ts_load3(v[1]->position), a));
	ts_set_lane3(&to->ac, i, ts_sub(ts_load3(v[2]->position), a));
	to->handedness[i] = v[0]->tangent[3];
}

/* sets: 1 for each set of texture coordinates that a slot reads; bumpy: there is a normal map. */
TS_WIDE(void, copy_corners,
        (corners * to, const ts_arrays *scene, const ts_surface_batch *of, u32 sets, bool bumpy, u32 n),
        (to, scene, of, sets, bumpy, n))
{
	for (u32 i = 0; i < n; i++) {
		const ts_triangle *t = &scene->triangles[of->triangle[i]];
		const ts_vertex *const v[3] = {&scene->vertices[t->vertex[0]], &scene->vertices[t->vertex[1]],
		                               &scene->vertices[t->vertex[2]]};
		copy_blends(to, i, v, ts_lane3(&of->w, i));
		for (u32 set = 0; set < UV_SETS; set++)
			if ((sets >> set & 1) != 0) copy_uv(&to->uv[set], i, v, set);
		if (bumpy) copy_edges(to, i, v);
		to->mirror[i] = scene->objects[v[0]->object].reflector != TS_NONE ? 1 : 0;
	}
}

/* Like the start of ts_k_surface_geometry. */
TS_WIDE(void, find_geometry,
        (ts_surfaces *restrict to, corners *restrict c, const ts_surface_batch *restrict of, u32 n), (to, c, of, n))
{
	for (u32 i = 0; i < n; i++) {
		ts_v3 across = ts_lane3(&of->normal, i), face = ts_normalize(across);
		ts_v3 normal = ts_normalize(ts_lane3(&c->normal, i));
		c->area[i] = ts_length(across);
		ts_set_lane3(&to->face, i, face);
		ts_set_lane3(&to->n, i, ts_choose_lane(ts_length(normal) > 0.0f ? 1u : 0u, normal, face));
	}
}

/* What all lanes of a normal map share. */
typedef struct {
	f32 transform[6];
	f32 scale;
} bumps;

/* ts_k_tangent of lane i. */
static inline ts_tangent tangent_of(const corners *c, const ts_uv_batch *uv, const bumps *m, u32 i)
{
	ts_v2 p = ts_uv_lane(m->transform, uv, 0, i), q = ts_uv_lane(m->transform, uv, 1, i);
	ts_v2 r = ts_uv_lane(m->transform, uv, 2, i);
	f32 dv1 = q.y - p.y, dv2 = r.y - p.y;
	f32 det = ts_flush(ts_diff_of_products(q.x - p.x, dv2, r.x - p.x, dv1));
	f32 positive = det > 0.0f ? 1.0f : 0.0f, sign = det < 0.0f ? -1.0f : positive;
	ts_v3 of_uv = ts_sub(ts_scale(ts_lane3(&c->ab, i), sign * dv2), ts_scale(ts_lane3(&c->ac, i), sign * dv1));
	ts_v3 blended = ts_lane3(&c->tangent, i);
	u32 there = ts_length(blended) > 0.0f ? 1u : 0u;
	f32 hand = c->handedness[i] < 0.0f ? -1.0f : 1.0f;
	ts_tangent t;
	t.t = ts_choose_lane(there, blended, of_uv);
	t.handedness = there != 0u ? hand : -sign;
	return t;
}

/* Like ts_k_normal_map, given the map's values. */
TS_WIDE(void, turn_normals,
        (ts_surfaces *restrict to, const corners *restrict c, const ts_uv_batch *restrict uv,
         const ts_lanes3 *restrict held, bumps m, u32 n),
        (to, c, uv, held, m, n))
{
	for (u32 i = 0; i < n; i++) {
		ts_tangent tangent = tangent_of(c, uv, &m, i);
		ts_v3 normal = ts_lane3(&to->n, i);
		ts_v3 t = ts_normalize(ts_mad(tangent.t, normal, -ts_dot(normal, tangent.t)));
		ts_v3 b = ts_scale(ts_cross(normal, t), tangent.handedness);
		f32 x = (held->x[i] * 2.0f - 1.0f) * m.scale, y = (held->y[i] * 2.0f - 1.0f) * m.scale;
		ts_v3 r = ts_normalize(ts_blend(ts_v3_make(x, y, held->z[i] * 2.0f - 1.0f), t, b, normal));
		u32 good = ts_length(t) > 0.0f ? 1u : 0u;
		good = ts_length(r) > 0.0f ? good : 0u;
		ts_set_lane3(&to->n, i, ts_choose_lane(good, r, normal));
	}
}

/* Like ts_k_surface_material without textures. */
TS_WIDE(void, find_material, (ts_surfaces *restrict to, const corners *restrict c, ts_material m, u32 n), (to, c, m, n))
{
	for (u32 i = 0; i < n; i++) {
		ts_set_lane3(&to->base, i, ts_mul(ts_v3_make(m.base[0], m.base[1], m.base[2]), ts_lane3(&c->colour, i)));
		ts_set_lane3(&to->emissive, i, ts_v3_make(m.emissive[0], m.emissive[1], m.emissive[2]));
		to->metallic[i] = m.metallic;
		to->roughness[i] = m.roughness;
		to->occlusion[i] = 1.0f;
	}
}

TS_WIDE(void, tint, (ts_lanes3 *restrict to, const ts_lanes3 *restrict by, u32 n), (to, by, n))
{
	for (u32 i = 0; i < n; i++) ts_set_lane3(to, i, ts_mul(ts_lane3(to, i), ts_lane3(by, i)));
}

TS_WIDE(void, scale_metal, (ts_surfaces *restrict to, const ts_lanes3 *restrict by, u32 n), (to, by, n))
{
	for (u32 i = 0; i < n; i++) {
		to->roughness[i] = to->roughness[i] * by->y[i];
		to->metallic[i] = to->metallic[i] * by->z[i];
	}
}

TS_WIDE(void, occlude, (ts_surfaces *restrict to, const ts_lanes3 *restrict by, f32 strength, u32 n),
        (to, by, strength, n))
{
	for (u32 i = 0; i < n; i++) to->occlusion[i] = 1.0f + strength * (by->x[i] - 1.0f);
}

/* ts_k_surface_mirror */
TS_WIDE(void, dull_mirrors, (ts_surfaces *restrict to, const corners *restrict c, u32 n), (to, c, n))
{
	for (u32 i = 0; i < n; i++) {
		to->metallic[i] = c->mirror[i] != 0u ? 0.0f : to->metallic[i];
		to->roughness[i] = c->mirror[i] != 0u ? 1.0f : to->roughness[i];
	}
}

/* One texture after another. */
static void apply(ts_surfaces *to, u32 use, const ts_lanes3 *held, const corners *c, const ts_slot *slot,
                  const ts_material *m, u32 n)
{
	bumps b = {.scale = m->normal_scale};
	memcpy(b.transform, slot->transform, sizeof b.transform);
	switch (use) {
	case BASE: tint(&to->base, held, n); break;
	case METALLIC_ROUGHNESS: scale_metal(to, held, n); break;
	case NORMAL_MAP: turn_normals(to, c, &c->uv[slot->uv_set], held, b, n); break;
	case OCCLUSION: occlude(to, held, m->occlusion, n); break;
	default: tint(&to->emissive, held, n); break;
	}
}

void ts_surfaces_find(ts_surfaces *to, const ts_arrays *scene, const ts_surface_batch *of)
{
	const ts_material *m = &scene->materials[of->material];
	corners c;
	u32 n = ts_whole_lanes(of->n), sets = 0;
	for (u32 use = 0; use < SLOTS; use++)
		if (m->slot[use] != TS_NONE) sets |= 1u << scene->slots[m->slot[use]].uv_set;
	copy_corners(&c, scene, of, sets, m->slot[NORMAL_MAP] != TS_NONE, n);
	find_geometry(to, &c, of, n);
	find_material(to, &c, *m, n);
	for (u32 use = 0; use < SLOTS; use++) {
		if (m->slot[use] == TS_NONE) continue;
		const ts_slot *slot = &scene->slots[m->slot[use]];
		ts_lanes3 held;
		ts_texture_batch(&held, scene, slot, of, &c.uv[slot->uv_set], c.area);
		apply(to, use, &held, &c, slot, m, n);
	}
	dull_mirrors(to, &c, n);
}

#include "backends/selftest.h"
