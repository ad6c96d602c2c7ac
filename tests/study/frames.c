/* Frames one after the other, and least, mean and greatest of figures over them. */
#include <math.h>
#include "study/frames.h"
#include "tests/model/test.h"

static void frames_go_by_steps_to_the_last(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	params.frame = 7;
	const ts_frames none = {.step = 0}, all = {.first = 3, .last = 5, .step = 1},
					some = {.first = 3, .last = 13, .step = 4};
	assert_int_equal(ts_frames_count(&none), 1);
	assert_int_equal(ts_frames_count(&all), 3);
	assert_int_equal(ts_frames_count(&some), 3);
	ts_frames_set(&params, &none, 0);
	assert_int_equal(params.frame, 7);
	ts_frames_set(&params, &some, 2);
	assert_int_equal(params.frame, 11);
}

static void a_spread_has_its_extremes_and_mean(void **state)
{
	(void)state;
	ts_frame_spread spread = {.n = 0};
	assert_true(isnan(ts_frame_spread_mean(&spread)));
	const double values[] = {NAN, 4, -2, 4, 10, -2, NAN};
	for (u32 i = 0; i < 7; i++) ts_frame_spread_add(&spread, values[i], 100 + i);
	assert_int_equal(spread.n, 5);
	assert_true(ts_frame_spread_mean(&spread) == 2.8);
	assert_true(spread.least == -2 && spread.least_at == 102 && spread.most == 10 && spread.most_at == 104);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(frames_go_by_steps_to_the_last),
	                                   cmocka_unit_test(a_spread_has_its_extremes_and_mean)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
