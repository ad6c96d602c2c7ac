/* Decimal numbers are read with a point, and to the last bit, whatever the locale of the host program. */
#include <float.h>
#include <math.h>
#include "model/decimal.h"
#include "tests/comma.h"

static void check(void)
{
	static const char *const texts[] = {"0.1", "-2.5e-3", "16777217", "3.4028235e38", "1e-45", "7", "1e39"};
	static const float right[] = {0.1f, -2.5e-3f, 16777216.0f, FLT_MAX, 0x1p-149f, 7.0f, INFINITY};
	char *end;
	for (unsigned i = 0; i < sizeof texts / sizeof *texts; i++) {
		assert_true(ts_strtof(texts[i], &end) == right[i] && *end == 0);
		assert_true((float)ts_strtod(texts[i], NULL) == right[i]);
	}
	assert_true(ts_strtod("0.1", NULL) == 0.1);
	assert_true(ts_strtof("0,5", &end) == 0 && *end == ',');
	assert_true(ts_strtod("x", &end) == 0 && *end == 'x');
}

static void decimals_have_a_point_in_any_locale(void **state)
{
	(void)state;
	check();
	comma_begin();
	check();
	assert_true(strtod("0,5", NULL) == 0.5);
	comma_end();
}

static void typed_numbers_have_no_blank_and_no_letter_but_e(void **state)
{
	(void)state;
	static const char *const plain[] = {"1", "-1", "+1", "1e9", "1E-9", ".5"}, *const others[] = {
																				   "",    " 1", "1 ",  "0x10", "inf",
																				   "nan", "1f", "1,5", "0x1p4"};
	for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
		assert_true(ts_decimal_plain(plain[i], plain[i] + strlen(plain[i])));
	for (size_t i = 0; i < sizeof others / sizeof *others; i++)
		assert_false(ts_decimal_plain(others[i], others[i] + strlen(others[i])));
	assert_true(ts_decimal_plain("1 2", "1 2" + 1));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(decimals_have_a_point_in_any_locale),
		cmocka_unit_test(typed_numbers_have_no_blank_and_no_letter_but_e),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
