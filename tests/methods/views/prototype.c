/* Whole maps show what each view by itself would, as often as in the prototype (FIGURES 11). */
#include "tests/methods/views/prototype.h"

static void whole_maps_repeat_the_prototype(void **state)
{
	static const prototype_row rows[] = {
		{7, 16, 256, grove_floor, TS_VIEW_FIELD_HALF, 1704665, 1.22, 1.51, 6.98, 92.58, 98.69},
		{7, 16, 4096, grove_floor, TS_VIEW_FIELD_HALF, 6502386, 5.12, 5.82, 13.92, 92.76, 98.69},
	};
	(void)state;
	prototype_check_rows(rows, sizeof rows / sizeof *rows);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(whole_maps_repeat_the_prototype)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
