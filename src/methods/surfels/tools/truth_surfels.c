/* Truths of surfels by rays (METHODS 17), shaded by the methods' own deferred shader: `discs`, the surfels themselves,
 * each ray blending hits no more than epsilon behind the nearest by the object-space Gaussian; `surface`, the surface
 * that surfels sample, triangles or the checkerboard. Every pixel is a grid of cells with one ray in each: a picture
 * for each cell, and their mean in linear light. A ray's place in its cell is a hash: equal places in all pixels would
 * make a pattern of details finer than the cells.
 *
 * Shadows are rays from the light. Surfels no more than epsilon before the point stop none, as in their depth maps; nor
 * do triangles in the last 2^-12 of the greatest coordinate. */
#include <math.h>
#include <stdlib.h>
#include "kernels/raster/patch.h"
#include "kernels/surfels/surfel_blend_mean.h"
#include "methods/pipeline.h"
#include "methods/stages.h"
#include "methods/surfels/surfel.h"
#include "methods/surfels/tools/discs.h"
#include "methods/surfels/tools/tools.h"
#include "scene/sources.h"
#include "truth/sampling.h"
#include "truth/truth.h"

#define SKIP 0.000244140625f /* of the greatest coordinate */
#define ONE 1073741824.0     /* sums are in 2^-30, so that the order of hits does not matter */
#define STREAM_SAMPLES 7u    /* of ts_random */

enum { N_ATTRIBUTES = 7, WEIGHT = 6 };
enum { ROWS = 32 };        /* between two reports of progress */
enum { DISC_BYTES = 192 }; /* of Embree's tree per surfel: 146 to 191 for 300 000 to four million of them */

typedef struct {
	ts_v3 p, n, albedo;
} spot;

typedef struct tracer tracer;

/* The target of rays. */
typedef struct {
	const char *label;
	ts_status (*open)(tracer *t, ts_run *run);
	bool (*see)(const tracer *t, const ts_disc_ray *ray, spot *at);
	bool (*reaches)(const tracer *t, ts_v3 light, ts_v3 p); /* whether nothing is between them */
	u32 cost;                                               /* of a ray, relative to one into triangles */
} world;

struct tracer {
	const world *into;
	ts_discs *discs;
	ts_truth *mesh;
	const ts_surfel *surfels;
	const ts_view *eye;
	const ts_light *lights;
	u32 n_lights;
	double eps, fall;   /* world units; 1 / (2 ewa.sigma_k^2) */
	f32 spread, beyond; /* footprint per unit of path; farther than the scene reaches */
	u32 side, cell;     /* rays per side of a pixel; the one that is cast */
	u32 seed;           /* of their places */
	const ts_sampling *sampling;
	ts_gpixel *pixels;
	u32 *lit; /* NULL: no shadows */
	int n_threads;
};

/* Sums of attributes and weights over a ray's hits, and the heaviest of these. */
typedef struct {
	const tracer *t;
	i64 sum[N_ATTRIBUTES];
	double most;
	u32 heaviest;
} blend;

static ts_v3 normal_of(const ts_surfel *s) { return ts_normalize(ts_cross(ts_load3(s->u), ts_load3(s->v))); }

static void add(void *user, const ts_disc_met *met)
{
	blend *b = user;
	const ts_surfel *s = &b->t->surfels[met->surfel];
	ts_v3 n = normal_of(s);
	double weight = exp(-b->t->fall * met->r2);
	double value[N_ATTRIBUTES] = {0, 0, 0, (double)n.x, (double)n.y, (double)n.z, 1};
	for (u32 k = 0; k < 3; k++) value[k] = fmin(fmax((double)s->colour[k], 0.0), 1.0);
	for (u32 k = 0; k < N_ATTRIBUTES; k++) b->sum[k] += llrint(weight * value[k] * ONE);
	bool heavier = weight > b->most || (weight == b->most && met->surfel < b->heaviest);
	b->most = heavier ? weight : b->most;
	b->heaviest = heavier ? met->surfel : b->heaviest;
}

static ts_v3 mean(const i64 *sum, i64 weight)
{
	double w = (double)weight;
	return ts_v3_make((f32)((double)sum[0] / w), (f32)((double)sum[1] / w), (f32)((double)sum[2] / w));
}

static ts_v3 along(const ts_disc_ray *ray, double t)
{
	return ts_v3_make((f32)(ray->origin[0] + t * ray->direction[0]), (f32)(ray->origin[1] + t * ray->direction[1]),
	                  (f32)(ray->origin[2] + t * ray->direction[2]));
}

static bool see_discs(const tracer *t, const ts_disc_ray *ray, spot *at)
{
	blend b = {.t = t, .most = -1};
	ts_disc_met nearest = ts_discs_nearest(t->discs, ray);
	if (nearest.surfel == TS_NONE) return false;
	ts_discs_each(t->discs, ray, nearest.t + t->eps, add, &b);
	if (b.sum[WEIGHT] == 0) return false;
	at->p = along(ray, nearest.t);
	at->albedo = mean(b.sum, b.sum[WEIGHT]);
	ts_v3 n = mean(b.sum + 3, b.sum[WEIGHT]);
	at->n = ts_length(n) < TS_LEAST_NORMAL ? normal_of(&t->surfels[b.heaviest]) : ts_normalize(n);
	return true;
}

static bool see_mesh(const tracer *t, const ts_disc_ray *ray, spot *at)
{
	ts_v3 eye = ts_load3(t->eye->eye);
	ts_v3 d = ts_v3_make((f32)ray->direction[0], (f32)ray->direction[1], (f32)ray->direction[2]);
	ts_truth_query query = {.origin = eye,
	                        .direction = ts_normalize(d),
	                        .near = (f32)ray->near,
	                        .masked = TS_NONE,
	                        .from = eye,
	                        .spread = t->spread};
	ts_truth_hit hit = ts_truth_cast(t->mesh, &query);
	if (hit.triangle == TS_NONE) return false;
	ts_surface s = ts_k_surface(ts_truth_scene(t->mesh), hit.triangle, hit.weights, hit.footprint);
	*at = (spot){s.p, ts_k_facing_normal(&s, ts_sub(eye, s.p)), ts_k_albedo(&s)};
	return true;
}

static bool see_board(const tracer *t, const ts_disc_ray *ray, spot *at)
{
	(void)t;
	f32 albedo;
	if (!(ray->direction[1] < 0.0)) return false;
	double distance = -ray->origin[1] / ray->direction[1];
	ts_v3 p = along(ray, distance);
	if (!(distance >= ray->near) || !ts_checkerboard_at(&albedo, p.x, p.z)) return false;
	*at = (spot){p, ts_v3_make(0, 1, 0), ts_v3_make(albedo, albedo, albedo)};
	return true;
}

static bool reaches_disc(const tracer *t, ts_v3 light, ts_v3 p)
{
	const double from[3] = {(double)light.x, (double)light.y, (double)light.z};
	const double way[3] = {(double)p.x - from[0], (double)p.y - from[1], (double)p.z - from[2]};
	double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
	ts_disc_ray ray = {.origin = {from[0], from[1], from[2]}};
	for (u32 k = 0; k < 3; k++) ray.direction[k] = way[k] / length;
	return !(ts_discs_nearest(t->discs, &ray).t < length - t->eps);
}

static bool reaches_mesh(const tracer *t, ts_v3 light, ts_v3 p)
{
	ts_v3 way = ts_sub(p, light);
	ts_truth_query query = {.origin = light, .direction = ts_normalize(way), .masked = TS_NONE, .from = light};
	ts_truth_hit hit = ts_truth_cast(t->mesh, &query);
	f32 greatest = ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z));
	return hit.triangle == TS_NONE || hit.t >= ts_length(way) - SKIP * greatest;
}

static bool reaches_board(const tracer *t, ts_v3 light, ts_v3 p)
{
	(void)t;
	(void)light;
	(void)p;
	return true;
}

static ts_status open_discs(tracer *t, ts_run *run)
{
	return ts_discs_new(&t->discs, t->surfels, run->scene->n_surfels, run->c.threads);
}

static ts_status open_mesh(tracer *t, ts_run *run)
{
	return ts_truth_make(run, TS_B_pose_vertex) == TS_OK ? ts_truth_new(&t->mesh, run) : TS_ERROR;
}

static ts_status open_board(tracer *t, ts_run *run)
{
	(void)t;
	(void)run;
	return TS_OK;
}

static const world of_discs = {"truth discs", open_discs, see_discs, reaches_disc, 4};
static const world of_mesh = {"truth surface", open_mesh, see_mesh, reaches_mesh, 1};
static const world of_board = {"truth surface", open_board, see_board, reaches_board, 1};

static double jitter(u32 pixel, u32 draw, u32 seed)
{
	return (double)ts_uniform(ts_random(pixel ^ ts_pcg(draw), STREAM_SAMPLES, seed));
}

void ts_truth_place(double place[2], u32 pixel, u32 cell, u32 side, u32 seed)
{
	place[0] = (cell % side + jitter(pixel, 2 * cell, seed)) / side;
	place[1] = (cell / side + jitter(pixel, 2 * cell + 1, seed)) / side;
}

static ts_disc_ray eye_ray(const tracer *t, u32 x, u32 y)
{
	double place[2];
	const ts_view *eye = t->eye;
	ts_truth_place(place, y * eye->width + x, t->cell, t->side, t->seed);
	double i = (x + place[0] - eye->width * 0.5) / (double)eye->focal;
	double j = (eye->height * 0.5 - (y + place[1])) / (double)eye->focal;
	double length = sqrt(i * i + j * j + 1.0);
	ts_disc_ray ray = {.near = (double)eye->near * length};
	for (u32 k = 0; k < 3; k++) {
		double way = i * (double)eye->right[k] + j * (double)eye->up[k] - (double)eye->back[k];
		ray.origin[k] = (double)eye->eye[k];
		ray.direction[k] = way / length;
	}
	return ray;
}

/* Finds which lights reach the spot. */
static void light_spot(const tracer *t, const spot *at, u32 *lit)
{
	for (u32 k = 0; k < t->n_lights; k++) {
		ts_v3 l;
		const ts_light *light = &t->lights[k];
		bool arrives = ts_k_light(light, at->p, &l) > 0.0f && ts_dot(at->n, l) > 0.0f;
		bool sun = light->kind == TS_LIGHT_KIND_DIRECTIONAL;
		ts_v3 from = sun ? ts_mad(at->p, l, t->beyond) : ts_load3(light->position);
		lit[k] = arrives && t->into->reaches(t, from, at->p);
	}
}

static void cast(const tracer *t, u32 x, u32 y)
{
	spot at;
	u64 i = (u64)y * t->eye->width + x;
	ts_disc_ray ray = eye_ray(t, x, y);
	ts_v3 zero = {0, 0, 0}, eye = ts_load3(t->eye->eye);
	bool left_out = t->sampling->chosen && !ts_sampling_chooses(t->sampling, (u32)i);
	if (left_out || !t->into->see(t, &ray, &at)) {
		ts_k_gpixel_store(&t->pixels[i], zero, TS_SKY, zero, zero);
		return;
	}
	f32 z = -ts_dot(ts_load3(t->eye->back), ts_sub(at.p, eye));
	ts_k_gpixel_store(&t->pixels[i], at.p, ts_k_screen_depth(t->eye->near, z), at.n, at.albedo);
	if (t->lit != NULL) light_spot(t, &at, t->lit + i * t->n_lights);
}

/* Adds the picture of one cell of the grid to the mean. */
static ts_status add_picture(f32 *radiance, tracer *t, ts_run *run, ts_work *work)
{
	u32 width = t->eye->width, height = t->eye->height, n = t->side * t->side;
	const ts_step *shader = ts_pipeline_maker(run->pipeline, TS_B_image_radiance);
	ts_stop *stop = ts_stop_here();
	for (u32 first = 0; first < height; first += ROWS) {
		u32 end = first + ROWS < height ? first + ROWS : height;
#pragma omp parallel for num_threads(t->n_threads) schedule(dynamic, 1)
		for (u32 y = first; y < end; y++)
			for (u32 x = 0; x < width && !ts_stopped(stop); x++) cast(t, x, y);
		ts_work_at(work, (u64)t->cell * height + end, (u64)n * height);
	}
	if (ts_run_stage(run, ts_stage_find(shader->stage)) != TS_OK) return TS_ERROR;
	const f32 *one = ts_frame_data(&run->frame, TS_B_image_radiance);
	for (u64 i = 0; i < (u64)width * height * 3; i++) radiance[i] += one[i] / (f32)n;
	return TS_OK;
}

static ts_status make_room(f32 **radiance, tracer *t, ts_run *run)
{
	u32 width = TS_PARAM(&run->params, width), height = TS_PARAM(&run->params, height);
	*radiance = ts_alloc_zero((size_t)width * height * 3, sizeof **radiance, t->into->label);
	t->pixels = ts_frame_make2(&run->frame, TS_B_gbuffer_pixel, height, width);
	if (*radiance == NULL || t->pixels == NULL) return TS_ERROR;
	if (!ts_shader_has_shadows(&run->params)) return TS_OK;
	t->lit = ts_frame_make3(&run->frame, TS_B_shadow_test_lit, height, width, t->n_lights);
	return t->lit != NULL ? TS_OK : TS_ERROR;
}

/* The diagonal of the box, and the longest half-axis of surfels with their centre in it. */
static f32 extent_of(const ts_scene *scene)
{
	f32 longest = 0.0f;
	for (u32 i = 0; i < scene->n_surfels; i++) {
		const ts_surfel *s = &scene->surfels[i];
		longest = ts_max(longest, ts_max(ts_length(ts_load3(s->u)), ts_length(ts_load3(s->v))));
	}
	return ts_length(ts_sub(ts_load3(scene->info.box_max), ts_load3(scene->info.box_min))) + longest;
}

/* Divides the rays among all cells; a share of them is a smaller grid. */
static u64 plan(tracer *t, ts_sampling *sampling)
{
	u64 n = (u64)t->eye->width * t->eye->height, each = 1 + (t->lit != NULL ? t->n_lights : 0);
	if (!sampling->chosen) {
		ts_sampling_plan(sampling, n, (u64)t->side * t->side, each * t->into->cost);
		while ((u64)t->side * t->side > sampling->some) t->side--;
		sampling->some = (u64)t->side * t->side;
	}
	t->sampling = sampling;
	u64 pixels = sampling->chosen ? n * sampling->chance >> 32 : n;
	return pixels * t->side * t->side * each;
}

static ts_status trace(f32 **radiance, const world *into, ts_run *run, ts_sampling *sampling)
{
	const ts_view *eye = ts_frame_data(&run->frame, TS_B_eye_view);
	double sigma_k = (double)TS_PARAM(&run->params, ewa_sigma_k);
	tracer t = {
		.into = into,
		.surfels = run->scene->surfels,
		.eye = eye,
		.lights = ts_frame_data(&run->frame, TS_B_lamp_light),
		.n_lights = (u32)ts_frame_n(&run->frame, TS_B_lamp_light),
		.eps = (double)*(const f32 *)ts_frame_data(&run->frame, TS_B_surfel_setup_epsilon),
		.fall = 0.5 / (sigma_k * sigma_k),
		.spread = 1.0f / (eye->focal * (f32)TS_PARAM(&run->params, truth_grid_rays)),
		.beyond = 2.0f * extent_of(run->scene),
		.side = TS_PARAM(&run->params, truth_grid_rays),
		.seed = TS_PARAM(&run->params, seed),
		.n_threads = (int)run->c.threads,
	};
	ts_sampling whole = {.rays = 0};
	sampling = sampling != NULL ? sampling : &whole;
	ts_status status = into->open(&t, run) == TS_OK ? make_room(radiance, &t, run) : TS_ERROR;
	ts_work work = ts_work_begin(into->label, status == TS_OK ? plan(&t, sampling) : 0);
	for (; t.cell < t.side * t.side && status == TS_OK; t.cell++) status = add_picture(*radiance, &t, run, &work);
	ts_work_end(&work);
	ts_discs_free(t.discs);
	ts_truth_free(t.mesh);
	return status;
}

static ts_status trace_scene(f32 **radiance, const world *into, const ts_scene *scene, const ts_params *params,
                             u32 threads, ts_sampling *sampling)
{
	ts_run run;
	*radiance = NULL;
	ts_run_begin(&run, scene, params, threads > 0 ? threads : 1);
	ts_status status = ts_truth_begin(&run, NULL, (const ts_buffer_id[]){TS_B_surfel_setup_disc, TS_N_BUFFERS});
	if (status == TS_OK) status = trace(radiance, into, &run, sampling);
	ts_run_end(&run);
	if (status == TS_OK) return TS_OK;
	free(*radiance);
	*radiance = NULL;
	return TS_ERROR;
}

bool ts_truth_has_surface(const ts_scene *scene, const ts_params *params)
{
	return scene->is_checkerboard || (TS_PARAM(params, surfels_from_mesh) > 0 && scene->n_triangles > 0);
}

ts_status ts_truth_discs(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
                         ts_sampling *sampling)
{
	return trace_scene(radiance, &of_discs, scene, params, threads, sampling);
}

ts_status ts_truth_surface(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
                           ts_sampling *sampling)
{
	return trace_scene(radiance, scene->is_checkerboard ? &of_board : &of_mesh, scene, params, threads, sampling);
}

u64 ts_truth_surface_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params)
{
	static const ts_buffer_id ids[] = {TS_B_surfel_setup_disc, TS_B_gbuffer_pixel, TS_B_image_radiance,
	                                   TS_B_image_srgb};
	const ts_expected expected = ts_pipeline_expect(method, scene, params);
	const ts_sizes *sizes = &expected.sizes;
	u64 bytes = ts_pipeline_bytes(TS_B_image_radiance, sizes);
	for (u32 i = 0; i < sizeof ids / sizeof ids[0]; i++) bytes += ts_pipeline_bytes(ids[i], sizes);
	if (ts_shader_has_shadows(params)) bytes += ts_pipeline_bytes(TS_B_shadow_test_lit, sizes);
	return bytes;
}

u64 ts_truth_discs_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params)
{
	return ts_truth_surface_bytes(method, scene, params) + (u64)DISC_BYTES * scene->n_surfels;
}
