/* The fast path of MVR's depth maps gives the kernel's bits: of random triangles, in views of any kind, by fewer and by
 * more threads than views, in batches. */
#include "kernels/raster/depth_map.h"
#include "tests/backends/c/raster/offscreen.h"

enum { N = 200 };

static void fast_depth_maps_equal_the_kernel(void **state)
{
	static small_scene s;
	static u32 plain[TEXELS], fast[TEXELS];
	ts_offscreen views[VIEWS];
	u64 n_written = 0;
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_depth_map_args args = {.scene = triangles(&s), .views = views, .depths = plain};
		u32 threads = 1 + below(9);
		random_views(views);
		args.first_view = below(VIEWS);
		args.n_views = below(VIEWS + 1 - args.first_view);
		for (u32 k = 0; k < TEXELS; k++) plain[k] = before();
		memcpy(fast, plain, sizeof fast);
		ts_c_launch(TS_KERNEL_depth_map, &args, s.n_triangles, 1);
		for (u32 k = 0; k < TEXELS; k++) n_written += plain[k] != fast[k];
		args.depths = fast;
		assert_true(ts_c_fast_depth_map(&args, s.n_triangles, threads));
		for (u32 k = 0; k < TEXELS; k++) {
			if (plain[k] == fast[k]) continue;
			fail_msg("scene %u: %u triangles, views %u and %u after, %u threads: texel %u is %x, not %x", i,
			         s.n_triangles, args.first_view, args.n_views, threads, k, fast[k], plain[k]);
		}
	}
	assert_true(n_written > 1000 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fast_depth_maps_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
