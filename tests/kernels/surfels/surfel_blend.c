/* The bound of the sums of surfels (CONTRACT rule 30): no term is above 2^31 - 1, whatever the surfel, and 2^32 - 1 of
 * these still have room; more surfels are refused. */
#include <inttypes.h>
#include "kernels/surfels/surfel_blend.h"
#include "kernels/surfels/surfel_setup.h"
#include "methods/stages.h"
#include "tests/methods/small.h"

enum { N = 20000 };

typedef struct {
	i64 sums[TS_BLEND_SUMS];
	u64 heaviest;
} target;

static void add(target *to, const ts_surfel *surfel, const ts_disc *disc, f32 weight)
{
	ts_surfel_blend_args args = {.sums = to->sums, .heaviest = &to->heaviest};
	ts_attributes attributes = ts_k_attributes(surfel, disc);
	ts_k_blend_add(&args, 0, 0, &attributes, weight);
}

/* Surfels of all sizes and directions, seen from where they face; colours of any number. */
static void no_term_is_above_its_bound(void **state)
{
	(void)state;
	i64 greatest = 0;
	u32 n_drawn = 0;
	const ts_view eye = {.eye = {0, 0, 4},
	                     .focal = 100,
	                     .right = {1, 0, 0},
	                     .width = 64,
	                     .up = {0, 1, 0},
	                     .height = 64,
	                     .back = {0, 0, 1},
	                     .near = 0.001f};
	const ts_filter filter = {.filter = TS_FILTER_MIN, .per_sigma2 = 1, .reach = 1, .fall = 2, .object2 = 0.25f};
	ts_camera_k view = ts_k_view(&eye);
	for (u32 i = 0; i < N; i++) {
		ts_disc disc;
		ts_surfel s = {.centre = {0, 0, 0}};
		ts_v3 r[2];
		for (u32 k = 0; k < 2; k++) {
			u32 at = 6 * i + 3 * k;
			r[k] = ts_v3_make(ts_uniform(ts_random(at, 6, 51)) - 0.5f, ts_uniform(ts_random(at + 1, 6, 51)) - 0.5f,
			                  ts_uniform(ts_random(at + 2, 6, 51)) - 0.5f);
		}
		ts_v3 u = ts_normalize(r[0]), v = ts_normalize(ts_cross(r[1], u));
		ts_store3(s.u, ts_scale(u, ldexpf(1, (int)(i % 9) - 8)));
		ts_store3(s.v, ts_scale(v, ldexpf(1, (int)(i / 9 % 9) - 8)));
		for (u32 k = 0; k < 3; k++) s.colour[k] = (ts_uniform(ts_random(3 * i + k, 6, 52)) - 0.5f) * 1e6f;
		if (ts_k_disc(&disc, &view, &filter, &s) != TS_DISC_DRAWN) continue;
		target to = {.heaviest = TS_EMPTY};
		add(&to, &s, &disc, 1);
		for (u32 k = 0; k <= TS_BLEND_WEIGHT; k++)
			greatest = llabs(to.sums[k]) > greatest ? llabs(to.sums[k]) : greatest;
		n_drawn++;
	}
	print_message("# the greatest of %u surfels' terms is 2^30 and %" PRId64 "\n", n_drawn, greatest - (1 << 30));
	assert_true(n_drawn > N / 3);
	assert_in_range(greatest, 1 << 30, (1 << 30) + (1 << 8));
}

/* The last of them, each the largest that ts_fix gives. */
static void sums_have_room_for_the_most_surfels(void **state)
{
	(void)state;
	const i64 most = INT32_MAX, others = ((i64)TS_NONE - 1) * most;
	const ts_surfel s = {.colour = {1, 1, 1}};
	const ts_disc disc = {.normal = {8, -8, 0}};
	target to = {.sums = {others, others, others, others, -others, 0, others, TS_NONE - 1}, .heaviest = TS_EMPTY};
	add(&to, &s, &disc, 8);
	for (u32 k = 0; k < 4; k++) assert_true(to.sums[k] == others + most);
	assert_true(to.sums[4] == -(others + most) && to.sums[5] == 0 && to.sums[6] == others + most &&
	            to.sums[7] == TS_NONE);
}

static void more_surfels_than_sums_hold_are_refused(void **state)
{
	(void)state;
	ts_run run;
	const ts_surfel one = {.colour = {1, 1, 1}};
	ts_params params = small_params(16, 16);
	ts_scene *scene = small_scene(&params);
	ts_run_begin(&run, scene, &params, 1);
	ts_frame_borrow(&run.frame, TS_B_scene_surfel, &one, (u64)1 << 32);
	ts_run_set_size(&run, TS_DIM_surfels, (u64)1 << 32);
	assert_int_equal(ts_run_stage(&run, ts_stage_find("surfel_blend")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "4294967296 surfels are more than"));
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(no_term_is_above_its_bound),
	                                   cmocka_unit_test(sums_have_room_for_the_most_surfels),
	                                   cmocka_unit_test(more_surfels_than_sums_hold_are_refused)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
