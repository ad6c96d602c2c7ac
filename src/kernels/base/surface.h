/* The surface: position, normal and material of a triangle at weights of its corners, for eye pixels, face texels,
 * points and ray hits alike (METHODS 4). A footprint is the width of the sample in world units. */
#ifndef TS_KERNELS_BASE_SURFACE_H
#define TS_KERNELS_BASE_SURFACE_H
#include "kernels/base/texture.h"

typedef struct {
	ts_v3 p;    /* position */
	ts_v3 n;    /* shading normal, unit, on the side of the face normal */
	ts_v3 face; /* face normal, unit */
	ts_v3 base; /* base colour */
	ts_v3 emissive;
	f32 metallic, roughness, occlusion;
	u32 flags; /* of the material */
} ts_surface;

/* A triangle ready for look-ups at one sample. */
typedef struct {
	TS_GLOBAL const ts_vertex *a, *b, *c;
	TS_GLOBAL const ts_material *material;
	ts_v3 w;  /* weights */
	f32 area; /* |(b - a) x (c - a)| */
	f32 footprint;
} ts_sample;

TS_FN ts_sample ts_k_sample(const ts_arrays *scene, u32 triangle, ts_v3 w, ts_v3 normal, f32 footprint)
{
	TS_GLOBAL const ts_triangle *t = &scene->triangles[triangle];
	ts_sample r;
	r.a = &scene->vertices[t->vertex[0]];
	r.b = &scene->vertices[t->vertex[1]];
	r.c = &scene->vertices[t->vertex[2]];
	r.material = &scene->materials[t->material];
	r.w = w;
	r.area = ts_length(normal);
	r.footprint = footprint;
	return r;
}

/* The texture coordinates of a corner, by the slot's affine transform (KHR_texture_transform). */
TS_FN ts_v2 ts_k_slot_uv(TS_GLOBAL const ts_slot *slot, TS_GLOBAL const ts_vertex *v)
{
	f32 x = v->uv[slot->uv_set * 2u];
	f32 y = v->uv[slot->uv_set * 2u + 1u];
	TS_GLOBAL const f32 *m = slot->transform;
	f32 s = m[0] * x + m[1] * y;
	f32 t = m[3] * x + m[4] * y;
	return ts_v2_make(s + m[2], t + m[5]);
}

/* The texture of a slot, filtered for the sample's footprint. */
TS_HOT ts_rgba ts_k_slot_sample(const ts_arrays *scene, const ts_sample *s, u32 slot_index)
{
	TS_GLOBAL const ts_slot *slot = &scene->slots[slot_index];
	ts_v2 a = ts_k_slot_uv(slot, s->a);
	ts_v2 b = ts_k_slot_uv(slot, s->b);
	ts_v2 c = ts_k_slot_uv(slot, s->c);
	f32 uv_area = ts_abs(ts_diff_of_products(b.x - a.x, c.y - a.y, b.y - a.y, c.x - a.x));
	TS_GLOBAL const ts_image *image = &scene->images[slot->image];
	u32 lod = ts_k_texture_lod(image->width, image->height, s->footprint, uv_area, s->area);
	ts_v2 uv = ts_v2_make(ts_blend1(s->w, a.x, b.x, c.x), ts_blend1(s->w, a.y, b.y, c.y));
	return ts_k_texture_sample(scene, slot, uv, lod);
}

/* Texture alpha times factor times vertex alpha. */
TS_FN f32 ts_k_alpha(const ts_arrays *scene, const ts_sample *s)
{
	f32 vertex = ts_blend1(s->w, s->a->colour[3], s->b->colour[3], s->c->colour[3]);
	f32 alpha = s->material->base[3] * vertex;
	if (s->material->slot[0] == TS_NONE) return alpha;
	return alpha * ts_k_slot_sample(scene, s, s->material->slot[0]).a;
}

TS_FN bool ts_k_is_masked(const ts_arrays *scene, u32 triangle)
{
	return (scene->materials[scene->triangles[triangle].material].flags & TS_MASKED) != 0u;
}

/* A sample of a masked material with alpha below the cutoff is dropped (METHODS 4). */
TS_CALL bool ts_k_is_below_cutoff(const ts_arrays *scene, u32 triangle, ts_v3 w, ts_v3 normal, f32 footprint)
{
	ts_sample s = ts_k_sample(scene, triangle, w, normal, footprint);
	return ts_k_alpha(scene, &s) < s.material->alpha_cutoff;
}

TS_FN bool ts_k_is_cut(const ts_arrays *scene, u32 triangle, ts_v3 w, ts_v3 normal, f32 footprint)
{
	return ts_k_is_masked(scene, triangle) && ts_k_is_below_cutoff(scene, triangle, w, normal, footprint);
}

/* T and the sign of B = cross(n, T) * handedness. T is zero where there is no tangent. */
typedef struct {
	ts_v3 t;
	f32 handedness;
} ts_tangent;

/* The direction in which u grows on the triangle; none where uv is degenerate. */
TS_FN ts_tangent ts_k_tangent_of_uv(const ts_sample *s, TS_GLOBAL const ts_slot *slot)
{
	/* Take the determinant of the edges in uv; only its sign counts, since the tangent is normalized later. */
	ts_v2 a = ts_k_slot_uv(slot, s->a);
	ts_v2 b = ts_k_slot_uv(slot, s->b);
	ts_v2 c = ts_k_slot_uv(slot, s->c);
	f32 dv1 = b.y - a.y;
	f32 dv2 = c.y - a.y;
	f32 det = ts_flush(ts_diff_of_products(b.x - a.x, dv2, c.x - a.x, dv1));
	f32 sign = det < 0.0f ? -1.0f : det > 0.0f ? 1.0f : 0.0f;
	/* Combine the edges so that u grows along T and v stays. */
	ts_v3 pa = ts_load3(s->a->position);
	ts_v3 e1 = ts_scale(ts_sub(ts_load3(s->b->position), pa), sign * dv2);
	ts_v3 e2 = ts_scale(ts_sub(ts_load3(s->c->position), pa), sign * dv1);
	ts_tangent r;
	r.t = ts_sub(e1, e2);
	/* Turn B against v: y of a normal map points up, v grows downward. */
	r.handedness = -sign;
	return r;
}

/* The tangent of the vertices (TANGENT of glTF); without one, that of the uv gradient of the triangle (METHODS 4). */
TS_FN ts_tangent ts_k_tangent(const ts_sample *s, TS_GLOBAL const ts_slot *slot)
{
	ts_tangent r;
	r.t = ts_blend(s->w, ts_load3(s->a->tangent), ts_load3(s->b->tangent), ts_load3(s->c->tangent));
	r.handedness = s->a->tangent[3] < 0.0f ? -1.0f : 1.0f;
	return ts_length(r.t) > 0.0f ? r : ts_k_tangent_of_uv(s, slot);
}

/* The normal map's normal in the frame T, B, n. */
TS_FN ts_v3 ts_k_normal_map(const ts_arrays *scene, const ts_sample *s, ts_v3 n)
{
	/* Leave n where there is no normal map. */
	u32 slot = s->material->slot[2];
	if (slot == TS_NONE) return n;
	/* Build the frame: T at right angles to n, B across both (METHODS 4). */
	ts_tangent tangent = ts_k_tangent(s, &scene->slots[slot]);
	ts_v3 t = ts_normalize(ts_mad(tangent.t, n, -ts_dot(n, tangent.t)));
	if (!(ts_length(t) > 0.0f)) return n;
	ts_v3 b = ts_scale(ts_cross(n, t), tangent.handedness);
	/* Turn the texel into a direction, and the direction into the frame. */
	ts_rgba m = ts_k_slot_sample(scene, s, slot);
	f32 x = (m.r * 2.0f - 1.0f) * s->material->normal_scale;
	f32 y = (m.g * 2.0f - 1.0f) * s->material->normal_scale;
	f32 z = m.b * 2.0f - 1.0f;
	ts_v3 r = ts_normalize(ts_blend(ts_v3_make(x, y, z), t, b, n));
	return ts_length(r) > 0.0f ? r : n;
}

/* Position and normals of the sample, without its material. */
TS_FN ts_surface ts_k_surface_geometry(const ts_arrays *scene, const ts_sample *s, ts_v3 normal)
{
	ts_surface r;
	r.p = ts_blend(s->w, ts_load3(s->a->position), ts_load3(s->b->position), ts_load3(s->c->position));
	r.face = ts_normalize(normal);
	ts_v3 n = ts_normalize(ts_blend(s->w, ts_load3(s->a->normal), ts_load3(s->b->normal), ts_load3(s->c->normal)));
	n = ts_length(n) > 0.0f ? n : r.face;
	r.n = ts_k_normal_map(scene, s, n);
	return r;
}

/* The material at the sample: factors times vertex colour times textures, in the order of glTF 2.0 (CONTRACT rule
 * 39). */
TS_FN void ts_k_surface_material(const ts_arrays *scene, const ts_sample *s, ts_surface *r)
{
	/* Begin with the factors and the vertex colour. */
	TS_GLOBAL const ts_material *m = s->material;
	ts_v3 colour = ts_blend(s->w, ts_load3(s->a->colour), ts_load3(s->b->colour), ts_load3(s->c->colour));
	r->base = ts_mul(ts_load3(m->base), colour);
	r->emissive = ts_load3(m->emissive);
	r->metallic = m->metallic;
	r->roughness = m->roughness;
	r->occlusion = 1.0f;
	r->flags = m->flags;
	/* Multiply by the textures: base colour, then roughness (green) and metallic (blue). */
	if (m->slot[0] != TS_NONE) {
		ts_rgba t = ts_k_slot_sample(scene, s, m->slot[0]);
		r->base = ts_mul(r->base, ts_v3_make(t.r, t.g, t.b));
	}
	if (m->slot[1] != TS_NONE) {
		ts_rgba t = ts_k_slot_sample(scene, s, m->slot[1]);
		r->roughness = r->roughness * t.g;
		r->metallic = r->metallic * t.b;
	}
	/* Weaken the occlusion texture (red) by its strength, and tint the emission. */
	if (m->slot[3] != TS_NONE) {
		ts_rgba t = ts_k_slot_sample(scene, s, m->slot[3]);
		r->occlusion = 1.0f + m->occlusion * (t.r - 1.0f);
	}
	if (m->slot[4] != TS_NONE) {
		ts_rgba t = ts_k_slot_sample(scene, s, m->slot[4]);
		r->emissive = ts_mul(r->emissive, ts_v3_make(t.r, t.g, t.b));
	}
}

/* A mirror whose reflection is not followed is diffuse in its own colour (METHODS 2). */
TS_FN void ts_k_surface_mirror(const ts_arrays *scene, u32 triangle, ts_surface *r)
{
	if (ts_k_reflector_of(scene, triangle) == TS_NONE) return;
	r->metallic = 0.0f;
	r->roughness = 1.0f;
}

/* Position, normals and material. w: weights of the corners, not negative, of sum 1. */
TS_FN ts_surface ts_k_surface(const ts_arrays *scene, u32 triangle, ts_v3 w, f32 footprint)
{
	ts_corners t = ts_k_corners(scene, triangle);
	ts_sample s = ts_k_sample(scene, triangle, w, t.n, footprint);
	ts_surface r = ts_k_surface_geometry(scene, &s, t.n);
	ts_k_surface_material(scene, &s, &r);
	ts_k_surface_mirror(scene, triangle, &r);
	return r;
}

/* The shading normal on the side of the surface from which `towards` points away. */
TS_FN ts_v3 ts_k_facing_normal(const ts_surface *s, ts_v3 towards)
{
	return ts_dot(s->face, towards) < 0.0f ? ts_neg(s->n) : s->n;
}

#define TS_LEAST_SLANTED 0.015625f

/* Footprint of a pixel `width` world units wide at this depth, on a surface seen at this slant: width / sqrt |cos|.
 * |cos| is at least 2^-6, which bounds the footprint of a surface seen edge-on. d: from the eye to the surface; n: the
 * triangle's normal, any length. */
TS_FN f32 ts_k_footprint(f32 width, ts_v3 d, ts_v3 n)
{
	f32 lengths = ts_length(d) * ts_length(n);
	f32 cosine = lengths > 0.0f ? ts_abs(ts_dot(d, n)) / lengths : 1.0f;
	return width / ts_sqrt(ts_max(cosine, TS_LEAST_SLANTED));
}

#endif
