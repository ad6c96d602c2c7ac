/* The largest face that a table of iVIR prints. */
#include <math.h>
#include "methods/points/tools/benches.h"
#include "tests/model/test.h"

static void the_largest_face_is_that_of_any_cube(void **state)
{
	(void)state;
	enum { CUBES = 5 };
	ts_run run = {0};
	assert_true(isnan(ts_ivir_2.look(&run)));
	ts_face *cubes = ts_frame_make1(&run.frame, TS_B_cube_size_face, CUBES);
	assert_non_null(cubes);
	for (u32 largest = 0; largest < CUBES; largest++) {
		for (u32 i = 0; i < CUBES; i++) cubes[i] = (ts_face){.n = i == largest ? 77 : 16 + i};
		assert_true(ts_ivir_2.look(&run) == 77);
	}
	ts_frame_cut(&run.frame, TS_B_cube_size_face, 2);
	cubes = ts_frame_data(&run.frame, TS_B_cube_size_face);
	assert_true(ts_ivir_2.look(&run) == 17);
	ts_frame_cut(&run.frame, TS_B_cube_size_face, 0);
	assert_true(isnan(ts_ivir_2.look(&run)));
	ts_frame_clear(&run.frame);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(the_largest_face_is_that_of_any_cube)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
