/* Texels against rays: a slanted floor whose depths are known, right, missing, too deep and too near, in each kind of
 * buffer. */
#include <math.h>
#include "kernels/points/scatter.h"
#include "methods/points/tools/tools.h"
#include "tests/model/test.h"
#include "tests/truth/world.h"

enum { SIDE = 32 };

static const f32 slope = 0.5f; /* the floor is at z = 4 + slope * x ahead */

/* Two views of a floor that faces them; over the left quarter of it hangs something with a mask. */
static world *world_new(bool parallel)
{
	world *w = malloc(sizeof *w);
	assert_non_null(w);
	world_begin(w);
	ts_v3 a = ts_v3_make(-8, -8, -4 + slope * 8), b = ts_v3_make(8, -8, -4 - slope * 8);
	ts_v3 c = ts_v3_make(8, 8, -4 - slope * 8), d = ts_v3_make(-8, 8, -4 + slope * 8);
	world_quad(w, a, b, c, d, ONE_SIDED, 0);
	world_quad(w, ts_v3_make(-8, -8, -1), ts_v3_make(-0.5f, -8, -1), ts_v3_make(-0.5f, 8, -1), ts_v3_make(-8, 8, -1),
	           UNCUT, 0);
	world_pose(w);
	ts_offscreen *views = ts_frame_make1(&w->run.frame, TS_B_offscreen_view, 2);
	for (u32 v = 0; v < 2; v++) {
		views[v] = (ts_offscreen){.focal = SIDE / 2.0f,
		                          .right = {1, 0, 0},
		                          .up = {0, 1, 0},
		                          .back = {0, 0, 1},
		                          .near = 0.01f,
		                          .width = SIDE,
		                          .height = SIDE,
		                          .reach = {1, 1},
		                          .orthographic = parallel,
		                          .offset = v * SIDE * SIDE,
		                          .object = TS_NONE};
	}
	w->run.plan.units = w->run.n_units = 2;
	return w;
}

/* Depth of the floor in a column: z = 4 + slope x, where x is z times the tangent, or orthographic the tangent
 * itself. */
static double floor_at(u32 column, bool parallel)
{
	double tangent = (column + 0.5 - SIDE / 2) / (SIDE / 2.0);
	return parallel ? 4 + (double)slope * tangent : 4 / (1 - (double)slope * tangent);
}

/* Only the columns beyond the masked one count. */
static bool counts(u32 column) { return (column + 0.5 - SIDE / 2) / (SIDE / 2.0) > -0.5; }

static ts_texel_counts judge(world *w, ts_buffer_id id)
{
	ts_truth *truth;
	ts_texel_counts c = {0};
	assert_int_equal(ts_truth_new(&truth, &w->run), TS_OK);
	assert_int_equal(ts_truth_texels(&c, truth, &w->run, id), TS_OK);
	ts_truth_free(truth);
	return c;
}

static void assert_counts(ts_texel_counts c, u64 holes, u64 leaks, u64 apart)
{
	u64 covered = 0;
	for (u32 x = 0; x < SIDE; x++) covered += counts(x) ? 2 * SIDE : 0;
	assert_int_equal(c.covered, covered);
	assert_int_equal(c.holes, holes);
	assert_int_equal(c.leaks, leaks);
	assert_int_equal(c.apart, apart);
}

/* In the second view: nothing, far behind, far in front; and half a texel aside on the floor, which is right. */
static void check_depths(bool parallel)
{
	world *w = world_new(parallel);
	u32 *depth = ts_frame_make1(&w->run.frame, TS_B_depth_map_depth, 2 * SIDE * SIDE);
	for (u32 i = 0; i < 2 * SIDE * SIDE; i++) depth[i] = ts_f2u((f32)floor_at(i % SIDE, parallel));
	assert_counts(judge(w, TS_B_depth_map_depth), 0, 0, 0);
	u32 *second = depth + SIDE * SIDE;
	second[5 * SIDE + 20] = TS_NONE;
	second[6 * SIDE + 21] = ts_f2u(40);
	second[7 * SIDE + 22] = ts_f2u(1);
	second[8 * SIDE + 23] = ts_f2u((f32)(floor_at(23, parallel) + floor_at(24, parallel)) * 0.5f);
	second[9 * SIDE] = TS_NONE; /* under the mask */
	assert_counts(judge(w, TS_B_depth_map_depth), 1, 1, 2);
	w->run.first_unit = 1; /* the second batch alone: the same texels are its first */
	w->run.n_units = 1;
	memmove(depth, second, SIDE * SIDE * sizeof *depth);
	ts_texel_counts c = judge(w, TS_B_depth_map_depth);
	assert_true(c.holes == 1 && c.leaks == 1 && c.apart == 2);
	ts_run_end(&w->run);
	free(w);
}

static void wrong_depths_are_counted_by_their_kind(void **state)
{
	(void)state;
	check_depths(false);
	check_depths(true);
}

/* Without a bias all that a texel may hold is what its triangle does within half a texel: that is right, and more is
 * not. */
static void depth_within_half_a_texel_is_right(void **state)
{
	(void)state;
	world *w = world_new(false);
	w->run.params.depth_map_bias = w->run.params.depth_map_bias_slope = 0;
	u32 *depth = ts_frame_make1(&w->run.frame, TS_B_depth_map_depth, 2 * SIDE * SIDE);
	for (u32 i = 0; i < 2 * SIDE * SIDE; i++) {
		double tangent = (i % SIDE + 0.5 - SIDE / 2 + (i < SIDE * SIDE ? 0.499 : 0.51)) / (SIDE / 2.0);
		depth[i] = ts_f2u((f32)(4 / (1 - (double)slope * tangent)));
	}
	ts_texel_counts c = judge(w, TS_B_depth_map_depth);
	assert_int_equal(c.holes, 0);
	assert_int_equal(c.leaks, c.covered / 2);
	assert_int_equal(c.apart, c.covered);
	ts_run_end(&w->run);
	free(w);
}

/* Environment maps tell radial distances, in steps. */
static void environment_maps_tell_radial_distances(void **state)
{
	(void)state;
	world *w = world_new(false);
	u32 *colour = ts_frame_make1(&w->run.frame, TS_B_scatter_colour, 2 * SIDE * SIDE);
	for (u32 i = 0; i < 2 * SIDE * SIDE; i++) {
		double x = (i % SIDE + 0.5 - SIDE / 2) / (SIDE / 2.0), y = (i / SIDE % SIDE + 0.5 - SIDE / 2) / (SIDE / 2.0);
		double distance = floor_at(i % SIDE, false) * sqrt(1 + x * x + y * y);
		colour[i] = ts_k_depth_code((f32)distance, 0.01f) << 19 | 0x12345;
	}
	assert_counts(judge(w, TS_B_scatter_colour), 0, 0, 0);
	colour[20] = TS_NONE;
	colour[21] = ts_k_depth_code(40, 0.01f) << 19;
	colour[22] = ts_k_depth_code(1, 0.01f) << 19;
	assert_counts(judge(w, TS_B_scatter_colour), 1, 1, 2);
	ts_run_end(&w->run);
	free(w);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(wrong_depths_are_counted_by_their_kind),
		cmocka_unit_test(depth_within_half_a_texel_is_right),
		cmocka_unit_test(environment_maps_tell_radial_distances),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
