/* T_epr: an orthonormal frame along the longest edge, the centroid on a sample, corners that map back. */
#include "tests/kernels/points/mesh.h"

enum { N = 20000 };

/* A triangle in the middle of the range of sizes, with its density; false: without area. */
static bool random_align(mesh *m, ts_v3 corner[3])
{
	mesh_begin(m);
	random_corners(corner, 8, 0.01f, 8);
	if (is_degenerate(corner)) return false;
	mesh_triangle(m, corner[0], corner[1], corner[2], 0, 0);
	f32 length;
	ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
	mesh_whole(m, uniform_power(-4, 13) / length);
	mesh_align(m);
	return true;
}

/* How precisely the plane is known: coordinates are rounded to 2^-24 of themselves, and the triangle is this high. */
static double slack(const ts_v3 corner[3])
{
	f32 length;
	ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
	double height = 2 * d3_area(d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])) / length;
	return 1e-6 + 1e-7 * length / height;
}

static void frames_are_orthonormal_about_the_centroid(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_v3 corner[3];
		if (!random_align(&m, corner)) continue;
		d3 u = d3_load(m.frames->u), v = d3_load(m.frames->v), c = d3_load(m.frames->c);
		assert_true(fabs(d3_length(u) - 1) <= 1e-6 && fabs(d3_length(v) - 1) <= 1e-6);
		assert_true(fabs(d3_dot(u, v)) <= 1e-6);
		d3 middle = d3_scale(d3_add(d3_add(d3_of(corner[0]), d3_of(corner[1])), d3_of(corner[2])), 1 / 3.0);
		assert_true(d3_length(d3_sub(middle, c)) <= 1e-5);
		d3 n = d3_cross(d3_sub(d3_of(corner[1]), d3_of(corner[0])), d3_sub(d3_of(corner[2]), d3_of(corner[0])));
		n = d3_unit(n);
		double most = slack(corner);
		assert_true(d3_length(d3_sub(d3_cross(u, v), n)) <= 4 * most || most > 1e-3);
		mesh_clear(&m);
	}
}

/* The longest edge runs along +x and the third corner lies above it. */
static void the_longest_edge_runs_along_x(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_v3 corner[3];
		if (!random_align(&m, corner)) continue;
		const i32 *q = m.frames->q;
		u32 longest = 0;
		double length[3];
		for (u32 k = 0; k < 3; k++) length[k] = d3_length(d3_sub(d3_of(corner[(k + 1) % 3]), d3_of(corner[k])));
		for (u32 k = 1; k < 3; k++) longest = length[k] > length[longest] ? k : longest;
		u32 from = longest, to = (longest + 1) % 3, third = (longest + 2) % 3;
		bool tie = length[to] > length[from] * 0.999999 || length[third] > length[from] * 0.999999;
		if (!tie) {
			f32 s = m.frames->s;
			assert_true(q[to * 2] >= q[from * 2]);
			assert_true(abs(q[to * 2 + 1] - q[from * 2 + 1]) <= 1 + (int)(256 * s * 1e-5));
			assert_true(q[third * 2 + 1] >= q[from * 2 + 1] - 1 - (int)(256 * s * 1e-5));
			assert_true(fabs(q[to * 2] - q[from * 2] - length[longest] * s * 256) <= 1.01 + 256 * s * 2e-6);
		}
		mesh_clear(&m);
	}
}

/* The centroid maps to the middle of sample 0, 0; each snapped corner maps back to within half a 256th of a sample. */
static void corners_map_back_to_half_a_step(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_v3 corner[3];
		if (!random_align(&m, corner)) continue;
		const ts_align *f = m.frames;
		d3 c = d3_load(f->c), u = d3_load(f->u), v = d3_load(f->v);
		double x = 0, y = 0, rounding = f->s * 3e-6, s = f->s;
		for (u32 k = 0; k < 3; k++) {
			d3 back = d3_mad(d3_mad(c, u, (f->q[k * 2] / 256.0 - 0.5) / s), v, (f->q[k * 2 + 1] / 256.0 - 0.5) / s);
			assert_true(d3_length(d3_sub(back, d3_of(corner[k]))) * s <= sqrt(0.5) / 256 + rounding);
			x += f->q[k * 2] / 256.0 / 3;
			y += f->q[k * 2 + 1] / 256.0 / 3;
		}
		assert_true(fabs(x - 0.5) <= 0.5 / 256 + rounding && fabs(y - 0.5) <= 0.5 / 256 + rounding);
		mesh_clear(&m);
	}
}

/* Its area in samples is A s^2; counter-clockwise like the triangle. */
static void frames_keep_the_area_in_samples(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_v3 corner[3];
		if (!random_align(&m, corner)) continue;
		const i32 *q = m.frames->q;
		double twice = (double)(q[2] - q[0]) * (q[5] - q[1]) - (double)(q[3] - q[1]) * (q[4] - q[0]);
		double s = m.frames->s, area = d3_area(d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])) * s * s;
		f32 length;
		ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
		assert_true(fabs(twice / 131072 - area) <= length * s * (2.0 / 256 + s * 5e-6) + 0.001);
		mesh_clear(&m);
	}
}

/* Dropped: no density, but the same frame. Padding is zero. */
static void dropped_pieces_keep_their_frame(void **state)
{
	(void)state;
	mesh m;
	mesh_begin(&m);
	mesh_triangle(&m, ts_v3_make(0, 0, 0), ts_v3_make(3, 0, 0), ts_v3_make(0, 3, 0), 0, 0);
	mesh_whole(&m, 4);
	u32 keep[2] = {0, 1};
	for (u32 k = 0; k < 2; k++) {
		ts_align frame;
		memset(&frame, 0xff, sizeof frame);
		ts_align_args args = {.pieces = m.pieces, .scale = m.scale, .keep = &keep[k], .frames = &frame};
		ts_k_align_item(&args, 0);
		assert_true(frame.s == (f32)(4 * k));
		assert_true(frame.c[0] == 1 && frame.c[1] == 1 && frame.c[2] == 0);
		assert_int_equal(frame.pad0 | frame.pad1 | frame.pad2[0] | frame.pad2[1], 0);
		for (u32 i = 0; i < 6 && k == 0; i++) assert_int_equal(frame.q[i], 128);
	}
	mesh_clear(&m);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(frames_are_orthonormal_about_the_centroid), cmocka_unit_test(the_longest_edge_runs_along_x),
		cmocka_unit_test(corners_map_back_to_half_a_step),           cmocka_unit_test(frames_keep_the_area_in_samples),
		cmocka_unit_test(dropped_pieces_keep_their_frame),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
