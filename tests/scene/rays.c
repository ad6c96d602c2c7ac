/* Rays and clearances against every triangle, one by one, in double arithmetic. */
#include "kernels/base/scene.h"
#include "scene/build.h"
#include "scene/rays.h"
#include "tests/model/test.h"

enum { N = 600 };

static f32 between(u32 i, f32 low, f32 high) { return low + (high - low) * ts_uniform(ts_random(i, 6, 3)); }

static ts_v3 point(u32 i, f32 reach)
{
	return ts_v3_make(between(3 * i, -reach, reach), between(3 * i + 1, -reach, reach),
	                  between(3 * i + 2, -reach, reach));
}

static void corner(ts_build *build, ts_v3 p)
{
	ts_vertex v = {.position = {p.x, p.y, p.z}};
	ts_build_vertex(build, &v);
}

/* Small triangles, each seen from one side, from both, or masked, by turns. */
static ts_build *soup(void)
{
	ts_build *build = ts_build_new("soup");
	assert_non_null(build);
	ts_material m = ts_material_default();
	for (u32 k = 0; k < 3; k++) {
		m.flags = k == 0 ? 0 : k == 1 ? TS_DOUBLE_SIDED : TS_MASKED;
		ts_build_material(build, &m);
	}
	for (u32 i = 0; i < N; i++) {
		ts_v3 at = point(i, 10.0f);
		for (u32 k = 0; k < 3; k++) corner(build, ts_add(at, point(N + 3 * i + k, 2.0f)));
		ts_build_triangle(build, 3 * i, 3 * i + 1, 3 * i + 2, i % 3);
	}
	return build;
}

static void load(double to[3], const ts_scene *s, u32 t, u32 k)
{
	for (u32 a = 0; a < 3; a++) to[a] = (double)s->vertices[s->triangles[t].vertex[k]].position[a];
}

static void cross(double to[3], const double a[3], const double b[3])
{
	for (u32 k = 0; k < 3; k++) to[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* The nearest triangle that is met by more than a hair; *doubt if one is met within it. */
static u32 nearest(double *distance, bool *doubt, const ts_scene *s, const double from[3], const double way[3])
{
	u32 hit = TS_NONE;
	*distance = 1e9;
	*doubt = false;
	for (u32 t = 0; t < N; t++) {
		double a[3], b[3], c[3], ab[3], ac[3], n[3], p[3], at[3], inside[3];
		load(a, s, t, 0);
		load(b, s, t, 1);
		load(c, s, t, 2);
		for (u32 k = 0; k < 3; k++) ab[k] = b[k] - a[k], ac[k] = c[k] - a[k], p[k] = a[k] - from[k];
		cross(n, ab, ac);
		double facing = dot(n, way), far = dot(n, p) / facing;
		if (t % 3 == 2 || far <= 0.0 || (t % 3 == 0 && facing > 0.0)) continue;
		const double *corners[3] = {a, b, c};
		double least = 1e9;
		for (u32 k = 0; k < 3; k++) {
			double edge[3];
			for (u32 i = 0; i < 3; i++) {
				edge[i] = corners[(k + 1) % 3][i] - corners[k][i];
				at[i] = from[i] + way[i] * far - corners[k][i];
			}
			cross(inside, edge, at);
			least = fmin(least, dot(inside, n) / dot(n, n));
		}
		*doubt |= fabs(least) < 1e-4 || fabs(facing) < 1e-4 * sqrt(dot(n, n));
		if (least < 0.0 || far >= *distance) continue;
		*distance = far;
		hit = t;
	}
	return hit;
}

static void rays_meet_the_nearest_triangle(void **state)
{
	(void)state;
	ts_build *build = soup();
	const ts_scene *scene = ts_build_peek(build);
	ts_rays *rays = ts_rays_new(scene);
	u32 n_hits = 0, n_sure = 0;
	assert_non_null(rays);
	for (u32 i = 0; i < 4000; i++) {
		ts_v3 from = point(90000 + i, 12.0f), way = ts_rays_way(i, 4000);
		const double start[3] = {(double)from.x, (double)from.y, (double)from.z};
		const double to[3] = {(double)way.x, (double)way.y, (double)way.z};
		double expected;
		f32 distance;
		bool doubt;
		u32 wanted = nearest(&expected, &doubt, scene, start, to);
		u32 hit = ts_rays_cast(&distance, rays, from, way, TS_RAYS_FAR);
		if (doubt) continue;
		n_sure++;
		n_hits += hit != TS_NONE;
		assert_int_equal(hit, wanted);
		if (hit == TS_NONE) assert_true(distance == TS_RAYS_FAR);
		if (hit != TS_NONE) assert_true(fabs((double)distance - expected) < 1e-3);
	}
	assert_true(n_sure > 3000 && n_hits > 500 && n_hits < n_sure);
	ts_rays_free(rays);
	ts_build_free(build);
}

/* No sample of any triangle is nearer, and one is as near. */
static void clearance_is_the_distance_to_the_nearest(void **state)
{
	(void)state;
	ts_build *build = soup();
	const ts_scene *scene = ts_build_peek(build);
	ts_rays *rays = ts_rays_new(scene);
	assert_non_null(rays);
	for (u32 i = 0; i < 60; i++) {
		ts_v3 p = point(50000 + i, 11.0f);
		f32 clear = ts_rays_clearance(rays, p, 100.0f);
		double least = 1e9;
		for (u32 t = 0; t < N; t++) {
			double a[3], b[3], c[3];
			load(a, scene, t, 0);
			load(b, scene, t, 1);
			load(c, scene, t, 2);
			for (u32 k = 0; k < 21 * 21; k++) {
				double u = k % 21 / 20.0, v = k / 21 / 20.0 * (1.0 - u), d[3];
				const double q[3] = {(double)p.x, (double)p.y, (double)p.z};
				for (u32 x = 0; x < 3; x++) d[x] = a[x] + u * (b[x] - a[x]) + v * (c[x] - a[x]) - q[x];
				least = fmin(least, sqrt(dot(d, d)));
			}
		}
		assert_true((double)clear <= least + 1e-4 && (double)clear >= least - 0.2);
		assert_true(ts_rays_clearance(rays, p, clear * 0.5f) == clear * 0.5f);
	}
	ts_rays_free(rays);
	ts_build_free(build);
}

/* The middle of a tetrahedron that faces outwards is inside; other points are not, nor is that of one turned over. */
static void only_the_middle_of_bodies_is_inside(void **state)
{
	(void)state;
	static const f32 p[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
	static const u32 faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
	for (u32 inwards = 0; inwards < 2; inwards++) {
		ts_build *build = ts_build_new("body");
		for (u32 i = 0; i < 4; i++) corner(build, ts_load3(p[i]));
		for (u32 i = 0; i < 4; i++)
			ts_build_triangle(build, faces[i][0], faces[i][inwards ? 2 : 1], faces[i][inwards ? 1 : 2], TS_NONE);
		ts_rays *rays = ts_rays_new(ts_build_peek(build));
		assert_non_null(rays);
		assert_int_equal(ts_rays_is_inside(rays, ts_v3_make(0.0f, 0.0f, 0.0f)), !inwards);
		assert_false(ts_rays_is_inside(rays, ts_v3_make(3.0f, 0.0f, 0.0f)));
		assert_int_equal(ts_rays_free_between(rays, ts_v3_make(3, 0, 0), ts_v3_make(-3, 0, 0)), false);
		assert_true(ts_rays_free_between(rays, ts_v3_make(3, 0, 0), ts_v3_make(3, 5, 0)));
		ts_rays_free(rays);
		ts_build_free(build);
	}
}

/* Triangles without corners, beyond the limit, or in one place by the thousand: no crash, no hit. */
static void odd_triangles_are_never_hit(void **state)
{
	(void)state;
	ts_build *build = ts_build_new("odd");
	f32 distance;
	for (u32 i = 0; i < 3; i++) corner(build, ts_v3_make(1e30f, (f32)i, 0.0f));
	for (u32 i = 0; i < 3000; i++) corner(build, ts_v3_make(5.0f, 5.0f, 5.0f));
	ts_build_triangle(build, 0, 1, 2, TS_NONE);
	ts_build_triangle(build, 7, 8, 900000, TS_NONE);
	for (u32 i = 0; i < 1000; i++) ts_build_triangle(build, 3 + 3 * i, 4 + 3 * i, 5 + 3 * i, 77);
	ts_rays *rays = ts_rays_new(ts_build_peek(build));
	assert_non_null(rays);
	assert_int_equal(ts_rays_cast(&distance, rays, ts_v3_make(0, 0, 0), ts_v3_make(1, 0, 0), 9.0f), TS_NONE);
	assert_true(distance == 9.0f);
	assert_float_equal(ts_rays_clearance(rays, ts_v3_make(5, 5, 2), 100.0f), 3.0f, 1e-5f);
	ts_rays_free(rays);
	ts_build_free(build);
	build = ts_build_new("empty");
	rays = ts_rays_new(ts_build_peek(build));
	assert_non_null(rays);
	assert_true(ts_rays_clearance(rays, ts_v3_make(0, 0, 0), 2.0f) == 2.0f);
	ts_rays_free(rays);
	ts_rays_free(NULL);
	ts_build_free(build);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_meet_the_nearest_triangle),
		cmocka_unit_test(clearance_is_the_distance_to_the_nearest),
		cmocka_unit_test(only_the_middle_of_bodies_is_inside),
		cmocka_unit_test(odd_triangles_are_never_hit),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
