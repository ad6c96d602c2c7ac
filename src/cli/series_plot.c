/* Plots of a series: errors and changes by frame, or by a swept parameter while the others are at their first value. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include "cli/series.h"
#include "model/decimal.h"
#include "output/file.h"
#include "study/results/folder.h"

/* The plotted figures: of each picture, the first whose name begins with this. */
static const struct {
	const char *begins, *file, *axis;
} plotted[] = {{"rmse_", "rmse", "RMSE, grey levels"},
               {"flicker_", "flicker", "flicker, grey levels"},
               {"change", "change", "change since the frame before, grey levels"}};
enum { N_PLOTTED = sizeof plotted / sizeof *plotted };

static ts_status add(ts_series *series, ts_datum datum)
{
	void *data = series->data;
	if (isnan(datum.y)) return TS_OK;
	if (ts_grow(&data, &series->data_capacity, series->n_data + 1, sizeof *series->data, "a plot") != TS_OK)
		return TS_ERROR;
	series->data = data;
	series->data[series->n_data++] = datum;
	return TS_OK;
}

/* Adds every picture's value at x: in this frame, or its mean over the combination. */
static ts_status add_all(ts_series *series, u32 along, double x)
{
	ts_status status = TS_OK;
	for (u32 p = 0; p < N_PLOTTED; p++) {
		for (u32 i = 0; i < TS_MAX_SHOWN && status == TS_OK; i++) {
			const ts_series_row *row = series->rows[i];
			u32 k = 0, n = row != NULL ? row->figures.n : 0;
			while (k < n && strncmp(row->figures.figure[k].name, plotted[p].begins, strlen(plotted[p].begins)) != 0)
				k++;
			if (k == n) continue;
			double mean = ts_frame_spread_mean(&row->spread[k]);
			double y = along == 0 ? row->figures.figure[k].value : mean;
			status = add(series, (ts_datum){along, p, i, x, y});
		}
	}
	return status;
}

ts_status ts_series_plot_frame(ts_series *series)
{
	bool alone = series->job->frames.step > 0 && series->job->sweep.n == 0;
	return alone ? add_all(series, 0, TS_PARAM(&series->job->params, frame)) : TS_OK;
}

ts_status ts_series_plot_combination(ts_series *series)
{
	const ts_sweep *sweep = &series->job->sweep;
	ts_status status = TS_OK;
	u32 weight = 1;
	for (u32 k = sweep->n; k-- > 0 && status == TS_OK; weight *= sweep->swept[k].n) {
		char *end;
		u32 place = series->combination / weight % sweep->swept[k].n;
		double x = ts_strtod(series->values[k], &end);
		if (*end == 0 && place * weight == series->combination) status = add_all(series, 1 + k, x);
	}
	return status;
}

/* Collects the points of one axis and figure, by curves. True if a curve has at least two. */
static bool collect(const ts_series *series, ts_plot *plot, ts_plot_point *points, char (*names)[24], u32 along,
                    u32 figure)
{
	bool lines = false;
	for (u32 i = 0; i < TS_MAX_SHOWN && plot->n_curves < TS_PLOT_CURVES; i++) {
		u32 n = plot->n_points;
		for (size_t d = 0; d < series->n_data; d++) {
			const ts_datum *datum = &series->data[d];
			if (datum->along != along || datum->figure != figure || datum->shown != i) continue;
			points[plot->n_points++] =
				(ts_plot_point){plot->n_curves, along == 0 ? NULL : "", datum->x, datum->y, false};
		}
		if (plot->n_points == n) continue;
		ts_render_name(names[plot->n_curves], sizeof *names, series->render, i);
		plot->curves[plot->n_curves] = names[plot->n_curves];
		plot->n_curves++;
		lines |= plot->n_points > n + 1;
	}
	return lines;
}

static ts_status write(const ts_plot *plot, const char *name)
{
	ts_file_text text;
	const char *path = ts_folder_file(name);
	if (path == NULL || ts_file_text_begin(&text, name) != TS_OK) return TS_ERROR;
	ts_plot_svg(plot, text.out);
	return ts_file_text_write(&text, path);
}

static ts_status plot(ts_series *series, ts_plot_point *points, u32 along, u32 figure)
{
	char name[128], title[128], names[TS_PLOT_CURVES][24];
	const char *axis = along == 0 ? "frame" : series->job->sweep.swept[along - 1].name;
	ts_plot p = {.title = title, .x_axis = axis, .y_axis = plotted[figure].axis, .points = points, .even = true};
	if (!collect(series, &p, points, names, along, figure)) return TS_OK;
	snprintf(title, sizeof title, "%s of %.90s", plotted[figure].file, series->render->scene->name);
	snprintf(name, sizeof name, "%s-%s.svg", plotted[figure].file, axis);
	return write(&p, name);
}

ts_status ts_series_plots_write(ts_series *series)
{
	ts_plot_point *points = ts_alloc(series->n_data, sizeof *points, "a plot");
	ts_status status = points != NULL ? TS_OK : TS_ERROR;
	for (u32 along = 0; along <= series->job->sweep.n; along++) {
		for (u32 p = 0; p < N_PLOTTED && status == TS_OK; p++) status = plot(series, points, along, p);
	}
	free(points);
	return status;
}
