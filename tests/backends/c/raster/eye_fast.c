/* The fast path of the eye's view gives the kernel's bits: of random triangles, for one sample of the pixels and for
 * four, in images wider and narrower than a tile, by one thread and by several. */
#include "kernels/raster/eye.h"
#include "tests/backends/c/raster/triangles.h"

enum { N = 200, TEXELS = 4 * 1200 * 40 };

static ts_view random_view(void)
{
	ts_v3 back = direction(), right = ts_normalize(ts_cross(direction(), back));
	bool wide = below(4) == 0;
	ts_view r = {.focal = power(3, 9),
	             .width = 1 + below(wide ? 1200 : 150),
	             .height = 1 + below(wide ? 40 : 150),
	             .near = power(-10, 1)};
	ts_store3(r.eye, place(4, below(2) == 0));
	ts_store3(r.right, right);
	ts_store3(r.up, ts_cross(back, right));
	ts_store3(r.back, back);
	return r;
}

static void the_fast_eye_equals_the_kernel(void **state)
{
	static small_scene s;
	static u64 plain[TEXELS], fast[TEXELS];
	u64 n_written = 0;
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_view view = random_view();
		ts_eye_args args = {.scene = triangles(&s), .view = &view, .texels = plain, .samples = below(2) == 0 ? 4 : 1};
		u64 n = (u64)s.n_triangles * args.samples;
		u32 threads = 1 + below(9);
		for (u32 k = 0; k < TEXELS; k++) plain[k] = (u64)before() << 32 | TS_NONE;
		memcpy(fast, plain, sizeof fast);
		ts_c_launch(TS_KERNEL_eye, &args, n, 1);
		for (u32 k = 0; k < TEXELS; k++) n_written += plain[k] != fast[k];
		args.texels = fast;
		assert_true(ts_c_fast_eye(&args, n, threads));
		for (u32 k = 0; k < TEXELS; k++) {
			if (plain[k] == fast[k]) continue;
			fail_msg("scene %u: %u triangles, %u x %u pixels, %u samples, %u threads: texel %u is %llx, not %llx", i,
			         s.n_triangles, view.width, view.height, args.samples, threads, k, (unsigned long long)fast[k],
			         (unsigned long long)plain[k]);
		}
	}
	assert_true(n_written > 3000 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(the_fast_eye_equals_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
