/* Vectors: exact on small integers, near double precision elsewhere, and in the written order without contraction. */
#include "tests/kernels/seeded.h"

enum { N = 100000 };

static ts_v3 small(void)
{
	f32 x = (f32)below(2001) - 1000, y = (f32)below(2001) - 1000;
	return ts_v3_make(x, y, (f32)below(2001) - 1000);
}

/* Any exponent that a product of two sanitized numbers may have. */
static f32 wide(void) { return uniform(-1, 1) * ldexpf(1, (int)below(48) - 24); }

static ts_v3 wide3(void)
{
	f32 x = wide(), y = wide();
	return ts_v3_make(x, y, wide());
}

static bool equal(ts_v3 a, double3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

static void vectors_of_small_integers_are_exact(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = small(), b = small();
		double3 p = d3_of(a), q = d3_of(b);
		assert_true(equal(ts_add(a, b), d3_add(p, q)) && equal(ts_sub(a, b), d3_sub(p, q)));
		assert_true(equal(ts_neg(a), d3_scale(p, -1)) && equal(ts_scale(a, 4), d3_scale(p, 4)));
		assert_true(equal(ts_mul(a, b), (double3){p.x * q.x, p.y * q.y, p.z * q.z}));
		assert_true(equal(ts_mad(a, b, 3), d3_mad(p, q, 3)));
		assert_true(ts_dot(a, b) == d3_dot(p, q) && equal(ts_cross(a, b), d3_cross(p, q)));
		assert_true(equal(ts_min3(a, b), (double3){fmin(p.x, q.x), fmin(p.y, q.y), fmin(p.z, q.z)}));
		assert_true(equal(ts_max3(a, b), (double3){fmax(p.x, q.x), fmax(p.y, q.y), fmax(p.z, q.z)}));
	}
}

static void dot_and_cross_are_near_double_precision(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = wide3(), b = wide3();
		double3 p = d3_of(a), q = d3_of(b);
		double size = d3_length(p) * d3_length(q);
		assert_near(ts_dot(a, b), d3_dot(p, q), 3e-7 * size);
		assert_true(d3_distance(d3_of(ts_cross(a, b)), d3_cross(p, q)) <= 3e-7 * size);
		assert_true(equal(ts_cross(a, b), d3_of(ts_neg(ts_cross(b, a)))));
		assert_true(equal(ts_cross(a, a), (double3){0, 0, 0}));
	}
}

/* A fused multiply-add would leave the rounding error of one product; another order would keep the 1. */
static void products_add_in_the_written_order(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 a = wide(), b = wide();
		assert_true(ts_diff_of_products(a, b, a, b) == 0);
		assert_true(ts_dot(ts_v3_make(a, -a, 0), ts_v3_make(b, b, 1)) == 0);
	}
	ts_v3 one = ts_v3_make(1, 1, 1), big = ts_v3_make(1073741824, 1, -1073741824);
	assert_true(ts_dot(big, one) == 0 && ts_blend1(big, 1, 1, 1) == 0);
	assert_true(ts_dot(ts_v3_make(big.x, big.z, 1), one) == 1);
}

static void normalized_vectors_have_length_one(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = wide3();
		double l = d3_length(d3_of(a));
		assert_near(ts_length(a), l, 3e-7 * l);
		assert_near(d3_length(d3_of(ts_normalize(a))), 1, 4e-7);
		assert_true(d3_distance(d3_of(ts_normalize(a)), d3_scale(d3_of(a), 1 / l)) <= 4e-7);
	}
	assert_true(equal(ts_normalize(ts_v3_make(0, 0, 0)), (double3){0, 0, 0}));
	assert_true(equal(ts_normalize(ts_v3_make(0, -5, 0)), (double3){0, -1, 0}));
}

/* Same length, same angle on the other side, in the plane of the two; and back again. */
static void reflection_keeps_length_and_angle(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 d = direction(), n = direction();
		double3 r = d3_of(ts_reflect(d, n));
		assert_near(d3_length(r), 1, 1e-6);
		assert_near(d3_dot(r, d3_of(n)), -d3_dot(d3_of(d), d3_of(n)), 1e-6);
		assert_near(d3_dot(r, d3_cross(d3_of(d), d3_of(n))), 0, 1e-6);
		assert_true(d3_distance(d3_of(ts_reflect(ts_reflect(d, n), n)), d3_of(d)) <= 2e-6);
	}
}

static void blends_match_double_precision(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = uniform3(-9, 9), b = uniform3(-9, 9), c = uniform3(-9, 9), w = random_weights();
		assert_true(d3_distance(d3_of(ts_blend(w, a, b, c)), d3_blend(w, d3_of(a), d3_of(b), d3_of(c))) <= 4e-6);
		assert_true(same_bits(ts_blend(w, a, b, c).y, ts_blend1(w, a.y, b.y, c.y)));
		assert_true(equal(ts_blend(ts_v3_make(0, 1, 0), a, b, c), d3_of(b)));
	}
}

static void storing_flushes_the_least_numbers(void **state)
{
	(void)state;
	f32 p[3] = {1, 2, 3};
	assert_true(equal(ts_load3(p), (double3){1, 2, 3}));
	ts_store3(p, ts_v3_make(-0.0f, ldexpf(-1, -101), ldexpf(-1, -100)));
	assert_true(ts_f2u(p[0]) == 0 && ts_f2u(p[1]) == 0 && p[2] == ldexpf(-1, -100));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(vectors_of_small_integers_are_exact), seeded_test(dot_and_cross_are_near_double_precision),
		seeded_test(products_add_in_the_written_order),   seeded_test(normalized_vectors_have_length_one),
		seeded_test(reflection_keeps_length_and_angle),   seeded_test(blends_match_double_precision),
		seeded_test(storing_flushes_the_least_numbers),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
