/* False colours: the ramp grows lighter throughout, and neighbouring names differ. */
#include <math.h>
#include "image/falsecolour.h"
#include "tests/model/test.h"

static int lightness(const uint8_t rgb[3]) { return 2126 * rgb[0] + 7152 * rgb[1] + 722 * rgb[2]; }

static void the_ramp_grows_lighter(void **state)
{
	(void)state;
	int last = -1;
	for (int i = 0; i <= 200; i++) {
		uint8_t rgb[3];
		ts_falsecolour_ramp(rgb, i / 200.0);
		assert_true(lightness(rgb) >= last - 7152); /* one step of rounding */
		last = lightness(rgb);
	}
	assert_true(last > 2000000);
}

static void the_ramp_is_clamped(void **state)
{
	(void)state;
	uint8_t low[3], high[3], rgb[3];
	ts_falsecolour_ramp(low, 0);
	ts_falsecolour_ramp(high, 1);
	ts_falsecolour_ramp(rgb, -5);
	assert_memory_equal(rgb, low, 3);
	ts_falsecolour_ramp(rgb, NAN);
	assert_memory_equal(rgb, low, 3);
	ts_falsecolour_ramp(rgb, INFINITY);
	assert_memory_equal(rgb, high, 3);
}

static void neighbouring_names_differ_in_colour(void **state)
{
	(void)state;
	int near = 0;
	for (uint32_t i = 0; i < 10000; i++) {
		uint8_t a[3], b[3];
		ts_falsecolour_name(a, i);
		ts_falsecolour_name(b, i + 1);
		near += abs(a[0] - b[0]) + abs(a[1] - b[1]) + abs(a[2] - b[2]) < 24;
		int weak = 0;
		for (int c = 0; c < 3; c++) {
			weak += a[c] < 128;
			assert_true(a[c] >= 128 || (a[c] >= 16 && a[c] < 80));
		}
		assert_int_equal(weak, 1);
	}
	assert_true(near < 200);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_ramp_grows_lighter),
		cmocka_unit_test(the_ramp_is_clamped),
		cmocka_unit_test(neighbouring_names_differ_in_colour),
	};
	return cmocka_run_group_tests_name("falsecolour", tests, NULL, NULL);
}
