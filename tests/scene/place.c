/* Places of nodes against the same in double precision: translations, rotations and scales, nodes below nodes, what
 * mirrors and what flattens. */
#include <math.h>
#include "scene/place.h"
#include "tests/lcg.h"
#include "tests/model/test.h"

enum { N_TRIED = 200 };

static u32 random_state;

typedef struct {
	double m[9], o[3];
} affine;

static f32 uniform(f32 most) { return ((f32)lcg_below(&random_state, 20001) / 10000.0f - 1.0f) * most; }

static void fill(f32 *to, u32 n, f32 most)
{
	for (u32 i = 0; i < n; i++) to[i] = uniform(most);
}

/* By Rodrigues' formula about the quaternion's axis, by twice the angle of its cosine. */
static affine of_trs(const f32 t[3], const f32 q[4], const f32 s[3])
{
	affine r;
	double x = q[0], y = q[1], z = q[2], length = sqrt(x * x + y * y + z * z), angle = 2 * atan2(length, (double)q[3]);
	double a[3] = {x / length, y / length, z / length}, c = cos(angle), d = sin(angle);
	const double cross[9] = {0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0};
	for (u32 i = 0; i < 9; i++) {
		double turned = c * (i % 4 == 0) + (1 - c) * a[i / 3] * a[i % 3] + d * cross[i];
		r.m[i] = turned * (double)s[i % 3];
	}
	for (u32 i = 0; i < 3; i++) r.o[i] = t[i];
	return r;
}

static affine below(const affine *parent, const affine *local)
{
	affine r;
	for (u32 i = 0; i < 3; i++) {
		r.o[i] = parent->o[i];
		for (u32 k = 0; k < 3; k++) {
			r.o[i] += parent->m[3 * i + k] * local->o[k];
			r.m[3 * i + k] = 0;
			for (u32 j = 0; j < 3; j++) r.m[3 * i + k] += parent->m[3 * i + j] * local->m[3 * j + k];
		}
	}
	return r;
}

static double determinant(const affine *a)
{
	const double *m = a->m;
	return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

static void assert_near(double found, double right, double size)
{
	if (!(fabs(found - right) <= 2e-5 * size)) fail_msg("%.9g, not %.9g", found, right);
}

static void assert_place(const ts_place *place, const affine *right)
{
	for (u32 i = 0; i < 9; i++) assert_near(place->linear[i], right->m[i], 10);
	for (u32 i = 0; i < 3; i++) assert_near(place->origin[i], right->o[i], 100);
	double d = determinant(right);
	if (fabs(d) > 1e-3) assert_true(place->side == (d > 0 ? 1 : -1));
}

/* A direction with its length, and a point. */
static ts_v3 direction_of(const ts_place *place, ts_v3 d)
{
	const f32 *m = place->linear;
	return ts_v3_make(ts_dot(ts_load3(m), d), ts_dot(ts_load3(m + 3), d), ts_dot(ts_load3(m + 6), d));
}

static ts_v3 point_of(const ts_place *place, ts_v3 p)
{
	return ts_add(direction_of(place, p), ts_load3(place->origin));
}

static ts_place place_of(affine *right)
{
	f32 t[3], q[4], s[3];
	fill(t, 3, 5);
	fill(q, 4, 1);
	fill(s, 3, 2);
	*right = of_trs(t, q, s);
	return ts_place_from_trs(t, q, s);
}

static void places_are_translated_turned_and_scaled(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_TRIED; i++) {
		affine a, b;
		f32 matrix[16] = {0};
		ts_place p = place_of(&a), q = place_of(&b);
		assert_place(&p, &a);
		affine both = below(&a, &b);
		ts_place composed = ts_place_compose(&p, &q);
		assert_place(&composed, &both);
		for (u32 k = 0; k < 9; k++) matrix[4 * (k % 3) + k / 3] = p.linear[k];
		for (u32 k = 0; k < 3; k++) matrix[12 + k] = p.origin[k];
		ts_place same = ts_place_from_matrix(matrix);
		assert_memory_equal(&same, &p, sizeof p);
	}
	const ts_place none = ts_place_identity();
	affine identity = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
	assert_place(&none, &identity);
}

/* A triangle that moves: its normal is still at a right angle to its edges and on its side; the handedness of the
 * tangent is that of the texture on the mirrored surface. A motion keeps the same three parts. */
static void normals_stay_on_their_side(void **state)
{
	(void)state;
	u32 n_mirrored = 0;
	for (u32 i = 0; i < N_TRIED; i++) {
		affine a;
		ts_place place = place_of(&a);
		ts_motion motion = ts_place_motion(&place);
		ts_vertex v = {.tangent = {0, 0, 0, 1}};
		f32 e[3], f[3];
		if (fabs(determinant(&a)) < 0.05) continue;
		fill(v.position, 3, 3);
		fill(e, 3, 1);
		fill(f, 3, 1);
		ts_v3 normal = ts_cross(ts_load3(e), ts_load3(f));
		if (ts_length(normal) < 0.2f) continue;
		ts_store3(v.normal, ts_normalize(normal));
		ts_store3(v.tangent, ts_load3(e));
		ts_vertex moved = ts_place_vertex(&place, &v);
		ts_v3 u = direction_of(&place, ts_load3(e)), w = direction_of(&place, ts_load3(f));
		ts_v3 n = ts_load3(moved.normal), right = ts_scale(ts_normalize(ts_cross(u, w)), place.side);
		assert_true(ts_length(ts_sub(n, right)) < 2e-4f);
		assert_true(ts_length(ts_sub(ts_load3(moved.tangent), ts_normalize(u))) < 1e-5f);
		assert_true(moved.tangent[3] == place.side);
		ts_v3 p = point_of(&place, ts_load3(v.position));
		assert_true(ts_length(ts_sub(ts_load3(moved.position), p)) == 0.0f);
		for (u32 k = 0; k < 3; k++) {
			double sum = a.o[k], across = 0;
			for (u32 j = 0; j < 3; j++) {
				sum += a.m[3 * k + j] * (double)v.position[j];
				across += (double)motion.normal[3 * k + j] * (double)v.normal[j];
			}
			assert_near(moved.position[k], sum, 100);
			double length = 0;
			for (u32 r = 0; r < 3; r++) {
				double one = 0;
				for (u32 j = 0; j < 3; j++) one += (double)motion.normal[3 * r + j] * (double)v.normal[j];
				length += one * one;
			}
			assert_near(across / sqrt(length), moved.normal[k], 10);
		}
		assert_memory_equal(motion.linear, place.linear, sizeof motion.linear);
		assert_memory_equal(motion.origin, place.origin, sizeof motion.origin);
		assert_int_equal(motion.moves, place.side < 0 ? 2 : 1);
		n_mirrored += place.side < 0;
	}
	assert_true(n_mirrored > N_TRIED / 8);
}

/* A surfel's image has the area and the normal of the plane's image. */
static void surfels_are_the_images_of_their_ellipses(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_TRIED; i++) {
		affine a;
		ts_place place = place_of(&a);
		ts_surfel from = {.u = {0.5f, 0, 0}, .v = {0, 0.25f, 0}}, to;
		fill(from.centre, 3, 2);
		if (fabs(determinant(&a)) < 0.05) continue;
		assert_true(ts_place_surfel(&place, &from, &to));
		ts_v3 u = ts_load3(to.u), v = ts_load3(to.v),
			  image = ts_scale(ts_cross(direction_of(&place, ts_load3(from.u)), direction_of(&place, ts_load3(from.v))),
		                       place.side);
		assert_true(ts_length(ts_sub(ts_cross(u, v), image)) < 1e-4f * (1.0f + ts_length(image)));
		assert_true(ts_abs(ts_dot(u, v)) < 1e-4f * (1.0f + ts_length(u) * ts_length(v)));
		assert_true(ts_length(ts_sub(ts_load3(to.centre), point_of(&place, ts_load3(from.centre)))) == 0.0f);
	}
}

/* Cameras look along -z, lights shine along it. */
static void cameras_and_lights_look_along_minus_z(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_TRIED; i++) {
		affine a;
		ts_camera camera = {.yfov = 1};
		ts_place place = place_of(&a);
		f32 position[3], direction[3];
		if (fabs(determinant(&a)) < 0.05) continue;
		ts_place_aim(&place, position, direction);
		assert_true(ts_place_camera(&place, &camera));
		ts_v3 back = ts_normalize(direction_of(&place, ts_v3_make(0, 0, 1)));
		ts_v3 up = direction_of(&place, ts_v3_make(0, 1, 0));
		assert_true(ts_length(ts_add(ts_load3(direction), back)) < 1e-5f);
		assert_true(ts_length(ts_sub(ts_load3(camera.back), back)) < 1e-5f);
		assert_memory_equal(position, place.origin, sizeof position);
		assert_memory_equal(camera.eye, place.origin, sizeof camera.eye);
		ts_v3 r = ts_load3(camera.right), t = ts_load3(camera.up), b = ts_load3(camera.back);
		assert_true(ts_length(ts_sub(ts_cross(t, b), r)) < 1e-4f && ts_abs(ts_length(t) - 1.0f) < 1e-4f);
		assert_true(ts_abs(ts_dot(t, b)) < 1e-4f && ts_dot(t, up) > 0.0f);
	}
}

/* On a node that flattens nothing has a side; elements that are no numbers are 0, and those too large are not sane. */
static void flat_and_wild_nodes_have_no_side(void **state)
{
	(void)state;
	const f32 none[3] = {0, 0, 0}, still[4] = {0, 0, 0, 1};
	ts_surfel surfel = {.u = {1, 0, 0}, .v = {0, 1, 0}}, to;
	ts_camera camera = {.yfov = 1};
	for (u32 axis = 0; axis < 3; axis++) {
		f32 scale[3] = {2, 3, 4};
		scale[axis] = 0;
		ts_place flat = ts_place_from_trs(none, still, scale);
		ts_vertex v = ts_place_vertex(&flat, &(ts_vertex){.normal = {1, 1, 1}, .tangent = {1, 1, 1, 1}});
		assert_true(flat.side == 0.0f && ts_length(ts_load3(v.normal)) == 0.0f);
		assert_false(ts_place_surfel(&flat, &surfel, &to));
		assert_int_equal(ts_place_camera(&flat, &camera), axis == 0); /* y and z suffice */
	}
	for (u32 k = 0; k < 12; k++) {
		f32 matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
		u32 at = k < 9 ? 4 * (k % 3) + k / 3 : 12 + k - 9;
		matrix[at] = 0x1p24f;
		ts_place large = ts_place_from_matrix(matrix);
		assert_true(ts_place_is_sane(&large));
		matrix[at] = -0x1.000002p24f;
		large = ts_place_from_matrix(matrix);
		assert_true(!ts_place_is_sane(&large) && large.side == 0.0f);
		matrix[at] = NAN;
		large = ts_place_from_matrix(matrix);
		assert_true((k < 9 ? large.linear[k] : large.origin[k - 9]) == 0.0f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(places_are_translated_turned_and_scaled), cmocka_unit_test(normals_stay_on_their_side),
		cmocka_unit_test(surfels_are_the_images_of_their_ellipses),
		cmocka_unit_test(cameras_and_lights_look_along_minus_z), cmocka_unit_test(flat_and_wild_nodes_have_no_side)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
