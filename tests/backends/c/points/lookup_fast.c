/* The fast look-ups equal the plain kernel bit for bit: of pixels whose samples meet corners and edges of faces, with
 * normals that are short or none, in cubes of all sizes and of none. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "kernels/points/lookup.h"
#include "tests/kernels/points/pixels.h"

enum { N = 400, PIXELS = 61 };

static void fast_look_ups_equal_the_kernel(void **state)
{
	(void)state;
	static const u32 sizes[] = {0, 1, 2, 7, 16, 33, 64};
	n_random = 0;
	u64 n_found = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_pixel pixels[PIXELS];
		static u32 plain[PIXELS * TS_N_SAMPLES], fast[PIXELS * TS_N_SAMPLES];
		u32 start = n_random, threads = 1 + random_bits() % 7, n_cubes = 1 + random_bits() % MESH_CUBES;
		u64 n = 1 + random_bits() % PIXELS;
		mesh_begin(&m);
		for (u32 r = 0; r < n_cubes; r++) mesh_cube(&m, uniform3(-1, 1), 1, sizes[random_bits() % 7]);
		u64 *texels = mesh_alloc(mesh_texels(&m), sizeof *texels);
		for (u64 t = 0; t < mesh_texels(&m); t++) texels[t] = random_bits() % 8 == 0 ? TS_EMPTY : t;
		ts_store3(m.view.eye, random_bits() % 2 == 0 ? ts_v3_make(0, 0, 0) : uniform3(-4, 4));
		random_pixels(pixels, PIXELS, n_cubes);
		ts_lookup_args args = {.view = &m.view,
		                       .cubes = m.cubes,
		                       .texels = texels,
		                       .pixels = pixels,
		                       .found = plain,
		                       .n_samples = random_bits() % 4 == 0 ? TS_N_BOUNCE_SAMPLES : TS_N_SAMPLES,
		                       .first = 1};
		memset(plain, 0x55, sizeof plain);
		memset(fast, 0x55, sizeof fast);
		ts_c_launch(TS_KERNEL_lookup, &args, n, 1);
		args.found = fast;
		assert_true(ts_c_fast_lookup(&args, n, threads));
		for (u32 k = 0; k < PIXELS * TS_N_SAMPLES; k++) {
			if (plain[k] != fast[k]) {
				fail_msg("random %u: %u cubes, %u threads, %u samples: pixel %u of a cube of %u: sample %u: %u, %u",
				         start, n_cubes, threads, args.n_samples, k / args.n_samples,
				         m.cubes[pixels[k / args.n_samples].reflector].n, k % args.n_samples, plain[k], fast[k]);
			}
		}
		for (u64 k = 0; k < n * args.n_samples; k++) n_found += plain[k] != TS_NONE;
		free(texels);
	}
	assert_true(n_found > 200 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_look_ups_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
