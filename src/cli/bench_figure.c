/* The figures of a table. */
#include <math.h>
#include <touchstone/image.h>
#include "bench_figure.h"

static const char *const point_stages[] = { "visibility", "offscreen_visibility", "split", "view_split", "shadow_split",
	"cull", "align", "count", "points", NULL };
static const char *const view_stages[] = { "splat", "scatter", "scatter_colour", "copy", "face", "depth",
	"shadow_resize", "shadow_splat", NULL };

static double milliseconds(const ts_measure *m, const char *const *stages)
{
	double sum = 0;
	for (; *stages != NULL; stages++) {
		const ts_timing *timing = ts_measure_timing(m, *stages);
		sum += timing != NULL ? 1e3 * timing->seconds : 0;
	}
	return sum;
}

static double counted(const ts_measure *m, const char *name)
{
	const ts_counter *counter = ts_measure_counter(m, name);
	return counter != NULL ? (double)counter->value : NAN;
}

static double rmse(const ts_bench_case *c, ts_figure_kind kind, u32 variant, u32 other)
{
	const ts_picture *image = &c->images[variant], *reference = c->truths != 0 ? &c->truth : &c->images[other];
	if (image->srgb == NULL || reference->srgb == NULL || image == reference) return NAN;
	u32 width = c->params.width, height = c->params.height;
	if (kind == TS_FIGURE_RELATIVE) {
		return ts_metrics_relative(reference->radiance, image->radiance, image->seen, width, height);
	}
	return ts_metrics_compare(reference->srgb, image->srgb, NULL, width, height).rmse;
}

static double measured(const ts_bench_figure *f, const ts_bench_case *c)
{
	if (f->kind == TS_FIGURE_TRIANGLES) return c->scene->n_triangles;
	if (f->kind == TS_FIGURE_PIXELS) return 1e-6 * c->params.width * c->params.height;
	if (f->kind >= TS_FIGURE_DERIVED || c->methods[f->a] == NULL) return NAN;
	const ts_measure *m = &c->measures[f->a];
	double points = milliseconds(m, point_stages), views = milliseconds(m, view_stages), all = 1e3 * m->seconds;
	switch (f->kind) {
	case TS_FIGURE_COUNTER: return counted(m, f->what);
	case TS_FIGURE_TRAVERSED: return (counted(m, "geometry traversals") - 1) * c->scene->n_triangles;
	case TS_FIGURE_DIAMETER: return m->mean_diameter;
	case TS_FIGURE_TIME: return all;
	case TS_FIGURE_POINT_TIME: return points;
	case TS_FIGURE_VIEW_TIME: return views;
	case TS_FIGURE_MAP_TIME: return points + views;
	case TS_FIGURE_REST_TIME: return all - points - views;
	case TS_FIGURE_RMSE:
	case TS_FIGURE_RELATIVE: return rmse(c, f->kind, f->a, f->b);
	default: return NAN;
	}
}

void ts_bench_measure(double *values, const ts_bench_figure *figures, const ts_bench_case *c)
{
	for (u32 i = 0; figures[i].key != NULL; i++) values[i] = measured(&figures[i], c);
}

static double derived(ts_figure_kind kind, double a, double b)
{
	if (kind == TS_FIGURE_MORE) return 100 * (a - b) / 255;
	if (!(b > 0)) return NAN;
	if (kind == TS_FIGURE_RATE) return 1e3 / b;
	return kind == TS_FIGURE_RATIO ? a / b : 100 * (1 - a / b);
}

void ts_bench_derive(double *values, const ts_bench_figure *figures)
{
	for (u32 i = 0; figures[i].key != NULL; i++) {
		const ts_bench_figure *f = &figures[i];
		if (f->kind >= TS_FIGURE_DERIVED && isnan(values[i])) values[i] = derived(f->kind, values[f->a], values[f->b]);
	}
}

void ts_bench_cell(ts_table *table, const ts_bench_figure *figure, double value)
{
	if (isnan(value)) {
		ts_table_none(table);
	} else if (figure->decimals == TS_WHOLE) {
		ts_table_count(table, (i64)value);
	} else {
		ts_table_real(table, value, figure->decimals);
	}
}
