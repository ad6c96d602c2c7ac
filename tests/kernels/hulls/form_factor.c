/* Solid angles and form factors against closed forms, quadrature over the triangle, rays, and the same sums in double
 * precision; and that no place and no triangle gives anything but a number in range. */
#include "kernels/hulls/form_factor.h"
#include "tests/kernels/hulls/form_factor_truth.h"

enum { N = 20000 };

static double3 from(ts_v3 p, ts_v3 a) { return d3_sub(d3_of(a), d3_of(p)); }

static double factor(ts_v3 p, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c)
{
	double3 corner[] = {from(p, a), from(p, b), from(p, c)};
	return ff_factor(d3_of(n), corner);
}

/* How far p is in front of it. */
static double front(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	double3 n = d3_cross(from(a, b), from(a, c));
	return d3_dot(d3_unit(n), from(a, p));
}

/* The integral of f(cos at the receiver, cos at the light) / r^2 over the triangle, by the middles of STEPS^2 parts. */
typedef struct {
	double solid, factor;
} integrals;
enum { STEPS = 96 };

static integrals integrate(ts_v3 p, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c)
{
	double3 corner = from(p, a), ab = from(a, b), ac = from(a, c), normal = d3_cross(ab, ac);
	integrals r = {0, 0};
	for (u32 i = 0; i < STEPS; i++) {
		for (u32 j = 0; j < 2 * (STEPS - i) - 1; j++) {
			double third = j % 2 == 0 ? 1 / 3.0 : 2 / 3.0;
			double3 at = d3_mad(d3_mad(corner, ab, (i + third) / STEPS), ac, (j / 2 + third) / STEPS);
			double far = d3_length(at), part = fabs(d3_dot(normal, at)) / (2.0 * STEPS * STEPS * far * far * far);
			r.solid += part;
			r.factor += part * fmax(0, d3_dot(d3_of(n), at)) / (ff_pi * far);
		}
	}
	return r;
}

/* Triangles about the point, half of them seen from behind. */
static void form_factors_match_quadrature(void **state)
{
	(void)state;
	u32 n_cut = 0, n_behind = 0;
	for (u32 i = 0; i < 600; i++) {
		ts_v3 p = uniform3(-1, 1), n = direction(), away = ts_mad(p, direction(), uniform(1.5f, 4));
		ts_v3 a = ts_add(away, uniform3(-1, 1)), b = ts_add(away, uniform3(-1, 1)), c = ts_add(away, uniform3(-1, 1));
		double side = front(p, a, b, c), found = ts_k_form_factor(p, n, a, b, c);
		if (fabs(side) < 0.05) continue;
		integrals right = integrate(p, n, a, b, c);
		assert_near(ts_k_solid_angle(p, a, b, c), right.solid, 3e-4 * right.solid + 1e-5);
		assert_near(found, side > 0 ? right.factor : 0, 3e-4 * right.factor + 2e-5);
		double da = d3_dot(d3_of(n), from(p, a)), db = d3_dot(d3_of(n), from(p, b)), dc = d3_dot(d3_of(n), from(p, c));
		n_cut += side > 0 && fmax(fmax(da, db), dc) > 0 && fmin(fmin(da, db), dc) < 0;
		n_behind += side < 0;
	}
	assert_true(n_cut > 30 && n_behind > 200);
}

/* Rounding, of all sizes and distances: the solid angle loses as much as the triangle is turned away; the form factor's
 * edges cancel, so that its error is absolute. */
static void rounding_stays_within_its_bound(void **state)
{
	(void)state;
	double worst_solid = 0, worst = 0;
	u32 n_judged = 0;
	for (u32 i = 0; i < N; i++) {
		f32 size = ldexpf(1, -(i32)below(12)), far_off = i % 2 == 0 ? 0 : ldexpf(1, (i32)below(10));
		ts_v3 p = ts_mad(uniform3(-1, 1), direction(), far_off), n = direction(),
			  away = ts_mad(p, direction(), uniform(1, 4));
		ts_v3 a = ts_mad(away, uniform3(-1, 1), size), b = ts_mad(away, uniform3(-1, 1), size);
		ts_v3 c = ts_mad(away, uniform3(-1, 1), size);
		double side = front(p, a, b, c), far = d3_length(from(p, a));
		if (fabs(side) < 0.1 * far || size < far_off * 1e-4f ||
		    d3_length(d3_cross(from(a, b), from(a, c))) < 0.1 * size * size)
			continue;
		double solid = ff_solid(from(p, a), from(p, b), from(p, c)), right = side > 0 ? factor(p, n, a, b, c) : 0;
		worst_solid = fmax(worst_solid, fabs(ts_k_solid_angle(p, a, b, c) - solid) / solid * fabs(side) / far);
		worst = fmax(worst, fabs(ts_k_form_factor(p, n, a, b, c) - right));
		n_judged++;
	}
	assert_true(n_judged > N / 2);
	assert_true(worst_solid > 0 && worst_solid < 1e-6);
	assert_true(worst > 0 && worst < 2e-7);
}

/* No light of a surface's own triangle, nor of one on the other side of a thin wall, wherever the scene is: rounding
 * puts places of the plane in front of it or behind. A thousandth of its size in front the surface sees the light. */
static void no_triangle_lights_its_own_plane(void **state)
{
	(void)state;
	u32 n_front = 0, n_behind = 0;
	for (u32 i = 0; i < N; i++) {
		ts_v3 middle = ts_scale(direction(), ldexpf(1, (i32)below(8)));
		ts_v3 a = ts_add(middle, uniform3(-1, 1)), b = ts_add(middle, uniform3(-1, 1)),
			  c = ts_add(middle, uniform3(-1, 1));
		ts_v3 normal = ts_cross(ts_sub(b, a), ts_sub(c, a)), n = ts_normalize(normal);
		ts_v3 p = ts_blend(random_weights(), a, b, c);
		if (ts_length(normal) < 0.1f) continue;
		n_front += front(p, a, b, c) > 0;
		n_behind += front(p, a, b, c) < 0;
		assert_true(ts_k_form_factor(p, n, a, b, c) == 0 && ts_k_form_factor(p, ts_neg(n), a, b, c) == 0);
		ts_v3 away = ts_mad(p, n, 1e-3f);
		assert_true(ts_k_is_in_front(away, a, normal) && !ts_k_is_in_front(ts_mad(p, n, -1e-3f), a, normal));
	}
	assert_true(n_front > N / 4 && n_behind > N / 4);
}

/* A rectangle a by b at distance 1, parallel, p facing one of its corners; and the same seen at right angles: tables of
 * any textbook of heat transfer. */
static void rectangles_match_the_textbook(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 a = uniform(0.01f, 8), b = uniform(0.01f, 8);
		ts_v3 p = uniform3(-1, 1), n = ts_v3_make(0, 0, 1), o = ts_add(p, n);
		ts_v3 x = ts_add(o, ts_v3_make(a, 0, 0)), y = ts_add(o, ts_v3_make(0, b, 0)),
			  xy = ts_add(x, ts_v3_make(0, b, 0));
		double ra = sqrt(1 + (double)a * a), rb = sqrt(1 + (double)b * b);
		double right = (a / ra * atan(b / ra) + b / rb * atan(a / rb)) / (2 * ff_pi);
		double solid = asin(a * (double)b / (ra * rb));
		assert_near(ts_k_form_factor(p, n, o, xy, x) + ts_k_form_factor(p, n, o, y, xy), right, 4e-7);
		assert_near(ts_k_solid_angle(p, o, x, xy) + ts_k_solid_angle(p, o, xy, y), solid, 2e-6);
		ts_v3 beside = ts_v3_make(1, 0, 0);
		double edge = (atan(b) - atan(b / ra) / ra) / (2 * ff_pi);
		assert_near(ts_k_form_factor(p, beside, o, xy, x) + ts_k_form_factor(p, beside, o, y, xy), edge, 4e-7);
		assert_true(ts_k_form_factor(p, n, o, x, xy) == 0 && ts_k_form_factor(p, ts_neg(n), o, xy, x) == 0);
	}
}

/* Far away A / (pi d^2). */
static void far_triangles_shine_by_their_area(void **state)
{
	(void)state;
	ts_v3 o = ts_v3_make(0, 0, 0), up = ts_v3_make(0, 0, 1);
	for (f32 size = 0.1f; size > 1e-3f; size *= 0.5f) {
		f32 found = ts_k_form_factor(o, up, ts_v3_make(0, 0, 10), ts_v3_make(0, size, 10), ts_v3_make(size, 0, 10));
		double right = (double)size * size / 2 / (ff_pi * 100);
		assert_near(found, right, 1e-4 * right);
	}
}

/* Around a point inside, all directions and all that a surface emits: a cube of twelve triangles. */
static void a_closed_box_is_all_directions(void **state)
{
	(void)state;
	for (u32 i = 0; i < N / 20; i++) {
		ts_v3 p = uniform3(-0.95f, 0.95f), n = direction();
		double solid = 0, all = 0;
		for (u32 face = 0; face < 6; face++) {
			ts_v3 corner[4];
			for (u32 k = 0; k < 4; k++) {
				f32 u = k == 1 || k == 2 ? 1.0f : -1.0f, v = k >= 2 ? 1.0f : -1.0f, w = face % 2 == 0 ? 1.0f : -1.0f;
				u = face % 2 == 0 ? -u : u;
				corner[k] = face < 2 ? ts_v3_make(w, u, v) : face < 4 ? ts_v3_make(v, w, u) : ts_v3_make(u, v, w);
			}
			solid += ts_k_solid_angle(p, corner[0], corner[1], corner[2]);
			solid += ts_k_solid_angle(p, corner[0], corner[2], corner[3]);
			all += ts_k_form_factor(p, n, corner[0], corner[1], corner[2]);
			all += ts_k_form_factor(p, n, corner[0], corner[2], corner[3]);
		}
		assert_near(solid, 4 * ff_pi, 2e-5);
		assert_near(all, 1, 4e-6);
	}
}

/* Rays by the cosine, from the surface, and which of them meet the triangle. */
static void form_factors_match_rays(void **state)
{
	(void)state;
	enum { RAYS = 200000 };
	ts_v3 o = ts_v3_make(0, 0, 0), n = ts_v3_make(0, 0, 1);
	ts_v3 a = ts_v3_make(1, -1, 1.2f), b = ts_v3_make(-0.3f, 0.7f, -0.4f), c = ts_v3_make(-1, -0.5f, 0.6f);
	double3 ab = from(a, b), ac = from(a, c), normal = d3_cross(ab, ac);
	u32 n_hits = 0;
	for (u32 i = 0; i < RAYS; i++) {
		double z2 = (i + 0.5) / RAYS, turn = 2 * ff_pi * uniform(0, 1), r = sqrt(1 - z2);
		double3 w = {r * cos(turn), r * sin(turn), sqrt(z2)};
		double t = d3_dot(normal, d3_of(a)) / d3_dot(normal, w);
		double3 hit = d3_sub(d3_scale(w, t), d3_of(a));
		double area = d3_dot(normal, normal), u = d3_dot(d3_cross(hit, ac), normal) / area;
		double v = d3_dot(d3_cross(ab, hit), normal) / area;
		n_hits += t > 0 && u >= 0 && v >= 0 && u + v <= 1;
	}
	double found = ts_k_form_factor(o, n, a, b, c) + ts_k_form_factor(o, n, a, c, b);
	assert_true(found > 0.1);
	assert_near(found, (double)n_hits / RAYS, 5e-3);
}

static void judge_range(ts_v3 p, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c)
{
	f32 solid = ts_k_solid_angle(p, a, b, c), found = ts_k_form_factor(p, n, a, b, c);
	assert_true(solid >= 0 && solid <= 6.2831855f);
	assert_true(found >= 0 && found <= 1);
}

/* Corners, edges, the plane; needles, points; large and small. */
static void any_place_gives_a_number_in_range(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 scale = ldexpf(1, (i32)below(50) - 30);
		ts_v3 a = ts_scale(uniform3(-1, 1), scale), b = ts_scale(uniform3(-1, 1), scale);
		ts_v3 c = ts_scale(uniform3(-1, 1), scale), p = ts_scale(uniform3(-1, 1), scale), n = direction();
		ts_v3 on_edge = ts_mad(a, ts_sub(b, a), uniform(0, 1)), inside = ts_blend(random_weights(), a, b, c);
		const ts_v3 places[] = {a, b, c, on_edge, inside, p};
		for (u32 k = 0; k < 6; k++) {
			judge_range(places[k], n, a, b, c);
			judge_range(places[k], n, a, b, on_edge);
			judge_range(places[k], n, a, a, b);
			judge_range(places[k], n, a, a, a);
		}
		assert_true(ts_k_form_factor(a, n, a, b, c) == 0 && ts_k_form_factor(p, n, a, a, b) == 0);
		assert_true(ts_k_solid_angle(a, a, a, a) == 0 && ts_k_solid_angle(a, a, b, c) < 1e-5f);
	}
	ts_v3 a = ts_v3_make(-1, -1, 0), b = ts_v3_make(3, -1, 0), c = ts_v3_make(-1, 3, 0), n = ts_v3_make(0, 0, 1);
	assert_near(ts_k_solid_angle(ts_v3_make(0, 0, 0), a, b, c), 2 * ff_pi, 1e-6);
	assert_near(ts_k_solid_angle(ts_v3_make(0, 0, 1e-4f), a, b, c), 2 * ff_pi, 1e-3);
	assert_near(ts_k_form_factor(ts_v3_make(0, 0, 1e-4f), ts_neg(n), a, b, c), 1, 1e-4);
	assert_true(ts_k_solid_angle(ts_v3_make(5, 5, 0), a, b, c) < 1e-6f);
	assert_true(ts_k_form_factor(ts_v3_make(5, 5, 0), n, a, b, c) == 0);
	assert_true(ts_k_form_factor(ts_v3_make(0, 0, 0), ts_neg(n), a, b, c) == 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(form_factors_match_quadrature),     seeded_test(rounding_stays_within_its_bound),
		seeded_test(no_triangle_lights_its_own_plane),  seeded_test(rectangles_match_the_textbook),
		seeded_test(far_triangles_shine_by_their_area), seeded_test(a_closed_box_is_all_directions),
		seeded_test(form_factors_match_rays),           seeded_test(any_place_gives_a_number_in_range),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
