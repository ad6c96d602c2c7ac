/* The sample set is the one of CONTRACT rule 40, and rays leave mirrors by the law of reflection. */
#include "kernels/points/samples.h"
#include "tests/kernels/seeded.h"

enum { N = 20000 };

static const i32 specified[] = {
	0,   -23, 19,  30, 45, 48,  -37, 10, -9, 56,  43,  10, -33, 59, -63, 6,  -55, -38, -14, 17,  63, -17, -62, 35,  -28,
	-26, -56, -64, 23, -4, -21, 38,  13, 54, -35, -47, 7,  -49, 47, -59, 21, -25, 7,   10,  -10, -4, 32,  -43, -14, -46,
};

static void offsets_are_those_of_the_contract(void **state)
{
	(void)state;
	assert_int_equal(sizeof specified / sizeof specified[0], 2 * TS_N_SAMPLES);
	for (u32 k = 0; k < TS_N_SAMPLES; k++) {
		ts_v2 o = ts_k_sample_offset(k);
		assert_true(o.x == (f32)((specified[2 * k] + 0.5) / 128) && o.y == (f32)((specified[2 * k + 1] + 0.5) / 128));
		assert_true(ts_abs(o.x) < 0.5f && ts_abs(o.y) < 0.5f);
	}
}

/* Around the torus no two are nearer than 21/128, and some pair is as near as another dart would not have been. */
static void no_two_offsets_are_too_near(void **state)
{
	(void)state;
	double nearest = 1;
	for (u32 i = 0; i < TS_N_SAMPLES; i++) {
		for (u32 j = 0; j < i; j++) {
			ts_v2 a = ts_k_sample_offset(i), b = ts_k_sample_offset(j);
			double dx = fabs((double)a.x - b.x), dy = fabs((double)a.y - b.y);
			nearest = fmin(nearest, hypot(fmin(dx, 1 - dx), fmin(dy, 1 - dy)));
		}
	}
	assert_true(nearest >= 21.0 / 128 && nearest < 22.0 / 128);
}

static void put(f32 *to, ts_v3 from) { ts_store3(to, from); }

/* A plane mirror: the ray's line passes through the eye's image behind the mirror. */
static void plane_mirrors_show_the_eyes_image(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 eye = uniform3(-5, 5), p = uniform3(-5, 5), n = direction();
		ts_v3 u = ts_normalize(ts_cross(n, direction())), v = ts_cross(n, u);
		double3 image = d3_mad(d3_of(eye), d3_of(n), 2 * d3_dot(d3_sub(d3_of(p), d3_of(eye)), d3_of(n)));
		ts_pixel pixel = {0};
		put(pixel.position, p);
		put(pixel.normal, n);
		put(pixel.position_dx, ts_scale(u, 0.25f));
		put(pixel.position_dy, ts_scale(v, 0.5f));
		u32 k = i % TS_N_SAMPLES;
		ts_ray ray = ts_k_sample_ray(&pixel, eye, k);
		double3 at = d3_mad(d3_of(p), d3_of(u), 0.25 * (specified[2 * k] + 0.5) / 128);
		at = d3_mad(at, d3_of(v), 0.5 * (specified[2 * k + 1] + 0.5) / 128);
		assert_true(d3_distance(d3_of(ray.p), at) <= 3e-6);
		if (d3_distance(at, d3_of(eye)) < 0.5) continue;
		assert_true(d3_distance(d3_of(ray.direction), d3_unit(d3_sub(at, image))) <= 2e-5);
	}
}

/* A curved mirror: angle in and angle out are equal at the normal of the sample. */
static void curved_mirrors_obey_the_law_of_reflection(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 eye = uniform3(-5, 5), p = uniform3(-5, 5), n = direction();
		ts_v3 nx = ts_scale(direction(), 0.3f), ny = ts_scale(direction(), 0.3f);
		if (d3_distance(d3_of(eye), d3_of(p)) < 0.5) continue;
		ts_pixel pixel = {0};
		put(pixel.position, p);
		put(pixel.normal, n);
		put(pixel.normal_dx, nx);
		put(pixel.normal_dy, ny);
		u32 k = i % TS_N_SAMPLES;
		double3 r = d3_of(ts_k_sample_ray(&pixel, eye, k).direction), in = d3_unit(d3_sub(d3_of(p), d3_of(eye)));
		double3 m = d3_mad(d3_of(n), d3_of(nx), (specified[2 * k] + 0.5) / 128);
		m = d3_unit(d3_mad(m, d3_of(ny), (specified[2 * k + 1] + 0.5) / 128));
		assert_near(d3_length(r), 1, 1e-6);
		assert_near(d3_dot(r, m), -d3_dot(in, m), 2e-6);
		assert_near(d3_dot(r, d3_cross(in, m)), 0, 2e-6);
	}
}

/* Later bounces: spread 0 is a plane mirror; else the normal leans by the offset, and the same law holds. */
static void later_bounces_obey_the_law_of_reflection(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 from = uniform3(-5, 5), p = uniform3(-5, 5), n = direction();
		ts_v3 u = ts_normalize(ts_cross(n, direction())), v = ts_cross(n, u);
		if (d3_distance(d3_of(from), d3_of(p)) < 0.5) continue;
		f32 spread = i % 2 == 0 ? 0 : uniform(0, 1);
		u32 k = below(TS_N_BOUNCE_SAMPLES);
		double3 r = d3_of(ts_k_bounce_direction(p, n, u, v, from, spread, k));
		double3 in = d3_unit(d3_sub(d3_of(p), d3_of(from)));
		double3 m = d3_mad(d3_of(n), d3_of(u), (specified[2 * k] + 0.5) / 128 * spread);
		m = d3_unit(d3_mad(m, d3_of(v), (specified[2 * k + 1] + 0.5) / 128 * spread));
		assert_true(d3_distance(r, d3_mad(in, m, -2 * d3_dot(in, m))) <= 3e-6);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(offsets_are_those_of_the_contract),        seeded_test(no_two_offsets_are_too_near),
		seeded_test(plane_mirrors_show_the_eyes_image),        seeded_test(curved_mirrors_obey_the_law_of_reflection),
		seeded_test(later_bounces_obey_the_law_of_reflection),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
