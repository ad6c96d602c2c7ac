/* Checks of reflections by MegaViews: reflectors of nodes are indices of views, and every cube has a map. */
#include "tests/replay/loaded.h"

enum { MIRRORS = 1 }; /* one batch: what a run leaves is all of it */

static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(64, 48);
	params.reflectors_count = MIRRORS;
	params.octree_levels = 4;
	params.cube_view_px = 8;
	loaded_run(ts_pipeline_find("reflections", "megaviews"), &params);
	return 0;
}

static void reflectors_must_be_indices_of_views(void **state)
{
	(void)state;
	u64 n = ts_frame_n(&run.frame, TS_B_octree_reflector);
	refuses("view_map", TS_B_octree_reflector, 0, "", MIRRORS);
	refuses("view_map.margin", TS_B_octree_reflector, n - 1, "", 0xfffffffe);
	refuses("view_map.colour", TS_B_view_map_fused_node, 5, "", ts_frame_n(&run.frame, TS_B_octree_node));
}

static void every_cube_must_have_a_map(void **state)
{
	(void)state;
	ts_load load;
	const ts_stage *stage = ts_stage_find("cube_view.mip");
	ts_buffer *colours = &run.frame.buffer[TS_B_view_map_colour];
	ts_npy *npy = &trace.item[TS_B_view_map_colour].npy;
	load_for(&load, stage);
	assert_int_equal(ts_check(&load, stage), TS_OK);
	colours->n = npy->n = colours->n / MIRRORS * (MIRRORS - 1);
	colours->shape[0] = npy->shape[0] = MIRRORS - 1;
	load_for(&load, stage);
	assert_int_equal(ts_check(&load, stage), TS_ERROR);
	assert_string_equal(ts_error_message(), "view_map.colour: maps of 0 views; 1, one a cube, would be right");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_is_loaded_is_right),
		cmocka_unit_test(reflectors_must_be_indices_of_views),
		cmocka_unit_test(every_cube_must_have_a_map),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
