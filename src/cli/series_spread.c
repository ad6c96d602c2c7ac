/* Means and extremes over the frames of a combination. */
#include <stdlib.h>
#include "cli/series.h"

ts_status ts_series_add(ts_series *series)
{
	u32 frame = TS_PARAM(&series->job->params, frame);
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		const ts_picture *picture = ts_render_shown(series->render, i);
		if (picture == NULL) continue;
		if (series->rows[i] == NULL) series->rows[i] = ts_alloc_zero(1, sizeof *series->rows[i], "figures");
		ts_series_row *row = series->rows[i];
		if (row == NULL) return TS_ERROR;
		if (series->fetched == NULL) {
			ts_series_figures(&row->figures, series->render, i);
		} else if (ts_series_fetch_figures(&row->figures, series, i) != TS_OK) {
			return TS_ERROR;
		}
		for (u32 k = 0; k < row->figures.n; k++)
			ts_frame_spread_add(&row->spread[k], row->figures.figure[k].value, frame);
		ts_frame_spread_add(&row->milliseconds, 1e3 * picture->seconds, frame);
	}
	return TS_OK;
}

static void put_name(ts_table *table, const ts_series *series, u32 shown)
{
	char name[24];
	ts_render_name(name, sizeof name, series->render, shown);
	ts_table_text(table, name);
}

/* Figures that a picture does not have, or that are 0 throughout, are left out. */
static void report_figures(ts_series *series)
{
	static const ts_column columns[] = {{"image", "image", false}, {"figure", "figure", false}, TS_SPREAD_COLUMNS, {0}};
	ts_table table = ts_table_begin("over_frames", "Over the frames", columns);
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		const ts_series_row *row = series->rows[i];
		for (u32 k = 0; row != NULL && k < row->figures.n; k++) {
			const ts_frame_spread *spread = &row->spread[k];
			if (spread->n == 0 || (spread->least == 0 && spread->most == 0)) continue;
			put_name(&table, series, i);
			ts_table_text(&table, row->figures.figure[k].name);
			int decimals = row->figures.figure[k].decimals;
			ts_frame_spread_cells(&table, spread, ts_frame_spread_mean(spread), decimals < 3 ? decimals : 3);
		}
	}
	ts_report_table(&series->report, &table);
}

static void report_times(ts_series *series)
{
	static const ts_column columns[] = {{"image", "image", false}, TS_SPREAD_COLUMNS, {0}};
	ts_table table = ts_table_begin("milliseconds", "Time, ms", columns);
	table.timed = true;
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		const ts_series_row *row = series->rows[i];
		if (row == NULL) continue;
		put_name(&table, series, i);
		ts_frame_spread_cells(&table, &row->milliseconds, ts_frame_spread_mean(&row->milliseconds), 2);
	}
	ts_report_table(&series->report, &table);
}

void ts_series_report(ts_series *series)
{
	if (series->job->frames.step == 0 || series->job->sweep.n > 0) return;
	report_times(series);
	report_figures(series);
}
