/* A surface and its light, term by term. This file has no formulas of terms: ts_k_shade itself runs in worlds where
 * only one term is left. */
#include "probe/parts.h"

void ts_probe_put_triangle(ts_probe *p, json_t *object, u32 triangle)
{
	const ts_triangle *t = &p->scene.triangles[triangle];
	u32 reflector = ts_k_reflector_of(&p->scene, triangle);
	ts_probe_put(p, object, "triangle", ts_probe_int(triangle));
	ts_probe_put(p, object, "material", ts_probe_int(t->material));
	ts_probe_put(p, object, "object", ts_probe_int(p->scene.vertices[t->vertex[0]].object));
	if (reflector != TS_NONE) ts_probe_put(p, object, "reflector", ts_probe_int(reflector));
}

static json_t *texture(ts_probe *p, const ts_sample *sample, const char *use, u32 slot_index)
{
	const ts_slot *slot = &p->scene.slots[slot_index];
	ts_v2 uv[3] = {ts_k_slot_uv(slot, sample->a), ts_k_slot_uv(slot, sample->b), ts_k_slot_uv(slot, sample->c)};
	ts_rgba t = ts_k_slot_sample(&p->scene, sample, slot_index);
	f32 u = ts_blend1(sample->w, uv[0].x, uv[1].x, uv[2].x), v = ts_blend1(sample->w, uv[0].y, uv[1].y, uv[2].y);
	return json_pack("{s:s,s:I,s:I,s:[o,o],s:[o,o,o,o]}", "use", use, "slot", (json_int_t)slot_index, "image",
	                 (json_int_t)slot->image, "uv", ts_probe_real(u), ts_probe_real(v), "rgba", ts_probe_real(t.r),
	                 ts_probe_real(t.g), ts_probe_real(t.b), ts_probe_real(t.a));
}

json_t *ts_probe_surface(ts_probe *p, u32 triangle, const ts_surface *s, ts_v3 weights, f32 footprint)
{
	static const char *const uses[] = {"base", "metallic-roughness", "normal", "occlusion", "emissive"};
	const ts_material *material = &p->scene.materials[p->scene.triangles[triangle].material];
	ts_sample sample = ts_k_sample(&p->scene, triangle, weights, ts_k_corners(&p->scene, triangle).n, footprint);
	json_t *o = json_object(), *textures = json_array();
	ts_probe_put_triangle(p, o, triangle);
	ts_probe_put(p, o, "weights", ts_probe_v3(weights));
	ts_probe_put(p, o, "footprint", ts_probe_real(footprint));
	ts_probe_put(p, o, "position", ts_probe_v3(s->p));
	ts_probe_put(p, o, "normal", ts_probe_v3(s->n));
	ts_probe_put(p, o, "face_normal", ts_probe_v3(s->face));
	ts_probe_put(p, o, "base", ts_probe_v3(s->base));
	ts_probe_put(p, o, "emissive", ts_probe_v3(s->emissive));
	ts_probe_put(p, o, "metallic", ts_probe_real(s->metallic));
	ts_probe_put(p, o, "roughness", ts_probe_real(s->roughness));
	ts_probe_put(p, o, "occlusion", ts_probe_real(s->occlusion));
	ts_probe_put(p, o, "flags", ts_probe_int(s->flags));
	for (u32 i = 0; i < 5; i++) {
		if (material->slot[i] != TS_NONE) ts_probe_append(p, textures, texture(p, &sample, uses[i], material->slot[i]));
	}
	ts_probe_put(p, o, "textures", textures);
	return o;
}

/* The samples of each light that reach a surface; NULL: all do. */
typedef struct {
	const u32 *lit;
	const ts_lamp *lamps;
} reach;

/* The result of ts_k_shade with one light, at its reach, or with none. */
static ts_v3 term(const ts_probe *p, const ts_surface *surface, ts_v3 v, reach r, u32 light, f32 ambient)
{
	ts_arrays world = p->scene;
	ts_surface s = *surface;
	bool one = light != TS_NONE;
	bool shadows = one && r.lit != NULL;
	world.lights = one ? &p->scene.lights[light] : NULL;
	world.n_lights = one ? 1 : 0;
	world.ambient = ambient;
	s.emissive = ts_v3_make(0.0f, 0.0f, 0.0f);
	return ts_k_shade_lit(&world, &s, v, shadows ? &r.lit[light] : NULL, shadows ? &r.lamps[light] : NULL);
}

static ts_v3 put_lights(ts_probe *p, json_t *o, const ts_surface *s, ts_v3 v, reach r, ts_v3 sum)
{
	static const char *const kinds[] = {"directional", "point", "spot"};
	json_t *lights = json_array();
	for (u32 i = 0; i < p->scene.n_lights; i++) {
		const ts_light *light = &p->scene.lights[i];
		ts_v3 l, radiance = term(p, s, v, r, i, 0.0f);
		f32 arrives = ts_k_light(light, s->p, &l) * ts_k_share(r.lit, r.lamps, i);
		sum = ts_add(sum, radiance);
		ts_probe_append(p, lights,
		                json_pack("{s:I,s:s,s:o,s:o,s:o}", "light", (json_int_t)i, "kind",
		                          kinds[light->kind < 2 ? light->kind : 2], "towards", ts_probe_v3(l), "arrives",
		                          ts_probe_real(arrives), "radiance", ts_probe_v3_bits(radiance)));
	}
	ts_probe_put(p, o, "lights", lights);
	return sum;
}

json_t *ts_probe_shading(ts_probe *p, const ts_surface *s, ts_v3 v, const u32 *lit, const ts_lamp *lamps, ts_v3 *total)
{
	reach r = {lit, lamps};
	json_t *o = json_object();
	*total = ts_k_shade_lit(&p->scene, s, v, lit, lamps);
	ts_probe_put(p, o, "towards", ts_probe_v3(v));
	if ((s->flags & TS_UNLIT) != 0) {
		ts_probe_put(p, o, "unlit", ts_probe_v3_bits(s->base));
	} else {
		ts_v3 ambient = term(p, s, v, r, TS_NONE, p->scene.ambient);
		ts_probe_put(p, o, "emissive", ts_probe_v3_bits(s->emissive));
		ts_probe_put(p, o, "ambient", ts_probe_v3_bits(ambient));
		ts_v3 sum = put_lights(p, o, s, v, r, ts_add(s->emissive, ambient));
		ts_probe_put_sum(p, o, sum, *total);
	}
	ts_probe_put(p, o, "total", ts_probe_v3_bits(*total));
	return o;
}
