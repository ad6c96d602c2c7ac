/* The prototype's rows of more and of deeper octrees, larger maps, and views anywhere (FIGURES 11). */
#include "tests/methods/views/prototype.h"

/* In the air, all looking up. */
static grove_place air(void)
{
	double x = 0.05 + 0.9 * grove_uniform(), y = 0.05 + 0.9 * grove_uniform(), z = 0.05 + 0.9 * grove_uniform();
	return (grove_place){grove_v3(x, y, z), {0, 0, 1}};
}

static void deep_octrees_repeat_the_prototype(void **state)
{
	static const prototype_row rows[] = {
		{7, 16, 16384, grove_floor, TS_VIEW_FIELD_HALF, 7608328, 17.50, 19.63, 15.13, 92.76, 98.68},
		{7, 16, 4096, grove_surface, TS_VIEW_FIELD_HALF, 27685533, 0.93, 1.29, 7.63, 92.96, 98.57},
		{7, 16, 4096, air, TS_VIEW_FIELD_ALL, 39371199, 0.87, 1.10, 2.73, 93.39, 98.71},
		{9, 16, 1024, grove_floor, TS_VIEW_FIELD_HALF, 6762791, 1.55, 1.95, 6.61, 87.04, 95.96},
		{9, 16, 4096, grove_floor, TS_VIEW_FIELD_HALF, 17409636, 2.43, 2.98, 9.76, 87.21, 96.05},
		{9, 32, 1024, grove_floor, TS_VIEW_FIELD_HALF, 30192572, 1.27, 1.50, 5.61, 95.91, 99.11},
		{9, 64, 1024, grove_floor, TS_VIEW_FIELD_HALF, 131737640, 1.02, 1.20, 5.22, 98.30, 99.83},
	};
	(void)state;
	prototype_check_rows(rows, sizeof rows / sizeof *rows);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(deep_octrees_repeat_the_prototype)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
