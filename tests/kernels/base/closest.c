/* Closest points against a double-precision search over the regions' candidates and over samples of the triangle. */
#include "kernels/base/closest.h"
#include "tests/kernels/seeded.h"

enum { N = 50000, STEPS = 12 };

static double3 on_segment(double3 p, double3 a, double3 b)
{
	double3 u = d3_sub(b, a);
	double uu = d3_dot(u, u), k = uu > 0 ? d3_dot(d3_sub(p, a), u) / uu : 0;
	return d3_mad(a, u, fmin(fmax(k, 0), 1));
}

static double3 nearer(double3 p, double3 a, double3 b) { return d3_distance(p, b) < d3_distance(p, a) ? b : a; }

/* The foot of the perpendicular if the triangle holds it, else the nearest point of the three edges. */
static double3 closest(double3 p, double3 a, double3 b, double3 c)
{
	double3 n = d3_cross(d3_sub(b, a), d3_sub(c, a));
	double nn = d3_dot(n, n);
	double3 best = nearer(p, nearer(p, on_segment(p, a, b), on_segment(p, b, c)), on_segment(p, c, a));
	if (!(nn > 0)) return best;
	double3 foot = d3_mad(p, n, d3_dot(d3_sub(a, p), n) / nn);
	bool ab = d3_dot(d3_cross(d3_sub(b, a), d3_sub(foot, a)), n) >= 0;
	bool bc = d3_dot(d3_cross(d3_sub(c, b), d3_sub(foot, b)), n) >= 0;
	bool ca = d3_dot(d3_cross(d3_sub(a, c), d3_sub(foot, c)), n) >= 0;
	return ab && bc && ca ? foot : best;
}

/* Height over the longest edge, as a share of that edge: how far a triangle is from a needle. */
static double fatness(double3 a, double3 b, double3 c)
{
	double l = fmax(fmax(d3_distance(a, b), d3_distance(b, c)), d3_distance(c, a));
	return d3_length(d3_cross(d3_sub(b, a), d3_sub(c, a))) / (l * l);
}

static void closest_points_of_triangles_match_double_precision(void **state)
{
	(void)state;
	u32 n_regions[2] = {0};
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = uniform3(-4, 4), b = uniform3(-4, 4), c = uniform3(-4, 4), p = uniform3(-8, 8);
		if (fatness(d3_of(a), d3_of(b), d3_of(c)) < 0.02) continue;
		double3 q = d3_of(ts_k_closest_on_triangle(p, a, b, c));
		double3 truth = closest(d3_of(p), d3_of(a), d3_of(b), d3_of(c));
		assert_near(d3_distance(d3_of(p), q), d3_distance(d3_of(p), truth), 2e-5);
		assert_true(d3_distance(q, closest(q, d3_of(a), d3_of(b), d3_of(c))) <= 2e-5);
		n_regions[d3_distance(q, d3_of(a)) == 0]++;
	}
	assert_true(n_regions[0] > N / 2 && n_regions[1] > N / 20);
}

static void no_sample_of_the_triangle_is_nearer(void **state)
{
	(void)state;
	for (u32 i = 0; i < N / 50; i++) {
		ts_v3 a = uniform3(-4, 4), b = uniform3(-4, 4), c = uniform3(-4, 4), p = uniform3(-8, 8);
		double d = d3_distance(d3_of(p), d3_of(ts_k_closest_on_triangle(p, a, b, c)));
		for (u32 j = 0; j <= STEPS; j++) {
			for (u32 k = 0; k + j <= STEPS; k++) {
				ts_v3 w = {(f32)j / STEPS, (f32)k / STEPS, (f32)(STEPS - j - k) / STEPS};
				assert_true(d3_distance(d3_of(p), d3_blend(w, d3_of(a), d3_of(b), d3_of(c))) >= d - 2e-4);
			}
		}
	}
}

/* Corners answer with their own bits; small integers are exact in each of the seven regions. */
static void small_integers_are_exact_in_every_region(void **state)
{
	(void)state;
	ts_v3 a = {0, 0, 0}, b = {8, 0, 0}, c = {0, 8, 0};
	const f32 in[][5] = {
		{-1, -2, 3, 0, 0}, {9, -1, 2, 8, 0}, {-3, 12, 1, 0, 8}, {2, -5, 1, 2, 0},
		{-4, 6, 2, 0, 6},  {7, 5, -1, 5, 3}, {2, 4, -7, 2, 4},
	};
	for (u32 i = 0; i < 7; i++) {
		ts_v3 q = ts_k_closest_on_triangle(ts_load3(in[i]), a, b, c);
		assert_true(q.x == in[i][3] && q.y == in[i][4] && q.z == 0);
	}
	for (u32 i = 0; i < N; i++) {
		ts_v3 v[3] = {uniform3(-4, 4), uniform3(-4, 4), uniform3(-4, 4)};
		for (u32 k = 0; k < 3; k++) {
			ts_v3 q = ts_k_closest_on_triangle(v[k], v[0], v[1], v[2]);
			assert_true(d3_distance(d3_of(q), d3_of(v[k])) <= 2e-6);
		}
	}
}

/* Triangles without area are dropped before; asked all the same, the answer is one of their points. */
static void triangles_without_area_answer_with_a_point(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = uniform3(-4, 4), b = uniform3(-4, 4), p = uniform3(-8, 8);
		ts_v3 q[3] = {ts_k_closest_on_triangle(p, a, b, b), ts_k_closest_on_triangle(p, a, a, b),
		              ts_k_closest_on_triangle(p, b, a, b)};
		for (u32 k = 0; k < 3; k++) {
			assert_true(d3_distance(d3_of(q[k]), on_segment(d3_of(q[k]), d3_of(a), d3_of(b))) <= 1e-5);
		}
		assert_true(same_bits3(ts_k_closest_on_triangle(p, a, a, a), a));
	}
}

static void closest_points_of_segments_match_double_precision(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = uniform3(-4, 4), b = uniform3(-4, 4), p = uniform3(-8, 8);
		double3 q = d3_of(ts_k_closest_on_segment(p, a, b));
		assert_true(d3_distance(q, on_segment(d3_of(p), d3_of(a), d3_of(b))) <= 1e-5);
		assert_true(same_bits3(ts_k_closest_on_segment(p, a, a), a));
	}
}

/* Equally far from the three corners, in their plane; without a circle, the first corner. */
static void circumcentre_is_equally_far_from_the_corners(void **state)
{
	(void)state;
	u32 n_judged = 0;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = uniform3(-4, 4), b = uniform3(-4, 4), c = uniform3(-4, 4);
		if (fatness(d3_of(a), d3_of(b), d3_of(c)) < 0.1) continue;
		n_judged++;
		double3 m = d3_of(ts_k_circumcentre(a, b, c)), n = d3_unit(d3_cross(d3_of(ts_sub(b, a)), d3_of(ts_sub(c, a))));
		double r = d3_distance(m, d3_of(a));
		assert_near(d3_distance(m, d3_of(b)), r, 1e-4 * r);
		assert_near(d3_distance(m, d3_of(c)), r, 1e-4 * r);
		assert_near(d3_dot(d3_sub(m, d3_of(a)), n), 0, 1e-4 * r);
		assert_true(same_bits3(ts_k_circumcentre(a, b, b), a) && same_bits3(ts_k_circumcentre(a, a, a), a));
	}
	assert_true(n_judged > N / 2);
	ts_v3 m = ts_k_circumcentre(ts_v3_make(2, 0, 0), ts_v3_make(0, 4, 0), ts_v3_make(0, 0, 0));
	assert_near(m.x, 1, 1e-6);
	assert_near(m.y, 2, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(closest_points_of_triangles_match_double_precision),
		seeded_test(no_sample_of_the_triangle_is_nearer),
		seeded_test(small_integers_are_exact_in_every_region),
		seeded_test(triangles_without_area_answer_with_a_point),
		seeded_test(closest_points_of_segments_match_double_precision),
		seeded_test(circumcentre_is_equally_far_from_the_corners),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
