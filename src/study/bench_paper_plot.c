/* Plots of a paper's table. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "study/bench.h"
#include "study/bench_paper.h"

/* Plots one scene. */
static ts_status plot_scene(const ts_paper_table *table, const ts_paper_line *lines, u32 n, u32 scene)
{
	const ts_paper_plot *of = table->plot;
	char title[160], name[64];
	ts_plot_point *points = ts_alloc((u64)n * TS_PLOT_CURVES, sizeof *points, "a plot");
	ts_plot plot = {.title = title, .x_axis = of->x_axis, .y_axis = of->y_axis, .points = points, .rises = of->rises};
	if (points == NULL) return TS_ERROR;
	snprintf(title, sizeof title, "%s, %.90s", table->title, lines[0].scene);
	bool timed = ts_bench_is_timed(table->figures, of->x);
	for (; of->curves[plot.n_curves] != TS_NO_FIGURE; plot.n_curves++) {
		u32 figure = of->curves[plot.n_curves];
		plot.curves[plot.n_curves] = table->figures[figure].head;
		timed |= ts_bench_is_timed(table->figures, figure);
		for (u32 i = 0; i < n; i++) {
			ts_plot_point point = {plot.n_curves, "", lines[i].here[of->x], lines[i].here[figure], false};
			if (!isnan(point.y)) points[plot.n_points++] = point;
		}
	}
	snprintf(name, sizeof name, "%s%s_%u.svg", timed ? "times-" : "", table->parts[0].key, (unsigned)scene);
	ts_status status = plot.n_points > 0 ? ts_bench_plot(name, &plot) : TS_OK;
	free(points);
	return status;
}

ts_status ts_paper_plots(const ts_paper_table *table, const ts_paper_line *lines, u32 n)
{
	ts_status status = TS_OK;
	for (u32 i = 0, end, scene = 1; i < n && status == TS_OK; i = end, scene++) {
		for (end = i; end < n && strcmp(lines[end].scene, lines[i].scene) == 0; end++) continue;
		status = plot_scene(table, lines + i, end - i, scene);
	}
	return status;
}
