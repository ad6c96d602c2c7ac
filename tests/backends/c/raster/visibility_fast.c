/* The fast visibility equals the plain kernel bit for bit: triangles in all places about many cubes, biased to the
 * extremes, or near one place; more of them than go side by side. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/mesh.h"

enum { N = 200, TRIANGLES = 300, CUBES = 40, WORDS = (CUBES * 6 + 63) / 64 };

static ts_vertex vertices[TRIANGLES * 3];
static ts_triangle triangles[TRIANGLES];
static ts_face cubes[CUBES];

/* Whole numbers lie in planes of frusta; a cube's centre, its near plane, what is far, what has no area. */
static ts_v3 extreme_corner(ts_v3 centre)
{
	ts_v3 p = uniform3(-4, 4);
	switch (random_bits() % 8) {
	case 0: return centre;
	case 1: return ts_scale(p, 4194304);
	case 2: return ts_mad(centre, p, 0.0001f);
	case 3: return ts_add(centre, ts_v3_make(ts_floor(p.x), ts_floor(p.x), ts_floor(p.z)));
	case 4: return ts_add(centre, ts_v3_make(p.x, -p.x, p.z));
	case 5: return p;
	default: return ts_v3_make(ts_floor(p.x), ts_floor(p.y), ts_floor(p.z));
	}
}

/* Of a scene whose corners are all near one place, often in planes of frusta. */
static ts_v3 near_corner(ts_v3 place)
{
	ts_v3 p = ts_add(place, uniform3(-1, 1));
	return random_bits() % 4 == 0 ? p : ts_v3_make(ts_floor(p.x), ts_floor(p.y), ts_floor(p.z));
}

static void random_scene(u32 n_cubes)
{
	bool near = random_bits() % 2 == 0;
	ts_v3 place = uniform3(-6, 6);
	static const u32 sizes[] = {0, 1, 64};
	for (u32 r = 0; r < n_cubes; r++) {
		ts_v3 centre = uniform3(-3, 3);
		if (r % 2 == 0) centre = ts_v3_make(ts_floor(centre.x), ts_floor(centre.y), ts_floor(centre.z));
		cubes[r] = (ts_face){.n = sizes[random_bits() % 3],
		                     .near = random_bits() % 4 == 0 ? 1 : uniform_power(-12, 1),
		                     .object = random_bits() % 4};
		ts_store3(cubes[r].centre, centre);
	}
	for (u32 t = 0; t < TRIANGLES; t++) {
		u32 object = random_bits() % 4;
		for (u32 k = 0; k < 3; k++) {
			vertices[t * 3 + k] = (ts_vertex){.object = object};
			ts_v3 centre = ts_load3(cubes[random_bits() % n_cubes].centre);
			ts_store3(vertices[t * 3 + k].position, near ? near_corner(place) : extreme_corner(centre));
		}
		triangles[t] = (ts_triangle){{t * 3, t * 3 + 1, t * 3 + 2}, random_bits() % 2};
	}
}

static void fast_visibility_equals_the_kernel(void **state)
{
	(void)state;
	static u64 plain[TRIANGLES * WORDS], fast[TRIANGLES * WORDS];
	const ts_material materials[2] = {{.flags = 0}, {.flags = TS_DOUBLE_SIDED}};
	u64 n_bits = 0;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		u32 start = n_random, n_cubes = 1 + random_bits() % CUBES, threads = 1 + random_bits() % 7;
		u64 n = 1 + random_bits() % TRIANGLES;
		random_scene(n_cubes);
		ts_visibility_args args = {.scene = {.vertices = vertices, .triangles = triangles, .materials = materials},
		                           .cubes = cubes,
		                           .bits = plain,
		                           .n_cubes = n_cubes,
		                           .n_words = (n_cubes * 6 + 63) / 64};
		memset(plain, 0x55, sizeof plain);
		memset(fast, 0x55, sizeof fast);
		ts_c_launch(TS_KERNEL_visibility, &args, n, 1);
		args.bits = fast;
		assert_true(ts_c_fast_visibility(&args, n, threads));
		for (u64 w = 0; w < TRIANGLES * WORDS; w++) {
			if (plain[w] != fast[w]) {
				fail_msg("random %u: %u cubes, %u threads: word %u: %llx, %llx", start, n_cubes, threads, (u32)w,
				         (unsigned long long)plain[w], (unsigned long long)fast[w]);
			}
		}
		for (u64 w = 0; w < n * args.n_words; w++) n_bits += (u64)__builtin_popcountll(plain[w]);
	}
	assert_true(n_bits > 1000 * N);
}

/* Faces that have a corner in sight are the kernel's. */
static void the_kernel_tests_vertices(void **state)
{
	(void)state;
	ts_visibility_args args = {.vertex_mode = 1};
	assert_false(ts_c_fast_visibility(&args, 0, 1));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_visibility_equals_the_kernel),
	                                   cmocka_unit_test(the_kernel_tests_vertices)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
