/* The C backend: every item once whatever the threads, prefix sums, filled buffers. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/mesh.h"

/* Prefix sums against their definition; the total may need more than 32 bits. */
static void prefix_sums_follow_their_definition(void **state)
{
	(void)state;
	n_random = 0;
	u32 one[1] = {7};
	assert_true(ts_c_scan(one, 0) == 0 && one[0] == 0);
	for (u32 run = 0; run < 400; run++) {
		u32 n = run < 40 ? run : random_bits() % 3000, counts[3001], before[3001];
		u32 range = run % 3 == 0 ? 1 : run % 3 == 1 ? 9 : 0xffffffff;
		for (u32 i = 0; i < n; i++) counts[i] = before[i] = random_bits() % range;
		u64 total = ts_c_scan(counts, n), sum = 0;
		for (u32 i = 0; i < n; i++) {
			assert_true(counts[i] == (u32)sum);
			sum += before[i];
		}
		assert_true(total == sum && counts[n] == (u32)sum);
	}
}

/* Filling, by any number of threads. */
static void filling_sets_every_byte(void **state)
{
	(void)state;
	for (u32 n = 0; n < 300; n++) {
		ts_frame frame = {.bytes = 0};
		ts_c_backend c;
		ts_c_begin(&c, 1 + n % 7);
		u64 *texels = ts_frame_make1(&frame, TS_B_splat_depth_index, n * 1001);
		assert_int_equal(c.backend.fill(&c.backend, &frame, TS_B_splat_depth_index, 0xff), TS_OK);
		for (u32 i = 0; i < n * 1001; i++) assert_true(texels[i] == TS_EMPTY);
		ts_frame_clear(&frame);
	}
}

/* n pieces culled on `threads` threads are those culled one after another, and nothing beyond the last is touched. */
static void every_item_runs_once_on_any_threads(void **state)
{
	(void)state;
	enum { MOST = 20000 };
	n_random = 0;
	ts_piece *pieces = mesh_alloc(MOST, sizeof *pieces);
	f32 *scale = mesh_alloc(MOST, sizeof *scale);
	u32 *expected = mesh_alloc(MOST, sizeof *expected), *keep = mesh_alloc(MOST, sizeof *keep);
	for (u32 i = 0; i < MOST; i++) {
		pieces[i] = (ts_piece){.b = {uniform(0, 0.5f)}, .c = {0, 1}, .triangle = i, .path = 1};
		scale[i] = 1;
	}
	ts_cull_args args = {.pieces = pieces, .scale = scale, .keep = expected, .unit = 1, .enabled = 1};
	for (u32 i = 0; i < MOST; i++) ts_k_cull_item(&args, i);
	args.keep = keep;
	for (u32 run = 0; run < 300; run++) {
		u32 n = run < 100 ? run : random_bits() % MOST, threads = 1 + random_bits() % 9;
		memset(keep, 0xee, MOST * sizeof *keep);
		ts_c_launch(TS_KERNEL_cull, &args, n, threads);
		assert_memory_equal(keep, expected, n * sizeof *keep);
		if (n < MOST) assert_int_equal(keep[n], 0xeeeeeeee);
	}
	free(pieces);
	free(scale);
	free(expected);
	free(keep);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(prefix_sums_follow_their_definition),
		cmocka_unit_test(filling_sets_every_byte),
		cmocka_unit_test(every_item_runs_once_on_any_threads),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
