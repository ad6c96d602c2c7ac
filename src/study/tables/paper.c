/* Measuring a paper's table. Times are medians, and ratios are taken within one run. */
#include "study/tables/paper.h"
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "scene/sources.h"
#include "study/asked/words.h"
#include "study/bench.h"
#include "study/busy.h"

/* Whether `text` begins with `prefix`, in any case. */
static bool begins(const char *text, const char *prefix)
{
	for (; *prefix != 0; text++, prefix++) {
		if (tolower((unsigned char)*text) != tolower((unsigned char)*prefix)) return false;
	}
	return true;
}

static bool is_builtin(const char *scene, const char *name)
{
	size_t n = strlen(name);
	return strncmp(scene, name, n) == 0 && (scene[n] == 0 || scene[n] == ':');
}

static bool is_scene(const ts_paper_row *row, const char *spec)
{
	const char *slash = strrchr(spec, '/');
	const char *file = slash != NULL ? slash + 1 : spec;
	return ts_builtin_is(spec) ? is_builtin(spec, row->builtin) : begins(file, row->file);
}

static const ts_paper_row *find(const ts_paper_table *table, const char *spec, u32 objects)
{
	const ts_paper_row *row = table->rows;
	while (row->name != NULL && (row->objects != objects || !is_scene(row, spec))) row++;
	return row->name != NULL ? row : NULL;
}

/* NULL if no row has the figure. */
static const ts_paper_row *nearest(const ts_paper_table *table, double value)
{
	const ts_paper_row *best = NULL;
	double least = INFINITY;
	for (const ts_paper_row *row = table->rows; row->name != NULL; row++) {
		double apart = fabs(log(row->figures[table->nearest] / value));
		if (!(apart < least)) continue;
		best = row;
		least = apart;
	}
	return best;
}

void ts_paper_compare(ts_paper_line *line, const ts_paper_table *table, const char *spec)
{
	bool by_name = table->nearest == TS_NO_FIGURE;
	line->row = by_name ? find(table, spec, line->objects) : nearest(table, line->here[table->nearest]);
	for (u32 i = 0; i < TS_BENCH_FIGURES; i++) line->paper[i] = line->row != NULL ? line->row->figures[i] : NAN;
	ts_bench_derive(line->paper, NULL, NULL, table->figures);
}

enum { SPEC_BYTES = 4096 };

typedef struct {
	const ts_job *job;
	const ts_paper_table *table;
	const ts_params *alone; /* for models that stand alone */
	const ts_truth_kind *judge;
	ts_paper_line *lines;
	size_t n_lines, capacity;
	u32 n_scenes;
} work;

static void derive(double *values, const double *measured, const double *before, const ts_bench_figure *figures)
{
	for (u32 f = 0; f < TS_BENCH_FIGURES; f++) values[f] = NAN;
	ts_bench_derive(values, measured, before, figures);
}

static bool is_counted(const ts_figure *figure, const ts_bench_case *c)
{
	bool counted = false;
	for (u32 v = 0; v < c->n_variants && !counted; v++) {
		const ts_measure *m = &c->measures[v];
		for (u32 i = 0; i < m->n_counters && !counted; i++) {
			char name[64];
			ts_figure_counter(name, sizeof name, m->counters[i].name);
			counted = strcmp(name, figure->what) == 0;
		}
	}
	return counted;
}

/* A counter that no variant has may be misspelt. */
static void say_uncounted(const ts_figure *measured, const ts_bench_case *c)
{
	for (; measured->row != NULL; measured++)
		if (measured->row->object == TS_FIGURE_OF_COUNTER && !is_counted(measured, c))
			ts_say("bench: no variant has a counter \"%s\"; `touchstone render --json` has all", measured->what);
}

/* Means over the frames of a run. Only times differ from the first run's, which alone has pictures. */
static ts_status run_frames(double *means, ts_paper_line *line, u32 run, ts_bench_case *c, const work *w)
{
	const ts_bench_figure *figures = w->table->figures;
	const ts_figure *measured = w->table->measured;
	ts_frame_spread mean[TS_BENCH_MEASURED] = {{0}};
	const ts_figure_source source = ts_bench_case_source(c);
	ts_status status = TS_OK;
	for (u32 k = 0; k < ts_frames_count(&w->job->frames) && status == TS_OK; k++) {
		double frame[TS_BENCH_MEASURED], values[TS_BENCH_FIGURES];
		ts_frames_set(&c->params, &w->job->frames, k);
		status = ts_bench_case_run(c, run);
		if (status != TS_OK) break;
		if (run == 0 && k == 0) say_uncounted(measured, c);
		for (u32 i = 0; measured[i].row != NULL; i++) {
			frame[i] = ts_figure_value(&measured[i], &source);
			ts_frame_spread_add(&mean[i], frame[i], TS_PARAM(&c->params, frame));
		}
		derive(values, frame, NULL, figures);
		for (u32 f = 0; run == 0 && figures[f].key != NULL; f++)
			ts_frame_spread_add(&line->over[f], values[f], TS_PARAM(&c->params, frame));
	}
	for (u32 i = 0; measured[i].row != NULL; i++)
		if (run == 0 || measured[i].row->timed) means[i] = ts_frame_spread_mean(&mean[i]);
	return status;
}

/* The median of each figure over the runs. */
static ts_status run_case(ts_paper_line *line, const double *before, ts_bench_case *c, const work *w)
{
	const ts_bench_figure *figures = w->table->figures;
	u32 runs = w->table->timed ? w->job->runs : 1;
	double means[TS_BENCH_MEASURED], values[TS_BENCH_FIGURES];
	double *of_run = ts_alloc(runs, TS_BENCH_FIGURES * sizeof *of_run, "the figures");
	ts_status status = of_run != NULL ? TS_OK : TS_ERROR;
	for (u32 i = 0; i < runs && status == TS_OK; i++) {
		status = run_frames(means, line, i, c, w);
		if (status == TS_OK) derive(values, means, before, figures);
		for (u32 f = 0; figures[f].key != NULL && status == TS_OK; f++) of_run[f * runs + i] = values[f];
	}
	for (u32 f = 0; figures[f].key != NULL && status == TS_OK; f++) line->here[f] = ts_median(of_run + f * runs, runs);
	free(of_run);
	return status;
}

/* The figures of the line before, if it has the same scene. */
static const double *before(const work *w, const ts_paper_line *line)
{
	bool same = line > w->lines && line[-1].of_scene == line->of_scene;
	return same ? line[-1].here : NULL;
}

static ts_status measure_line(ts_paper_line *line, const work *w, const char *spec, const ts_params *params)
{
	const char *slash = strrchr(spec, '/');
	ts_bench_case *c = ts_alloc_zero(1, sizeof *c, "a case");
	if (c == NULL) return TS_ERROR;
	c->job = w->job;
	c->effect = w->table->effect;
	c->variants = w->table->variants;
	c->judge = w->judge;
	c->rays = w->table->rays;
	c->look = w->table->look;
	c->sampled = w->table->sampled;
	c->hurried = w->table->most_long != 0 && line->objects > w->table->most_long;
	snprintf(line->scene, sizeof line->scene, "%s", slash != NULL ? slash + 1 : spec);
	ts_status status = ts_bench_case_open(c, spec, params);
	ts_busy begin = ts_busy_now();
	if (status == TS_OK) status = run_case(line, before(w, line), c, w);
	ts_busy end = ts_busy_now();
	line->others = ts_busy_others(&begin, &end);
	if (status == TS_OK) ts_paper_compare(line, w->table, spec);
	bool pictures = w->table->pictures != NULL && w->job->output.dir != NULL;
	if (status == TS_OK && pictures) status = ts_paper_pictures(w->table, c, line, (u32)w->n_lines + 1);
	ts_bench_case_close(c);
	free(c);
	return status;
}

/* Sets what the rows vary: the number of objects, or the size of the image. */
static ts_status vary(u32 *objects, ts_params *params, const ts_paper_table *table, const char *item)
{
	if (table->objects_param == NULL) {
		ts_status status = ts_words_size(params, item, "--objects");
		*objects = TS_PARAM(params, width) * TS_PARAM(params, height);
		return status;
	}
	ts_status status = ts_words_count(objects, item, 1, table->most > 0 ? table->most : TS_BENCH_OBJECTS, "--objects");
	return status == TS_OK ? ts_params_set(params, table->objects_param, item) : status;
}

/* Prints a row when it is measured: the figures of the first part. */
static void say_line(const ts_paper_table *table, const ts_paper_line *line)
{
	char text[512];
	int n = snprintf(text, sizeof text, "%s", line->scene);
	if (table->objects_head != NULL)
		n += snprintf(text + n, sizeof text - (size_t)n, ", %s %u", table->objects_head, (unsigned)line->objects);
	for (const u8 *f = table->parts[0].figures; *f != TS_NO_FIGURE && n < (int)sizeof text; f++) {
		const ts_bench_figure *figure = &table->figures[*f];
		int decimals = figure->decimals == TS_WHOLE ? 0 : figure->decimals;
		n += snprintf(text + n, sizeof text - (size_t)n, ", %s %.*f", figure->key, decimals, line->here[*f]);
	}
	ts_say("%s", text);
}

static bool stands_alone(const ts_paper_table *table, const char *spec)
{
	const char *slash = strrchr(spec, '/'), *list = table->alone;
	char item[128];
	while (list != NULL && ts_words_item(&list, item, sizeof item)) {
		if (strcmp(item, slash != NULL ? slash + 1 : spec) == 0) return true;
	}
	return false;
}

static ts_status add_line(work *w, const char *spec, const char *objects)
{
	ts_params params = stands_alone(w->table, spec) ? *w->alone : w->job->params;
	void *lines = w->lines;
	ts_status status = ts_grow(&lines, &w->capacity, w->n_lines + 1, sizeof *w->lines, "the rows");
	if (status != TS_OK) return status;
	w->lines = lines;
	ts_paper_line *line = &w->lines[w->n_lines];
	*line = (ts_paper_line){.of_scene = w->n_scenes};
	if (objects != NULL) status = vary(&line->objects, &params, w->table, objects);
	if (status == TS_OK) status = measure_line(line, w, spec, &params);
	if (status == TS_OK) say_line(w->table, line);
	w->n_lines += status == TS_OK;
	return status;
}

static ts_status add_scene(void *user, const char *spec)
{
	work *w = user;
	const char *list = w->job->objects != NULL ? w->job->objects : w->table->objects;
	char item[32];
	ts_status status = TS_OK;
	w->n_scenes++;
	if (w->table->objects_head == NULL) return add_line(w, spec, NULL);
	while (status == TS_OK && ts_words_item(&list, item, sizeof item)) status = add_line(w, spec, item);
	return status;
}

ts_status ts_paper_check_objects(const ts_paper_table *table, const char *objects)
{
	char item[32];
	u32 count;
	ts_status status = TS_OK;
	while (status == TS_OK && ts_words_item(&objects, item, sizeof item)) {
		ts_params params;
		ts_params_default(&params);
		status = vary(&count, &params, table, item);
	}
	return status;
}

/* Checks all typed lists once before hours of work. */
static ts_status check_lists(const work *w, const char *scenes)
{
	char spec[SPEC_BYTES];
	ts_status status = TS_OK;
	if (w->job->objects != NULL && w->table->objects_head == NULL)
		return ts_fail("bench %s: takes no --objects: its rows vary nothing", w->table->name);
	if (w->job->objects != NULL) status = ts_paper_check_objects(w->table, w->job->objects);
	while (status == TS_OK && ts_words_item(&scenes, spec, sizeof spec)) {
		ts_scene *scene = NULL;
		ts_params params = w->job->params;
		TS_PARAM_SET(&params, reflectors_count, 1);
		status = ts_scene_load(&scene, spec, &params, &w->job->scene.options);
		ts_scene_free(scene);
	}
	return status;
}

static ts_status measure_lines(work *w, ts_report *report)
{
	ts_status status = check_lists(w, w->job->scenes);
	if (status != TS_OK) return status;
	return ts_bench_scenes(w->job, w->table->scenes, w->table->models, report, add_scene, w);
}

static const ts_column variant_columns[] = {
	{"variant", "variant", false}, {"method", "method", false}, {"set", "set for it", false}, {0}};

static void report_variants(ts_report *report, const ts_paper_table *table)
{
	ts_table t = ts_table_begin("variants", table->title, variant_columns);
	for (const ts_bench_variant *v = table->variants; v->method != NULL; v++) {
		char set[128];
		const char *how = v->runs == TS_ALONE ? "one thread" : v->runs == TS_FIRST ? "the first frame" : "";
		snprintf(set, sizeof set, "%s%s%s", v->set, v->set[0] != 0 && how[0] != 0 ? "; " : "", how);
		ts_table_text(&t, v->name);
		ts_table_text(&t, v->method);
		ts_table_text(&t, set);
	}
	if (table->set[0] != 0) ts_report_line(report, "set: %s", table->set);
	if (table->defaults[0] != 0) ts_report_line(report, "set unless --set says otherwise: %s", table->defaults);
	if (table->alone != NULL) {
		ts_report_line(report, "models that stand alone: %s", table->alone);
		ts_report_line(report, "set for them unless --set says otherwise: %s", table->alone_set);
	}
	if (table->own_camera) ts_report_line(report, "Models are seen through their first camera, as by render.");
	if (table->note != NULL) ts_report_line(report, "%s", table->note);
	ts_report_table(report, &t);
}

/* A table, and the parameters for models that stand alone. */
typedef struct {
	const ts_paper_table *table;
	ts_params alone;
} measured;

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	const measured *m = user;
	const ts_paper_table *table = m->table;
	work w = {.job = job, .table = table, .alone = &m->alone};
	ts_status status = table->judge != NULL ? ts_bench_truth(&w.judge, job, table->effect, table->judge) : TS_OK;
	ts_bench_head(report, job, table->objects_head == NULL || table->objects_param != NULL);
	report_variants(report, table);
	if (status == TS_OK) status = measure_lines(&w, report);
	if (status == TS_OK) ts_paper_report(report, table, w.lines, (u32)w.n_lines);
	if (status == TS_OK && job->frames.step > 0) ts_paper_report_frames(report, table, w.lines, (u32)w.n_lines);
	bool plots = table->plot != NULL && job->output.dir != NULL;
	if (status == TS_OK && plots) status = ts_paper_plots(table, w.lines, (u32)w.n_lines);
	free(w.lines);
	return status;
}

/* The typed parameters with those of the table; `first` has priority over its defaults. */
static ts_status set_params(ts_params *params, const ts_job *job, const ts_paper_table *table, const char *first)
{
	bool sized = table->size == NULL || job->sized;
	*params = job->params;
	ts_status status = ts_bench_set_defaults(params, job, first, "");
	if (status == TS_OK) status = ts_bench_set_defaults(params, job, table->defaults, first);
	if (status == TS_OK) status = ts_bench_set(params, table->set);
	return status == TS_OK && !sized ? ts_bench_set(params, table->size) : status;
}

ts_status ts_paper_bench(const ts_job *job, const ts_paper_table *table)
{
	ts_job own = *job;
	measured m = {.table = table};
	if (table->own_camera) own.scene.options.camera = NULL;
	ts_status status = set_params(&own.params, job, table, "");
	if (status == TS_OK) status = set_params(&m.alone, job, table, table->alone != NULL ? table->alone_set : "");
	return status == TS_OK ? ts_bench_with_report(&own, work_on, &m) : status;
}
