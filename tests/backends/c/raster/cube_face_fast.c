/* The fast path of MVR's cube faces gives the kernel's bits: of random triangles, in cubes of any size, of which some
 * are out of sight, by several threads, in batches. */
#include "kernels/raster/cube_face.h"
#include "tests/backends/c/raster/triangles.h"

enum { N = 150, CUBES = 4, MOST = 90, TEXELS = CUBES * 6 * MOST * MOST };

static void random_cubes(ts_face *cubes)
{
	u64 offset = 0;
	for (u32 r = 0; r < CUBES; r++) {
		cubes[r] = (ts_face){.n = below(6) == 0 ? 0 : 1 + below(MOST), .near = power(-14, 1), .object = below(5)};
		cubes[r].offset = offset;
		ts_store3(cubes[r].centre, place(4, below(2) == 0));
		offset += 6 * (u64)cubes[r].n * cubes[r].n;
	}
}

static void fast_cube_faces_equal_the_kernel(void **state)
{
	static small_scene s;
	static u64 plain[TEXELS], fast[TEXELS];
	ts_face cubes[CUBES];
	u64 n_written = 0;
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_cube_face_args args = {.scene = triangles(&s), .cubes = cubes, .texels = plain};
		u32 threads = 1 + below(7);
		random_cubes(cubes);
		args.first_cube = below(CUBES);
		args.n_cubes = below(CUBES + 1 - args.first_cube);
		for (u32 k = 0; k < TEXELS; k++) plain[k] = (u64)before() << 32 | TS_NONE;
		memcpy(fast, plain, sizeof fast);
		ts_c_launch(TS_KERNEL_cube_face, &args, s.n_triangles, 1);
		for (u32 k = 0; k < TEXELS; k++) n_written += plain[k] != fast[k];
		args.texels = fast;
		assert_true(ts_c_fast_cube_face(&args, s.n_triangles, threads));
		for (u32 k = 0; k < TEXELS; k++) {
			if (plain[k] == fast[k]) continue;
			fail_msg("scene %u: %u triangles, cubes %u and %u after, %u threads: texel %u is %llx, not %llx", i,
			         s.n_triangles, args.first_cube, args.n_cubes, threads, k, (unsigned long long)fast[k],
			         (unsigned long long)plain[k]);
		}
	}
	assert_true(n_written > 10000 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fast_cube_faces_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
