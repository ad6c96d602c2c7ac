/* Cube maps against OpenGL's table: which face, where on it, which texel; the faces as views; their common edges. */
#include "kernels/raster/cube.h"
#include "kernels/raster/raster.h"
#include "tests/kernels/seeded.h"

enum { N = 100000 };

/* The table of CONTRACT rule 36. */
static u32 look_up(double3 d, double *s, double *t)
{
	double x = fabs(d.x), y = fabs(d.y), z = fabs(d.z);
	u32 face = x >= y && x >= z ? d.x < 0 : y >= z ? 2 + (d.y < 0) : 4 + (d.z < 0);
	double ma = face < 2 ? x : face < 4 ? y : z;
	const double sc[] = {-d.z, d.z, d.x, d.x, d.x, -d.x};
	const double tc[] = {-d.y, -d.y, d.z, -d.z, -d.y, -d.y};
	*s = sc[face] / ma;
	*t = tc[face] / ma;
	return face;
}

static void directions_meet_the_face_of_the_table(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 d = ts_scale(direction(), ldexpf(1, (int)below(60) - 30));
		double s, t;
		u32 face = look_up(d3_of(d), &s, &t);
		ts_cube_place place = ts_k_cube_place(d);
		assert_int_equal(place.face, face);
		assert_near(place.s, s, 1e-7);
		assert_near(place.t, t, 1e-7);
	}
}

/* All 26 directions of a cube's faces, edges and corners: ties go to x, then y; the coordinates are exact. */
static void ties_go_to_x_and_then_y(void **state)
{
	(void)state;
	for (i32 k = 0; k < 27; k++) {
		ts_v3 d = ts_v3_make((f32)(k % 3 - 1), (f32)(k / 3 % 3 - 1), (f32)(k / 9 - 1));
		if (k == 13) continue;
		double s, t;
		u32 face = look_up(d3_of(d), &s, &t);
		ts_cube_place place = ts_k_cube_place(d);
		assert_true(place.face == face && place.s == s && place.t == t);
		assert_true(ts_k_cube_index(place, 7) < 6 * 7 * 7);
	}
	assert_true(ts_k_cube_index(ts_k_cube_place(ts_v3_make(0, 0, 0)), 16) < 6 * 16 * 16);
}

static void places_on_faces_lead_back_to_themselves(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 s = uniform(-0.9999f, 0.9999f), t = uniform(-0.9999f, 0.9999f);
		for (u32 face = 0; face < 6; face++) {
			ts_cube_place place = ts_k_cube_place(ts_k_cube_direction(face, s, t));
			assert_true(place.face == face && place.s == s && place.t == t);
		}
	}
}

/* Each texel's middle finds the texel, in order: face, row, column. */
static void each_middle_finds_its_texel(void **state)
{
	(void)state;
	const u32 sizes[] = {1, 2, 3, 16, 37};
	for (u32 k = 0; k < 5; k++) {
		u32 n = sizes[k];
		u64 expected = 0;
		for (u32 face = 0; face < 6; face++) {
			for (u32 row = 0; row < n; row++) {
				for (u32 column = 0; column < n; column++) {
					f32 s = (2 * (f32)column + 1) / (f32)n - 1, t = (2 * (f32)row + 1) / (f32)n - 1;
					ts_v3 d = ts_k_cube_direction(face, s, t);
					assert_int_equal(ts_k_cube_index(ts_k_cube_place(d), n), expected++);
				}
			}
		}
		assert_int_equal(ts_k_cube_texel(-1, n), 0);
		assert_int_equal(ts_k_cube_texel(1, n), n - 1);
		assert_int_equal(ts_k_cube_texel(-1.5f, n), 0);
		assert_int_equal(ts_k_cube_texel(1.5f, n), n - 1);
	}
	for (u32 column = 0; column <= 64; column++) {
		f32 edge = (f32)column / 32 - 1;
		assert_int_equal(ts_k_cube_texel(edge, 64), column < 64 ? column : 63);
		if (column > 0) assert_int_equal(ts_k_cube_texel(edge - 1e-6f, 64), column - 1);
	}
}

/* A face drawn as a view puts a direction where the look-up finds it: x = N/2 + N/2 s, y = N/2 + N/2 t, depth ma. */
static void drawn_faces_agree_with_look_ups(void **state)
{
	(void)state;
	ts_face cube = {.centre = {3, -2, 5}, .n = 64, .near = 0.125f};
	for (u32 i = 0; i < N; i++) {
		ts_v3 d = ts_scale(direction(), 4);
		ts_v3 p = ts_add(ts_load3(cube.centre), d);
		ts_cube_place place = ts_k_cube_place(ts_sub(p, ts_load3(cube.centre)));
		ts_camera_k view = ts_k_cube_view(&cube, place.face);
		ts_corner q = ts_k_to_view(&view, p);
		ts_v2 xy = ts_k_project(&view, &q);
		assert_near(q.z, fmax(fmax(fabs(d.x), fabs(d.y)), fabs(d.z)), 2e-6);
		assert_near(xy.x, 32 + 32 * (double)place.s, 1e-4);
		assert_near(xy.y, 32 + 32 * (double)place.t, 1e-4);
	}
}

/* Orthonormal rows of determinant -1: seen from inside, screen winding is mirrored. The view looks at its own face. */
static void faces_are_orthonormal_and_mirrored(void **state)
{
	(void)state;
	ts_face cube = {.n = 10, .near = 0.25f};
	for (u32 face = 0; face < 6; face++) {
		ts_camera_k view = ts_k_cube_view(&cube, face);
		double3 right = d3_of(view.right), up = d3_of(view.up), back = d3_of(view.back);
		assert_true(d3_dot(right, right) == 1 && d3_dot(up, up) == 1 && d3_dot(back, back) == 1);
		assert_true(d3_dot(d3_cross(right, up), back) == -1);
		assert_int_equal(ts_k_cube_place(ts_neg(view.back)).face, face);
		assert_true(view.focal == 5 && view.near == 0.25f && view.width == 10 && view.height == 10);
	}
}

static ts_v3 edge_direction(u32 face, u32 side, f32 along, f32 reach)
{
	f32 out = side & 1u ? reach : -reach;
	return side < 2 ? ts_k_cube_direction(face, out, along) : ts_k_cube_direction(face, along, out);
}

/* A step across a side of a face lands on the border texel of one neighbour, never on the same or the opposite face;
 * twelve common edges, each seen from both sides. */
static void steps_off_a_face_reach_one_neighbour(void **state)
{
	(void)state;
	enum { SIZE = 32 };
	u32 meets[6] = {0};
	for (u32 k = 0; k < 6 * 4 * SIZE; k++) {
		u32 face = k / (4 * SIZE), side = k / SIZE % 4;
		f32 along = (2 * (f32)(k % SIZE) + 1) / SIZE - 1;
		ts_cube_place inside = ts_k_cube_place(edge_direction(face, side, along, 1 - 1.0f / 1024));
		ts_cube_place outside = ts_k_cube_place(edge_direction(face, side, along, 1 + 1.0f / 1024));
		assert_int_equal(inside.face, face);
		assert_true(outside.face != face && outside.face != (face ^ 1u));
		u32 s = ts_k_cube_texel(outside.s, SIZE), t = ts_k_cube_texel(outside.t, SIZE);
		bool on_s = s == 0 || s == SIZE - 1, on_t = t == 0 || t == SIZE - 1;
		assert_true(on_s || on_t);
		u32 running = k % SIZE == 0 || k % SIZE == SIZE - 1 ? SIZE : on_s ? t : s;
		assert_true(running == SIZE || running == k % SIZE || running == SIZE - 1 - k % SIZE);
		meets[face] |= 1u << outside.face;
	}
	for (u32 face = 0; face < 6; face++) {
		assert_int_equal(meets[face], 63u ^ (1u << face) ^ (1u << (face ^ 1u)));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(directions_meet_the_face_of_the_table),   seeded_test(ties_go_to_x_and_then_y),
		seeded_test(places_on_faces_lead_back_to_themselves), seeded_test(each_middle_finds_its_texel),
		seeded_test(drawn_faces_agree_with_look_ups),         seeded_test(faces_are_orthonormal_and_mirrored),
		seeded_test(steps_off_a_face_reach_one_neighbour),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
