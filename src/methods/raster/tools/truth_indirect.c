/* Truths of indirect light by rays (METHODS 17), which tell the errors of a method apart. `lights` gathers from the
 * very triangles of light that the methods have, as `direct` does, but only from those whose middle the pixel sees. `bounce`
 * has no triangles of light: its rays leave the pixel as the cosine wants them, and bring what the lights themselves send to
 * where they end. `vpls` gathers from all virtual point lights of MegaViews, `glow` from all its particles.
 *
 * Rays begin and end 2^-12 of the greatest coordinate off their surfaces. The rays of `bounce` are the seeds of a sunflower
 * (Vogel 1979) in the pixel's tangent disc, lifted to the hemisphere (Malley), at a random turn a pixel. */
#include "../../../kernels/hulls/direct.h"
#include "../../../kernels/views/vpl_gather.h"
#include "../../../scene/lamp.h"
#include "../../stages.h"
#include "../../../truth/query.h"

#define SKIP 0.000244140625f /* of the greatest coordinate */

enum { CHUNK = 4096 }; /* pixels between two signs of progress */

typedef struct {
	const ts_truth *truth;
	const ts_arrays *scene;
	const ts_gpixel *pixels; u64 n_pixels;
	const ts_patch *patches; u64 n_patches;
	const ts_light *lamps; u32 n_lamps;
	const ts_vpl *vpls; u64 n_vpls;
	f32 near, reach;      /* world units: least distance of a virtual point light, and what about it stops nothing */
	f32 beyond;           /* farther than the scene reaches */
	u32 n_rays;
	f32 *irradiance;
	int n_threads;
} tracer;

typedef ts_v3 gather(const tracer *t, u64 pixel, ts_v3 p, ts_v3 n);

static f32 skip(ts_v3 p) { return ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z)) * SKIP; }

bool ts_truth_sees(const ts_truth *truth, ts_v3 from, ts_v3 to, f32 reach)
{
	ts_v3 way = ts_sub(to, from);
	ts_truth_query ray = {
		.origin = from, .direction = ts_normalize(way), .near = skip(from), .masked = TS_NONE, .from = from};
	ts_truth_hit hit = ts_truth_cast(truth, &ray);
	return hit.triangle == TS_NONE || hit.t >= ts_length(way) - reach;
}

static ts_v3 from_lights(const tracer *t, u64 pixel, ts_v3 p, ts_v3 n)
{
	(void)pixel;
	ts_v3 sum = {0, 0, 0};
	for (u64 k = 0; k < t->n_patches; k++) {
		const ts_patch *patch = &t->patches[k];
		ts_v3 light = ts_k_direct(patch, p, n);
		if (!(light.x + light.y + light.z > 0.0f)) continue;
		ts_v3 third = {1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f};
		ts_v3 middle = ts_blend(third, ts_load3(patch->a), ts_load3(patch->b), ts_load3(patch->c));
		if (ts_truth_sees(t->truth, p, middle, skip(middle))) sum = ts_add(sum, light);
	}
	return sum;
}

/* Where light that arrives at p from l comes from; of a sun from beyond the scene. */
static ts_v3 origin_of(const tracer *t, const ts_light *light, ts_v3 p, ts_v3 l)
{
	if (light->kind != TS_LIGHT_KIND_DIRECTIONAL) return ts_load3(light->position);
	return ts_mad(p, l, t->beyond);
}

/* What the lights send to a surface directly; rays begin at the light, as its reflective shadow map does. */
static ts_v3 irradiance_at(const tracer *t, ts_v3 p, ts_v3 n)
{
	ts_v3 sum = {0, 0, 0}, l;
	for (u32 k = 0; k < t->n_lamps; k++) {
		f32 arrives = ts_k_light(&t->lamps[k], p, &l) * ts_dot(n, l);
		if (!(arrives > 0.0f) || !ts_truth_sees(t->truth, origin_of(t, &t->lamps[k], p, l), p, skip(p))) continue;
		sum = ts_mad(sum, ts_load3(t->lamps[k].intensity), arrives);
	}
	return sum;
}

/* The same as the triangles of light have it: by the face, turned to where the light is seen from. */
static ts_v3 exitance_at(const tracer *t, const ts_truth_query *ray)
{
	ts_truth_hit hit = ts_truth_cast(t->truth, ray);
	if (hit.triangle == TS_NONE) return ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_surface s = ts_k_surface(t->scene, hit.triangle, hit.weights, hit.footprint);
	ts_v3 n = ts_dot(s.face, ray->direction) > 0.0f ? ts_neg(s.face) : s.face;
	return ts_mul(ts_k_albedo(&s), irradiance_at(t, s.p, n));
}

/* E = integral of L cos = the mean of pi L over directions that are as dense as the cosine; pi L is the exitance. */
static ts_v3 from_bounce(const tracer *t, u64 pixel, ts_v3 p, ts_v3 n)
{
	ts_v3 u = ts_k_across(n), v = ts_cross(n, u), sum = {0, 0, 0};
	f32 turn = ts_uniform(ts_random((u32)pixel, 0, 0));
	for (u32 k = 0; k < t->n_rays; k++) {
		f32 share = ((f32)k + 0.5f) / (f32)t->n_rays, r = ts_sqrt(share), turns = turn + TS_GOLDEN_TURN * (f32)k;
		ts_v3 aside = ts_add(ts_scale(u, r * ts_cos_turn(turns)), ts_scale(v, r * ts_sin_turn(turns)));
		ts_v3 d = ts_normalize(ts_mad(aside, n, ts_sqrt(1.0f - share)));
		ts_truth_query ray = {.origin = p, .direction = d, .near = skip(p), .masked = TS_NONE, .from = p};
		sum = ts_add(sum, exitance_at(t, &ray));
	}
	return ts_scale(sum, 1.0f / (f32)t->n_rays);
}

static ts_v3 from_vpls(const tracer *t, u64 pixel, ts_v3 p, ts_v3 n)
{
	(void)pixel;
	ts_v3 sum = {0, 0, 0};
	for (u64 k = 0; k < t->n_vpls; k++) {
		const ts_vpl *light = &t->vpls[k];
		ts_v3 from = ts_load3(light->position);
		f32 form = ts_k_vpl_form(ts_sub(p, from), ts_load3(light->normal), n, t->near);
		if (form > 0.0f && ts_truth_sees(t->truth, p, from, t->reach)) sum = ts_mad(sum, ts_load3(light->flux), form);
	}
	return sum;
}

static void light_pixel(const tracer *t, u64 i, gather *light)
{
	const ts_gpixel *pixel = &t->pixels[i];
	ts_v3 sum = {0, 0, 0};
	if (pixel->depth != TS_SKY) sum = light(t, i, ts_load3(pixel->position), ts_load3(pixel->normal));
	ts_store3(t->irradiance + i * 3, sum);
}

static f32 extent(const ts_info *info) { return ts_length(ts_sub(ts_load3(info->box_max), ts_load3(info->box_min))); }

/* What only some truths have. */
static void take_lamps(tracer *t, const ts_run *run)
{
	if (!run->frame.buffer[TS_B_rsm_patch].made) return;
	t->patches = ts_frame_data(&run->frame, TS_B_rsm_patch);
	t->n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch);
	t->lamps = ts_frame_data(&run->frame, TS_B_lamp_light);
	t->n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_light);
}

static void take_vpls(tracer *t, const ts_run *run)
{
	if (!run->frame.buffer[TS_B_vpl_light].made) return;
	const ts_root *root = ts_frame_data(&run->frame, TS_B_root_cube);
	f32 leaf = root->side / (f32)(1 << TS_PARAM(&run->params, levels));
	t->vpls = ts_frame_data(&run->frame, TS_B_vpl_light);
	t->n_vpls = ts_frame_n(&run->frame, TS_B_vpl_light);
	t->near = TS_PARAM(&run->params, light_near) * leaf;
	t->reach = leaf * 1.73205077648162841796875f;
}

static ts_status trace(const ts_truth *truth, ts_run *run, gather *light, const char *label)
{
	u64 width = TS_PARAM(&run->params, width), height = TS_PARAM(&run->params, height);
	tracer t = {
		.truth = truth,
		.scene = ts_truth_scene(truth),
		.pixels = ts_frame_data(&run->frame, TS_B_gbuffer_pixel),
		.n_pixels = width * height,
		.beyond = 2.0f * extent(ts_run_info(run)),
		.n_rays = TS_PARAM(&run->params, bounce_rays),
		.irradiance = ts_frame_make3(&run->frame, TS_B_indirect_irradiance, height, width, 3),
		.n_threads = (int)run->c.threads,
	};
	if (t.irradiance == NULL) return TS_ERROR;
	take_lamps(&t, run);
	take_vpls(&t, run);
	for (u64 first = 0; first < t.n_pixels; first += CHUNK) {
		u64 end = first + CHUNK < t.n_pixels ? first + CHUNK : t.n_pixels;
		ts_progress(label, first, t.n_pixels);
#pragma omp parallel for num_threads(t.n_threads) schedule(dynamic, 64)
		for (u64 i = first; i < end; i++) light_pixel(&t, i, light);
	}
	ts_progress(label, t.n_pixels, t.n_pixels);
	return TS_OK;
}

/* From lights that stages make, in order; ended by NULL. */
static ts_status trace_views(ts_truth *truth, ts_run *run, const char *const *makers, const char *label)
{
	for (; *makers != NULL; makers++) {
		if (ts_run_stage(run, ts_stage_find(*makers)) != TS_OK) return TS_ERROR;
	}
	return trace(truth, run, from_vpls, label);
}

ts_status ts_truth_indirect_begin(ts_run *run, const char *effect)
{
	static const ts_buffer_id needs[] = {TS_B_rsm_patch, TS_B_gbuffer_pixel, TS_N_BUFFERS};
	return ts_truth_begin(run, effect, needs);
}

ts_status ts_truth_particles_begin(ts_run *run, const char *effect)
{
	static const ts_buffer_id needs[] = {TS_B_gbuffer_pixel, TS_N_BUFFERS};
	return ts_truth_begin(run, effect, needs);
}

ts_status ts_truth_lights(ts_truth *truth, ts_run *run) { return trace(truth, run, from_lights, "truth lights"); }

ts_status ts_truth_bounce(ts_truth *truth, ts_run *run) { return trace(truth, run, from_bounce, "truth bounce"); }

ts_status ts_truth_vpls(ts_truth *truth, ts_run *run)
{
	static const char *const makers[] = {"root", "voxel", "octree", "vpl", NULL};
	return trace_views(truth, run, makers, "truth vpls");
}

ts_status ts_truth_glow(ts_truth *truth, ts_run *run)
{
	static const char *const makers[] = {"root", "particle", NULL};
	return trace_views(truth, run, makers, "truth glow");
}
