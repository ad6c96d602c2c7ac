/* The fast G-buffer equals the plain kernel bit for bit: of pixels that name triangles in front of the eye, across
 * the near plane, behind it, degenerate, or beside the pixel, in runs of any length; of the sky; and of samples of
 * pixels. */
#include "tests/backends/c/raster/scribble.h"

enum { N = 60 };

static void check(const ts_run *run, u32 n_triangles)
{
	static ts_gpixel plain[PIXELS], fast[PIXELS];
	static u64 keys[PIXELS];
	memcpy(keys, ts_frame_data(&run->frame, TS_B_eye_depth_triangle), sizeof keys);
	scribble(keys, PIXELS, n_triangles);
	ts_view view = *(const ts_view *)ts_frame_data(&run->frame, TS_B_eye_view);
	if (below(4) == 0) view.near = uniform(0.5f, 8);
	ts_gbuffer_args args = {.view = &view, .depth_triangle = keys, .pixels = plain, .samples = EYE_SAMPLES};
	args.scene = ts_run_arrays(run);
	memset(plain, 0x55, sizeof plain);
	memset(fast, 0x55, sizeof fast);
	ts_gbuffer_args other = args;
	other.pixels = fast;
	launch_both(TS_KERNEL_gbuffer, ts_c_fast_gbuffer, &args, &other, 1 + below(PIXELS));
	assert_memory_equal(plain, fast, sizeof plain);
}

static void the_fast_gbuffer_equals_the_kernel(void **state)
{
	(void)state;
	with_run(check, N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(the_fast_gbuffer_equals_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
