/* The fast alignment equals the plain kernel bit for bit: pieces of every shape, degenerate and far away too, with
 * densities of every size, in numbers that fill no vector. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/mesh.h"

enum { N = 2000, PIECES = 150 };

static void random_piece(ts_piece *piece)
{
	static const f32 sizes[] = {1, 1, 0, 1e-20f, 16777216};
	ts_v3 corner[3];
	u32 sort = random_bits() % 8;
	random_corners(corner, 6, 0.002f, 64);
	if (sort == 0) corner[random_bits() % 3] = corner[random_bits() % 3];
	f32 size = sizes[random_bits() % 5];
	for (u32 k = 0; k < 3; k++) {
		ts_v3 p = corner[k];
		if (sort == 1) p = ts_v3_make(ts_floor(p.x), ts_floor(p.y), ts_floor(p.z));
		ts_store3(k == 0 ? piece->a : k == 1 ? piece->b : piece->c, ts_scale(p, size));
	}
}

static void fast_alignment_equals_the_kernel(void **state)
{
	static ts_piece pieces[PIECES];
	static ts_align frames[2][PIECES];
	f32 scale[PIECES];
	u32 keep[PIECES];
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		u32 start = n_random, n = 1 + random_bits() % PIECES, threads = 1 + random_bits() % 7;
		for (u32 k = 0; k < n; k++) {
			random_piece(&pieces[k]);
			scale[k] = uniform_power(-20, 20);
			keep[k] = random_bits() % 4 != 0;
		}
		memset(frames, 0xff, sizeof frames);
		ts_align_args args = {.pieces = pieces, .scale = scale, .keep = keep, .frames = frames[0]};
		ts_c_launch(TS_KERNEL_align, &args, n, 1);
		args.frames = frames[1];
		assert_true(ts_c_fast_align(&args, n, threads));
		u32 k = 0;
		while (k < PIECES && memcmp(&frames[0][k], &frames[1][k], sizeof *frames[0]) == 0) k++;
		if (k < PIECES) fail_msg("random %u: %u pieces, %u threads: piece %u", start, n, threads, k);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_alignment_equals_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
