/* Display values: the thresholds against the definition in long double, and the search against a count. */
#include "kernels/base/srgb.h"
#include "tests/model/test.h"
#include "tests/srgb.h"

/* The least float not below the exact boundary between two codes. */
static void thresholds_are_the_least_floats(void **state)
{
	(void)state;
	for (u32 k = 1; k < 256; k++) {
		long double exact = srgb_decoded((k - 0.5L) / 255.0L);
		f32 t = ts_srgb_threshold[k - 1];
		assert_true((long double)t >= exact * (1.0L - 1e-17L));
		assert_true((long double)ts_u2f(ts_f2u(t) - 1) < exact);
	}
}

static void the_search_counts_thresholds_below(void **state)
{
	(void)state;
	for (u32 k = 1; k < 256; k++) {
		f32 t = ts_srgb_threshold[k - 1];
		assert_int_equal(ts_srgb_byte(t), k);
		assert_int_equal(ts_srgb_byte(ts_u2f(ts_f2u(t) - 1)), k - 1);
	}
	for (u32 i = 0; i < 100000; i++) {
		f32 l = ts_uniform(ts_random(i, 6, 2)) * 1.25f;
		u32 count = 0;
		for (u32 k = 0; k < 255; k++) count += l >= ts_srgb_threshold[k];
		assert_int_equal(ts_srgb_byte(l), count);
	}
}

/* Each code's own linear value displays as that code. */
static void each_code_displays_as_itself(void **state)
{
	(void)state;
	for (u32 k = 0; k < 256; k++) assert_int_equal(ts_srgb_byte((f32)srgb_decoded(k / 255.0L)), k);
}

static void extremes_and_nan_display_as_end_codes(void **state)
{
	(void)state;
	assert_int_equal(ts_srgb_byte(0.0f), 0);
	assert_int_equal(ts_srgb_byte(-1.0f), 0);
	assert_int_equal(ts_srgb_byte(-INFINITY), 0);
	assert_int_equal(ts_srgb_byte(NAN), 0);
	assert_int_equal(ts_srgb_byte(INFINITY), 255);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(thresholds_are_the_least_floats),
		cmocka_unit_test(the_search_counts_thresholds_below),
		cmocka_unit_test(each_code_displays_as_itself),
		cmocka_unit_test(extremes_and_nan_display_as_end_codes),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
