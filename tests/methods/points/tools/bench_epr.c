/* What tables of EPR look at beside counters: how large mirrors are in the picture, in closed form of their boxes. */
#include <math.h>
#include "methods/points/tools/benches.h"
#include "tests/model/test.h"

enum { MIRRORS = 4 };

/* An eye in the origin that looks along -z: what is at depth z is focal / z times as large in the picture. */
static void fill(ts_run *run)
{
	ts_view *eye = ts_frame_make1(&run->frame, TS_B_eye_view, 1);
	ts_face *cubes = ts_frame_make1(&run->frame, TS_B_cube_size_face, MIRRORS);
	assert_true(eye != NULL && cubes != NULL);
	*eye = (ts_view){.right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}, .focal = 100, .near = 0.01f};
	eye->width = 320;
	eye->height = 240;
	memset(cubes, 0, MIRRORS * sizeof *cubes);
	cubes[0] = (ts_face){.box_min = {-3, -1, -9}, .box_max = {5, 1, -4}, .n = 200}; /* 8 wide, 4 away */
	cubes[1] = (ts_face){.box_min = {-90, -90, -91}, .box_max = {90, 90, -1}};      /* out of sight */
	cubes[2] = (ts_face){.box_min = {1, -2, -8}, .box_max = {2, 7, -5}, .n = 16};   /* 9 high, 5 away */
	cubes[3] = (ts_face){.box_min = {6, 2, -25}, .box_max = {10, 6, -20}, .n = 16}; /* from 6 / 25 to 10 / 20 */
}

static void mirrors_are_as_large_as_their_boxes_in_the_picture(void **state)
{
	(void)state;
	const ts_paper_table *const tables[] = {&ts_epr_1, &ts_epr_2};
	ts_run run = {0};
	fill(&run);
	ts_face *cubes = ts_frame_data(&run.frame, TS_B_cube_size_face);
	for (u32 i = 0; i < 2; i++) {
		double right = (800 / 4.0 + 900 / 5.0 + fmax(1000 / 20.0 - 600 / 25.0, 600 / 20.0 - 200 / 25.0)) / 3;
		fill(&run);
		assert_float_equal(tables[i]->look(&run), right, 1e-4);
		for (u32 r = 0; r < 3; r++) cubes[r].n = 0;
		assert_float_equal(tables[i]->look(&run), 26, 1e-4);
		cubes[3].n = 0;
		assert_true(isnan(tables[i]->look(&run)));
	}
	ts_frame_clear(&run.frame);
}

static void a_method_without_cubes_has_no_size(void **state)
{
	(void)state;
	ts_run run = {0};
	assert_true(isnan(ts_epr_1.look(&run)));
	fill(&run);
	ts_frame_drop(&run.frame, TS_B_cube_size_face);
	assert_true(isnan(ts_epr_1.look(&run)));
	ts_frame_clear(&run.frame);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(mirrors_are_as_large_as_their_boxes_in_the_picture),
		cmocka_unit_test(a_method_without_cubes_has_no_size),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
