/* Display values by the table equal ts_srgb_byte: at each threshold and around it, at the ends of each place of the
 * table, at infinity, NaN and negative numbers, and of random bits. */
#include "backends/c/raster/srgb_table.h"
#include "tests/kernels/seeded.h"

static ts_srgb_table table;

static void check(u32 number)
{
	f32 l = ts_u2f(number);
	if (ts_srgb_find(&table, l) != ts_srgb_byte(l)) fail_msg("%a: %u", (double)l, ts_srgb_find(&table, l));
}

static void check_around(u32 number)
{
	for (u32 k = 0; k < 9; k++) check(number - 4 + k);
}

static void the_table_equals_the_search(void **state)
{
	(void)state;
	ts_srgb_table_make(&table);
	for (u32 i = 0; i < 255; i++) check_around(ts_f2u(ts_srgb_threshold[i]));
	for (u32 i = 0; i <= TS_SRGB_PLACES; i++) check_around(TS_SRGB_LEAST + (i << TS_SRGB_SHIFT));
	for (u32 i = 0; i < 16; i++) check_around(i << 28);
	check_around(0x7f800000);
	check_around(0xff800000);
	for (u32 i = 0; i < 1000000; i++) check(bits());
	for (u32 i = 0; i < 1000000; i++) check(ts_f2u(uniform(0, 1.1f)));
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(the_table_equals_the_search)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
