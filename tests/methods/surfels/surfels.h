/* Scenes of surfels for tests, made by hand. */
#ifndef TS_TESTS_METHODS_SURFELS_SURFELS_H
#define TS_TESTS_METHODS_SURFELS_SURFELS_H
#include <math.h>
#include "scene/build.h"
#include "tests/methods/small.h"

static u32 surfels_random;
static inline f32 surfels_uniform(void) { return ts_uniform(ts_random(surfels_random++, 6, 41)); }

static inline void surfels_add(ts_build *build, ts_v3 centre, ts_v3 n, f32 radius, f32 thin, ts_v3 colour)
{
	ts_surfel s;
	ts_v3 other = fabsf(n.y) < 0.9f ? ts_v3_make(0, 1, 0) : ts_v3_make(1, 0, 0);
	ts_v3 u = ts_normalize(ts_cross(other, n)), v = ts_cross(n, u);
	ts_store3(s.centre, centre);
	ts_store3(s.u, ts_scale(u, radius));
	ts_store3(s.v, ts_scale(v, radius * thin));
	ts_store3(s.colour, colour);
	ts_build_surfel(build, &s);
}

/* Seen along -z from `eye`. */
static inline ts_scene *surfels_finish(ts_build *build, const ts_params *params, ts_v3 eye, f32 yfov)
{
	ts_scene *scene;
	char name[] = "eye";
	ts_camera camera = {.name = name, .right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}, .yfov = yfov};
	ts_store3(camera.eye, eye);
	ts_build_camera(build, &camera);
	if (ts_build_finish(build, params, "eye", &scene) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

/* A ball of so many, in stripes, and a ball about it that shows its inside, where the shadow of the first falls. */
static inline ts_scene *surfels_balls(const ts_params *params, u32 n)
{
	ts_build *build = ts_build_new("balls");
	const ts_light sun = {.direction = {0.6f, -0.2f, -0.8f}, .intensity = {3, 3, 3}};
	ts_build_light(build, &sun);
	surfels_random = 0;
	for (u32 i = 0; i < n; i++) {
		f32 y = 1 - (2 * (f32)i + 1) / (f32)n, across = ts_sqrt(1 - y * y), turn = (f32)i * 0.618034f;
		ts_v3 d = ts_v3_make(across * ts_cos_turn(turn), y, across * ts_sin_turn(turn));
		ts_v3 colour = (i32)floorf(6 * y + 12) % 2 == 0 ? ts_v3_make(0.9f, 0.2f, 0.1f) : ts_v3_make(0.1f, 0.3f, 0.9f);
		f32 radius = 5 / ts_sqrt((f32)n) * (0.7f + 0.6f * surfels_uniform());
		surfels_add(build, d, d, radius, 0.6f + 0.4f * surfels_uniform(), colour);
		if (i % 2 == 0) surfels_add(build, ts_scale(d, 3), ts_neg(d), 4 * radius, 1, ts_v3_make(0.2f, 0.8f, 0.3f));
	}
	return surfels_finish(build, params, ts_v3_make(0, 0.2f, 2.6f), 60.0f / 360);
}

static inline void surfels_run(ts_run *run, const ts_scene *scene, const ts_params *params, const char *method,
                               u32 threads)
{
	ts_run_begin(run, scene, params, threads);
	if (ts_pipeline_run(ts_pipeline_find("surfels", method), run) != TS_OK)
		fail_msg("%s: %s", method, ts_error_message());
}

/* After a stage: the same again from what it claims to read. */
static inline ts_status surfels_claims(const ts_run *run, const ts_stage *stage, void *user)
{
	(void)user;
	small_assert_claims(run, stage);
	return TS_OK;
}

/* A surfel at a pixel, in double precision: r3D, r2D and the depth. */
typedef struct {
	double r3, r2, z;
} ray_hit;

typedef struct {
	double x, y, z;
} d3;
static inline d3 d3_sub(d3 a, d3 b) { return (d3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline double d3_dot(d3 a, d3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline d3 d3_cross(d3 a, d3 b)
{
	return (d3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline d3 d3_of(const f32 *p) { return (d3){p[0], p[1], p[2]}; }

/* The camera looks along -z, so that view space is the world moved. */
static inline ray_hit hit_of(const ts_view *view, const ts_surfel *s, double x, double y)
{
	d3 eye = d3_of(view->eye), c = d3_sub(d3_of(s->centre), eye), u = d3_of(s->u), v = d3_of(s->v), n = d3_cross(u, v);
	double f = view->focal, w = view->width / 2.0, h = view->height / 2.0;
	d3 q = {(x - w) / f, -(y - h) / f, -1};
	double t = d3_dot(c, n) / d3_dot(q, n);
	d3 d = {q.x * t - c.x, q.y * t - c.y, q.z * t - c.z};
	double a = d3_dot(d, u) / d3_dot(u, u), b = d3_dot(d, v) / d3_dot(v, v);
	double px = w + f * c.x / -c.z - x, py = h - f * c.y / -c.z - y;
	bool turned = d3_dot(n, c) >= 0, met = !turned && t >= view->near, seen = !turned && -c.z >= view->near;
	return (ray_hit){met ? sqrt(a * a + b * b) : 1e9, seen ? sqrt(px * px + py * py) : 1e9, t};
}

/* Every stage of a frame again, from what it claims to read. */
static inline void surfels_assert_claims(const ts_params *params, const char *method)
{
	ts_run run;
	ts_scene *scene = surfels_balls(params, 800);
	ts_run_begin(&run, scene, params, 2);
	run.hook = surfels_claims;
	if (ts_pipeline_run(ts_pipeline_find("surfels", method), &run) != TS_OK) fail_msg("%s", ts_error_message());
	ts_run_end(&run);
	ts_scene_free(scene);
}

#endif
