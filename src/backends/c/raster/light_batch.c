/* Lights one after another, each on all surfaces. */
#include "backends/c/raster/surface_batch.h"
#include "backends/wide.h"

enum { N = TS_ABREAST };

typedef struct {
	ts_lanes3 v; /* to the viewer, unit */
	ts_lanes3 n; /* turned to the viewer where both sides are seen */
	f32 share[N];
} view;

/* Emission and ambient light; like the start of ts_k_shade_lit. */
TS_WIDE(void, start,
        (ts_lanes3 *restrict sum, view *restrict to, const ts_surface_batch *restrict of, const ts_surfaces *restrict s,
         f32 ambient, u32 two_sided, u32 n),
        (sum, to, of, s, ambient, two_sided, n))
{
	for (u32 i = 0; i < n; i++) {
		ts_v3 v = ts_normalize(ts_sub(ts_lane3(&of->viewer, i), ts_lane3(&of->p, i))), normal = ts_lane3(&s->n, i);
		u32 behind = ts_dot(ts_lane3(&s->face, i), v) < 0.0f ? two_sided : 0u;
		f32 by = (ambient * s->occlusion[i]) * (1.0f - s->metallic[i]);
		ts_set_lane3(&to->v, i, v);
		ts_set_lane3(&to->n, i, ts_choose_lane(behind, ts_neg(normal), normal));
		ts_set_lane3(sum, i, ts_mad(ts_lane3(&s->emissive, i), ts_lane3(&s->base, i), by));
		to->share[i] = 1.0f;
	}
}

/* ts_k_light of a point or spot light. */
static inline f32 arrives_from(const ts_light *light, u32 kind, ts_v3 p, ts_v3 *l)
{
	ts_v3 d = ts_sub(ts_v3_make(light->position[0], light->position[1], light->position[2]), p);
	f32 d2 = ts_flush(ts_dot(d, d));
	*l = ts_normalize(d);
	f32 arrives = 1.0f / d2, q = d2 / (light->range * light->range);
	f32 window = ts_clamp(1.0f - q * q, 0.0f, 1.0f);
	arrives = light->range > 0.0f ? arrives * window : arrives;
	if (kind == TS_LIGHT_KIND_SPOT) {
		ts_v3 direction = ts_v3_make(light->direction[0], light->direction[1], light->direction[2]);
		f32 cosine = -ts_dot(direction, *l);
		f32 cone = ts_clamp(cosine * light->spot_scale + light->spot_offset, 0.0f, 1.0f);
		arrives = arrives * (cone * cone);
	}
	return d2 > 0.0f ? ts_flush(arrives) : 0.0f;
}

static inline ts_v3 added(ts_v3 sum, const ts_light *light, u32 kind, const ts_surface *s, ts_v3 v, f32 share)
{
	ts_v3 l = ts_v3_make(-light->direction[0], -light->direction[1], -light->direction[2]);
	f32 arrives = (kind == TS_LIGHT_KIND_DIRECTIONAL ? 1.0f : arrives_from(light, kind, s->p, &l)) * share;
	f32 n_l = ts_flush(ts_dot(s->n, l));
	ts_v3 intensity = ts_v3_make(light->intensity[0], light->intensity[1], light->intensity[2]);
	ts_v3 more = ts_mul(ts_scale(intensity, arrives), ts_k_brdf(s, s->n, v, l, n_l));
	u32 lit = n_l > 0.0f ? 1u : 0u;
	lit = arrives > 0.0f ? lit : 0u;
	return ts_choose_lane(lit, ts_add(sum, more), sum);
}

/* Adds one light to all; like the loop of ts_k_shade_lit. */
static inline void add(ts_lanes3 *restrict sum, const view *restrict from, const ts_surface_batch *restrict of,
                       const ts_surfaces *restrict s, const ts_light *light, u32 kind, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		ts_surface at;
		at.p = ts_lane3(&of->p, i);
		at.n = ts_lane3(&from->n, i);
		at.base = ts_lane3(&s->base, i);
		at.metallic = s->metallic[i];
		at.roughness = s->roughness[i];
		ts_set_lane3(sum, i, added(ts_lane3(sum, i), light, kind, &at, ts_lane3(&from->v, i), from->share[i]));
	}
}

TS_WIDE(void, add_directional,
        (ts_lanes3 *restrict sum, const view *restrict from, const ts_surface_batch *restrict of,
         const ts_surfaces *restrict s, ts_light light, u32 n),
        (sum, from, of, s, light, n))
{
	add(sum, from, of, s, &light, TS_LIGHT_KIND_DIRECTIONAL, n);
}

TS_WIDE(void, add_point,
        (ts_lanes3 *restrict sum, const view *restrict from, const ts_surface_batch *restrict of,
         const ts_surfaces *restrict s, ts_light light, u32 n),
        (sum, from, of, s, light, n))
{
	add(sum, from, of, s, &light, TS_LIGHT_KIND_POINT, n);
}

TS_WIDE(void, add_spot,
        (ts_lanes3 *restrict sum, const view *restrict from, const ts_surface_batch *restrict of,
         const ts_surfaces *restrict s, ts_light light, u32 n),
        (sum, from, of, s, light, n))
{
	add(sum, from, of, s, &light, TS_LIGHT_KIND_SPOT, n);
}

static void find_shares(view *to, const ts_surface_batch *of, const ts_lamp *lamps, u32 light)
{
	for (u32 i = 0; i < of->n; i++) to->share[i] = ts_k_share(of->lit[i], lamps, light);
}

TS_WIDE(void, flush_sums, (ts_lanes3 * sum, u32 n), (sum, n))
{
	for (u32 i = 0; i < n; i++) {
		sum->x[i] = ts_flush(sum->x[i]);
		sum->y[i] = ts_flush(sum->y[i]);
		sum->z[i] = ts_flush(sum->z[i]);
	}
}

void ts_light_batch(ts_lanes3 *radiance, const ts_arrays *scene, const ts_lamp *lamps, const ts_surface_batch *of,
                    const ts_surfaces *s)
{
	u32 n = ts_whole_lanes(of->n), flags = scene->materials[of->material].flags;
	view from;
	if ((flags & TS_UNLIT) != 0) {
		*radiance = s->base;
		return;
	}
	start(radiance, &from, of, s, scene->ambient, (flags & TS_DOUBLE_SIDED) != 0 ? 1 : 0, n);
	for (u32 i = 0; i < scene->n_lights; i++) {
		const ts_light *light = &scene->lights[i];
		if (lamps != NULL) find_shares(&from, of, lamps, i);
		switch (light->kind) {
		case TS_LIGHT_KIND_DIRECTIONAL: add_directional(radiance, &from, of, s, *light, n); break;
		case TS_LIGHT_KIND_SPOT: add_spot(radiance, &from, of, s, *light, n); break;
		default: add_point(radiance, &from, of, s, *light, n); break;
		}
	}
	flush_sums(radiance, n);
}

#include "backends/selftest.h"
