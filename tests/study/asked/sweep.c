/* Sweeps: every combination of the values stands once, the last parameter's values fastest; what there cannot be more
 * of is refused and changes nothing. */
#include <stdio.h>
#include <string.h>
#include "study/asked/sweep.h"
#include "tests/status.h"

static ts_params params;

static u32 added(ts_sweep *sweep, const char *name, const char *values)
{
	require(ts_sweep_add(sweep, &params, name, values));
	return ts_sweep_count(sweep);
}

static void combinations_go_by_the_last_parameter_first(void **state)
{
	(void)state;
	static const char *const seeds[] = {"1", "2", "3"}, *const sides[] = {"16", "32"}, *const scales[] = {"0.5", "1"};
	ts_sweep sweep = {.n = 0};
	assert_int_equal(ts_sweep_count(&sweep), 1);
	assert_int_equal(added(&sweep, "seed", "1,2,3"), 3);
	assert_int_equal(added(&sweep, "cube.max_px", "16,32"), 6);
	assert_int_equal(added(&sweep, "density.scale", "0.5,1"), 12);
	for (u32 i = 0; i < 12; i++) {
		char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT];
		ts_params set = params;
		require(ts_sweep_set(&sweep, i, &set, values));
		assert_string_equal(values[0], seeds[i / 4]);
		assert_string_equal(values[1], sides[i / 2 % 2]);
		assert_string_equal(values[2], scales[i % 2]);
		assert_int_equal(TS_PARAM(&set, seed), 1 + i / 4);
		assert_int_equal(TS_PARAM(&set, cube_max_px), 16 << i / 2 % 2);
		assert_true(TS_PARAM(&set, density_scale) == (i % 2 ? 1.0f : 0.5f));
	}
}

/* 100 values of each of two parameters are 10,000; one more of either is too many. */
static void more_than_ten_thousand_combinations_are_refused(void **state)
{
	(void)state;
	char hundred[400] = "1", more[404];
	for (u32 i = 2; i <= 100; i++) snprintf(hundred + strlen(hundred), 8, ",%u", (unsigned)i);
	snprintf(more, sizeof more, "%s,101", hundred);
	ts_sweep sweep = {.n = 0};
	added(&sweep, "seed", hundred);
	refused(ts_sweep_add(&sweep, &params, "frame", more), "--set frame: more than 10000 combinations");
	assert_int_equal(ts_sweep_count(&sweep), 100);
	assert_int_equal(added(&sweep, "frame", hundred), 10000);
	refused(ts_sweep_add(&sweep, &params, "cube.max_px", "16,32"), "--set cube.max_px: more than 10000 combinations");
	assert_int_equal(added(&sweep, "cube.max_px", "16"), 10000);
}

static void one_parameter_more_than_there_is_room_for_is_refused(void **state)
{
	(void)state;
	ts_sweep sweep = {.n = 0};
	for (u32 i = 0; i < TS_MAX_SWEEPS; i++) added(&sweep, "seed", "1");
	refused(ts_sweep_add(&sweep, &params, "seed", "1"), "--set seed: at most 8 parameters can have lists");
	refused(ts_sweep_add(&sweep, &params, "seed", "1"), "--set seed: at most 8");
	sweep.n = 0;
	refused(ts_sweep_add(&sweep, &params, "seed", "1,x"), "seed");
	assert_int_equal(sweep.n, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(combinations_go_by_the_last_parameter_first),
		cmocka_unit_test(more_than_ten_thousand_combinations_are_refused),
		cmocka_unit_test(one_parameter_more_than_there_is_room_for_is_refused),
	};
	ts_params_default(&params);
	return cmocka_run_group_tests(tests, NULL, NULL);
}
