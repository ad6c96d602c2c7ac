/* Where a ray meets a triangle: against double precision, at the corners, off the triangle, edge-on and at the
 * extremes. */
#include "kernels/base/hit.h"
#include "tests/model/test.h"

enum { SEED = 11, STREAM = 6, N = 100000 };

static u32 n_random;

static u32 bits(void) { return ts_random(n_random++, STREAM, SEED); }

static f32 uniform(f32 low, f32 high) { return low + (high - low) * ts_uniform(bits()); }

static ts_v3 uniform3(f32 low, f32 high)
{
	f32 x = uniform(low, high), y = uniform(low, high);
	return ts_v3_make(x, y, uniform(low, high));
}

static ts_corners corners(ts_v3 a, ts_v3 b, ts_v3 c)
{
	return (ts_corners){a, b, c, ts_cross(ts_sub(b, a), ts_sub(c, a))};
}

static void assert_weights(ts_v3 w)
{
	assert_true(w.x >= 0 && w.x <= 1 && w.y >= 0 && w.y <= 1 && w.z >= 0 && w.z <= 1);
	assert_true(ts_abs(w.x + w.y + w.z - 1) <= 1e-6f);
}

static ts_v3 random_weights(void)
{
	f32 x = uniform(0.01f, 1), y = uniform(0.01f, 1), z = uniform(0.01f, 1);
	f32 sum = x + y + z;
	return ts_v3_make(x / sum, y / sum, z / sum);
}

/* How steeply a ray meets a plane: 0 along it, 1 along its normal. */
static f32 slope(ts_v3 n, ts_v3 d) { return ts_abs(ts_dot(ts_normalize(n), ts_normalize(d))); }

/* A ray towards a point of the triangle finds its weights and its distance. */
static void rays_towards_a_point_find_its_weights(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_judged = 0;
	for (u32 i = 0; i < N; i++) {
		ts_corners t = corners(uniform3(-4, 4), uniform3(-4, 4), uniform3(-4, 4));
		ts_v3 w = random_weights(), o = uniform3(-9, 9);
		ts_v3 to = ts_sub(ts_blend(w, t.a, t.b, t.c), o);
		ts_hit hit = ts_k_hit(o, ts_normalize(to), &t);
		assert_weights(hit.weights);
		if (slope(t.n, to) < 0.05f || ts_length(t.n) < 2) continue;
		n_judged++;
		assert_true(ts_abs(hit.t - ts_length(to)) <= 1e-3f);
		assert_true(ts_length(ts_sub(hit.weights, w)) <= 1e-3f);
	}
	assert_true(n_judged > N / 2);
}

/* Small integers are exact: t and weights in all three projections. */
static void hits_of_small_integers_are_exact(void **state)
{
	(void)state;
	for (u32 axis = 0; axis < 3; axis++) {
		f32 v[5][3] = {{0}, {0}, {0}, {0}, {0}};
		u32 s = (axis + 1) % 3, u = (axis + 2) % 3;
		v[1][s] = 8;
		v[2][u] = 8;
		v[3][s] = 2;
		v[3][u] = 4;
		v[3][axis] = 5;
		v[4][axis] = -2;
		ts_corners t = corners(ts_load3(v[0]), ts_load3(v[1]), ts_load3(v[2]));
		ts_hit hit = ts_k_hit(ts_load3(v[3]), ts_load3(v[4]), &t);
		assert_true(hit.t == 2.5f);
		assert_true(hit.weights.x == 0.25f && hit.weights.y == 0.25f && hit.weights.z == 0.5f);
	}
}

/* Outside, the weights are those of the clamped areas; at a corner, the corner's alone. */
static void outside_hits_weigh_the_clamped_areas(void **state)
{
	(void)state;
	ts_corners t = corners(ts_v3_make(0, 0, 0), ts_v3_make(1, 0, 0), ts_v3_make(0, 1, 0));
	ts_v3 down = ts_v3_make(0, 0, -1);
	assert_true(ts_k_hit(ts_v3_make(-3, -2, 1), down, &t).weights.x == 1);
	assert_true(ts_k_hit(ts_v3_make(1, 0, 1), down, &t).weights.y == 1);
	assert_true(ts_k_hit(ts_v3_make(-1, 9, 1), down, &t).weights.z == 1);
	ts_v3 edge = ts_k_hit(ts_v3_make(0.5f, -0.25f, 1), down, &t).weights;
	assert_true(edge.z == 0 && edge.x > edge.y && edge.y > 0);
	assert_true(ts_k_hit(ts_v3_make(0.25f, 0.25f, -1), down, &t).t == -1);
}

/* A ray within the plane, a ray without direction and a triangle without area still give numbers. */
static void hits_edge_on_still_give_numbers(void **state)
{
	(void)state;
	ts_corners t = corners(ts_v3_make(3, 0, 0), ts_v3_make(3, 3, 0), ts_v3_make(3, 0, 3));
	ts_hit hit = ts_k_hit(ts_v3_make(3, -4, 1), ts_v3_make(0, 1, 0), &t);
	assert_true(ts_abs(hit.t - 5) <= 1e-5f);
	assert_weights(hit.weights);
	hit = ts_k_hit(ts_v3_make(0, 0, 0), ts_v3_make(0, 0, 0), &t);
	assert_true(hit.t == 0);
	assert_weights(hit.weights);
	t = corners(t.a, t.b, t.b);
	assert_weights(ts_k_hit(ts_v3_make(0, 0, 0), ts_v3_make(1, 0, 0), &t).weights);
}

/* Anything up to the greatest coordinate, at every scale: no NaN, infinity, denormal or -0. */
static void extreme_coordinates_give_sound_hits(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		f32 x[15];
		for (u32 k = 0; k < 15; k++) {
			u32 scale = bits() % 64;
			x[k] = scale == 0 ? 0 : uniform(-1, 1) * ts_u2f((151u - scale) << 23);
		}
		ts_corners t = corners(ts_load3(x), ts_load3(x + 3), ts_load3(x + 6));
		ts_hit hit = ts_k_hit(ts_load3(x + 9), ts_normalize(ts_load3(x + 12)), &t);
		assert_weights(hit.weights);
		assert_true(hit.t == hit.t && ts_abs(hit.t) <= 4611686018427387904.0f);
		assert_int_equal(ts_f2u(hit.t), ts_f2u(ts_put(hit.t)));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_towards_a_point_find_its_weights), cmocka_unit_test(hits_of_small_integers_are_exact),
		cmocka_unit_test(outside_hits_weigh_the_clamped_areas),  cmocka_unit_test(hits_edge_on_still_give_numbers),
		cmocka_unit_test(extreme_coordinates_give_sound_hits),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
