/* The share of texels that no pair of nodes wrote, of the maps of leaves of views. */
#include <math.h>
#include "methods/views/tools/tools.h"
#include "tests/model/test.h"

enum { PX = 3, TEXELS = 2 * PX * PX, NODES = 4 };

static void only_maps_of_leaves_count_as_empty(void **state)
{
	(void)state;
	ts_run run = {0};
	run.plan.views.px = PX;
	assert_true(isnan(ts_views_codes[0].look(&run)));
	ts_node *nodes = ts_frame_make1(&run.frame, TS_B_view_octree_node, NODES);
	u32 *depths = ts_frame_make2(&run.frame, TS_B_view_map_fused_depth, NODES, TEXELS);
	assert_true(nodes != NULL && depths != NULL);
	for (u32 leaves = 1; leaves < 1u << NODES; leaves++) {
		u32 n = 0, empty = 0;
		for (u32 i = 0; i < NODES; i++) {
			bool leaf = (leaves >> i & 1) != 0;
			nodes[i] = (ts_node){.children = leaf ? 0 : 5};
			for (u32 k = 0; k < TEXELS; k++) depths[i * TEXELS + k] = k % (i + 2) == 0 ? TS_NONE : TS_NONE - 1;
			n += leaf ? TEXELS : 0;
			empty += leaf ? (TEXELS + i + 1) / (i + 2) : 0;
		}
		assert_float_equal(ts_views_codes[0].look(&run), 100.0 * empty / n, 1e-9);
	}
	ts_frame_clear(&run.frame);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(only_maps_of_leaves_count_as_empty)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
