/* Reflections by MegaViews: the same bits on any number of threads and by queues of any length; every stage from what
 * it claims to read; reflectors of nodes against a recursion, and none in its own view; pictures nearer to those of
 * rasterized cubes as octrees become deep. */
#include <math.h>
#include "kernels/base/morton.h"
#include "kernels/base/scene.h"
#include "methods/views/views.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

static ts_params tiny_params(u32 levels)
{
	ts_params params = small_params(80, 44);
	params.octree_levels = levels;
	params.cube_view_px = 32;
	params.reflectors_count = 3;
	return params;
}

static void sums_of(ts_sums *sums, const ts_scene *scene, const ts_params *params, u32 threads)
{
	const ts_how how = {.threads = threads};
	ts_status status = ts_sums_of(sums, ts_pipeline_find("reflections", "megaviews"), scene, params, &how);
	if (status != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(strlen(sums->hex[TS_B_view_map_colour]), 64);
}

static void threads_and_queues_change_no_bit(void **state)
{
	(void)state;
	static ts_sums one, seven, pieces;
	ts_params params = tiny_params(6);
	ts_scene *scene = small_scene(&params);
	sums_of(&one, scene, &params, 1);
	sums_of(&seven, scene, &params, 7);
	params.traverse_queue_mb = 1;
	sums_of(&pieces, scene, &params, 2);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		assert_string_equal(one.hex[id], seven.hex[id]);
		assert_string_equal(one.hex[id], pieces.hex[id]);
	}
	ts_scene_free(scene);
}

static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = tiny_params(5);
	params.reflectors_count = 1; /* one batch: what stages left is all that they made */
	ts_scene *scene = small_scene(&params);
	ts_run_begin(&run, scene, &params, 2);
	run.traced = run.margins = true;
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", "megaviews"), &run), TS_OK);
	for (u32 i = 0; i < run.n_timings; i++) small_assert_claims(&run, ts_stage_find(run.timings[i].stage));
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* The reflector of all triangles below a node, TS_NONE: of several, or of none. */
static u32 reflector_of(const ts_run *run, u32 node)
{
	const ts_arrays scene = ts_run_arrays(run);
	const ts_node *nodes = ts_frame_data(&run->frame, TS_B_octree_node);
	const u32 *level = ts_frame_data(&run->frame, TS_B_octree_level),
			  *offset = ts_frame_data(&run->frame, TS_B_octree_offset),
			  *triangles = ts_frame_data(&run->frame, TS_B_octree_triangle);
	u32 leaf = node - level[run->params.octree_levels], one = TS_NONE, n = ts_k_count_bits(nodes[node].children);
	for (u32 k = n == 0 ? offset[leaf] : 0; k < (n == 0 ? offset[leaf + 1] : n); k++) {
		u32 next = n == 0 ? ts_k_reflector_of(&scene, triangles[k]) : reflector_of(run, nodes[node].child + k);
		if (next == TS_NONE || (one != TS_NONE && next != one)) return TS_NONE;
		one = next;
	}
	return one;
}

/* No view shows its own reflector, and each shows others. */
static void check_own(const ts_run *run)
{
	const u32 *reflectors = ts_frame_data(&run->frame, TS_B_octree_reflector),
			  *shown = ts_frame_data(&run->frame, TS_B_view_map_fused_node),
			  *leaves = ts_frame_data(&run->frame, TS_B_view_octree_leaf);
	u32 n_texels = 2 * run->params.cube_view_px * run->params.cube_view_px;
	for (u32 view = 0; view < run->params.reflectors_count; view++) {
		u32 others = 0, walls = 0;
		for (u32 i = 0; i < n_texels; i++) {
			u32 node = shown[(u64)leaves[view] * n_texels + i];
			if (node == TS_NONE) continue;
			assert_true(reflectors[node] != view);
			others += reflectors[node] != TS_NONE;
			walls += reflectors[node] == TS_NONE;
		}
		assert_true(others > 10 && walls > n_texels / 4);
	}
}

static void no_view_shows_its_own_reflector(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = tiny_params(7);
	ts_scene *scene = small_scene(&params);
	small_run(&run, scene, &params, "megaviews", 2, NULL, NULL);
	const u32 *reflectors = ts_frame_data(&run.frame, TS_B_octree_reflector);
	u32 n = (u32)ts_frame_n(&run.frame, TS_B_octree_reflector), n_own = 0;
	for (u32 i = 0; i < n; i++) {
		assert_int_equal(reflectors[i], reflector_of(&run, i));
		n_own += reflectors[i] != TS_NONE;
	}
	assert_true(n_own > 100 && n_own < n / 2);
	check_own(&run);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Mean square of the difference of what mirrors show. */
static double apart(const ts_scene *scene, const ts_params *params)
{
	ts_run ours, theirs;
	double sum = 0;
	small_run(&ours, scene, params, "megaviews", 2, NULL, NULL);
	small_run(&theirs, scene, params, "mvr", 2, NULL, NULL);
	const f32 *a = ts_frame_data(&ours.frame, TS_B_shade_radiance),
			  *b = ts_frame_data(&theirs.frame, TS_B_shade_radiance);
	u64 n = ts_frame_n(&ours.frame, TS_B_shade_radiance);
	assert_true(n > 300 && n == ts_frame_n(&theirs.frame, TS_B_shade_radiance));
	for (u64 i = 0; i < n; i++) sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
	ts_run_end(&ours);
	ts_run_end(&theirs);
	return sum / (double)n;
}

static void deeper_octrees_come_nearer_to_cubes(void **state)
{
	(void)state;
	double before = INFINITY;
	for (u32 levels = 3; levels <= 7; levels += 2) {
		ts_params params = tiny_params(levels);
		params.cube_view_px = 64;
		ts_scene *scene = small_scene(&params);
		double now = apart(scene, &params);
		print_message("%u levels: %.4f\n", levels, now);
		assert_true(now < 0.7 * before);
		before = now;
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_and_queues_change_no_bit),
		cmocka_unit_test(stages_read_only_what_they_claim),
		cmocka_unit_test(no_view_shows_its_own_reflector),
		cmocka_unit_test(deeper_octrees_come_nearer_to_cubes),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
