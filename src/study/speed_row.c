/* Rows of `bench speed`: see speed_work.h. */
#include <math.h>
#include <stdlib.h>
#include "study/speed_work.h"

enum { TRIES = 3, LONG = 20 }; /* seconds of a row after which it rests */

ts_status ts_speed_row_begin(ts_speed_row *row, u32 n_values, u32 runs)
{
	row->n_values = n_values;
	row->values = ts_alloc_zero(runs, n_values * sizeof *row->values, "the times");
	row->quiet = ts_alloc_zero(runs, sizeof *row->quiet, "the times");
	return row->values != NULL && row->quiet != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_speed_row_run(ts_speed_row *row, u32 run, ts_quiet *quiet)
{
	double *values = row->values + (size_t)run * row->n_values;
	ts_status status = TS_OK;
	if (row->spent > LONG && run > 0) {
		memcpy(values, values - row->n_values, row->n_values * sizeof *values);
		row->quiet[run] = row->quiet[run - 1];
		return TS_OK;
	}
	for (u32 i = 0; i < TRIES && status == TS_OK && !row->quiet[run]; i++) {
		double begin = ts_seconds();
		ts_quiet_before(quiet);
		status = row->measure(values, row->of);
		row->quiet[run] = ts_quiet_after(quiet);
		row->spent += ts_seconds() - begin;
		if (row->spent > LONG || quiet->anyway) break;
	}
	return status;
}

void ts_speed_row_end(ts_speed_row *row)
{
	free(row->values);
	free(row->quiet);
	*row = (ts_speed_row){.measure = NULL};
}

static ts_speed_value sum(const double *values, const bool *quiet, u32 runs, bool any)
{
	double chosen[runs], least = INFINITY, most = -INFINITY;
	u32 n = 0;
	for (u32 i = 0; i < runs; i++) {
		if ((any || quiet[i]) && !isnan(values[i])) chosen[n++] = values[i];
	}
	for (u32 i = 0; i < n; i++) {
		least = fmin(least, chosen[i]);
		most = fmax(most, chosen[i]);
	}
	if (n == 0) return (ts_speed_value){NAN, NAN, false};
	double median = ts_median(chosen, n);
	return (ts_speed_value){median, median > 0 ? 100 * (most - least) / median : 0, !any};
}

ts_speed_value ts_speed_sum(const double *values, const bool *quiet, u32 runs)
{
	ts_speed_value value = sum(values, quiet, runs, false);
	return isnan(value.median) ? sum(values, quiet, runs, true) : value;
}

ts_speed_value ts_speed_row_value(const ts_speed_row *row, u32 value, u32 runs)
{
	double values[runs];
	if (row->values == NULL) return (ts_speed_value){NAN, NAN, false};
	for (u32 i = 0; i < runs; i++) values[i] = row->values[(size_t)i * row->n_values + value];
	return ts_speed_sum(values, row->quiet, runs);
}

const char *ts_speed_state(const ts_speed_value *value) { return value->quiet ? "" : "busy"; }
