/* Rows of `bench speed`: medians of quiet runs, how far they are apart, and rows that rest. */
#include <math.h>
#include "study/speed_work.h"
#include "tests/model/test.h"

static void assert_value(ts_speed_value value, double median, double spread, bool quiet)
{
	assert_float_equal(value.median, median, 1e-12);
	assert_float_equal(value.spread, spread, 1e-9);
	assert_int_equal(value.quiet, quiet);
}

static void medians_are_of_quiet_runs(void **state)
{
	(void)state;
	const double values[] = {9, 2, 4, 3, 1};
	const bool none[5] = {false}, all[5] = {true, true, true, true, true}, some[5] = {false, true, true, true, false};
	assert_value(ts_speed_sum(values, all, 5), 3, 100 * 8 / 3.0, true);
	assert_value(ts_speed_sum(values, some, 5), 3, 100 * 2 / 3.0, true);
	assert_value(ts_speed_sum(values, none, 5), 3, 100 * 8 / 3.0, false);
	assert_value(ts_speed_sum(values, all, 2), 5.5, 100 * 7 / 5.5, true);
	assert_value(ts_speed_sum(values, some, 1), 9, 0, false);
}

static void missing_values_do_not_count(void **state)
{
	(void)state;
	const double values[] = {NAN, 6, NAN}, nothing[] = {NAN, NAN};
	const bool quiet[] = {true, true, true};
	assert_value(ts_speed_sum(values, quiet, 3), 6, 0, true);
	assert_true(isnan(ts_speed_sum(nothing, quiet, 2).median));
	const ts_speed_row row = {.measure = NULL};
	assert_true(isnan(ts_speed_row_value(&row, 0, 3).median));
}

static ts_status count(double *values, void *of)
{
	u32 *n = of;
	values[0] = ++*n;
	values[1] = -values[0];
	return TS_OK;
}

static ts_status refuse(double *values, void *of)
{
	(void)values, (void)of;
	return ts_fail("no value");
}

/* Where nothing counts as quiet, a run is measured once. */
static void a_busy_run_is_measured_once(void **state)
{
	(void)state;
	u32 n = 0;
	ts_quiet quiet = {.threads = 1, .best = 1e9, .anyway = true};
	ts_speed_row row = {.measure = count, .of = &n};
	assert_int_equal(ts_speed_row_begin(&row, 2, 4), TS_OK);
	for (u32 run = 0; run < 3; run++) assert_int_equal(ts_speed_row_run(&row, run, &quiet), TS_OK);
	assert_int_equal(n, 3);
	row.spent = 1000;
	assert_int_equal(ts_speed_row_run(&row, 3, &quiet), TS_OK);
	assert_int_equal(n, 3);
	assert_value(ts_speed_row_value(&row, 0, 4), 2.5, 100 * 2 / 2.5, false);
	assert_true(ts_speed_row_value(&row, 1, 4).median == -2.5);
	row.measure = refuse;
	row.spent = 0;
	assert_int_equal(ts_speed_row_run(&row, 0, &quiet), TS_ERROR);
	ts_speed_row_end(&row);
	assert_null(row.values);
}

/* A loop that takes longer than it may is no quiet machine: three times, and the run stays busy. */
static void a_slow_loop_stays_busy(void **state)
{
	(void)state;
	u32 n = 0;
	ts_quiet quiet = {.threads = 1, .best = 1e-9};
	ts_speed_row row = {.measure = count, .of = &n};
	assert_int_equal(ts_speed_row_begin(&row, 2, 1), TS_OK);
	assert_int_equal(ts_speed_row_run(&row, 0, &quiet), TS_OK);
	assert_int_equal(n, 3);
	assert_int_equal(quiet.n_busy, 3);
	assert_false(row.quiet[0]);
	ts_speed_row_end(&row);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(medians_are_of_quiet_runs), cmocka_unit_test(missing_values_do_not_count),
		cmocka_unit_test(a_busy_run_is_measured_once), cmocka_unit_test(a_slow_loop_stays_busy)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
