/* Truth of shadows by rays: how many samples of each light reach what the eye sees (iVIR sections 4 and 6; METHODS 17),
 * with the methods' own samples, or with enough to make an area light. As in kernels/raster/shadow_map.h, a sample
 * reaches points outside of its view's image or before its near plane.
 *
 * A ray goes from the sample towards the point, so that it meets surfaces that face the sample, as the sample's depth
 * map does. The point's own triangle stops no ray. Nor does anything nearer than 2^-20 of the greatest coordinate, 16
 * roundings, to that triangle's plane, measured along the ray: what touches a receiver cannot be distinguished from it,
 * and neither can the neighbours in its plane. There is no other bias. */
#include "kernels/raster/shadow_test.h"
#include "methods/pipeline.h"
#include "methods/points/tools/tools.h"
#include "methods/raster/raster.h"
#include "truth/sampling.h"
#include "truth/truth.h"

enum { MOST_SAMPLES = 1 << 20, RAYS = 64 }; /* of all lights; rays that are cast at once */

typedef struct {
	const ts_truth *truth;
	const ts_arrays *scene;
	const ts_view *eye;
	u32 samples;
	const u64 *seen; /* eye.depth_triangle */
	const ts_offscreen *views;
	const ts_lamp *lamps;
	u32 n_lamps, step; /* step: views per sample */
	u32 *lit;
} tracer;

static f32 greatest(ts_v3 p) { return ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z)); }

/* Whether the image of a perspective or orthographic view contains the point; a cube's always does. */
static bool is_in_image(const ts_camera_k *view, const ts_corner *p)
{
	ts_v2 at = ts_k_project(view, p);
	i32 i = ts_floor_i32(at.x), j = ts_floor_i32(at.y);
	return i >= 0 && j >= 0 && i < view->width && j < view->height;
}

/* A ray from the sample, or from an orthographic view's image plane. The footprint is a texel's; an orthographic view
 * takes the finest level instead. */
static ts_truth_query ray_to(const ts_camera_k *view, ts_v3 p, f32 z)
{
	bool parallel = view->orthographic != 0;
	ts_v3 from = parallel ? ts_mad(p, view->back, z) : view->eye;
	ts_v3 way = ts_sub(p, from);
	return (ts_truth_query){.origin = from,
	                        .direction = ts_normalize(way),
	                        .near = view->near * (ts_length(way) / z),
	                        .masked = TS_NONE,
	                        .from = from,
	                        .spread = parallel ? 0.0f : 1.0f / view->focal};
}

/* False if the sample reaches the point, whatever rays say. */
static bool is_asked(ts_truth_query *ray, const tracer *t, const ts_offscreen *offscreen, const ts_receiver *at)
{
	ts_camera_k view = ts_k_offscreen(offscreen);
	ts_corner p = ts_k_to_view(&view, at->p);
	if (p.z < view.near || (t->step == 1 && !is_in_image(&view, &p))) return false;
	*ray = ray_to(&view, at->p, p.z);
	return true;
}

static bool reaches(const ts_truth_query *ray, const ts_truth_hit *hit, const ts_receiver *at, u32 triangle)
{
	if (hit->triangle == TS_NONE || hit->triangle == triangle) return true;
	f32 height = ts_max(greatest(at->p), greatest(ray->origin)) * 9.5367431640625e-7f;
	f32 slope = ts_max(ts_abs(ts_dot(at->n, ray->direction)), TS_LEAST_FACING);
	return hit->t >= ts_length(ts_sub(at->p, ray->origin)) - height / slope;
}

/* How many of these rays reach the point. */
static u32 count_rays(const tracer *t, const ts_truth_query *rays, u32 n, const ts_receiver *at, u32 triangle)
{
	ts_truth_hit found[RAYS];
	u32 n_reach = 0;
	ts_truth_cast_all(found, t->truth, rays, n);
	for (u32 i = 0; i < n; i++) n_reach += reaches(&rays[i], &found[i], at, triangle);
	return n_reach;
}

static u32 pixel_of(const void *user, u64 i)
{
	const tracer *t = user;
	return t->seen[i] != TS_EMPTY ? (u32)i : TS_NONE;
}

/* How many samples of a light reach the point; for a share of them, the expected number. */
static u32 count(const tracer *t, const ts_lamp *lamp, const ts_share *share, const ts_receiver *at, u32 triangle)
{
	u64 n = lamp->samples, hits = 0, asked = n * share->asked / share->items;
	const ts_share of = {n, asked > 0 ? asked : 1, share->pixel, share->seed};
	ts_truth_query rays[RAYS] = {{.near = 0}};
	u32 n_rays = 0;
	for (u64 j = 0; j < of.asked; j++) {
		const ts_offscreen *view = &t->views[t->step * (lamp->first + (u32)ts_share_item(&of, j))];
		view += t->step == 6 ? ts_k_cube_place(ts_sub(at->p, ts_load3(view->eye))).face : 0;
		bool asks = is_asked(&rays[n_rays], t, view, at);
		n_rays += asks;
		hits += !asks;
		if (n_rays < RAYS) continue;
		hits += count_rays(t, rays, n_rays, at, triangle);
		n_rays = 0;
	}
	hits += count_rays(t, rays, n_rays, at, triangle);
	return (u32)((hits * n + of.asked / 2) / of.asked);
}

static void resolve(const void *user, u64 i, const ts_share *share)
{
	const tracer *t = user;
	const ts_eye_place place = ts_k_eye_place(t->eye, t->samples, i);
	ts_receiver at = ts_k_receiver(t->scene, &place.view, t->seen[i], place.x, place.y);
	for (u32 k = 0; at.seen && k < t->n_lamps; k++) {
		t->lit[i * t->n_lamps + k] = count(t, &t->lamps[k], share, &at, (u32)t->seen[i]);
	}
}

static ts_status trace(const ts_truth *truth, ts_run *run, ts_sampling *sampling, const char *label)
{
	u64 width = TS_PARAM(&run->params, width), n = ts_eye_size(run);
	tracer t = {
		.truth = truth,
		.scene = ts_truth_scene(truth),
		.eye = ts_frame_data(&run->frame, TS_B_eye_view),
		.samples = ts_eye_samples(&run->params),
		.seen = ts_frame_data(&run->frame, TS_B_eye_depth_triangle),
		.views = ts_frame_data(&run->frame, TS_B_offscreen_view),
		.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_shape),
		.lamps = ts_frame_data(&run->frame, TS_B_lamp_shape),
		.step = ts_run_has_cubes(run) ? 6 : 1,
	};
	t.lit = ts_frame_make3(&run->frame, TS_B_shadow_test_lit, n / width, width, t.n_lamps);
	if (t.lit == NULL) return TS_ERROR;
	memset(t.lit, 0, n * t.n_lamps * sizeof *t.lit);
	u64 n_samples = ts_frame_n(&run->frame, TS_B_offscreen_view) / t.step;
	const ts_truth_asked asked = {.label = label,
	                              .n = n,
	                              .items = n_samples,
	                              .each = 1,
	                              .pixel = pixel_of,
	                              .ask = resolve,
	                              .user = &t,
	                              .threads = run->c.threads};
	ts_truth_ask(&asked, sampling);
	return TS_OK;
}

/* Inputs of rays to samples of lights. */
static const ts_buffer_id needs[] = {TS_B_eye_depth_triangle, TS_B_lamp_shape, TS_B_offscreen_view, TS_N_BUFFERS};

ts_status ts_truth_shadow_begin(ts_run *run, const char *effect) { return ts_truth_begin(run, effect, needs); }

ts_status ts_truth_samples(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	return trace(truth, run, sampling, "truth samples");
}

ts_status ts_truth_area(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	static const char *const maps[] = {"lamp", "lamp.view", NULL};
	static const char *const cubes[] = {"lamp.ball", "lamp.cube", "offscreen", NULL};
	u32 n = TS_PARAM(&run->params, truth_area_samples), n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_shape);
	if ((u64)n * n_lamps > MOST_SAMPLES) {
		return ts_fail("truth.area_samples=%u: of %u lights at most %u each would be right", (unsigned)n,
		               (unsigned)n_lamps, (unsigned)(MOST_SAMPLES / n_lamps));
	}
	const char *const *stage = ts_run_has_cubes(run) ? cubes : maps;
	ts_pipeline_plan(run->pipeline, run, NULL, &(ts_request){.samples = n});
	for (; *stage != NULL; stage++) {
		if (ts_run_stage(run, ts_stage_find(*stage)) != TS_OK) return TS_ERROR;
	}
	return trace(truth, run, sampling, "truth area");
}

u64 ts_truth_shadow_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params)
{
	static const ts_buffer_id ids[] = {TS_B_pose_vertex,    TS_B_eye_depth_triangle, TS_B_cube_size_face,
	                                   TS_B_offscreen_view, TS_B_shadow_test_lit,    TS_B_image_radiance,
	                                   TS_B_image_srgb};
	const ts_pipeline *start = ts_pipeline_making(method->effect->name, needs);
	ts_params many = *params;
	u64 bytes = 0, views = (u64)TS_PARAM(params, truth_area_samples) *
	                       (TS_PARAM(params, lamp_source) == TS_LAMP_SCENE ? scene->n_lights : 1);
	TS_PARAM_SET(&many, lamp_cubes, TS_PARAM(params, truth_area_samples));
	TS_PARAM_SET(&many, lamp_views, views < TS_NONE ? (u32)views : TS_NONE);
	const ts_expected expected = ts_pipeline_expect(start != NULL ? start : method, scene, &many);
	for (u32 i = 0; i < sizeof ids / sizeof ids[0]; i++) bytes += ts_pipeline_bytes(ids[i], &expected.sizes);
	return bytes;
}
