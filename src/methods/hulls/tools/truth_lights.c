/* Truths of indirect light by rays (METHODS 17), which separate the errors of a method. `lights` gathers from the
 * methods' own triangles of light, like `direct`, but only where the pixel sees their middle. `bounce` has no triangles
 * of light: its rays leave the pixel with the density of the cosine, and return the direct light of their end points.
 *
 * Rays begin and end 2^-12 of the greatest coordinate off their surfaces. The rays of `bounce` are a sunflower's seeds
 * (Vogel 1979) in the pixel's tangent disc, lifted to the hemisphere (Malley), at a random turn per pixel. */
#include "kernels/hulls/direct.h"
#include "kernels/raster/patch.h"
#include "methods/hulls/gloss.h"
#include "methods/hulls/tools/tools.h"
#include "methods/hulls/tools/truth_gloss.h"
#include "methods/raster/tools/truth_gather.h"
#include "scene/lamp.h"

typedef struct {
	const ts_truth *truth;
	const ts_arrays *scene;
	const ts_patch *patches;
	const ts_light *lamps;
	u32 n_lamps;
	f32 beyond;            /* farther than the scene reaches */
	const ts_gloss *gloss; /* of the pixels; NULL: light that arrives is computed, not specular reflection */
	ts_v3 eye;
} tracer;

static ts_v3 reflected(const tracer *t, const ts_patch *patch, u64 pixel, ts_v3 p, ts_v3 n)
{
	ts_v3 none = {0, 0, 0}, a = ts_load3(patch->a), b = ts_load3(patch->b), c = ts_load3(patch->c);
	if (!ts_k_is_in_front(p, a, ts_load3(patch->normal))) return none;
	ts_truth_glossy at = ts_truth_glossy_of(&t->gloss[pixel], p, n, t->eye);
	const ts_double3 corner[3] = {ts_double3_from_to(p, a), ts_double3_from_to(p, b), ts_double3_from_to(p, c)};
	ts_v3 share = ts_double3_round(ts_truth_gloss_triangle(&at, corner));
	return ts_mul(ts_load3(patch->exitance), ts_scale(share, (f32)(1 / TS_PI)));
}

static ts_v3 from_lights(const void *user, const ts_share *share, ts_v3 p, ts_v3 n)
{
	const tracer *t = user;
	ts_v3 sum = {0, 0, 0};
	for (u64 j = 0; j < share->asked; j++) {
		const ts_patch *patch = &t->patches[ts_share_item(share, j)];
		ts_v3 light = t->gloss != NULL ? reflected(t, patch, share->pixel, p, n) : ts_k_direct(patch, p, n);
		if (!(light.x + light.y + light.z > 0.0f)) continue;
		ts_v3 third = {1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f};
		ts_v3 middle = ts_blend(third, ts_load3(patch->a), ts_load3(patch->b), ts_load3(patch->c));
		if (ts_truth_sees(t->truth, p, middle, ts_truth_skip(middle))) sum = ts_add(sum, light);
	}
	return ts_scale(sum, ts_share_weight(share));
}

/* The origin of light that arrives at p from l; a sun's is beyond the scene. */
static ts_v3 origin_of(const tracer *t, const ts_light *light, ts_v3 p, ts_v3 l)
{
	if (light->kind != TS_LIGHT_KIND_DIRECTIONAL) return ts_load3(light->position);
	return ts_mad(p, l, t->beyond);
}

/* Direct light on a surface; rays begin at the light, as for its reflective shadow map. */
static ts_v3 irradiance_at(const tracer *t, ts_v3 p, ts_v3 n)
{
	ts_v3 sum = {0, 0, 0}, l;
	for (u32 k = 0; k < t->n_lamps; k++) {
		f32 arrives = ts_k_light(&t->lamps[k], p, &l) * ts_dot(n, l);
		if (!(arrives > 0.0f)) continue;
		if (!ts_truth_sees(t->truth, origin_of(t, &t->lamps[k], p, l), p, ts_truth_skip(p))) continue;
		sum = ts_mad(sum, ts_load3(t->lamps[k].intensity), arrives);
	}
	return sum;
}

/* Exitance as triangles of light have it: from the face that the light sees. */
static ts_v3 exitance_at(const tracer *t, const ts_truth_query *ray)
{
	ts_truth_hit hit = ts_truth_cast(t->truth, ray);
	if (hit.triangle == TS_NONE) return ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_surface s = ts_k_surface(t->scene, hit.triangle, hit.weights, hit.footprint);
	ts_v3 n = ts_dot(s.face, ray->direction) > 0.0f ? ts_neg(s.face) : s.face;
	return ts_mul(ts_k_albedo(&s), irradiance_at(t, s.p, n));
}

/* E = integral of L cos = the mean of pi L over directions of cosine density; pi L is the exitance. */
static ts_v3 from_bounce(const void *user, const ts_share *share, ts_v3 p, ts_v3 n)
{
	const tracer *t = user;
	ts_v3 u = ts_k_across(n), v = ts_cross(n, u), sum = {0, 0, 0};
	u32 n_rays = (u32)share->asked;
	f32 turn = ts_uniform(ts_random(share->pixel, 0, 0));
	for (u32 k = 0; k < n_rays; k++) {
		f32 part = ((f32)k + 0.5f) / (f32)n_rays, r = ts_sqrt(part), turns = turn + TS_GOLDEN_TURN * (f32)k;
		ts_v3 aside = ts_add(ts_scale(u, r * ts_cos_turn(turns)), ts_scale(v, r * ts_sin_turn(turns)));
		ts_v3 d = ts_normalize(ts_mad(aside, n, ts_sqrt(1.0f - part)));
		ts_truth_query ray = {.origin = p, .direction = d, .near = ts_truth_skip(p), .masked = TS_NONE, .from = p};
		sum = ts_add(sum, exitance_at(t, &ray));
	}
	return ts_scale(sum, 1.0f / (f32)n_rays);
}

/* Specular reflection, from directions with the BRDF's density at places of the golden sequence. */
static ts_v3 from_bounce_reflected(const void *user, const ts_share *share, ts_v3 p, ts_v3 n)
{
	const tracer *t = user;
	ts_truth_glossy at = ts_truth_glossy_of(&t->gloss[share->pixel], p, n, t->eye);
	ts_v3 sum = {0, 0, 0};
	u32 n_rays = (u32)share->asked;
	f32 turn = ts_uniform(ts_random(share->pixel, 0, 0));
	for (u32 k = 0; k < n_rays; k++) {
		ts_double3 l;
		f32 turns = turn + TS_GOLDEN_TURN * (f32)k;
		ts_double3 part = ts_truth_gloss_sample(&at, ((double)k + 0.5) / n_rays, (double)turns, &l);
		if (!(part.x + part.y + part.z > 0)) continue;
		ts_truth_query ray = {
			.origin = p, .direction = ts_double3_round(l), .near = ts_truth_skip(p), .masked = TS_NONE, .from = p};
		sum = ts_add(sum, ts_mul(ts_double3_round(part), exitance_at(t, &ray)));
	}
	return ts_scale(sum, (f32)(1 / TS_PI) / (f32)n_rays);
}

static f32 extent(const ts_info *info) { return ts_length(ts_sub(ts_load3(info->box_max), ts_load3(info->box_min))); }

/* How light is gathered: diffuse light by `light`, specular light by `specular`, both from equally many items and
 * rays. */
typedef struct {
	const char *label;
	ts_truth_light *light, *specular;
	u64 items, each;
} ways;

static ts_status trace(const ts_truth *truth, ts_run *run, ts_sampling *sampling, const ways *by)
{
	bool glossy = ts_gloss_is_asked(&run->params);
	tracer t = {
		.truth = truth,
		.scene = ts_truth_scene(truth),
		.patches = ts_frame_data(&run->frame, TS_B_rsm_patch),
		.lamps = ts_frame_data(&run->frame, TS_B_lamp_light),
		.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_light),
		.beyond = 2.0f * extent(ts_run_info(run)),
	};
	ts_truth_gathered of = {by->label, by->light, &t, by->items, glossy ? 2 * by->each : by->each};
	if (ts_truth_gather(run, TS_B_indirect_irradiance, &of, sampling) != TS_OK) return TS_ERROR;
	if (!glossy) return TS_OK;
	if (ts_truth_gloss(run, &t.gloss, &t.eye) != TS_OK) return TS_ERROR;
	of.light = by->specular;
	return ts_truth_gather(run, TS_B_indirect_specular, &of, sampling);
}

ts_status ts_truth_lights(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	u64 n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch);
	return trace(truth, run, sampling, &(ways){"truth lights", from_lights, from_lights, n_patches, 1});
}

ts_status ts_truth_bounce(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	u64 n_rays = TS_PARAM(&run->params, truth_bounce_rays), n_lamps = ts_frame_n(&run->frame, TS_B_lamp_light);
	return trace(truth, run, sampling,
	             &(ways){"truth bounce", from_bounce, from_bounce_reflected, n_rays, 1 + n_lamps});
}
