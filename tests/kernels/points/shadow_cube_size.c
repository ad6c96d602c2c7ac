/* The ratio that sizes shadow cubes, against its definition over the triangles in sight (EPR eq. 6). */
#include "kernels/points/shadow_cube_size.h"
#include "tests/kernels/points/mesh.h"

enum { WIDTH = 16, N_PIXELS = WIDTH * 8, N_FRAMES = 300 };

static double to(d3 p, const mesh *m, u32 t)
{
	const ts_vertex *v = &m->vertices[t * 3];
	d3 q = d3_on_triangle(p, d3_load(v[0].position), d3_load(v[1].position), d3_load(v[2].position));
	return d3_length(d3_sub(p, q));
}

static void random_world(mesh *m, u64 *keys)
{
	mesh_begin(m);
	for (u32 l = 0; l < 5; l++) mesh_cube(m, uniform3(-8, 8), 1, 64);
	ts_store3(m->view.eye, uniform3(-8, 8));
	for (u32 t = 0; t < 8; t++) {
		ts_v3 corner[3];
		random_corners(corner, 8, 0.01f, 4);
		mesh_triangle(m, corner[0], corner[1], corner[2], 0, 0);
	}
	for (u32 i = 0; i < N_PIXELS; i++) {
		u32 runs = i % 3 != 0 && i > 0 && random_bits() % 2 != 0;
		keys[i] = random_bits() % 4 == 0 ? TS_EMPTY : (u64)random_bits() << 32 | random_bits() % 8;
		if (runs != 0) keys[i] = keys[i - 1];
	}
}

/* The least d_er / max_l d_lt, in whatever order pixels come; nothing where nothing is in sight. */
static void the_least_ratio_in_sight_counts(void **state)
{
	(void)state;
	static mesh m;
	u64 keys[N_PIXELS];
	n_random = 0;
	for (u32 k = 0; k < N_FRAMES; k++) {
		random_world(&m, keys);
		double expected = INFINITY;
		for (u32 i = 0; i < N_PIXELS; i++) {
			if (keys[i] == TS_EMPTY) continue;
			double farthest = 0;
			for (u32 l = 0; l < m.n_cubes; l++)
				farthest = fmax(farthest, to(d3_load(m.cubes[l].centre), &m, (u32)keys[i]));
			expected = fmin(expected, to(d3_load(m.view.eye), &m, (u32)keys[i]) / farthest);
		}
		u32 least = TS_NONE;
		ts_shadow_cube_size_args args = {.scene = mesh_arrays(&m),
		                                 .view = &m.view,
		                                 .depth_triangle = keys,
		                                 .cubes = m.cubes,
		                                 .least = &least,
		                                 .n_cubes = m.n_cubes};
		for (u32 i = 0; i < N_PIXELS; i++) ts_k_shadow_cube_size_item(&args, k % 2 == 0 ? i : N_PIXELS - 1 - i);
		assert_true(fabs(ts_u2f(least) - expected) <= 1e-4 * (1 + expected));
		memset(keys, 0xff, sizeof keys);
		least = TS_NONE;
		for (u32 i = 0; i < N_PIXELS; i++) ts_k_shadow_cube_size_item(&args, i);
		assert_int_equal(least, TS_NONE);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(the_least_ratio_in_sight_counts)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
