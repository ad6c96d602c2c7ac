/* The two octrees of MegaViews, from the scene to the cones of the views: the same bits on any number of threads;
 * leaves that hold just their triangles; surfaces; every stage from what it claims to read. */
#include <math.h>
#include "kernels/views/voxel.h"
#include "tests/methods/views/octrees.h"

static void threads_change_no_octree(void **state)
{
	(void)state;
	static ts_sums one, seven;
	ts_params params = octrees_params(6, 1000);
	params.vpl_bounces = 4;
	ts_scene *scene = small_scene(&params);
	octrees_sums(&one, scene, &params, 1, NULL);
	octrees_sums(&seven, scene, &params, 7, NULL);
	octrees_assert_same(&one, &seven);
	ts_scene_free(scene);
}

static bool is_listed(const u32 *offset, const u32 *entries, u32 leaf, u32 triangle)
{
	for (u32 k = offset[leaf]; k < offset[leaf + 1]; k++) {
		if (entries[k] == triangle) return true;
	}
	return false;
}

/* Every leaf lists triangles in order, each once, and those whose corner it holds are there. */
static void every_leaf_lists_its_triangles_in_order(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = octrees_params(6, 0);
	ts_scene *scene = small_scene(&params);
	octrees_run(&run, scene, &params);
	const u32 *offset = ts_frame_data(&run.frame, TS_B_octree_offset);
	const u32 *entries = ts_frame_data(&run.frame, TS_B_octree_triangle);
	const u32 *before = ts_frame_data(&run.frame, TS_B_voxel_before),
			  *level = ts_frame_data(&run.frame, TS_B_octree_level);
	const u64 *mask = ts_frame_data(&run.frame, TS_B_voxel_mask);
	const ts_root *root = ts_frame_data(&run.frame, TS_B_octree_root);
	u64 n_leaves = ts_frame_n(&run.frame, TS_B_octree_offset) - 1;
	assert_int_equal(n_leaves, level[7] - level[6]);
	assert_int_equal(offset[n_leaves], ts_frame_n(&run.frame, TS_B_octree_triangle));
	for (u64 i = 0; i < n_leaves; i++) {
		assert_true(offset[i] < offset[i + 1]);
		for (u32 k = offset[i] + 1; k < offset[i + 1]; k++) assert_true(entries[k - 1] < entries[k]);
	}
	const ts_arrays arrays = ts_run_arrays(&run);
	for (u32 t = 0; t < scene->n_triangles; t++) {
		ts_corners corners = ts_k_corners(&arrays, t);
		if (ts_k_is_degenerate(corners.n) || ts_k_is_masked(&arrays, t)) continue;
		u64 code = ts_k_morton(ts_k_voxel_of(root, 6, corners.b));
		u64 word = ts_k_mask_word(6, code);
		assert_true((mask[word] & ts_k_mask_bit(code)) != 0);
		assert_true(is_listed(offset, entries, ts_k_mask_id(mask, before, 6, code) - level[6], t));
	}
	assert_int_equal(ts_run_counter(&run, "scene leaves"), n_leaves);
	assert_int_equal(ts_run_counter(&run, "scene nodes"), level[7]);
	ts_run_end(&run);
	ts_scene_free(scene);
}

enum { N_MEANS = sizeof(ts_node_surface) / sizeof(f32) };

/* Base colours are those of materials; inner nodes are means of their children. */
static void inner_nodes_are_means_of_their_children(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = octrees_params(5, 0);
	ts_scene *scene = small_scene(&params);
	octrees_run(&run, scene, &params);
	const ts_node *nodes = ts_frame_data(&run.frame, TS_B_octree_node);
	const ts_node_surface *surfaces = ts_frame_data(&run.frame, TS_B_octree_surface);
	u64 n = ts_frame_n(&run.frame, TS_B_octree_node);
	u32 n_coloured = 0;
	for (u64 i = 0; i < n; i++) {
		f32 own[N_MEANS], of_child[N_MEANS];
		double mean[N_MEANS] = {0};
		u32 children = ts_k_count_bits(nodes[i].children);
		for (u32 k = 0; k < 3; k++) {
			assert_true(surfaces[i].base[k] >= 0 && surfaces[i].base[k] <= 1);
			assert_true(fabsf(surfaces[i].normal[k]) <= 1.000001f);
		}
		memcpy(own, &surfaces[i], sizeof own);
		for (u32 c = 0; c < children; c++) {
			memcpy(of_child, &surfaces[nodes[i].child + c], sizeof of_child);
			for (u32 k = 0; k < N_MEANS; k++) mean[k] += (double)of_child[k] / children;
		}
		for (u32 k = 0; k < N_MEANS && children > 0; k++) assert_true(fabs(mean[k] - (double)own[k]) < 1e-6);
		n_coloured += surfaces[i].base[0] != surfaces[i].base[1];
	}
	assert_true(n_coloured > n / 10);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Every stage again from a frame where all that it does not claim to read is zero. */
static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	for (u32 place = TS_VPL_AT_LIGHT; place <= TS_VPL_AT_RANDOM; place++) {
		ts_run run;
		ts_params params = octrees_params(5, 200);
		params.vpl_bounces = 2;
		params.vpl_place = place;
		ts_scene *scene = small_scene(&params);
		octrees_run(&run, scene, &params);
		for (u32 i = 0; i < run.n_timings; i++) small_assert_claims(&run, ts_stage_find(run.timings[i].stage));
		ts_run_end(&run);
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_change_no_octree),
		cmocka_unit_test(every_leaf_lists_its_triangles_in_order),
		cmocka_unit_test(inner_nodes_are_means_of_their_children),
		cmocka_unit_test(stages_read_only_what_they_claim),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
