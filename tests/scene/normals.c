/* Estimated normals against closed forms: spheres, tori, planes, hills; and, in double precision, the plane that fits
 * best. */
#include <math.h>
#include <omp.h>
#include <unistd.h>
#include "scene/normals.h"
#include "tests/model/test.h"

#define TURN 6.283185307179586
enum { N = 4000 };
static ts_v3 points[2 * N], truth[2 * N], normals[2 * N];

static double uniform(u32 i, u32 stream) { return (double)ts_uniform(ts_random(i, stream, 11)); }

static ts_v3 of(double x, double y, double z) { return ts_v3_make((f32)x, (f32)y, (f32)z); }

static double dot(ts_v3 a, ts_v3 b)
{
	return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

/* Point i of a unit sphere, squeezed along z, about a centre. */
static void put_ellipsoid(u32 i, u32 at, double thickness, ts_v3 centre)
{
	double y = 2.0 * uniform(i, 0) - 1.0, r = sqrt(1.0 - y * y), a = TURN * uniform(i, 1);
	double x = r * cos(a), z = r * sin(a), l = sqrt(x * x + y * y + z * z / (thickness * thickness));
	points[at] = ts_add(of(x, y, z * thickness), centre);
	truth[at] = of(x / l, y / l, z / thickness / l);
}

static void put_torus(u32 i)
{
	double a = TURN * uniform(i, 0), b = TURN * uniform(i, 1), r = 1.0 + 0.4 * cos(b);
	points[i] = of(r * cos(a), 0.4 * sin(b), r * sin(a));
	truth[i] = of(cos(b) * cos(a), sin(b), cos(b) * sin(a));
}

/* A ball with a thin fin around its equator: radius 0.5 + 0.7 exp(-(f / WIDTH)^2) at latitude f, as dense
 * everywhere. */
#define WIDTH 0.2
static void put_finned(u32 i)
{
	double f, fin, radius, slope;
	u32 try = 0;
	do {
		f = (uniform(i, 10 + 2 * try) - 0.5) * TURN / 2.0;
		fin = 0.7 * exp(-f * f / WIDTH / WIDTH);
		radius = 0.5 + fin;
		slope = -2.0 * f / WIDTH / WIDTH * fin;
	} while (6.0 * uniform(i, 11 + 2 * try++) > radius * cos(f) * hypot(radius, slope));
	double along = slope * cos(f) - radius * sin(f), up = slope * sin(f) + radius * cos(f), l = hypot(along, up);
	double a = TURN * uniform(i, 1);
	points[i] = of(radius * cos(f) * cos(a), radius * sin(f), radius * cos(f) * sin(a));
	truth[i] = of(up / l * cos(a), -along / l, up / l * sin(a));
}

/* Up, by Hoppe's rule. */
static void put_hill(u32 i)
{
	double x = 6.0 * uniform(i, 0) - 3.0, z = 6.0 * uniform(i, 1) - 3.0, dx = cos(2.0 * x), dz = sin(z);
	double l = sqrt(1.0 + dx * dx + dz * dz);
	points[i] = of(x, 0.5 * sin(2.0 * x) - cos(z), z);
	truth[i] = of(-dx / l, 1.0 / l, -dz / l);
}

/* In degrees. */
static double angle(ts_v3 a, ts_v3 b)
{
	double x = (double)a.y * (double)b.z - (double)a.z * (double)b.y;
	double y = (double)a.z * (double)b.x - (double)a.x * (double)b.z;
	double z = (double)a.x * (double)b.y - (double)a.y * (double)b.x;
	return atan2(sqrt(x * x + y * y + z * z), dot(a, b)) * 360.0 / TURN;
}

/* At least `share` of a thousand within the angle, and not one turned over. */
static void assert_normals(u32 n, double degrees, u32 share)
{
	u32 n_near = 0;
	assert_int_equal(ts_normals_estimate(normals, NULL, points, n), TS_OK);
	for (u32 i = 0; i < n; i++) {
		double along = dot(normals[i], truth[i]);
		if (fabs(dot(normals[i], normals[i]) - 1.0) > 1e-5) fail_msg("point %u: no unit vector", i);
		if (along <= 0.0) fail_msg("point %u of %u: turned over, cosine %g", i, n, along);
		n_near += angle(normals[i], truth[i]) <= degrees;
	}
	if (n_near < (u64)n * share / 1000) fail_msg("%u of %u normals are within %g degrees", n_near, n, degrees);
}

static void spheres_look_outward(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) put_ellipsoid(i, i, 1.0, ts_v3_make(5.0f, -7.0f, 3.0f));
	assert_normals(N, 5.0, 990);
}

/* The rim of a thin one has neighbours on both sides. */
static void thin_ellipsoids_look_outward(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) put_ellipsoid(i, i, 0.2, ts_v3_make(0.0f, 0.0f, 0.0f));
	assert_normals(N, 15.0, 900);
}

/* Across its rim the planes say little: the sides of the fin hang together by the ball. */
static void thin_fins_look_outward(void **state)
{
	(void)state;
	for (u32 i = 0; i < 2 * N; i++) put_finned(i);
	assert_normals(2 * N, 15.0, 900);
}

static void tori_look_outward(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) put_torus(i);
	assert_normals(N, 5.0, 950);
}

static void hills_look_up(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) put_hill(i);
	assert_normals(N, 15.0, 990);
}

/* Each of what does not hang together has its own side. */
static void each_part_has_its_own_side(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		put_ellipsoid(i, 2 * i, 1.0, ts_v3_make(0.0f, 0.0f, 0.0f));
		put_ellipsoid(i + N, 2 * i + 1, 1.0, ts_v3_make(2.5f, 0.0f, 0.5f));
	}
	assert_normals(2 * N, 5.0, 990);
}

static void planes_are_exact_and_look_up(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		double a = uniform(i, 0), b = uniform(i, 1);
		points[i] = of(a, -0.75 * a, b);
		truth[i] = of(0.6, 0.8, 0.0);
	}
	assert_normals(N, 0.01, 1000);
}

/* A lattice's nearest are many at one distance; each point three times. */
static void equal_points_share_a_normal(void **state)
{
	(void)state;
	enum { SIDE = 30 };
	for (u32 i = 0; i < 3 * SIDE * SIDE; i++) {
		points[i] = of(i / 3 % SIDE, 0.0, i / 3 / SIDE);
		truth[i] = of(0.0, 1.0, 0.0);
	}
	assert_normals(3 * SIDE * SIDE, 0.01, 1000);
}

static bool is_none(ts_v3 n) { return n.x == 0.0f && n.y == 0.0f && n.z == 0.0f; }

static void lines_and_heaps_have_none(void **state)
{
	(void)state;
	enum { FEW = 40 };
	for (u32 kind = 0; kind < 4; kind++) {
		static const double along[4][3] = {{0, 0, 0}, {1, 0, 0}, {0.1, 0.2, -0.3}, {1e-11, 2e-11, 0}};
		for (u32 i = 0; i < FEW; i++) points[i] = of(along[kind][0] * i, along[kind][1] * i, along[kind][2] * i);
		for (u32 n = 0; n <= FEW; n++) {
			assert_int_equal(ts_normals_estimate(normals, NULL, points, n), TS_OK);
			for (u32 i = 0; i < n; i++) assert_true(is_none(normals[i]));
		}
	}
	/* Three points off a line have one; beside a plane, a line has none, and turns nothing. */
	points[0] = of(0, 0, 0), points[1] = of(1, 0, 0), points[2] = of(0, 0, 1);
	truth[0] = truth[1] = truth[2] = of(0, 1, 0);
	assert_normals(3, 0.01, 1000);
}

static void a_line_beside_a_plane_changes_nothing(void **state)
{
	(void)state;
	enum { SIDE = 20, LINE = 60 };
	for (u32 i = 0; i < SIDE * SIDE; i++) points[i] = of(i % SIDE, 0.0, i / SIDE);
	for (u32 i = 0; i < LINE; i++) points[SIDE * SIDE + i] = of(-40.0 - 0.1 * i, 50.0, 3.0);
	assert_int_equal(ts_normals_estimate(normals, NULL, points, SIDE * SIDE + LINE), TS_OK);
	for (u32 i = 0; i < SIDE * SIDE; i++) assert_true(normals[i].y > 0.999f);
	for (u32 i = 0; i < LINE; i++) assert_true(is_none(normals[SIDE * SIDE + i]));
}

/* A heap at the highest place of a plane is one place. */
static void a_heap_on_a_plane_changes_nothing(void **state)
{
	(void)state;
	enum { HEAP = TS_NORMALS_NEIGHBOURS + 1 };
	ts_v3 up = of(-0.8, 0.6, 0.0);
	for (u32 i = 0; i < N; i++) {
		double a = i < HEAP ? 1.0 : uniform(i, 0), b = i < HEAP ? 0.5 : uniform(i, 1);
		points[i] = of(3.0 * a, 4.0 * a, b);
	}
	assert_int_equal(ts_normals_estimate(normals, NULL, points, N), TS_OK);
	for (u32 i = 0; i < N; i++) assert_true(!is_none(normals[i]) && angle(normals[i], up) < 0.01);
}

typedef struct {
	double square;
	u32 index;
} place;

static int compare(const void *a, const void *b)
{
	const place *x = a, *y = b;
	if (x->square != y->square) return x->square < y->square ? -1 : 1;
	return x->index < y->index ? -1 : x->index > y->index;
}

/* Sum of the squared distances of a point and its nearest to the plane along n through their middle. */
static double misfit(const place *nearest, ts_v3 n)
{
	double sum = 0.0, mean = 0.0;
	for (u32 j = 0; j <= TS_NORMALS_NEIGHBOURS; j++) mean += dot(points[nearest[j].index], n);
	mean /= TS_NORMALS_NEIGHBOURS + 1;
	for (u32 j = 0; j <= TS_NORMALS_NEIGHBOURS; j++) {
		double d = dot(points[nearest[j].index], n) - mean;
		sum += d * d;
	}
	return sum / dot(n, n);
}

/* In a cloud that is no surface no plane around the estimated one fits better: a quadratic form has one least value. */
static void no_plane_fits_better(void **state)
{
	(void)state;
	enum { FEW = 300 };
	static place nearest[FEW];
	for (u32 i = 0; i < FEW; i++) points[i] = of(uniform(i, 0), 3.0 * uniform(i, 1), 2.0 * uniform(i, 2));
	assert_int_equal(ts_normals_estimate(normals, NULL, points, FEW), TS_OK);
	for (u32 i = 0; i < FEW; i++) {
		for (u32 j = 0; j < FEW; j++) {
			ts_v3 d = ts_sub(points[j], points[i]);
			nearest[j] = (place){dot(d, d), j};
		}
		qsort(nearest, FEW, sizeof *nearest, compare);
		double least = misfit(nearest, normals[i]);
		for (u32 k = 0; k < 50; k++) {
			double by = k % 2 ? 0.02 : 0.5;
			ts_v3 aside = of(by * uniform(k, 3) - by / 2, by * uniform(k, 4) - by / 2, by * uniform(k, 5) - by / 2);
			if (misfit(nearest, ts_add(normals[i], aside)) < least * 0.9999)
				fail_msg("point %u: a plane fits better", i);
		}
	}
}

static void threads_and_units_change_no_bit(void **state)
{
	(void)state;
	static ts_v3 again[N];
	for (u32 i = 0; i < N; i++) put_torus(i);
	omp_set_num_threads(1);
	assert_int_equal(ts_normals_estimate(normals, NULL, points, N), TS_OK);
	omp_set_num_threads(4);
	assert_int_equal(ts_normals_estimate(again, NULL, points, N), TS_OK);
	assert_memory_equal(again, normals, sizeof again);
	static const f32 units[] = {9.313225746154785e-10f, 0.25f, 8388608.0f};
	for (u32 k = 0; k < 3; k++) {
		for (u32 i = 0; i < N; i++) points[i] = ts_scale(points[i], units[k] / (k > 0 ? units[k - 1] : 1.0f));
		assert_int_equal(ts_normals_estimate(again, NULL, points, N), TS_OK);
		assert_memory_equal(again, normals, sizeof again);
	}
}

static void many_points_take_no_time(void **state)
{
	(void)state;
	enum { MANY = 100000 };
	ts_v3 *p = calloc(MANY, sizeof *p), *n = malloc(MANY * sizeof *n);
	assert_true(p != NULL && n != NULL);
	for (u32 i = MANY / 2; i < MANY; i++) p[i] = of(uniform(i, 0), 0.0, uniform(i, 1));
	alarm(60);
	assert_int_equal(ts_normals_estimate(n, NULL, p, MANY), TS_OK);
	alarm(0);
	assert_true(n[0].y > 0.99f && n[MANY - 1].y > 0.99f);
	free(p);
	free(n);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(spheres_look_outward),
		cmocka_unit_test(thin_ellipsoids_look_outward),
		cmocka_unit_test(thin_fins_look_outward),
		cmocka_unit_test(tori_look_outward),
		cmocka_unit_test(hills_look_up),
		cmocka_unit_test(each_part_has_its_own_side),
		cmocka_unit_test(planes_are_exact_and_look_up),
		cmocka_unit_test(equal_points_share_a_normal),
		cmocka_unit_test(lines_and_heaps_have_none),
		cmocka_unit_test(a_line_beside_a_plane_changes_nothing),
		cmocka_unit_test(a_heap_on_a_plane_changes_nothing),
		cmocka_unit_test(no_plane_fits_better),
		cmocka_unit_test(threads_and_units_change_no_bit),
		cmocka_unit_test(many_points_take_no_time),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
