/* Lighting: emissive + ambient * base * (1 - metallic) + punctual lights through the BRDF of glTF 2.0 appendix B
 * (GGX, Smith, Schlick, Lambert) (METHODS 4). */
#ifndef TS_KERNELS_BASE_SHADE_H
#define TS_KERNELS_BASE_SHADE_H
#include "kernels/base/surface.h"

#define TS_LIGHT_KIND_DIRECTIONAL 0u
#define TS_LIGHT_KIND_POINT 1u
#define TS_LIGHT_KIND_SPOT 2u

#define TS_LEAST_GGX_COSINE 0.0009765625f /* 2^-10: bounds GGX at grazing angles */

/* The background: the same for the eye, rays and empty texels. */
TS_FN ts_v3 ts_k_background(void)
{
	return ts_v3_make(0.20000000298023223876953125f, 0.300000011920928955078125f, 0.5f);
}

/* Light of KHR_lights_punctual: *l is the unit vector to the light. Returns the factor by which its intensity arrives
 * at p. */
TS_FN f32 ts_k_light(TS_GLOBAL const ts_light *light, ts_v3 p, ts_v3 *l)
{
	/* Let directional light arrive in full. */
	if (light->kind == TS_LIGHT_KIND_DIRECTIONAL) {
		*l = ts_neg(ts_load3(light->direction));
		return 1.0f;
	}
	/* Weaken light by the square of its distance; a place at the light itself gets none. */
	ts_v3 d = ts_sub(ts_load3(light->position), p);
	f32 d2 = ts_flush(ts_dot(d, d));
	*l = ts_normalize(d);
	if (!(d2 > 0.0f)) return 0.0f;
	f32 arrives = 1.0f / d2;
	/* Fade out towards the range: 1 - (distance / range)^4. */
	if (light->range > 0.0f) {
		f32 q = d2 / (light->range * light->range);
		arrives = arrives * ts_clamp(1.0f - q * q, 0.0f, 1.0f);
	}
	/* Fade out from the inner to the outer cone of a spot. */
	if (light->kind == TS_LIGHT_KIND_SPOT) {
		f32 cosine = -ts_dot(ts_load3(light->direction), *l);
		f32 cone = ts_clamp(cosine * light->spot_scale + light->spot_offset, 0.0f, 1.0f);
		arrives = arrives * (cone * cone);
	}
	return ts_flush(arrives);
}

/* Whether a light's maps are the faces of a cube: those of a point light, which shines in all directions. */
TS_FN bool ts_k_has_cube(TS_GLOBAL const ts_light *light) { return light->kind == TS_LIGHT_KIND_POINT; }

#define TS_LEAST_ALPHA_SQUARED 0.000003814697265625f /* 2^-18: the lobe of a perfect mirror would have no width */

/* GGX's alpha squared; alpha is the roughness squared, at least 2^-9. */
TS_FN f32 ts_k_alpha_squared(f32 roughness)
{
	f32 rough = roughness * roughness;
	f32 a2 = rough * rough;
	return ts_max(a2, TS_LEAST_ALPHA_SQUARED);
}

/* Reflectance at normal incidence. */
TS_FN ts_v3 ts_k_f0(const ts_surface *s)
{
	f32 dielectric = 0.039999999105930328369140625f * (1.0f - s->metallic);
	return ts_mad(ts_v3_make(dielectric, dielectric, dielectric), s->base, s->metallic);
}

/* Smith's masking and shadowing, correlated by height (Heitz 2014), divided by 4 n.l n.v. */
TS_FN f32 ts_k_smith(f32 n_l, f32 n_v, f32 a2)
{
	f32 left = n_l * ts_sqrt((n_v * n_v) * (1.0f - a2) + a2);
	f32 right = n_v * ts_sqrt((n_l * n_l) * (1.0f - a2) + a2);
	return 0.5f / (left + right);
}

/* Fresnel's reflectance by Schlick's approximation (1994): f0 + (1 - f0) (1 - v.h)^5. */
TS_FN ts_v3 ts_k_schlick(ts_v3 f0, f32 v_h)
{
	f32 x = 1.0f - v_h;
	f32 x2 = x * x;
	f32 schlick = ts_flush(x * (x2 * x2));
	ts_v3 one = ts_v3_make(1.0f, 1.0f, 1.0f);
	return ts_mad(f0, ts_sub(one, f0), schlick);
}

/* BRDF times n.l for one light. v, l, n: unit; n_l > 0. */
TS_FN ts_v3 ts_k_brdf(const ts_surface *s, ts_v3 n, ts_v3 v, ts_v3 l, f32 n_l)
{
	/* Take the cosines about the half vector h; n.v is bounded from below, and so Smith's term from above. */
	f32 a2 = ts_k_alpha_squared(s->roughness);
	ts_v3 h = ts_normalize(ts_add(l, v));
	f32 n_v = ts_max(ts_abs(ts_dot(n, v)), TS_LEAST_GGX_COSINE);
	f32 n_h = ts_clamp(ts_dot(n, h), 0.0f, 1.0f);
	f32 v_h = ts_clamp(ts_dot(v, h), 0.0f, 1.0f);
	/* Evaluate GGX's distribution of microfacets (Walter et al. 2007) and Smith's visibility. */
	f32 t = (n_h * n_h) * (a2 - 1.0f) + 1.0f;
	f32 d = a2 / ((TS_PI_F32 * t) * t);
	f32 visible = ts_k_smith(n_l, n_v, a2);
	/* Evaluate Fresnel's term. */
	ts_v3 one = ts_v3_make(1.0f, 1.0f, 1.0f);
	ts_v3 f = ts_k_schlick(ts_k_f0(s), v_h);
	/* Add Lambert's reflection of what is not reflected specularly. */
	f32 diffuse = (1.0f - s->metallic) / TS_PI_F32;
	ts_v3 lambert = ts_scale(ts_mul(ts_sub(one, f), s->base), diffuse);
	return ts_scale(ts_mad(lambert, f, d * visible), n_l);
}

/* The share of light i that reaches a pixel; all of it if lit is NULL. */
TS_FN f32 ts_k_share(TS_GLOBAL const u32 *lit, TS_GLOBAL const ts_lamp *lamps, u32 i)
{
	return lit != NULL ? (f32)lit[i] / (f32)lamps[i].samples : 1.0f;
}

/* Outgoing radiance towards v (unit). Two-sided normals turn to the viewer. lit[i] of lamps[i].samples samples of light
 * i reach the surface; both arrays may be NULL. */
TS_FN ts_v3 ts_k_shade_lit(const ts_arrays *scene, const ts_surface *s, ts_v3 v, TS_GLOBAL const u32 *lit,
                           TS_GLOBAL const ts_lamp *lamps)
{
	/* Show unlit materials in their base colour. */
	if ((s->flags & TS_UNLIT) != 0u) return s->base;
	/* Begin with emission and ambient light (CONTRACT rule 39). */
	ts_v3 n = (s->flags & TS_DOUBLE_SIDED) != 0u ? ts_k_facing_normal(s, v) : s->n;
	f32 ambient = (scene->ambient * s->occlusion) * (1.0f - s->metallic);
	ts_v3 sum = ts_mad(s->emissive, s->base, ambient);
	/* Add the lights in their order; those behind the surface or out of reach give nothing. */
	for (u32 i = 0u; i < scene->n_lights; i++) {
		TS_GLOBAL const ts_light *light = &scene->lights[i];
		ts_v3 l;
		f32 arrives = ts_k_light(light, s->p, &l) * ts_k_share(lit, lamps, i);
		f32 n_l = ts_flush(ts_dot(n, l));
		if (!(n_l > 0.0f) || !(arrives > 0.0f)) continue;
		ts_v3 brdf = ts_k_brdf(s, n, v, l, n_l);
		sum = ts_add(sum, ts_mul(ts_scale(ts_load3(light->intensity), arrives), brdf));
	}
	return ts_v3_make(ts_flush(sum.x), ts_flush(sum.y), ts_flush(sum.z));
}

/* ts_k_shade_lit in full light. */
TS_FN ts_v3 ts_k_shade(const ts_arrays *scene, const ts_surface *s, ts_v3 v)
{
	return ts_k_shade_lit(scene, s, v, NULL, NULL);
}

#endif
