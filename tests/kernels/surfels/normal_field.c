/* Linear fields of normals: against the least squares in double precision; of a plane and of a ball, whose normals are
 * known; and of neighbours that say nothing. */
#include <math.h>
#include "kernels/surfels/normal_field.h"
#include "scene/neighbours.h"
#include "tests/methods/small.h"

enum { K = TS_FIELD_NEIGHBOURS, N = 600 };

static f32 random_of(u32 i) { return ts_uniform(ts_random(i, 6, 71)) - 0.5f; }

static ts_v3 direction_of(u32 i)
{
	return ts_normalize(ts_v3_make(random_of(3 * i), random_of(3 * i + 1), random_of(3 * i + 2)));
}

static ts_surfel surfel_at(ts_v3 centre, ts_v3 n, f32 radius, f32 thin)
{
	ts_surfel s = {.colour = {1, 1, 1}};
	ts_v3 other = fabsf(n.y) < 0.9f ? ts_v3_make(0, 1, 0) : ts_v3_make(1, 0, 0);
	ts_v3 u = ts_normalize(ts_cross(other, n));
	ts_store3(s.centre, centre);
	ts_store3(s.u, ts_scale(u, radius));
	ts_store3(s.v, ts_scale(ts_cross(n, u), radius * thin));
	return s;
}

/* Of n surfels, by the nearest of each. */
static void fit(const ts_surfel *surfels, u32 n, u32 *near, f32 *slopes)
{
	ts_v3 *centres = malloc(n * sizeof *centres);
	assert_non_null(centres);
	for (u32 i = 0; i < n; i++) centres[i] = ts_load3(surfels[i].centre);
	ts_neighbours *tree = ts_neighbours_new(centres, n);
	assert_non_null(tree);
	for (u32 i = 0; i < n; i++) {
		ts_neighbour found[K];
		u32 m = ts_neighbours_find(tree, i, K, found);
		for (u32 k = 0; k < K; k++) near[i * K + k] = k < m ? found[k].index : TS_NONE;
	}
	ts_neighbours_free(tree);
	free(centres);
	ts_normal_field_args args = {.surfels = surfels, .near = near, .slopes = slopes};
	for (u32 i = 0; i < n; i++) ts_k_normal_field_item(&args, i);
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void normal_of(double n[3], const ts_surfel *s)
{
	const f32 *u = s->u, *v = s->v;
	for (u32 k = 0; k < 3; k++) {
		u32 a = (k + 1) % 3, b = (k + 2) % 3;
		n[k] = (double)u[a] * v[b] - (double)u[b] * v[a];
	}
	double length = sqrt(dot(n, n));
	for (u32 k = 0; k < 3; k++) n[k] /= length;
}

/* The sum that the slopes of surfel i minimize. */
static double sum_of(const ts_surfel *surfels, const u32 *near, u32 i, const double slope[6])
{
	double n[3], sum = 0;
	normal_of(n, &surfels[i]);
	for (u32 k = 0; k < K; k++) {
		double n_j[3], u[3], v[3], d[3];
		if (near[i * K + k] == TS_NONE) continue;
		const ts_surfel *other = &surfels[near[i * K + k]];
		normal_of(n_j, other);
		for (u32 c = 0; c < 3; c++) {
			d[c] = (double)other->centre[c] - surfels[i].centre[c];
			u[c] = surfels[i].u[c];
			v[c] = surfels[i].v[c];
		}
		double a = dot(d, u) / dot(u, u), b = dot(d, v) / dot(v, v), w = fmax(dot(n, n_j), 0);
		for (u32 c = 0; c < 3; c++) {
			double off = n_j[c] - n[c] - a * slope[c] - b * slope[c + 3];
			sum += w * (off * off + (a * a + b * b) / 1024 * (slope[c] * slope[c] + slope[c + 3] * slope[c + 3]));
		}
	}
	return sum;
}

/* No step from the slopes makes the sum less. */
static void no_step_from_the_slopes_is_better(void **state)
{
	(void)state;
	static ts_surfel surfels[N];
	static u32 near[N * K];
	static f32 slopes[N * 6];
	for (u32 i = 0; i < N; i++) {
		ts_v3 centre = ts_v3_make(random_of(9000 + 3 * i), random_of(9001 + 3 * i), random_of(9002 + 3 * i));
		surfels[i] = surfel_at(centre, direction_of(i), 0.05f + 0.1f * fabsf(random_of(20000 + i)), 0.5f);
	}
	fit(surfels, N, near, slopes);
	for (u32 i = 0; i < N; i++) {
		double at[6], most = 0;
		for (u32 k = 0; k < 6; k++) at[k] = slopes[6 * i + k];
		for (u32 k = 0; k < 6; k++) most = fmax(most, fabs(at[k]));
		double least = sum_of(surfels, near, i, at);
		for (u32 k = 0; k < 12; k++) {
			double there[6], step = 1e-3 * fmax(most, 1e-3);
			memcpy(there, at, sizeof there);
			there[k / 2] += k % 2 == 0 ? step : -step;
			assert_true(sum_of(surfels, near, i, there) > least);
		}
	}
}

static void a_plane_has_no_slopes(void **state)
{
	(void)state;
	static ts_surfel surfels[N];
	static u32 near[N * K];
	static f32 slopes[N * 6];
	for (u32 i = 0; i < N; i++) {
		surfels[i] = surfel_at(ts_v3_make(random_of(2 * i), 0, random_of(2 * i + 1)), ts_v3_make(0, 1, 0), 0.05f, 1);
	}
	fit(surfels, N, near, slopes);
	for (u32 k = 0; k < N * 6; k++) assert_true(slopes[k] == 0.0f);
}

/* Everywhere on each surfel nearer to the ball's normal than its own, and on average 20 times. */
static void fields_on_a_ball_beat_constant_normals(void **state)
{
	(void)state;
	static ts_surfel surfels[N];
	static u32 near[N * K];
	static f32 slopes[N * 6];
	double linear = 0, constant = 0;
	for (u32 i = 0; i < N; i++) {
		f32 y = 1 - (2 * (f32)i + 1) / N, across = ts_sqrt(1 - y * y), turn = (f32)i * 0.618034f;
		ts_v3 d = ts_v3_make(across * ts_cos_turn(turn), y, across * ts_sin_turn(turn));
		surfels[i] = surfel_at(d, d, 0.15f, 0.7f);
	}
	fit(surfels, N, near, slopes);
	for (u32 i = 0; i < N; i++) {
		for (u32 k = 0; k < 16; k++) {
			f32 turn = (f32)k / 16, a = 0.8f * ts_cos_turn(turn), b = 0.8f * ts_sin_turn(turn);
			ts_v3 n = ts_load3(surfels[i].centre), u = ts_load3(surfels[i].u), v = ts_load3(surfels[i].v);
			ts_v3 ball = ts_normalize(ts_mad(ts_mad(n, u, a), v, b)), slope = ts_load3(slopes + 6 * i);
			ts_v3 field = ts_normalize(ts_mad(ts_mad(n, slope, a), ts_load3(slopes + 6 * i + 3), b));
			assert_true(ts_length(ts_sub(field, ball)) < ts_length(ts_sub(n, ball)));
			linear += (double)ts_length(ts_sub(field, ball));
			constant += (double)ts_length(ts_sub(n, ball));
		}
	}
	print_message("# off by %.5f, and constant normals by %.5f\n", linear / (N * 16), constant / (N * 16));
	assert_true(linear < constant / 20);
}

/* No others, others in the same place, and others that look away: no slope. Others along a line: none across that. */
static void neighbours_that_say_nothing_give_no_slope(void **state)
{
	(void)state;
	u32 near[4 * K];
	f32 slopes[4 * 6];
	const ts_v3 up = {0, 1, 0}, down = {0, -1, 0}, aside = {0.6f, 0.8f, 0};
	ts_surfel one[1] = {surfel_at(up, up, 1, 1)};
	ts_surfel same[3] = {one[0], surfel_at(up, aside, 1, 1), surfel_at(up, aside, 1, 1)};
	ts_surfel turned[2] = {one[0], surfel_at(aside, down, 1, 1)};
	ts_surfel line[3] = {surfel_at(ts_v3_make(0, 0, 0), up, 1, 1), surfel_at(ts_v3_make(1, 0, 0), aside, 1, 1),
	                     surfel_at(ts_v3_make(-1, 0, 0), ts_v3_make(-0.6f, 0.8f, 0), 1, 1)};
	fit(one, 1, near, slopes);
	for (u32 k = 0; k < 6; k++) assert_true(slopes[k] == 0.0f);
	fit(same, 3, near, slopes);
	for (u32 k = 0; k < 6; k++) assert_true(slopes[k] == 0.0f);
	fit(turned, 2, near, slopes);
	for (u32 k = 0; k < 6; k++) assert_true(slopes[k] == 0.0f);
	fit(line, 3, near, slopes);
	ts_v3 u = ts_load3(line[0].u), along = ts_load3(slopes), across = ts_load3(slopes + 3);
	assert_true(fabsf(u.x) < 1e-6f); /* v is along the line */
	assert_true(ts_length(along) < 1e-6f);
	assert_float_equal(fabsf(across.x), 0.6f, 1e-3);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(no_step_from_the_slopes_is_better),
		cmocka_unit_test(a_plane_has_no_slopes),
		cmocka_unit_test(fields_on_a_ball_beat_constant_normals),
		cmocka_unit_test(neighbours_that_say_nothing_give_no_slope),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
