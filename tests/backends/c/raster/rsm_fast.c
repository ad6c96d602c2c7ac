/* The fast path of reflective shadow maps gives the kernel's bits: of random triangles, in views of any kind, by fewer
 * and by more threads than views. */
#include "kernels/raster/rsm.h"
#include "tests/backends/c/raster/offscreen.h"

enum { N = 100 };

static void fast_reflective_maps_equal_the_kernel(void **state)
{
	static small_scene s;
	static u64 plain[TEXELS], fast[TEXELS];
	ts_offscreen views[VIEWS];
	u64 n_written = 0;
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_rsm_args args = {
			.scene = triangles(&s), .views = views, .depth_triangle = plain, .n_views = below(VIEWS + 1)};
		u32 threads = 1 + below(9);
		random_views(views);
		for (u32 k = 0; k < TEXELS; k++) plain[k] = (u64)before() << 32 | TS_NONE;
		memcpy(fast, plain, sizeof fast);
		ts_c_launch(TS_KERNEL_rsm, &args, s.n_triangles, 1);
		for (u32 k = 0; k < TEXELS; k++) n_written += plain[k] != fast[k];
		args.depth_triangle = fast;
		assert_true(ts_c_fast_rsm(&args, s.n_triangles, threads));
		for (u32 k = 0; k < TEXELS; k++) {
			if (plain[k] == fast[k]) continue;
			fail_msg("scene %u: %u triangles, %u views, %u threads: texel %u is %llx, not %llx", i, s.n_triangles,
			         args.n_views, threads, k, (unsigned long long)fast[k], (unsigned long long)plain[k]);
		}
	}
	assert_true(n_written > 3000 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fast_reflective_maps_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
