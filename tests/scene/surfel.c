/* Surfels against double arithmetic: circles, what ellipses are refused, and what nodes make of them. */
#include <math.h>
#include "kernels/base/num.h"
#include "scene/place.h"
#include "scene/surfel.h"
#include "tests/model/test.h"

static f32 number(u32 i, u32 stream) { return 2.0f * ts_uniform(ts_random(i, stream, 3)) - 1.0f; }

static double dot(const f32 *a, const f32 *b)
{
	return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void cross(double n[3], const f32 *a, const f32 *b)
{
	for (int k = 0; k < 3; k++)
		n[k] = (double)a[(k + 1) % 3] * (double)b[(k + 2) % 3] - (double)a[(k + 2) % 3] * (double)b[(k + 1) % 3];
}

static void assert_close(double a, double b, double tolerance)
{
	if (!(fabs(a - b) <= tolerance)) fail_msg("%.9g is not %.9g", a, b);
}

/* u x v points along n. */
static void assert_normal(const ts_surfel *s, const double n[3])
{
	double m[3], along = 0.0, lengths[2] = {0.0, 0.0};
	cross(m, s->u, s->v);
	for (int k = 0; k < 3; k++) along += m[k] * n[k], lengths[0] += m[k] * m[k], lengths[1] += n[k] * n[k];
	assert_close(along / sqrt(lengths[0] * lengths[1]), 1.0, 1e-5);
}

static void circles_are_round_and_face_their_normal(void **state)
{
	(void)state;
	static const f32 axes[6][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-2, 0, 0}, {0, -3, 0}, {1e-10f, 0, -1e-10f}};
	for (u32 i = 0; i < 1000; i++) {
		f32 n[3] = {number(i, 0), number(i, 1), number(i, 2)}, radius = ts_uniform(ts_random(i, 3, 3)) + 0.001f;
		if (i < 6) memcpy(n, axes[i], sizeof n);
		ts_surfel s;
		assert_null(ts_surfel_circle(&s, n, radius));
		double r = (double)radius;
		assert_close(sqrt(dot(s.u, s.u)), r, 1e-6 * r);
		assert_close(sqrt(dot(s.v, s.v)), r, 1e-6 * r);
		assert_close(dot(s.u, s.v), 0.0, 1e-6 * r * r);
		assert_normal(&s, (double[3]){(double)n[0], (double)n[1], (double)n[2]});
	}
}

static void assert_says(const char *fault, const char *words)
{
	if (fault == NULL || strstr(fault, words) == NULL)
		fail_msg("\"%s\" does not say \"%s\"", fault ? fault : "", words);
}

static void circles_without_a_size_or_a_normal_are_refused(void **state)
{
	(void)state;
	ts_surfel s;
	f32 up[3] = {0.0f, 1.0f, 0.0f}, none[3] = {0.0f, 0.0f, 0.0f};
	assert_says(ts_surfel_circle(&s, none, 1.0f), "the normal has no length");
	assert_says(ts_surfel_circle(&s, up, 0.0f), "radius");
	assert_says(ts_surfel_circle(&s, up, -1.0f), "radius");
	assert_says(ts_surfel_circle(&s, up, 1e30f), "radius");
	assert_says(ts_surfel_circle(&s, up, 1e-38f), "radius");
}

static ts_surfel ellipse(f32 ux, f32 uy, f32 uz, f32 vx, f32 vy, f32 vz)
{
	return (ts_surfel){.u = {ux, uy, uz}, .v = {vx, vy, vz}};
}

static void ellipses_must_have_two_axes_and_right_angles(void **state)
{
	(void)state;
	f32 up[3] = {0.0f, 1.0f, 0.0f}, aside[3] = {1.0f, 1.0f, 0.0f}, none[3] = {0.0f, 0.0f, 0.0f};
	ts_surfel good = ellipse(0, 0, 2, 1, 0, 0), s = good;
	assert_null(ts_surfel_ellipse(&s, NULL));
	assert_null(ts_surfel_ellipse(&s, up));
	assert_memory_equal(&s, &good, sizeof s);
	assert_says(ts_surfel_ellipse(&s, aside), "right angle to the normal");
	assert_says(ts_surfel_ellipse(&s, none), "right angle to the normal");
	s = ellipse(0, 0, 0, 1, 0, 0);
	assert_says(ts_surfel_ellipse(&s, up), "half-axis u");
	s = ellipse(0, 0, 2, 0, 0, 0);
	assert_says(ts_surfel_ellipse(&s, up), "half-axis v");
	s = ellipse(0, 0, 1e30f, 1, 0, 0);
	assert_says(ts_surfel_ellipse(&s, up), "half-axis u");
	s = ellipse(0, 0, 2, 1, 0, 0.1f);
	assert_says(ts_surfel_ellipse(&s, up), "not at a right angle");
	s = ellipse(0, 0, 2, 1, 0, 0.003f);
	assert_null(ts_surfel_ellipse(&s, up));
}

static void axes_that_turn_away_from_the_normal_change_places(void **state)
{
	(void)state;
	f32 down[3] = {0.0f, -1.0f, 0.0f};
	ts_surfel s = ellipse(0, 0, 2, 1, 0, 0);
	assert_null(ts_surfel_ellipse(&s, down));
	assert_true(s.u[0] == 1.0f && s.v[2] == 2.0f);
}

/* The rim of the ellipse, carried by the node point for point, is the rim of the ellipse that is made of it. */
static void assert_is_image(const ts_surfel *to, const ts_surfel *from, const ts_place *place)
{
	for (u32 k = 0; k < 12; k++) {
		f32 p[3], d[3];
		double t = 6.283185307179586 * k / 12.0;
		for (u32 i = 0; i < 3; i++) p[i] = from->u[i] * (f32)cos(t) + from->v[i] * (f32)sin(t);
		for (u32 i = 0; i < 3; i++) d[i] = (f32)dot(place->linear + 3 * i, p);
		double a = dot(d, to->u) / dot(to->u, to->u), b = dot(d, to->v) / dot(to->v, to->v);
		assert_close(a * a + b * b, 1.0, 5e-4);
	}
	assert_close(dot(to->u, to->v) / sqrt(dot(to->u, to->u) * dot(to->v, to->v)), 0.0, 2e-5);
}

static void nodes_carry_ellipses_whatever_they_do_to_angles(void **state)
{
	(void)state;
	u32 n_mirrors = 0;
	for (u32 i = 0; i < 500; i++) {
		f32 matrix[16] = {0.0f}, n[3] = {number(i, 20), number(i, 21), number(i, 22)};
		for (u32 k = 0; k < 12; k++) matrix[k / 3 * 4 + k % 3] = number(i, k) + (k % 4 == 0 ? 0.5f : 0.0f);
		ts_place place = ts_place_from_matrix(matrix);
		ts_surfel from = {.centre = {number(i, 30), number(i, 31), number(i, 32)}}, to;
		assert_null(ts_surfel_circle(&from, n, 0.25f));
		for (u32 k = 0; k < 3; k++) from.v[k] *= 0.3f;
		assert_true(ts_place_surfel(&place, &from, &to));
		assert_is_image(&to, &from, &place);
		for (u32 k = 0; k < 3; k++)
			assert_close((double)to.centre[k], dot(place.linear + 3 * k, from.centre) + (double)place.origin[k], 1e-5);
		double normal[3];
		for (u32 k = 0; k < 3; k++) normal[k] = dot(place.cofactor + 3 * k, n) * (double)place.side;
		assert_normal(&to, normal);
		n_mirrors += place.side < 0.0f;
	}
	assert_in_range(n_mirrors, 50, 450);
}

static void flattening_nodes_leave_nothing(void **state)
{
	(void)state;
	f32 none[3] = {0.0f, 0.0f, 0.0f}, turn[4] = {0.0f, 0.0f, 0.0f, 1.0f}, flat[3] = {1.0f, 0.0f, 1.0f};
	ts_place place = ts_place_from_trs(none, turn, flat);
	ts_surfel s = ellipse(0, 0, 2, 1, 0, 0), to;
	assert_false(ts_place_surfel(&place, &s, &to));
}

static void quantiles_are_of_the_longer_axis(void **state)
{
	(void)state;
	ts_surfel s[9];
	f32 q[TS_SURFEL_QUANTILES];
	for (u32 i = 0; i < 9; i++)
		s[i] = i % 2 ? ellipse((f32)(9 - i), 0, 0, 0, 0.5f, 0) : ellipse(0.5f, 0, 0, 0, (f32)(9 - i), 0);
	assert_int_equal(ts_surfel_quantiles(q, s, 9), TS_OK);
	for (u32 k = 0; k < 5; k++) assert_true(q[k] == (f32)(1 + 2 * k));
	assert_int_equal(ts_surfel_quantiles(q, s, 1), TS_OK);
	assert_true(q[0] == 9.0f && q[4] == 9.0f);
}

static int by_value(const void *a, const void *b)
{
	f32 x = *(const f32 *)a, y = *(const f32 *)b;
	return (x > y) - (x < y);
}

static ts_v3 random_axis(u32 i, u32 stream, f32 range)
{
	f32 scale = exp2f(range * number(i, stream));
	return ts_v3_make(scale * number(i, stream + 1), scale * number(i, stream + 2), scale * number(i, stream + 3));
}

static void quantiles_are_of_sorted_lengths(void **state)
{
	(void)state;
	enum { MOST = 1000 };
	ts_surfel s[MOST];
	f32 length[MOST], q[TS_SURFEL_QUANTILES];
	for (u32 run = 0; run < 60; run++) {
		u32 n = run < 9 ? run + 1 : 1 + ts_random(run, 9, 3) % MOST;
		for (u32 i = 0; i < n; i++) {
			f32 range = run % 3 == 0 ? 30.0f : run % 3 == 1 ? 1.0f : 0.0f;
			ts_v3 u = random_axis(i + 1000 * run, 1, range), v = random_axis(i + 1000 * run, 5, range);
			ts_store3(s[i].u, u);
			ts_store3(s[i].v, v);
			length[i] = ts_max(ts_length(u), ts_length(v));
		}
		qsort(length, n, sizeof *length, by_value);
		assert_int_equal(ts_surfel_quantiles(q, s, n), TS_OK);
		for (u32 k = 0; k < 5; k++) assert_true(q[k] == length[(n - 1) * k / 4]);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(circles_are_round_and_face_their_normal),
		cmocka_unit_test(circles_without_a_size_or_a_normal_are_refused),
		cmocka_unit_test(ellipses_must_have_two_axes_and_right_angles),
		cmocka_unit_test(axes_that_turn_away_from_the_normal_change_places),
		cmocka_unit_test(nodes_carry_ellipses_whatever_they_do_to_angles),
		cmocka_unit_test(flattening_nodes_leave_nothing),
		cmocka_unit_test(quantiles_are_of_the_longer_axis),
		cmocka_unit_test(quantiles_are_of_sorted_lengths),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
