/* Pairs of nodes: nothing that a view could see is culled, equivalent pairs fall into the same texel of all views or
 * the next, and splitting keeps the views' ball no larger than the scene's: FIGURES 10. */
#include "kernels/views/pair.h"
#include "tests/kernels/seeded.h"
#include "tests/whole.h"

enum { N_VIEWS = 24, N_EQUIVALENT = 60000, N_CHILDREN = 8 };

static u32 n_pairs(void) { return whole_or(400000, 150000); }

static const double pi = 3.14159265358979323846;

static double random_double(double low, double high) { return low + (high - low) * (bits() + 0.5) / 4294967296.0; }
static double power_of_ten(double low, double high) { return pow(10, random_double(low, high)); }

static double3 sphere(void)
{
	double z = random_double(-1, 1), turn = random_double(0, 2 * pi), r = sqrt(1 - z * z);
	return (double3){r * cos(turn), r * sin(turn), z};
}

/* In a ball, half of them on its surface. */
static double3 in_ball(double r) { return d3_scale(sphere(), below(2) == 0 ? r : r * cbrt(random_double(0, 1))); }

static double angle(double3 a, double3 b) { return atan2(d3_length(d3_cross(a, b)), d3_dot(a, b)); }

/* Within theta of n, half of them on the rim. */
static double3 in_cone(double3 n, double theta)
{
	double z = below(2) == 0 ? cos(theta) : random_double(cos(theta), 1), turn = random_double(0, 2 * pi);
	double3 t = d3_unit(d3_cross(fabs(n.x) < 0.9 ? (double3){1, 0, 0} : (double3){0, 1, 0}, n)), b = d3_cross(n, t);
	double3 rim = d3_add(d3_scale(t, cos(turn)), d3_scale(b, sin(turn)));
	return d3_add(d3_scale(n, z), d3_scale(rim, sqrt(fmax(0, 1 - z * z))));
}

/* Of a point from the directions within psi of the axis. */
static double distance_from_cone(double3 x, double3 axis, double psi)
{
	double over = angle(x, axis) - psi, d = d3_length(x);
	return over <= 0 ? 0 : over < pi / 2 ? d * sin(over) : d;
}

/* A ball of the scene at `at`, of views at 0. */
typedef struct {
	double3 at, axis;
	double rs, rv, theta, phi;
} world;

/* Kernels and truth are given the same. */
static double as_float(double x) { return (double)(f32)x; }
static double3 as_floats(double3 a) { return (double3){as_float(a.x), as_float(a.y), as_float(a.z)}; }

static world random_world(bool single)
{
	world w = {.rs = as_float(power_of_ten(-2, 0)), .rv = single ? 0 : as_float(power_of_ten(-2, 0)), .axis = sphere()};
	w.at = as_floats(d3_scale(sphere(), power_of_ten(-1, 1.2)));
	w.phi = below(5) < 2 ? pi / 2 : random_double(0, pi);
	w.theta = single || below(8) == 0 ? 0 : random_double(0, pi) * (below(2) == 0 ? 0.3 : 1);
	return w;
}

static ts_v3 v3_of(double3 a) { return ts_v3_make((f32)a.x, (f32)a.y, (f32)a.z); }

/* Whether the pair is culled with so large a ball of views. */
static bool is_culled(const world *w, double rv)
{
	ts_ball s = {.p = v3_of(w->at), .r = (f32)w->rs}, v = {.p = {0, 0, 0}, .r = (f32)rv};
	ts_cone_k cone = {.axis = v3_of(w->axis), .cosine = (f32)cos(w->theta)};
	ts_aperture phi = {.cosine = w->phi == pi / 2 ? 0 : (f32)cos(w->phi), .sine = (f32)sin(w->phi)};
	return ts_k_pair_is_culled(&s, &v, &cone, &phi);
}

/* A view that is moved and turned towards the ball of the scene. */
static void lean(const world *w, double3 *at, double3 *direction)
{
	double3 aside = d3_unit(d3_mad(w->at, w->axis, -d3_dot(w->at, w->axis))), ahead = d3_unit(w->at);
	double3 way = d3_mad(d3_scale(ahead, random_double(0, 1)), aside, random_double(0, 1));
	*at = d3_scale(d3_unit(d3_mad(way, w->axis, random_double(-0.5, 0.5))), w->rv);
	*direction = d3_mad(d3_scale(w->axis, cos(w->theta)), aside, sin(w->theta));
}

/* One of some views in the node sees some of the ball. */
static bool is_seen(const world *w)
{
	for (u32 k = 0; k < N_VIEWS; k++) {
		double3 at = in_ball(w->rv), direction = in_cone(w->axis, w->theta);
		if (k < 8) lean(w, &at, &direction);
		if (distance_from_cone(d3_sub(w->at, at), direction, w->phi) <= w->rs) return true;
	}
	return false;
}

typedef struct {
	u32 n_culled, n_unseen, n_wrong;
} tally;

/* forget: without the radius of the views. */
static tally cull(bool single, bool forget)
{
	tally r = {0, 0, 0};
	for (u32 i = 0; i < n_pairs(); i++) {
		world w = random_world(single);
		bool culled = is_culled(&w, forget ? 0 : w.rv), seen = is_seen(&w);
		r.n_culled += culled;
		r.n_unseen += !seen;
		r.n_wrong += culled && seen;
	}
	return r;
}

static void no_seen_pair_is_culled(void **state)
{
	(void)state;
	tally nodes = cull(false, false);
	assert_int_equal(nodes.n_wrong, 0);
	assert_near(nodes.n_culled, nodes.n_unseen, n_pairs() * 0.035);
	assert_true(nodes.n_culled > n_pairs() / 10);
	tally single = cull(true, false);
	assert_int_equal(single.n_wrong, 0);
	assert_near(single.n_culled, single.n_unseen, n_pairs() * 0.001);
	assert_true(cull(false, true).n_wrong > n_pairs() / 100);
}

/* With the formula of angles, where it is sure. */
static void culling_follows_the_formula_of_angles(void **state)
{
	(void)state;
	u32 n_sure = 0, n_wide = 0;
	for (u32 i = 0; i < n_pairs(); i++) {
		world w = random_world(i % 4 == 0);
		double psi = w.theta + w.phi, alpha = angle(w.at, w.axis), need = w.rs + w.rv;
		double fs = distance_from_cone(w.at, w.axis, psi);
		bool sure = fabs(psi - pi) > 0.002 && fabs(alpha - psi) > 0.002 && fabs(fs - need) > 0.002 * d3_length(w.at);
		if (!sure) continue;
		n_sure++;
		n_wide += psi > pi / 2 && psi < pi && alpha > psi;
		assert_int_equal(is_culled(&w, w.rv), psi < pi && fs > need);
	}
	assert_true(n_sure > n_pairs() / 10 * 9 && n_wide > n_pairs() / 50);
	world inside = {.at = {0, 0, 0}, .axis = {0, 0, 1}, .phi = pi / 2};
	assert_false(is_culled(&inside, 0));
}

typedef struct {
	u32 n_children, n_same, n_next, n_far, n_other;
} shares;

static u32 apart(u32 a, u32 b) { return a > b ? a - b : b - a; }

/* Where views in the ball show the ball at `at`, beside where its middle does. */
static void compare(shares *sum, ts_v3 at, f32 rv, u32 n)
{
	u32 middle = ts_k_paraboloid_texel(at, n);
	for (u32 k = 0; k < N_CHILDREN; k++) {
		u32 t = ts_k_paraboloid_texel(ts_sub(at, v3_of(in_ball((double)rv))), n);
		u32 columns = apart(t % n, middle % n), rows = apart(t / n % n, middle / n % n);
		u32 far = columns > rows ? columns : rows;
		sum->n_children++;
		if (t / (n * n) != middle / (n * n))
			sum->n_other++;
		else if (far == 0)
			sum->n_same++;
		else if (far == 1)
			sum->n_next++;
		else
			sum->n_far++;
	}
}

/* FIGURES 10: shares of N = 8, 16, 64 and 256, the views' ball as large as the scene's, or half. */
static void equivalent_pairs_share_texels_as_figured(void **state)
{
	(void)state;
	static const struct {
		u32 n;
		f32 rv;
		double same, next, other;
	} rows[] = {
		{8, 1, 77.33, 21.25, 1.422},     {8, 0.5f, 87.80, 11.49, 0.706},   {16, 1, 76.77, 22.50, 0.730},
		{16, 0.5f, 87.89, 11.76, 0.352}, {64, 1, 76.38, 23.42, 0.206},     {64, 0.5f, 87.77, 12.14, 0.092},
		{256, 1, 76.37, 23.58, 0.050},   {256, 0.5f, 87.83, 12.14, 0.026},
	};
	for (u32 k = 0; k < sizeof rows / sizeof *rows; k++) {
		shares sum = {0, 0, 0, 0, 0};
		while (sum.n_children < N_EQUIVALENT * N_CHILDREN) {
			ts_v3 at = v3_of(d3_scale(sphere(), rows[k].n * random_double(0.25, 1.85)));
			ts_ball s = {.p = at, .r = 1}, v = {.p = {0, 0, 0}, .r = rows[k].rv};
			if (ts_k_pair_is_equivalent(&s, &v, rows[k].n)) compare(&sum, at, v.r, rows[k].n);
		}
		double percent = 100.0 / sum.n_children;
		assert_int_equal(sum.n_far, 0);
		assert_near(percent * sum.n_same, rows[k].same, 1);
		assert_near(percent * sum.n_next, rows[k].next, 1);
		assert_near(percent * sum.n_other, rows[k].other, 0.1);
	}
}

/* The formula of METHODS 13 in double precision, where it is sure; larger views, and views that may be inside, never
 * are. */
static void equivalence_follows_its_formula(void **state)
{
	(void)state;
	u32 n_sure = 0, n_equivalent = 0;
	for (u32 i = 0; i < n_pairs(); i++) {
		u32 n = 4u << below(7);
		double3 vs = as_floats(d3_scale(sphere(), random_double(0.5, 2.2 * n)));
		ts_ball s = {.p = v3_of(vs), .r = 1}, v = {.p = {0, 0, 0}, .r = uniform(0, 1.2f)};
		double d = d3_length(vs), nearest = d - (double)v.r, sine = 1 / nearest;
		double size = nearest > 1 ? n * sine / (fabs(vs.x) / d + sqrt(1 - sine * sine)) : 1e9;
		if (fabs(size - 1) < 1e-5 || fabs(nearest - 1) < 1e-5) continue;
		n_sure++;
		n_equivalent += size < 1;
		assert_int_equal(ts_k_pair_is_equivalent(&s, &v, n), size < 1 && v.r <= 1);
		if (nearest > 1.01) assert_near(ts_k_pair_size(&s, &v, n) / size, 1, 3e-4);
		if (nearest < 1) assert_true(ts_k_pair_size(&s, &v, n) < 0);
	}
	assert_true(n_sure > n_pairs() / 100 * 99 && n_equivalent > n_pairs() / 3);
}

/* From two roots alike to leaves: v.r <= s.r all the way, in turns; of unequal trees that which still has children. */
static void splitting_alternates_down_to_the_leaves(void **state)
{
	(void)state;
	for (u32 i = 0; i < 1000; i++) {
		u32 deepest_s = 1 + below(11), deepest_v = below(12), level_s = 0, level_v = 0;
		f32 r = uniform(0.01f, 1000);
		while (level_s < deepest_s || level_v < deepest_v) {
			ts_ball s = {.r = r / (f32)(1u << level_s), .leaf = level_s == deepest_s};
			ts_ball v = {.r = r / (f32)(1u << level_v), .leaf = level_v == deepest_v};
			bool both = !s.leaf && !v.leaf, splits_view = ts_k_pair_splits_view(&s, &v);
			if (both)
				assert_int_equal(splits_view, level_v == level_s);
			else
				assert_int_equal(splits_view, s.leaf);
			if (both || v.leaf) assert_true(level_v >= deepest_v || v.r <= s.r);
			if (splits_view)
				level_v++;
			else
				level_s++;
		}
		assert_true(level_s == deepest_s && level_v == deepest_v);
	}
}

/* Leaves of a lattice whose middles are less than 3 radii apart, 6.75 squares of a side, are near; so is a view alone;
 * inner nodes never are. */
static void leaves_nearer_than_three_radii_are_near(void **state)
{
	(void)state;
	f32 r = 0.8660254f;
	ts_ball v = {.p = {0, 0, 0}, .r = r, .leaf = true}, alone = {.p = {0, 0, 0}, .r = 0, .leaf = true};
	ts_ball inner = {.p = {0, 0, 0}, .r = r, .leaf = false};
	for (i32 i = 0; i < 9 * 9 * 9; i++) {
		i32 x = i % 9 - 4, y = i / 9 % 9 - 4, z = i / 81 - 4;
		ts_ball s = {.p = ts_v3_make((f32)x, (f32)y, (f32)z), .r = r, .leaf = true};
		bool near = x * x + y * y + z * z < 7;
		assert_true(ts_k_pair_is_near(&s, &v, 3) == near && ts_k_pair_is_near(&s, &alone, 3) == near);
		assert_false(ts_k_pair_is_near(&s, &inner, 3) || ts_k_pair_is_near(&inner, &v, 3));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(no_seen_pair_is_culled),
		seeded_test(culling_follows_the_formula_of_angles),
		seeded_test(equivalent_pairs_share_texels_as_figured),
		seeded_test(equivalence_follows_its_formula),
		seeded_test(splitting_alternates_down_to_the_leaves),
		seeded_test(leaves_nearer_than_three_radii_are_near),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
