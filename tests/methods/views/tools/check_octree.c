/* Checks of MegaViews, of its octrees and pairs: faults in what its stages read, planted in buffers of a run. */
#include "kernels/views/mask.h"
#include "methods/views/pipelines.h"
#include "tests/replay/loaded.h"

static const ts_step steps[] = {
	{.stage = "eye.view"},
	{.stage = "pose"},
	{.stage = "lamp"},
	{.stage = "rsm.view"},
	{.stage = "rsm"},
	{.stage = "rsm.patch"},
	{.stage = "octree.root"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree.surface"},
	{.stage = "vpl"},
	{.stage = "view_octree.voxel"},
	{.stage = "view_octree"},
	{.stage = "view_octree.cone"},
	{.stage = "traverse"},
	{.stage = "view_map"},
	{.stage = "view_map.fuse"},
	{.stage = "eye"},
	{.stage = "gbuffer"},
	{.stage = "vpl_gather.pairs"},
	{.stage = "vpl_gather"},
	{.stage = "bilateral"},
	{0},
};
static const ts_pipeline pipeline = {
	.name = "octrees",
	.effect = &ts_effect_indirect,
	.steps = steps,
	.plan = ts_views_plan,
	.expect = ts_indirect_expect,
};
enum { LEVELS = 4, LIGHTS = 200 };

static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(64, 48);
	params.reflectors_count = 0;
	params.octree_levels = LEVELS;
	params.vpl_paths = LIGHTS;
	params.vpl_bounces = 2;
	params.vpl_gather_level = 2;
	loaded_run(&pipeline, &params);
	return 0;
}

/* Every index of what these stages make, where one of them reads it. */
static void every_index_beyond_its_size_is_refused(void **state)
{
	(void)state;
	u32 n_tested = 0;
	size_t n_indices;
	const ts_index_info *indices = ts_index_table(&n_indices);
	for (size_t row = 0; row < n_indices; row++) {
		ts_buffer_id id = indices[row].buffer;
		for (const ts_step *step = steps; step->stage != NULL; step++) {
			ts_load load;
			const ts_stage *stage = ts_stage_find(step->stage);
			bool made = ts_stage_reads(stage, id) && run.frame.buffer[id].made && ts_frame_n(&run.frame, id) > 0;
			if (!made || id < TS_B_octree_root_least) continue;
			load_for(&load, stage);
			assert_int_equal(ts_check(&load, stage), TS_OK);
			u64 size = ts_axis_size(&indices[row].of, &load.sizes);
			assert_true(size != TS_UNKNOWN);
			refuses(step->stage, id, ts_frame_n(&run.frame, id) - 1, indices[row].field, size);
			refuses(step->stage, id, 0, indices[row].field, 0xfffffffe);
			n_tested++;
		}
	}
	assert_true(n_tested >= 9);
}

/* Lists are written where bits say. */
static void masks_must_agree_with_their_sums(void **state)
{
	(void)state;
	const u64 *mask = ts_frame_data(&run.frame, TS_B_voxel_mask),
			  *views = ts_frame_data(&run.frame, TS_B_view_octree_voxel_mask);
	u64 last = ts_k_mask_first(LEVELS + 1) - 1;
	refuses("octree", TS_B_voxel_mask, last, "", ~mask[last]);
	refuses("octree", TS_B_voxel_mask, 0, "", 0);
	refuses("octree", TS_B_voxel_before, 3, "", 4000000000);
	refuses("octree", TS_B_voxel_before, last + 1, "", 0);
	refuses("view_octree", TS_B_view_octree_voxel_mask, last, "", views[last] ^ 1);
	refuses("view_octree", TS_B_view_octree_voxel_before, last, "", 0);
}

static void nodes_must_make_a_tree(void **state)
{
	(void)state;
	const u32 *level = ts_frame_data(&run.frame, TS_B_octree_level), leaf = level[LEVELS], n = level[LEVELS + 1];
	const ts_node *nodes = ts_frame_data(&run.frame, TS_B_octree_node);
	refuses("octree.surface", TS_B_octree_level, 0, "", 1);
	refuses("octree.surface", TS_B_octree_level, 2, "", 0);
	refuses("octree.surface", TS_B_octree_node, 0, "level", 1);
	refuses("octree.surface", TS_B_octree_node, 0, "children", 0);
	refuses("octree.surface", TS_B_octree_node, 0, "children", 256);
	refuses("octree.surface", TS_B_octree_node, leaf, "children", 1);
	refuses("octree.surface", TS_B_octree_node, leaf - 1, "children", 511);
	refuses("octree.surface", TS_B_octree_node, 0, "child", 0);
	refuses("octree.surface", TS_B_octree_node, 2, "child", nodes[1].child);
	refuses("octree.surface", TS_B_octree_node, leaf - 1, "child", n - 1);
	refuses("octree.surface", TS_B_octree_node, leaf, "child", leaf + 1);
	refuses("octree.surface", TS_B_octree_node, 0, "parent", 0);
	refuses("octree.surface", TS_B_octree_offset, 0, "", 1);
	refuses("octree.surface", TS_B_octree_offset, n - leaf, "", 0);
	refuses("vpl", TS_B_octree_node, leaf - 1, "children", 0);
	refuses("vpl", TS_B_octree_offset, 0, "", 1);
	refuses("view_octree.cone", TS_B_view_octree_offset, 1, "", 0);
	refuses("view_octree.cone", TS_B_view_octree_view, 0, "",
	        *(u32 *)ts_frame_data(&run.frame, TS_B_view_octree_view) ^ 1);
	refuses("view_octree.cone", TS_B_view_octree_node, 1, "child", 1);
}

/* A fault in the parent of a node shows where the parent's children are read. */
static void a_wrong_parent_shows_at_its_children(void **state)
{
	(void)state;
	ts_load load;
	ts_node *nodes = ts_frame_data(&run.frame, TS_B_view_octree_node);
	const u32 n = (u32)ts_frame_n(&run.frame, TS_B_view_octree_node);
	for (u32 i = 1; i < n; i += n / 7) {
		u32 kept = nodes[i].parent;
		nodes[i].parent = i % 2 == 0 ? i : TS_NONE;
		load_for(&load, ts_stage_find("view_octree.cone"));
		assert_int_equal(ts_check(&load, ts_stage_find("view_octree.cone")), TS_ERROR);
		nodes[i].parent = kept;
	}
}

/* As many leaves as there are, behind nodes that are not there. */
static void leaves_beyond_the_nodes_are_refused(void **state)
{
	(void)state;
	ts_load load;
	u32 *level = ts_frame_data(&run.frame, TS_B_octree_level);
	level[LEVELS]++;
	level[LEVELS + 1]++;
	load_for(&load, ts_stage_find("octree.surface"));
	assert_int_equal(ts_check(&load, ts_stage_find("octree.surface")), TS_ERROR);
	level[LEVELS]--;
	level[LEVELS + 1]--;
	assert_non_null(strstr(ts_error_message(), "octree.level: element 5"));
}

/* Both halves of a pair are indices; the maps are as large as view_map.px says. */
static void both_halves_of_pairs_are_nodes(void **state)
{
	(void)state;
	ts_load load;
	u64 n = ts_frame_n(&run.frame, TS_B_traverse_rendered), n_nodes = ts_frame_n(&run.frame, TS_B_octree_node);
	assert_true(n > 1000);
	refuses("view_map", TS_B_traverse_rendered, 0, "", n_nodes << 32);
	refuses("view_map", TS_B_traverse_rendered, n - 1, "", UINT64_MAX << 32);
	load_for(&load, ts_stage_find("view_map.fuse"));
	load.run.params.view_map_px *= 2;
	assert_int_equal(ts_check(&load, ts_stage_find("view_map.fuse")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "view_map.depth_node"));
}

/* What pixels draw is a view, and the voxel that they are in a node. */
static void drawn_views_must_be_in_their_lists(void **state)
{
	(void)state;
	const u32 *views = ts_frame_data(&run.frame, TS_B_vpl_gather_pair_views);
	const u32 *before = ts_frame_data(&run.frame, TS_B_voxel_before);
	const u32 *level = ts_frame_data(&run.frame, TS_B_octree_level);
	const u64 *mask = ts_frame_data(&run.frame, TS_B_voxel_mask);
	u64 n = ts_frame_n(&run.frame, TS_B_vpl_gather_pair_views),
		n_lists = ts_frame_n(&run.frame, TS_B_vpl_gather_pair_offset) - 1;
	u64 last = ts_frame_n(&run.frame, TS_B_voxel_before) - 1;
	refuses("vpl_gather", TS_B_vpl_gather_pair_views, n - 1, "", views[n - 1] + 1);
	refuses("vpl_gather", TS_B_vpl_gather_pair_views, 0, "", 0xffffffff);
	refuses("vpl_gather", TS_B_vpl_gather_pair_offset, 0, "", 1);
	refuses("vpl_gather", TS_B_vpl_gather_pair_offset, n_lists, "", n + 1);
	refuses("vpl_gather", TS_B_voxel_before, last, "", before[last] + 1);
	refuses("vpl_gather", TS_B_view_map_fused_node, 0, "", level[LEVELS + 1]);
	ts_load load;
	u64 *bits = ts_frame_data(&run.frame, TS_B_voxel_mask);
	bits[last - 1] = ~mask[last - 1];
	load_for(&load, ts_stage_find("vpl_gather"));
	ts_status status = ts_check(&load, ts_stage_find("vpl_gather"));
	bits[last - 1] = ~bits[last - 1];
	assert_int_equal(status, TS_ERROR);
	u32 *sums = ts_frame_data(&run.frame, TS_B_voxel_before); /* of another octree: one leaf fewer */
	u64 word = last - 1;
	while (mask[word] == 0) word--;
	u64 without = mask[word] & (mask[word] - 1), kept = mask[word];
	for (u64 i = word + 1; i <= last; i++) sums[i]--;
	bits[word] = without;
	refuses("vpl_gather", TS_B_octree_level, LEVELS + 1, "", level[LEVELS + 1]);
	bits[word] = kept;
	for (u64 i = word + 1; i <= last; i++) sums[i]++;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_is_loaded_is_right),
		cmocka_unit_test(every_index_beyond_its_size_is_refused),
		cmocka_unit_test(masks_must_agree_with_their_sums),
		cmocka_unit_test(nodes_must_make_a_tree),
		cmocka_unit_test(a_wrong_parent_shows_at_its_children),
		cmocka_unit_test(leaves_beyond_the_nodes_are_refused),
		cmocka_unit_test(both_halves_of_pairs_are_nodes),
		cmocka_unit_test(drawn_views_must_be_in_their_lists),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
