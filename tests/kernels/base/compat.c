/* The atomics and bit casts that every language of the kernels must provide: order-free under threads. */
#include "tests/kernels/seeded.h"

enum { N = 200000, N_SLOTS = 64 };

/* The least value and the sum do not depend on who came first. */
static void atomics_do_not_depend_on_the_order(void **state)
{
	(void)state;
	u64 least[N_SLOTS], expected_least[N_SLOTS];
	i64 sum[N_SLOTS], expected_sum[N_SLOTS];
	for (u32 k = 0; k < N_SLOTS; k++) {
		least[k] = expected_least[k] = TS_EMPTY;
		sum[k] = expected_sum[k] = 0;
	}
	for (u32 i = 0; i < N; i++) {
		u64 v = (u64)ts_random(i, STREAM, 1) << 32 | i;
		u32 k = i % N_SLOTS;
		expected_least[k] = v < expected_least[k] ? v : expected_least[k];
		expected_sum[k] += (i64)v >> 20;
		expected_sum[k] -= i;
	}
#pragma omp parallel for num_threads(4) schedule(static, 1)
	for (u32 i = 0; i < N; i++) {
		u64 v = (u64)ts_random(i, STREAM, 1) << 32 | i;
		ts_min_u64(&least[i % N_SLOTS], v);
		ts_add_i64(&sum[i % N_SLOTS], ((i64)v >> 20) - i);
	}
	assert_memory_equal(least, expected_least, sizeof least);
	assert_memory_equal(sum, expected_sum, sizeof sum);
}

/* Nothing lies above the empty key, and depths order keys as they order themselves. */
static void depths_order_keys_below_the_empty_one(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 a = ts_put(ts_abs(ts_san(ts_u2f(bits())))), b = i % 4 == 0 ? a : ts_put(ts_abs(ts_san(ts_u2f(bits()))));
		u32 first = below(100), second = below(100);
		u64 one = (u64)ts_f2u(a) << 32 | first, other = (u64)ts_f2u(b) << 32 | second;
		assert_true(one < TS_EMPTY && (one < other) == (a < b || (a == b && first < second)));
	}
}

static void casts_keep_every_bit_of_a_number(void **state)
{
	(void)state;
	for (u64 u = 0; u <= 0xffffffffu; u += 8191) {
		f32 x = ts_u2f((u32)u);
		if (!isnan(x)) assert_int_equal(ts_f2u(x), (u32)u);
	}
	assert_true(ts_f2u(1) == 0x3f800000u && ts_f2u(-0.0f) == 0x80000000u && ts_u2f(0x40490fdbu) == 3.14159274f);
	assert_true(ts_sqrt(2.0f) == 1.41421354f && ts_floor(-0.5f) == -1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(atomics_do_not_depend_on_the_order),
	                                   seeded_test(depths_order_keys_below_the_empty_one),
	                                   seeded_test(casts_keep_every_bit_of_a_number)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
