/* The pictures of a table's rows, of methods, of the truth, and of the differences between methods and the first of
 * them; and plots of a paper's table. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/image.h>
#include "image/about.h"
#include "study/bench.h"
#include "study/results/folder.h"
#include "study/tables/paper.h"

typedef struct {
	const ts_bench_case *c;
	char row[160]; /* begins file names */
} place;

/* Writes a file that shows `shows`, with the parameters of the variant. */
static ts_status write_picture(const place *p, const char *name, const char *shows, const u8 *srgb, u32 variant)
{
	char file[256];
	ts_about about;
	ts_params params;
	if (ts_bench_case_params(&params, p->c, variant) != TS_OK) return TS_ERROR;
	snprintf(file, sizeof file, "%s-%s.png", p->row, name);
	const char *path = ts_folder_file(file);
	if (path == NULL) return TS_ERROR;
	ts_about_make(&about, p->c->scene->name, p->c->effect, shows, &params);
	return ts_image_write_png(path, srgb, TS_PARAM(&params, width), TS_PARAM(&params, height), 3, about.texts);
}

static ts_status write_difference(const place *p, const ts_paper_picture *k, const ts_picture *reference, u32 scale)
{
	char name[80], shows[80];
	const ts_picture *image = &p->c->images[k->variant];
	ts_picture difference;
	ts_status status = ts_picture_difference(&difference, image, reference, &p->c->params, scale);
	snprintf(name, sizeof name, "difference-%s", k->name);
	snprintf(shows, sizeof shows, "difference-%s-%s", reference->name, image->name);
	if (status == TS_OK) status = write_picture(p, name, shows, difference.srgb, k->variant);
	ts_picture_free(&difference);
	return status;
}

ts_status ts_paper_pictures(const ts_paper_table *table, const ts_bench_case *c, const ts_paper_line *line, u32 row)
{
	place p = {.c = c};
	u32 v = table->pictures->variant, scale = ts_effect_find(table->effect)->difference_scale;
	const ts_picture *first = &c->images[v];
	ts_status status = TS_OK;
	int n = snprintf(p.row, sizeof p.row, "%u-%s", (unsigned)row, line->scene);
	if (table->objects_head != NULL) snprintf(p.row + n, sizeof p.row - (size_t)n, "-%u", (unsigned)line->objects);
	for (const ts_paper_picture *k = table->pictures; status == TS_OK && k->name != NULL; k++) {
		const ts_picture *image = &c->images[k->variant];
		if (image->srgb == NULL) continue;
		status = write_picture(&p, k->name, image->name, image->srgb, k->variant);
		bool differs = image != first && first->srgb != NULL;
		if (status == TS_OK && differs) status = write_difference(&p, k, first, scale);
	}
	if (status != TS_OK || c->truth.srgb == NULL) return status;
	return write_picture(&p, c->truth.name, c->truth.name, c->truth.srgb, v);
}

/* Whether an axis can have the value. */
static bool fits(double value) { return value == 0 || (fabs(value) > 1e-100 && fabs(value) < 1e100); }

/* Plots one scene. */
static ts_status plot_scene(const ts_paper_table *table, const ts_paper_line *lines, u32 n, u32 scene)
{
	const ts_paper_plot *of = table->plot;
	char title[160], name[64];
	ts_plot_point *points = ts_alloc((u64)n * TS_PLOT_CURVES, sizeof *points, "a plot");
	ts_plot plot = {.title = title, .x_axis = of->x_axis, .y_axis = of->y_axis, .points = points, .rises = of->rises};
	if (points == NULL) return TS_ERROR;
	snprintf(title, sizeof title, "%s, %.90s", table->title, lines[0].scene);
	bool timed = table->figures[of->x].timed;
	for (; of->curves[plot.n_curves] != TS_NO_FIGURE; plot.n_curves++) {
		u32 figure = of->curves[plot.n_curves];
		plot.curves[plot.n_curves] = table->figures[figure].head;
		timed |= table->figures[figure].timed;
		for (u32 i = 0; i < n; i++) {
			ts_plot_point point = {plot.n_curves, "", lines[i].here[of->x], lines[i].here[figure], false};
			if (fits(point.x) && fits(point.y)) points[plot.n_points++] = point;
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
		for (end = i; end < n && lines[end].of_scene == lines[i].of_scene; end++) continue;
		status = plot_scene(table, lines + i, end - i, scene);
	}
	return status;
}
