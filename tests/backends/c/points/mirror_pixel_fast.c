/* The fast records of reflective pixels equal the plain kernel's: pictures of all sizes, higher than what a thread
 * takes at once, with one sample a pixel or four, mirrors beside each other and beside what reflects nothing. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "kernels/points/mirror_pixel.h"
#include "kernels/raster/eye.h"
#include "tests/kernels/small.h"

enum { N = 200, TRIANGLES = 36, WIDEST = 40, HIGHEST = 100, MOST = WIDEST * HIGHEST * TS_N_EYE_SAMPLES };

static small_scene scene;
static u64 keys[MOST];
static u32 offset[MOST + 1];
static ts_pixel records[2][MOST];

/* Two mirrors and something dull, in pieces all over the picture, seen from both sides. */
static void random_scene(void)
{
	small_mirrors(&scene);
	for (u32 k = 0; k < TRIANGLES; k++) {
		ts_v3 corner[3];
		for (u32 c = 0; c < 3; c++) {
			f32 z = uniform(2, 6);
			corner[c] = ts_v3_make(uniform(-0.8f, 0.8f) * z, uniform(-0.8f, 0.8f) * z, -z);
		}
		small_add(&scene, corner[0], corner[1], corner[2], k % 3, k % 3);
	}
	for (u32 k = 0; k < 3 * TRIANGLES; k++) ts_store3(scene.vertices[k].normal, direction());
}

static ts_view random_view(void)
{
	u32 width = 1 + below(WIDEST), height = 1 + below(HIGHEST);
	return (ts_view){.focal = 0.5f * (f32)(width > height ? width : height),
	                 .right = {1, 0, 0},
	                 .width = (i32)width,
	                 .up = {0, 1, 0},
	                 .height = (i32)height,
	                 .back = {0, 0, 1},
	                 .near = 0.25f};
}

/* Draws the scene and counts its reflective pixels. */
static u32 find_pixels(const ts_mirror_pixel_args *args, u32 n)
{
	ts_eye_args eye = {.scene = args->scene, .view = args->view, .texels = keys, .samples = args->samples};
	u32 sum = 0;
	for (u32 i = 0; i < n; i++) keys[i] = TS_EMPTY;
	ts_c_launch(TS_KERNEL_eye, &eye, scene.n_triangles, 1);
	ts_c_launch(TS_KERNEL_mirror_pixel_count, args, n, 1);
	for (u32 i = 0; i <= n; i++) {
		u32 count = i < n ? offset[i] : 0;
		offset[i] = sum;
		sum += count;
	}
	return sum;
}

static void fast_records_equal_the_kernel(void **state)
{
	(void)state;
	u32 n_pixels = 0;
	for (u32 i = 0; i < N; i++) {
		u32 start = n_random;
		random_scene();
		ts_view view = random_view();
		u32 samples = below(2) == 0 ? 1 : TS_N_EYE_SAMPLES, threads = 1 + below(7);
		u32 n = (u32)(view.width * view.height) * samples;
		ts_mirror_pixel_args args = {.scene = small_arrays(&scene),
		                             .view = &view,
		                             .depth_triangle = keys,
		                             .offset = offset,
		                             .pixels = records[0],
		                             .samples = samples};
		n_pixels += find_pixels(&args, n);
		memset(records, 0xee, sizeof records);
		ts_c_launch(TS_KERNEL_mirror_pixel, &args, n, 1);
		args.pixels = records[1];
		assert_true(ts_c_fast_mirror_pixel(&args, n, threads));
		u32 k = 0;
		while (k < MOST && memcmp(&records[0][k], &records[1][k], sizeof *records[0]) == 0) k++;
		if (k < MOST) {
			fail_msg("random %u: %d x %d pixels, %u samples, %u threads: pixel %u", start, view.width, view.height,
			         samples, threads, records[0][k].index);
		}
	}
	assert_true(n_pixels > 300 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fast_records_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
