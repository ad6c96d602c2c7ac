/* Mip chains of cubes: their levels and places against sums of squares. */
#include "kernels/raster/mip.h"
#include "tests/kernels/seeded.h"

static u64 chain_texels(u32 n)
{
	u64 sum = 0;
	for (; n > 0; n /= 2) sum += 6 * (u64)n * n;
	return sum;
}

static void sizes_of_levels_are_sums_of_squares(void **state)
{
	(void)state;
	for (u32 n = 1; n <= 4096; n++) {
		u32 levels = ts_k_mip_levels(n);
		assert_true(n >> (levels - 1) == 1);
		assert_int_equal(ts_k_mip_texels(n, TS_NONE), chain_texels(n));
		assert_int_equal(ts_k_mip_texels(n, levels), chain_texels(n));
		assert_int_equal(ts_k_mip_texels(n, 0), 0);
		for (u32 l = 0; l < levels; l++) {
			u64 size = ts_k_mip_size(n, l);
			assert_true(size == n >> l);
			assert_int_equal(ts_k_mip_texels(n, l + 1) - ts_k_mip_texels(n, l), 6 * size * size);
		}
	}
	assert_int_equal(ts_k_mip_texels(0, TS_NONE), 0);
	ts_face cubes[4] = {{.n = 5}, {.n = 0}, {.n = 16}, {.n = 1}};
	assert_int_equal(ts_k_mip_first(cubes, 0, 3), chain_texels(5) + chain_texels(16));
	assert_int_equal(ts_k_mip_first(cubes, 2, 3), chain_texels(16));
	assert_int_equal(ts_k_mip_first(cubes, 2, 2), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(sizes_of_levels_are_sums_of_squares)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
