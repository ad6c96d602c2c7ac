/* Dual-paraboloid maps: every used texel's direction leads back to it, directions are where the formula of METHODS 13
 * puts them, sizes are those of the images of circles, and 1 - pi / 4 of the texels are unused. */
#include "kernels/views/paraboloid.h"
#include "tests/kernels/seeded.h"

enum { N_SIZES = 20000, N_RIM = 720 };

static const u32 sides[] = {4, 8, 16, 64, 256, 1024};
static const double pi = 3.14159265358979323846;

static void directions_lead_back_to_their_texels(void **state)
{
	(void)state;
	for (u32 k = 0; k < sizeof sides / sizeof *sides; k++) {
		u32 n = sides[k], n_used = 0;
		for (u32 t = 0; t < 2 * n * n; t++) {
			ts_v3 d = ts_k_paraboloid_direction(t, n);
			assert_near(d3_length(d3_of(d)), 1, 4e-7);
			if (!ts_k_paraboloid_is_used(t, n)) continue;
			n_used++;
			assert_int_equal(ts_k_paraboloid_texel(ts_scale(d, uniform(0.001f, 1000)), n), t);
			assert_true((d.x >= 0) == (t < n * n) || ts_abs(d.x) < 1e-6f);
		}
		assert_near(1 - n_used / (2.0 * n * n), 1 - pi / 4, n < 64 ? 0.04 : n < 256 ? 0.005 : 0.001);
	}
}

/* Where a direction is in its map, in texels. */
typedef struct {
	double column, row;
	bool back;
} place;

static place place_of(double3 d, u32 n)
{
	double l = d3_length(d), k = 1 / (l + fabs(d.x));
	return (place){(d.y * k * 0.5 + 0.5) * n, (d.z * k * 0.5 + 0.5) * n, d.x < 0};
}

static bool is_near_integer(double x) { return fabs(x - nearbyint(x)) < 1e-4; }

/* Of any direction, and of the axes. */
static void any_direction_finds_its_texel(void **state)
{
	(void)state;
	u32 n_sure = 0;
	for (u32 i = 0; i < 100000; i++) {
		u32 n = sides[i % 5];
		ts_v3 d = ts_scale(direction(), uniform(0.001f, 1000));
		place at = place_of(d3_of(d), n);
		if (is_near_integer(at.column) || is_near_integer(at.row)) continue;
		n_sure++;
		assert_int_equal(ts_k_paraboloid_texel(d, n), (at.back * n + (u32)at.row) * n + (u32)at.column);
	}
	assert_true(n_sure > 90000);
	assert_int_equal(ts_k_paraboloid_texel(ts_v3_make(0, 0, 0), 16), 8 * 16 + 8);
	assert_int_equal(ts_k_paraboloid_texel(ts_v3_make(-2, 0, 0), 16), (16 + 8) * 16 + 8);
	assert_int_equal(ts_k_paraboloid_texel(ts_v3_make(0, 3, 0), 16), 8 * 16 + 15);
	assert_int_equal(ts_k_paraboloid_texel(ts_v3_make(0, 0, -3), 16), 8);
}

/* Extent along y of the image of a circle of directions. */
static double widest(double alpha, double rho, u32 n)
{
	double3 axis = {cos(alpha), sin(alpha), 0}, up = {-sin(alpha), cos(alpha), 0}, side = {0, 0, 1};
	double low = 1e9, high = -1e9;
	for (u32 i = 0; i < N_RIM; i++) {
		double turn = 2 * pi * i / N_RIM;
		double3 rim = d3_add(d3_scale(up, cos(turn)), d3_scale(side, sin(turn)));
		double3 d = d3_add(d3_scale(axis, cos(rho)), d3_scale(rim, sin(rho)));
		double column = d.y / (1 + d.x) * 0.5 * n;
		low = fmin(low, column);
		high = fmax(high, column);
	}
	return high - low;
}

static void sizes_are_those_of_imaged_circles(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_SIZES / 100; i++) {
		u32 n = sides[i % 5];
		double rho = (double)uniform(0.001f, 0.9f), alpha = (double)uniform(0, 1.5707f);
		f32 size = ts_k_paraboloid_size((f32)cos(alpha), (f32)sin(rho), n);
		assert_near(size / widest(alpha, rho, n), 1, 1e-5);
	}
	for (u32 i = 0; i < N_SIZES; i++) {
		u32 n = sides[i % 5];
		double rho = (double)uniform(0.0001f, 1.4f), alpha = (double)uniform(0, 1.5707f);
		double expected = 0.5 * n * (tan((alpha + rho) / 2) - tan((alpha - rho) / 2));
		assert_near(ts_k_paraboloid_size((f32)cos(alpha), (f32)sin(rho), n) / expected, 1, 1e-5);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(directions_lead_back_to_their_texels),
		seeded_test(any_direction_finds_its_texel),
		seeded_test(sizes_are_those_of_imaged_circles),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
