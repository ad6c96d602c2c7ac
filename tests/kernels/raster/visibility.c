/* Visibility bits against samples: what a face can see has its bit; what turns its back, owns the cube or has no area
 * has none; and every cube's six bits are found again among the words. */
#include "kernels/raster/visibility.h"
#include "tests/kernels/small.h"

enum { N = 20000, N_CUBES = 23, N_WORDS = 3, N_SAMPLES = 60 };

static small_scene scene;
static ts_face cubes[N_CUBES];
static u64 words[N_WORDS];

static void make_scene(f32 size)
{
	small_clear(&scene);
	scene.materials[1].flags = TS_DOUBLE_SIDED;
	ts_v3 o = uniform3(-3, 3), a = uniform3(-size, size), b = uniform3(-size, size), c = uniform3(-size, size);
	small_add(&scene, ts_add(o, a), ts_add(o, b), ts_add(o, c), 1, 0);
	for (u32 r = 0; r < N_CUBES; r++) {
		cubes[r] = (ts_face){.n = 16, .near = 0.125f, .object = TS_NONE};
		ts_store3(cubes[r].centre, uniform3(-3, 3));
	}
}

static void find_bits(u32 n_cubes, u32 vertex_mode)
{
	ts_visibility_args args = {.scene = small_arrays(&scene),
	                           .cubes = cubes,
	                           .bits = words,
	                           .n_cubes = n_cubes,
	                           .n_words = (n_cubes * 6 + 63) / 64,
	                           .vertex_mode = vertex_mode};
	ts_k_visibility_item(&args, 0);
}

static double3 corner(u32 k) { return d3_of(ts_load3(scene.vertices[k].position)); }

/* Along a face's axes (s, t, depth), from OpenGL's table. */
static double3 on_face(u32 face, double3 d)
{
	switch (face) {
	case 0: return (double3){-d.z, -d.y, d.x};
	case 1: return (double3){d.z, -d.y, -d.x};
	case 2: return (double3){d.x, d.z, d.y};
	case 3: return (double3){d.x, -d.z, -d.y};
	case 4: return (double3){d.x, -d.y, d.z};
	default: return (double3){-d.x, -d.y, -d.z};
	}
}

static bool sees(double3 p, double reach, double near)
{
	return p.z >= near && fabs(p.x) <= reach * p.z && fabs(p.y) <= reach * p.z;
}

/* A triangle with any sampled point inside a face's frustum before the near plane has the face's bit. */
static void what_a_face_sees_has_its_bit(void **state)
{
	(void)state;
	u32 n_seen = 0, n_set = 0;
	for (u32 i = 0; i < N / 4; i++) {
		make_scene(ldexpf(1, (int)below(6) - 3));
		find_bits(1, 0);
		for (u32 face = 0; face < 6; face++) {
			bool seen = false;
			for (u32 k = 0; k < N_SAMPLES && !seen; k++) {
				ts_v3 w = k < 3 ? ts_v3_make(k == 0, k == 1, k == 2) : random_weights();
				double3 p = d3_blend(w, corner(0), corner(1), corner(2));
				seen = sees(on_face(face, d3_sub(p, d3_of(ts_load3(cubes[0].centre)))), 1 - 1e-6, 0.125 + 1e-6);
			}
			n_seen += seen;
			n_set += words[0] >> face & 1;
			if (seen) assert_true(words[0] >> face & 1);
		}
	}
	assert_true(n_seen > N / 8 && n_set < n_seen * 3 / 2);
}

/* The plane test by its words: all corners beyond one of the five planes. */
static bool is_beyond_a_plane(const double3 *p, double near, double *margin)
{
	double best = -INFINITY;
	for (u32 plane = 0; plane < 5; plane++) {
		double least = INFINITY;
		for (u32 k = 0; k < 3; k++) {
			double x = plane < 2 ? p[k].x : p[k].y, beyond = (plane & 1 ? -x : x) - p[k].z;
			least = fmin(least, plane == 4 ? near - p[k].z : beyond);
		}
		best = fmax(best, least);
	}
	*margin = fabs(best);
	return best > 0;
}

static void both_modes_follow_their_words(void **state)
{
	(void)state;
	u32 n_set[2] = {0};
	for (u32 i = 0; i < N; i++) {
		make_scene(ldexpf(1, (int)below(6) - 3));
		u32 vertex_mode = i & 1;
		find_bits(1, vertex_mode);
		for (u32 face = 0; face < 6; face++) {
			double3 p[3];
			bool inner = false, outer = false, bit = words[0] >> face & 1;
			double margin;
			for (u32 k = 0; k < 3; k++) {
				p[k] = on_face(face, d3_sub(corner(k), d3_of(ts_load3(cubes[0].centre))));
				inner = inner || sees(p[k], 1.2 - 1e-5, 1e-9);
				outer = outer || sees(p[k], 1.2 + 1e-5, -1e-9);
			}
			n_set[vertex_mode] += bit;
			if (vertex_mode == 1 && inner == outer) assert_true(bit == inner);
			bool beyond = is_beyond_a_plane(p, 0.125, &margin);
			if (vertex_mode == 0 && margin > 1e-5) assert_true(bit == !beyond);
		}
	}
	assert_true(n_set[0] > 0 && n_set[1] > 0);
}

/* Planes are closed: what just touches one is seen. */
static void what_touches_a_plane_is_seen(void **state)
{
	(void)state;
	ts_frustum f = {.x = 1, .y = 1, .near = 0.125f};
	ts_v3 p = ts_v3_make(2, 1, 2), q = ts_v3_make(3, 0, 2), r = ts_v3_make(2.5f, -1, 2);
	assert_false(ts_k_outside_plane(&f, p, q, r));
	assert_true(ts_k_outside_plane(&f, ts_v3_make(2.001f, 1, 2), q, r));
	ts_v3 at_near = ts_v3_make(0, 0, 0.125f), before = ts_v3_make(0, 0, 0);
	assert_false(ts_k_outside_plane(&f, before, before, at_near));
	assert_true(ts_k_outside_plane(&f, before, before, before));
}

/* A small triangle before one face is that face's alone, in both modes. */
static void a_small_triangle_is_one_faces_alone(void **state)
{
	(void)state;
	for (u32 face = 0; face < 6; face++) {
		make_scene(1);
		ts_v3 d = ts_k_cube_direction(face, 0, 0), c = ts_mad(ts_load3(cubes[0].centre), d, 4);
		for (u32 k = 0; k < 3; k++) ts_store3(scene.vertices[k].position, ts_add(c, uniform3(-0.25f, 0.25f)));
		for (u32 mode = 0; mode < 2; mode++) {
			find_bits(1, mode);
			assert_true(words[0] == 1u << face);
		}
	}
}

/* The back of a single-sided triangle, its own cube, a cube of no size and a triangle without area: no bits. */
static void backs_and_own_cubes_have_no_bits(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		make_scene(2);
		find_bits(1, i & 1);
		u64 both = words[0];
		double3 n = d3_cross(d3_sub(corner(1), corner(0)), d3_sub(corner(2), corner(0)));
		double front = d3_dot(n, d3_sub(d3_of(ts_load3(cubes[0].centre)), corner(0)));
		scene.triangles[0].material = 0;
		find_bits(1, i & 1);
		if (fabs(front) > 1e-4) assert_true(words[0] == (front > 0 ? both : 0));
		scene.triangles[0].material = 1;
		cubes[0].object = 0;
		find_bits(1, i & 1);
		assert_true(words[0] == 0);
		cubes[0].object = 1;
		find_bits(1, i & 1);
		assert_true(words[0] == both);
		cubes[0].n = 0;
		find_bits(1, i & 1);
		assert_true(words[0] == 0);
		cubes[0].n = 16;
		scene.vertices[2] = scene.vertices[1];
		find_bits(1, i & 1);
		assert_true(words[0] == 0);
	}
}

/* Edge-on from the centre, a single-sided triangle does not face it. */
static void edge_on_triangles_do_not_face_cubes(void **state)
{
	(void)state;
	make_scene(1);
	ts_store3(cubes[0].centre, ts_v3_make(0, 0, 0));
	for (u32 k = 0; k < 3; k++) ts_store3(scene.vertices[k].position, ts_v3_make(k == 0 ? 2 : 3, k == 1, 0));
	find_bits(1, 0);
	assert_true(words[0] == 1);
	scene.triangles[0].material = 0;
	find_bits(1, 0);
	assert_true(words[0] == 0);
}

/* Cube r's bits are bits 6 r to 6 r + 5, also where they go from one word into the next; nothing else is set. */
static void each_cube_has_its_six_bits(void **state)
{
	(void)state;
	for (u32 i = 0; i < N / 10; i++) {
		make_scene(2);
		memset(words, 0xff, sizeof words);
		find_bits(N_CUBES, 0);
		u64 all[N_WORDS], n_set = 0, n_expected = 0;
		memcpy(all, words, sizeof all);
		for (u32 k = 0; k < N_WORDS * 64; k++) n_set += all[k / 64] >> (k % 64) & 1;
		for (u32 r = 0; r < N_CUBES; r++) {
			ts_face first = cubes[0];
			cubes[0] = cubes[r];
			find_bits(1, 0);
			cubes[0] = first;
			assert_int_equal(ts_k_cube_bits(all, r), words[0]);
			for (u32 face = 0; face < 6; face++) {
				u32 k = 6 * r + face;
				assert_int_equal(all[k / 64] >> (k % 64) & 1, words[0] >> face & 1);
				n_expected += words[0] >> face & 1;
			}
		}
		assert_true(n_set == n_expected);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(what_a_face_sees_has_its_bit),     seeded_test(both_modes_follow_their_words),
		seeded_test(what_touches_a_plane_is_seen),     seeded_test(a_small_triangle_is_one_faces_alone),
		seeded_test(backs_and_own_cubes_have_no_bits), seeded_test(edge_on_triangles_do_not_face_cubes),
		seeded_test(each_cube_has_its_six_bits),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
