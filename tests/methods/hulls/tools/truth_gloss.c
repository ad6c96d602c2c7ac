/* Specular reflection in double precision: the BRDF is the renderer's, the integral over a triangle that by many small
 * parts, and directions as the BRDF wants them have the mean of the integral over all. */
#include "kernels/base/shade.h"
#include "methods/hulls/tools/truth_gloss.h"
#include "tests/kernels/seeded.h"

enum { N = 2000, STEPS = 400, SAMPLES = 4096 };

static ts_truth_glossy surface_of(f32 roughness, ts_v3 n, ts_v3 v, ts_v3 f0)
{
	ts_gloss gloss = {.alpha_squared = ts_k_alpha_squared(roughness)};
	ts_store3(gloss.f0, f0);
	return ts_truth_glossy_of(&gloss, ts_v3_make(0, 0, 0), n, v);
}

/* Of metal the BRDF has nothing else. */
static void the_truth_has_the_renderers_brdf(void **state)
{
	(void)state;
	u32 n_bright = 0;
	for (u32 i = 0; i < N; i++) {
		ts_surface s = {.base = uniform3(0, 1), .metallic = 1, .roughness = uniform(0.25f, 1)};
		ts_v3 n = direction(), v = direction(), l = direction();
		ts_truth_glossy at = surface_of(s.roughness, n, v, s.base);
		ts_double3 found = ts_truth_gloss_brdf(&at, ts_double3_of(l));
		f32 n_l = ts_dot(n, l);
		if (!(n_l > 0)) assert_true(found.x == 0 && found.y == 0 && found.z == 0);
		if (n_l < 0.01f || ts_dot(n, v) < 0.01f) continue;
		ts_v3 right = ts_k_brdf(&s, n, v, l, n_l);
		for (u32 c = 0; c < 3; c++) {
			double truth = (double)(&right.x)[c];
			assert_true(fabs((&found.x)[c] - truth) <= 1e-4 * truth + 1e-6);
		}
		n_bright += right.x > 0.05f;
	}
	assert_true(n_bright > N / 20);
}

/* The middles of STEPS^2 parts of the flat triangle, each by the angle it is seen under. */
static double by_parts(const ts_truth_glossy *at, const ts_double3 c[3])
{
	ts_double3 b = ts_double3_mad(c[1], c[0], -1), d = ts_double3_mad(c[2], c[0], -1), across = ts_double3_cross(b, d);
	double sum = 0;
	for (u32 i = 0; i < STEPS * STEPS; i++) {
		double u = (i % STEPS + 0.5) / STEPS, v = (i / STEPS + 0.5) / STEPS;
		if (u + v > 1) {
			u = 1 - u;
			v = 1 - v;
		}
		ts_double3 way = ts_double3_mad(ts_double3_mad(c[0], b, u), d, v), l = ts_double3_unit(way);
		double far = ts_double3_dot(way, way);
		sum += ts_truth_gloss_brdf(at, l).y * fabs(ts_double3_dot(across, l)) / far / (2.0 * STEPS * STEPS);
	}
	return sum;
}

static void the_integral_is_that_of_many_parts(void **state)
{
	(void)state;
	u32 n_bright = 0;
	double worst = 0;
	for (u32 i = 0; i < 60; i++) {
		ts_v3 n = direction(), v = ts_normalize(ts_add(n, ts_scale(direction(), 0.8f)));
		ts_truth_glossy at = surface_of(uniform(0.2f, 1), n, v, ts_v3_make(1, 1, 1));
		ts_v3 mirrored = ts_sub(ts_scale(n, 2 * ts_dot(n, v)), v);
		ts_double3 corner[3];
		for (u32 k = 0; k < 3; k++) {
			ts_v3 aside = ts_scale(direction(), uniform(0.1f, 1.2f));
			corner[k] = ts_double3_of(ts_scale(ts_add(mirrored, aside), uniform(1, 3)));
		}
		double found = ts_truth_gloss_triangle(&at, corner).y, right = by_parts(&at, corner);
		worst = fmax(worst, fabs(found - right) / (right + 0.01));
		n_bright += right > 0.1;
	}
	print_message("# %u bright, within %.2g\n", n_bright, worst);
	assert_true(n_bright > 10 && worst < 0.02);
}

/* Eight triangles are the sphere. */
static double over_sphere(const ts_truth_glossy *at)
{
	double sum = 0;
	for (u32 k = 0; k < 8; k++) {
		double x = k & 1 ? 1 : -1, y = k & 2 ? 1 : -1, z = k & 4 ? 1 : -1;
		const ts_double3 corner[3] = {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
		sum += ts_truth_gloss_triangle(at, corner).y;
	}
	return sum;
}

static void samples_have_the_mean_of_the_integral(void **state)
{
	(void)state;
	for (u32 i = 0; i < 12; i++) {
		ts_v3 n = direction(), v = ts_normalize(ts_add(n, ts_scale(direction(), 0.7f)));
		ts_truth_glossy at = surface_of(0.2f + 0.06f * (f32)i, n, v, ts_v3_make(0.04f, 0.5f, 1));
		double mean = 0, right = over_sphere(&at);
		for (u32 k = 0; k < SAMPLES; k++) {
			ts_double3 l;
			mean += ts_truth_gloss_sample(&at, (k + 0.5) / SAMPLES, 0.6180339887498949 * k, &l).y / SAMPLES;
		}
		assert_true(right > 0.1 && right < 1.01 && fabs(mean / right - 1) < 0.02);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(the_truth_has_the_renderers_brdf),
		seeded_test(the_integral_is_that_of_many_parts),
		seeded_test(samples_have_the_mean_of_the_integral),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
