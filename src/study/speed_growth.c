/* `bench speed`: times as one thing grows, and the exponents of the power laws between them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "model/decimal.h"
#include "study/asked/words.h"
#include "study/speed_work.h"

enum { POINTS = 16, SPEC_BYTES = 96 };

/* The times of a growth by one method: of the whole frame, and of the listed stages. */
typedef struct {
	const char *method;
	u32 n;
	double value[POINTS];
	ts_speed_value whole[POINTS], part[POINTS];
} series;

typedef struct {
	const ts_speed_growth *growth;
	series of[TS_SPEED_METHODS];
	u32 n_series;
} curves;

static const ts_column point_columns[] = {
	{"growth", "growth", false},    {"value", "value", true}, {"method", "method", false},
	{"what", "what", false},        {"ms", "ms", true},       {"spread", "spread, %", true},
	{"exponent", "exponent", true}, {"state", "", false},     {0}};
static const ts_column law_columns[] = {{"growth", "growth", false},
                                        {"range", "from, to", false},
                                        {"method", "method", false},
                                        {"what", "what", false},
                                        {"exponent", "exponent", true},
                                        {"steepest", "steepest", true},
                                        {0}};

/* A number, optionally with k or M; for a size its pixels. */
static double number(const char *text)
{
	char *rest;
	double value = ts_strtod(text, &rest);
	if (*rest == 'x') return value * ts_strtod(rest + 1, NULL);
	return *rest == 'k' ? 1e3 * value : *rest == 'M' ? 1e6 * value : value;
}

static ts_status set_value(ts_job *job, char spec[SPEC_BYTES], const ts_speed_growth *growth, const char *value)
{
	bool of_scene = growth->of.spec[strlen(growth->of.spec) - 1] == '=';
	snprintf(spec, SPEC_BYTES, "%s%s", growth->of.spec, of_scene ? value : "");
	if (of_scene) return TS_OK;
	if (strcmp(growth->param, "size") == 0) return ts_words_size(&job->params, value, "--objects");
	if (strcmp(growth->param, "threads") == 0)
		return ts_words_count(&job->how.threads, value, 1, TS_MOST_THREADS, "--objects");
	return ts_params_set(&job->params, growth->param, value);
}

static ts_speed_value stages_of(const ts_speed_frame *frame, const char *stages)
{
	u32 runs = frame->set->n_runs;
	double sums[runs];
	char stage[32];
	memset(sums, 0, sizeof sums);
	while (stages != NULL && ts_words_item(&stages, stage, sizeof stage)) {
		const ts_timing *timing = ts_measure_timing(&frame->last, stage);
		for (u32 i = 0; timing != NULL && i < runs; i++)
			sums[i] += frame->row.values[(size_t)i * TS_SPEED_VALUES + (size_t)(timing - frame->last.timings)];
	}
	return ts_speed_sum(sums, frame->row.quiet, runs);
}

static void keep(curves *c, const ts_speed_set *set, double value)
{
	for (u32 i = 0; i < set->n_frames; i++) {
		const ts_speed_frame *frame = &set->frame[i];
		series *s = &c->of[i];
		s->method = frame->method->name;
		s->value[s->n] = value;
		s->whole[s->n] = ts_speed_row_value(&frame->row, TS_SPEED_WHOLE, set->n_runs);
		s->part[s->n] = stages_of(frame, c->growth->stages);
		s->n++;
	}
	c->n_series = set->n_frames;
}

static ts_status measure_point(curves *c, ts_speed *speed, const char *value)
{
	char spec[SPEC_BYTES];
	ts_job job = *speed->job;
	const ts_speed_growth *growth = c->growth;
	ts_speed_set *set = ts_alloc_zero(1, sizeof *set, "a frame");
	if (set == NULL) return TS_ERROR;
	ts_status status = set_value(&job, spec, growth, value);
	if (status == TS_OK) status = ts_speed_set_open(set, spec, &growth->of, &job, speed->n_runs);
	for (u32 run = 0; run < speed->n_runs && status == TS_OK; run++) status = ts_speed_set_run(set, run, &speed->quiet);
	if (status == TS_OK) {
		keep(c, set, number(value));
		ts_say("%s %s: measured", growth->of.name, value);
	}
	if (status == TS_SKIPPED)
		ts_report_line(speed->report, "%s %s: left out: %s", growth->of.name, value, ts_error_message());
	ts_speed_set_close(set);
	free(set);
	return status == TS_SKIPPED ? TS_OK : status;
}

/* Whether a value is measured: threads beyond those requested are not. */
static bool is_asked(const ts_speed *speed, const ts_speed_growth *growth, const char *value)
{
	return strcmp(growth->param, "threads") != 0 || number(value) <= speed->job->how.threads;
}

static ts_status measure_growth(curves *c, ts_speed *speed)
{
	const char *values = speed->job->objects != NULL ? speed->job->objects : c->growth->values;
	char value[16];
	ts_status status = TS_OK;
	while (status == TS_OK && ts_words_item(&values, value, sizeof value)) {
		if (c->of[0].n < POINTS && is_asked(speed, c->growth, value)) status = measure_point(c, speed, value);
	}
	return status;
}

static double slope(const double *value, const ts_speed_value *time, u32 a, u32 b)
{
	return log(time[b].median / time[a].median) / log(value[b] / value[a]);
}

/* The exponent of the power law with the least squared error of logarithms. */
static double exponent(const double *value, const ts_speed_value *time, u32 n)
{
	double x = 0, y = 0, xx = 0, xy = 0;
	for (u32 i = 0; i < n; i++) {
		double a = log(value[i]), b = log(time[i].median);
		x += a;
		y += b;
		xx += a * a;
		xy += a * b;
	}
	return (n * xy - x * y) / (n * xx - x * x);
}

static void add_points(ts_table *t, const curves *c, const series *s, const ts_speed_value *time, const char *what)
{
	for (u32 i = 0; i < s->n; i++) {
		ts_table_text(t, c->growth->of.name);
		ts_table_real(t, s->value[i], 0);
		ts_table_text(t, s->method);
		ts_table_text(t, what);
		ts_table_real(t, 1e3 * time[i].median, 1);
		ts_table_real(t, time[i].spread, 1);
		ts_table_known(t, i > 0 ? slope(s->value, time, i - 1, i) : NAN, 2);
		ts_table_text(t, ts_speed_state(&time[i]));
	}
}

static void add_law(ts_table *t, const curves *c, const series *s, const ts_speed_value *time, const char *what)
{
	char range[64];
	double steepest = -INFINITY;
	if (s->n < 2) return;
	for (u32 i = 1; i < s->n; i++) steepest = fmax(steepest, slope(s->value, time, i - 1, i));
	snprintf(range, sizeof range, "%.0f, %.0f", s->value[0], s->value[s->n - 1]);
	ts_table_text(t, c->growth->of.name);
	ts_table_text(t, range);
	ts_table_text(t, s->method);
	ts_table_text(t, what);
	ts_table_known(t, exponent(s->value, time, s->n), 2);
	ts_table_known(t, steepest, 2);
}

typedef void add_rows(ts_table *t, const curves *c, const series *s, const ts_speed_value *time, const char *what);

static void add_all(ts_table *t, const curves *c, add_rows *add)
{
	for (u32 i = 0; i < c->n_series; i++) {
		add(t, c, &c->of[i], c->of[i].whole, "frame");
		bool parted = c->of[i].n > 0 && c->of[i].part[0].median > 0;
		if (parted) add(t, c, &c->of[i], c->of[i].part, c->growth->called);
	}
}

static ts_status add_growth(ts_table *points, ts_table *laws, ts_speed *speed, const ts_speed_growth *growth)
{
	curves *c = ts_alloc_zero(1, sizeof *c, "times");
	if (c == NULL) return TS_ERROR;
	c->growth = growth;
	ts_status status = measure_growth(c, speed);
	add_all(points, c, add_points);
	add_all(laws, c, add_law);
	free(c);
	return status;
}

ts_status ts_speed_print_growths(ts_speed *speed)
{
	ts_status status = TS_OK;
	ts_table points = ts_table_begin("growth", "As one thing grows", point_columns);
	ts_table laws = ts_table_begin("exponents", "Exponents of power laws, and of their steepest step", law_columns);
	points.timed = laws.timed = true;
	for (const ts_speed_of *const *list = speed->lists; *list != NULL && status == TS_OK; list++) {
		const ts_speed_growth *growth = (*list)->growths;
		for (; growth->of.name != NULL && status == TS_OK; growth++) {
			if (ts_speed_wants(speed->job, growth->of.name)) status = add_growth(&points, &laws, speed, growth);
		}
	}
	if (points.n_cells > 0) ts_report_table(speed->report, &points);
	if (laws.n_cells > 0) ts_report_table(speed->report, &laws);
	ts_table_end(&points);
	ts_table_end(&laws);
	return status;
}
