/* Lines of CSV: of a series' file, and of a sweep on standard output. */
#include <math.h>
#include "cli/series.h"
#include "output/file.h"

static void put_head(const ts_series *series, FILE *out, bool timed)
{
	const ts_sweep *sweep = &series->job->sweep;
	u32 first = 0;
	while (ts_render_shown(series->render, first) == NULL) first++;
	const ts_series_figure_list *figures = &series->rows[first]->figures;
	for (u32 k = 0; k < sweep->n; k++) fprintf(out, "%s,", sweep->swept[k].name);
	if (series->job->frames.step > 0) fputs("frame,", out);
	fputs(timed ? "method,milliseconds" : "image", out);
	for (u32 i = 0; i < figures->n; i++) fprintf(out, ",%s", figures->figure[i].name);
	fputc('\n', out);
}

static void put_line(const ts_series *series, FILE *out, u32 shown, bool timed)
{
	const ts_series_figure_list *figures = &series->rows[shown]->figures;
	const ts_picture *picture = ts_render_shown(series->render, shown);
	for (u32 k = 0; k < series->job->sweep.n; k++) fprintf(out, "%s,", series->values[k]);
	if (series->job->frames.step > 0) fprintf(out, "%u,", (unsigned)TS_PARAM(&series->job->params, frame));
	fputs(picture->name, out);
	if (timed) fprintf(out, ",%.3f", 1e3 * picture->seconds);
	for (u32 i = 0; i < figures->n; i++) {
		const ts_series_figure *figure = &figures->figure[i];
		fputc(',', out);
		if (!isnan(figure->value)) fprintf(out, "%.*f", figure->decimals, figure->value);
	}
	fputc('\n', out);
}

/* For methods, and with frames for truths too, as their change is measured. */
static void put_lines(const ts_series *series, FILE *out, bool timed)
{
	u32 n = series->job->frames.step > 0 ? TS_MAX_SHOWN : TS_MAX_METHODS;
	if (series->n_done == 0) put_head(series, out, timed);
	for (u32 i = 0; i < n; i++) {
		if (ts_render_shown(series->render, i) != NULL) put_line(series, out, i, timed);
	}
}

ts_status ts_series_csv(ts_series *series, bool print)
{
	ts_file_text text;
	put_lines(series, series->csv.out, false);
	if (!print) return TS_OK;
	if (ts_file_text_begin(&text, "a line") != TS_OK) return TS_ERROR;
	put_lines(series, text.out, true);
	return ts_file_text_print(&text);
}
