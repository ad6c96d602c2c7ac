/* Truth of reflections by rays: A from the cube's centre in the exact directions of EPR's samples, B from the surface
 * (METHODS 17). A is EPR with cubes of infinite resolution; B has no cubes at all. */
#include <stdlib.h>
#include "kernels/base/shade.h"
#include "kernels/points/density.h"
#include "kernels/points/samples.h"
#include "kernels/raster/eye_sample.h"
#include "methods/points/tools/tools.h"
#include "methods/raster/raster.h"
#include "truth/sampling.h"
#include "truth/truth.h"

typedef struct tracer tracer;

/* The first leg of sample k of a pixel; and the radiance that a leg brings, with `left` more reflectors to follow. */
typedef ts_truth_query leg(const tracer *t, const ts_pixel *pixel, u32 k);
typedef ts_v3 sight(const tracer *t, const ts_truth_query *query, const ts_truth_hit *hit, u32 left);

struct tracer {
	const ts_truth *truth;
	const ts_arrays *scene;
	const ts_face *faces;
	const ts_pixel *pixels;
	u64 n_pixels;
	ts_v3 eye;
	f32 spread; /* footprint per unit of path: the side of a pixel sample's square */
	u32 bounces;
	int n_threads;
	leg *leave;
	sight *see;
	f32 *radiance;
};

static tracer tracer_of(const ts_truth *truth, const ts_run *run)
{
	const ts_view *eye = ts_frame_data(&run->frame, TS_B_eye_view);
	return (tracer){
		.truth = truth,
		.scene = ts_truth_scene(truth),
		.faces = ts_frame_data(&run->frame, TS_B_cube_size_face),
		.pixels = ts_frame_data(&run->frame, TS_B_mirror_pixel_record),
		.n_pixels = ts_frame_n(&run->frame, TS_B_mirror_pixel_record),
		.eye = ts_load3(eye->eye),
		.spread = ts_k_eye_view(eye, ts_eye_samples(&run->params), 0).side / eye->focal,
		.bounces = TS_PARAM(&run->params, lookup_bounces),
		.n_threads = (int)run->c.threads,
	};
}

/* The leg from p through the cube of `reflector`. */
static ts_truth_query from_centre(const tracer *t, u32 reflector, ts_v3 p, ts_v3 direction, f32 path)
{
	return (ts_truth_query){.origin = ts_load3(t->faces[reflector].centre),
	                        .direction = direction,
	                        .masked = reflector,
	                        .from = p,
	                        .path = path,
	                        .spread = t->spread};
}

static f32 greatest(ts_v3 p) { return ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z)); }

/* The leg from p, on `reflector`, itself. It skips 2^-12 |p|max to leave the surface; the radius replaces |p|max where
 * p is near the world's origin. */
static ts_truth_query from_surface(const tracer *t, u32 reflector, ts_v3 p, ts_v3 direction, f32 path)
{
	f32 reach = ts_max(greatest(p), t->faces[reflector].radius);
	return (ts_truth_query){.origin = p,
	                        .direction = direction,
	                        .near = reach * 0.000244140625f,
	                        .masked = TS_NONE,
	                        .from = p,
	                        .path = path,
	                        .spread = t->spread};
}

static ts_v3 shade_towards(const tracer *t, const ts_surface *s, ts_v3 viewer)
{
	return ts_k_shade(t->scene, s, ts_normalize(ts_sub(viewer, s->p)));
}

/* The normal turned, if need be, against a ray that arrives along d. */
static ts_v3 facing_normal(const ts_surface *s, ts_v3 d) { return ts_dot(s->face, d) > 0.0f ? ts_neg(s->n) : s->n; }

/* Axes of a hit's footprint as in EPR's tiles: along the longest edge, and across it. */
static void tile_axes(const ts_corners *t, ts_v3 *u, ts_v3 *v)
{
	const ts_v3 corner[4] = {t->a, t->b, t->c, t->a};
	f32 length;
	u32 edge = ts_k_longest_edge(t->a, t->b, t->c, &length);
	*u = ts_normalize(ts_sub(corner[edge + 1], corner[edge]));
	*v = ts_normalize(ts_cross(ts_normalize(t->n), *u));
}

/* Where a leg meets a reflector that continues it. */
typedef struct {
	ts_truth_hit hit;
	ts_surface s;
	ts_v3 n; /* against the ray */
	u32 reflector;
} bounce;

/* False if the light path ends here: then *radiance is its radiance. */
static bool goes_on(const tracer *t, const ts_truth_query *query, const ts_truth_hit *hit, u32 left, bounce *at,
                    ts_v3 *radiance)
{
	at->hit = *hit;
	*radiance = ts_k_background();
	if (at->hit.triangle == TS_NONE) return false;
	at->s = ts_k_surface(t->scene, at->hit.triangle, at->hit.weights, at->hit.footprint);
	at->n = facing_normal(&at->s, query->direction);
	at->reflector = left > 0 ? ts_k_reflector_of(t->scene, at->hit.triangle) : TS_NONE;
	if (at->reflector == TS_NONE) *radiance = shade_towards(t, &at->s, query->origin);
	return at->reflector != TS_NONE;
}

/* Radiance that the cube of query->masked sees; `left` more reflectors are followed, four rays each. */
static ts_v3 see_from_centre(const tracer *t, const ts_truth_query *query, const ts_truth_hit *hit, u32 left)
{
	bounce at;
	ts_v3 radiance, u, v, sum = {0, 0, 0};
	if (!goes_on(t, query, hit, left, &at, &radiance)) return radiance;
	ts_corners corner = ts_k_corners(t->scene, at.hit.triangle);
	tile_axes(&corner, &u, &v);
	f32 radius = t->faces[at.reflector].radius, spread = radius > 0.0f ? at.hit.footprint / radius : 0.0f;
	ts_truth_query next[TS_N_BOUNCE_SAMPLES];
	ts_truth_hit hits[TS_N_BOUNCE_SAMPLES];
	for (u32 k = 0; k < TS_N_BOUNCE_SAMPLES; k++) {
		ts_v3 d = ts_k_bounce_direction(at.s.p, at.n, u, v, query->origin, spread, k);
		next[k] = from_centre(t, at.reflector, at.s.p, d, at.hit.path);
	}
	ts_truth_cast_all(hits, t->truth, next, TS_N_BOUNCE_SAMPLES);
	for (u32 k = 0; k < TS_N_BOUNCE_SAMPLES; k++) sum = ts_add(sum, see_from_centre(t, &next[k], &hits[k], left - 1));
	return ts_mul(ts_scale(sum, 1.0f / (f32)TS_N_BOUNCE_SAMPLES), at.s.base);
}

/* Radiance that arrives along a true ray; every reflector on its way continues it with one ray. */
static ts_v3 see_from_surface(const tracer *t, const ts_truth_query *query, const ts_truth_hit *hit, u32 left)
{
	bounce at;
	ts_v3 radiance;
	if (!goes_on(t, query, hit, left, &at, &radiance)) return radiance;
	ts_v3 d = ts_normalize(ts_reflect(query->direction, at.n));
	ts_truth_query next = from_surface(t, at.reflector, at.s.p, d, at.hit.path);
	ts_truth_hit further = ts_truth_cast(t->truth, &next);
	return ts_mul(see_from_surface(t, &next, &further, left - 1), at.s.base);
}

static ts_truth_query first_from_centre(const tracer *t, const ts_pixel *pixel, u32 k)
{
	ts_ray ray = ts_k_sample_ray(pixel, t->eye, k);
	return from_centre(t, pixel->reflector, ray.p, ray.direction, ts_length(ts_sub(ray.p, t->eye)));
}

static ts_truth_query first_from_surface(const tracer *t, const ts_pixel *pixel, u32 k)
{
	ts_ray ray = ts_k_sample_ray(pixel, t->eye, k);
	return from_surface(t, pixel->reflector, ray.p, ray.direction, ts_length(ts_sub(ray.p, t->eye)));
}

static u32 pixel_of(const void *user, u64 i) { return ((const tracer *)user)->pixels[i].index; }

/* Mean of the samples in order, tinted (METHODS 2). */
static void keep_mean(const tracer *t, u64 i, const ts_truth_query *queries, const ts_truth_hit *hits, u64 asked)
{
	const ts_pixel *pixel = &t->pixels[i];
	ts_v3 sum = {0, 0, 0};
	for (u64 j = 0; j < asked; j++) sum = ts_add(sum, t->see(t, &queries[j], &hits[j], t->bounces - 1));
	f32 n = (f32)asked;
	ts_v3 mean = ts_v3_make(sum.x / n, sum.y / n, sum.z / n);
	ts_store3(t->radiance + i * 3, ts_mul(mean, ts_v3_make(pixel->tint_r, pixel->tint_g, pixel->tint_b)));
}

/* Casts the first legs of all these pixels in packets. */
static void look_from(const void *user, const u64 *i, const ts_share *shares, u32 n)
{
	const tracer *t = user;
	ts_truth_query queries[TS_ASKED * TS_N_SAMPLES] = {{.near = 0}};
	ts_truth_hit hits[TS_ASKED * TS_N_SAMPLES];
	u32 asked = (u32)shares[0].asked;
	for (u32 k = 0; k < n; k++) {
		for (u32 j = 0; j < asked; j++)
			queries[k * asked + j] = t->leave(t, &t->pixels[i[k]], (u32)ts_share_item(&shares[k], j));
	}
	ts_truth_cast_all(hits, t->truth, queries, n * asked);
	for (u32 k = 0; k < n; k++) keep_mean(t, i[k], &queries[k * asked], &hits[k * asked], asked);
}

/* Most rays of a sample, when every bounce continues. */
static u64 most_rays(u32 bounces, u64 each)
{
	u64 sum = 0, rays = 1;
	for (u32 k = 0; k < bounces; k++, rays *= each) sum += rays;
	return sum;
}

static ts_status trace(tracer t, ts_run *run, ts_sampling *sampling, u64 each, const char *label)
{
	t.radiance = ts_frame_make2(&run->frame, TS_B_shade_radiance, t.n_pixels, 3);
	if (t.radiance == NULL) return TS_ERROR;
	memset(t.radiance, 0, t.n_pixels * 3 * sizeof *t.radiance);
	const ts_truth_asked asked = {.label = label,
	                              .n = t.n_pixels,
	                              .items = TS_N_SAMPLES,
	                              .each = most_rays(t.bounces, each),
	                              .pixel = pixel_of,
	                              .ask_all = look_from,
	                              .user = &t,
	                              .threads = run->c.threads};
	ts_truth_ask(&asked, sampling);
	return TS_OK;
}

ts_status ts_truth_a(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	tracer t = tracer_of(truth, run);
	t.leave = first_from_centre;
	t.see = see_from_centre;
	return trace(t, run, sampling, TS_N_BOUNCE_SAMPLES, "truth A");
}

ts_status ts_truth_b(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	tracer t = tracer_of(truth, run);
	t.leave = first_from_surface;
	t.see = see_from_surface;
	return trace(t, run, sampling, 1, "truth B");
}

/* The middle of the texel that holds s, of n texels per side: both from -1 to 1. */
static f32 middle_of_texel(f32 s, u32 n) { return ((f32)ts_k_cube_texel(s, n) + 0.5f) * 2.0f / (f32)n - 1.0f; }

/* Casts through the centre of the texel that the sample reads. */
static ts_truth_query through_texel(const tracer *t, const ts_pixel *pixel, u32 k)
{
	ts_truth_query query = first_from_centre(t, pixel, k);
	u32 n = t->faces[pixel->reflector].n;
	ts_cube_place at = ts_k_cube_place(query.direction);
	query.direction = ts_normalize(ts_k_cube_direction(at.face, middle_of_texel(at.s, n), middle_of_texel(at.t, n)));
	return query;
}

ts_status ts_truth_hits(ts_truth *truth, const ts_run *run, const ts_sampling *sampling, u32 **hits)
{
	tracer t = tracer_of(truth, run);
	u32 *made = *hits = ts_alloc((size_t)t.n_pixels * TS_N_SAMPLES, sizeof(u32), "truth's hits");
	if (made == NULL) return TS_ERROR;
#pragma omp parallel for num_threads(t.n_threads) schedule(dynamic, 8)
	for (u64 i = 0; i < t.n_pixels; i++) {
		const ts_pixel *pixel = &t.pixels[i];
		bool left_out = sampling != NULL && sampling->chosen && !ts_sampling_chooses(sampling, pixel->index);
		ts_truth_query queries[TS_N_SAMPLES];
		ts_truth_hit found[TS_N_SAMPLES];
		for (u32 k = 0; k < TS_N_SAMPLES; k++) queries[k] = through_texel(&t, pixel, k);
		if (!left_out) ts_truth_cast_all(found, t.truth, queries, TS_N_SAMPLES);
		for (u32 k = 0; k < TS_N_SAMPLES; k++) made[i * TS_N_SAMPLES + k] = left_out ? TS_NONE : found[k].triangle;
	}
	return TS_OK;
}

ts_status ts_truth_missed(u64 *n_hits, u64 *n_missed, ts_truth *truth, const ts_run *run, const ts_sampling *sampling)
{
	u32 *hits;
	const u32 *found = ts_frame_data(&run->frame, TS_B_lookup_point);
	if (ts_truth_hits(truth, run, sampling, &hits) != TS_OK) return TS_ERROR;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_lookup_point); i++) {
		*n_hits += hits[i] != TS_NONE;
		*n_missed += hits[i] != TS_NONE && found[i] == TS_NONE;
	}
	free(hits);
	return TS_OK;
}
