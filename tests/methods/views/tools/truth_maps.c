/* Maps of virtual point lights against rays: by points coarse ones stop and let through more light wrongly than fine
 * ones, by the middles of texels they stop less of it than by points, and by distance they let more through than by the
 * plane; emptied or filled maps are found to be. */
#include "methods/views/tools/tools.h"
#include "tests/methods/small.h"

static ts_params params_of(u32 px)
{
	ts_params params = small_params(64, 40);
	params.reflectors_count = 0;
	params.rsm_px = 24;
	params.octree_levels = 7;
	params.vpl_paths = 80;
	params.view_map_px = px;
	params.view_map_texel = TS_TEXEL_POINT;
	params.view_map_multipixel = TS_MULTIPIXEL_TEXELS;
	return params;
}

static ts_texel_counts judge(const ts_run *run)
{
	ts_truth *truth;
	ts_texel_counts counts = {.asked = 0};
	assert_int_equal(ts_truth_new(&truth, run), TS_OK);
	assert_int_equal(ts_truth_maps(&counts, truth, run, TS_B_vpl_gather_irradiance), TS_OK);
	ts_truth_free(truth);
	print_message("%u texels, %u holes, %u leaks, %u apart; %u asked, %u lit, %u dark\n", (unsigned)counts.covered,
	              (unsigned)counts.holes, (unsigned)counts.leaks, (unsigned)counts.apart, (unsigned)counts.asked,
	              (unsigned)counts.lit, (unsigned)counts.dark);
	return counts;
}

static ts_texel_counts counts_of(const ts_scene *scene, const ts_params *params, u32 threads)
{
	ts_run run;
	ts_run_begin(&run, scene, params, threads);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("indirect", "megaviews"), &run), TS_OK);
	ts_texel_counts counts = judge(&run);
	ts_run_end(&run);
	return counts;
}

static void finer_maps_are_less_often_wrong(void **state)
{
	(void)state;
	ts_params coarse = params_of(16), fine = params_of(128), middle = coarse, distance = coarse;
	middle.view_map_texel = TS_TEXEL_MIDDLE;
	distance.vpl_gather_test = TS_SHADOW_TEST_DISTANCE;
	ts_scene *scene = small_scene(&coarse);
	ts_texel_counts a = counts_of(scene, &coarse, 2), b = counts_of(scene, &fine, 2);
	ts_texel_counts c = counts_of(scene, &distance, 1), d = counts_of(scene, &middle, 2);
	ts_texel_counts again = counts_of(scene, &coarse, 1);
	assert_memory_equal(&a, &again, sizeof a);
	assert_true(a.asked > 1000 && a.asked == b.asked && a.lit < c.lit / 2);
	assert_true(b.dark < a.dark * 4 / 5 && b.lit < a.lit * 4 / 5);
	assert_true(d.dark < a.dark * 3 / 5 && d.lit + d.dark < (a.lit + a.dark) * 9 / 10);
	ts_scene_free(scene);
}

/* Maps that show nothing let all light through, those that show what is at the light none; rays stay what they are. */
static void planted_maps_are_found_empty_or_full(void **state)
{
	(void)state;
	ts_params params = params_of(16);
	params.vpl_gather_test = TS_SHADOW_TEST_DISTANCE;
	params.depth_map_bias = params.depth_map_bias_slope = params.vpl_gather_bias = 0;
	ts_scene *scene = small_scene(&params);
	ts_run run;
	ts_run_begin(&run, scene, &params, 2);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("indirect", "megaviews"), &run), TS_OK);
	u32 *depths = ts_frame_data(&run.frame, TS_B_view_map_fused_depth),
		*shown = ts_frame_data(&run.frame, TS_B_view_map_fused_node);
	u64 n = ts_frame_n(&run.frame, TS_B_view_map_fused_depth);
	memset(depths, 0xff, n * sizeof *depths);
	memset(shown, 0xff, n * sizeof *shown);
	ts_texel_counts empty = judge(&run);
	assert_true(empty.holes == empty.covered && empty.leaks == 0 && empty.apart == 0 && empty.dark == 0);
	memset(depths, 0, n * sizeof *depths);
	memset(shown, 0, n * sizeof *shown);
	ts_texel_counts full = judge(&run);
	assert_true(full.holes == 0 && full.leaks == 0 && full.lit == 0 && full.apart > full.covered / 2);
	assert_true(full.covered == empty.covered && full.asked == empty.asked && full.dark + empty.lit == full.asked);
	f32 far = 1000;
	for (u64 i = 0; i < n; i++) depths[i] = ts_f2u(far);
	ts_texel_counts behind = judge(&run);
	assert_true(behind.leaks == behind.covered && behind.apart == behind.covered && behind.lit == empty.lit);
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(finer_maps_are_less_often_wrong),
	                                   cmocka_unit_test(planted_maps_are_found_empty_or_full)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
