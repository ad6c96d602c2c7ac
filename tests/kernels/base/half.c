/* Rounding to binary16 against the library's rounding in double: every binary16, and of every exponent and sign
 * whatever bits can tell roundings apart: all of the 14 leading ones, and four of each tail. */
#include "kernels/base/half.h"
#include "tests/kernels/base/half_truth.h"
#include "tests/kernels/seeded.h"

static void assert_half(u32 bits)
{
	f32 x = ts_u2f(bits), expected = (f32)half_of((double)x), found = ts_half(x);
	if (ts_f2u(found) != ts_f2u(expected)) fail_msg("%a: %a instead of %a", (double)x, (double)found, (double)expected);
}

static void every_tail_rounds_as_double_does(void **state)
{
	(void)state;
	static const u32 tails[] = {0, 1, 0x100, 0x1ff};
	for (u32 head = 0; head < 1u << 23; head++) {
		if ((head >> 14 & 255u) == 255 && (head & 0x3fffu) != 0) continue; /* no number */
		for (u32 k = 0; k < (((head >> 14 & 255u) == 255) ? 1 : 4); k++) assert_half(head << 9 | tails[k]);
	}
}

static void halves_stay_what_they_are(void **state)
{
	(void)state;
	u32 n = 0;
	for (u32 e = 0; e < 31; e++) {
		for (u32 m = 0; m < 1024; m++) {
			f32 x = (f32)(e == 0 ? ldexp(m, -24) : ldexp(1024 + m, (int)e - 25));
			assert_int_equal(ts_f2u(ts_half(x)), ts_f2u(x));
			assert_int_equal(ts_f2u(ts_half(-x)), ts_f2u(-x));
			n++;
		}
	}
	assert_int_equal(n, 31744);
	assert_true(isnan(ts_half(ts_u2f(0x7fc00000u))));
	assert_true(isinf(ts_half(65520)) && ts_half(ts_u2f(0x477fefffu)) < 65505);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(every_tail_rounds_as_double_does),
	                                   cmocka_unit_test(halves_stay_what_they_are)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
