/* The tables of `bench speed`: limits, stages, and figures computed from both. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "study/asked/words.h"
#include "study/speed_work.h"

static const ts_column limit_columns[] = {{"limit", "limit", false},     {"here", "here", true}, {"unit", "", false},
                                          {"spread", "spread, %", true}, {"state", "", false},   {0}};

static void limit_row(ts_table *t, const char *text, const ts_speed_row *row, u32 runs, double scale, const char *unit)
{
	ts_speed_value value = ts_speed_row_value(row, 0, runs);
	ts_table_text(t, text);
	ts_table_known(t, scale * value.median, 1);
	ts_table_text(t, unit);
	ts_table_known(t, value.spread, 1);
	ts_table_text(t, ts_speed_state(&value));
}

void ts_speed_print_limits(const ts_speed *speed)
{
	const ts_speed_machine *machine = &speed->machine;
	ts_table t = ts_table_begin("limits", "What the machine can do", limit_columns);
	t.timed = true;
	for (u32 i = 0; i < TS_SPEED_SIZES; i++) {
		char text[80];
		snprintf(text, sizeof text, "64-bit minima, random texels of %u MiB", (unsigned)ts_speed_mib[i]);
		limit_row(&t, text, &machine->minima[i], speed->n_runs, 1e-6, "millions a second and thread");
	}
	for (u32 i = 0; i < speed->n_sets; i++) {
		const ts_speed_set *set = &speed->sets[i];
		char text[80];
		if (!set->wants_points || set->face_bytes == 0) continue;
		snprintf(text, sizeof text, "the same, of %u KiB, a face of %s", (unsigned)(set->face_bytes >> 10), set->name);
		limit_row(&t, text, &set->minima, speed->n_runs, 1e-6, "millions a second and thread");
	}
	limit_row(&t, "streams that read and write", &machine->stream, speed->n_runs, 1e-9, "GB a second");
	ts_report_table(speed->report, &t);
}

static const ts_column stage_columns[] = {{"frame", "frame", false},
                                          {"stage", "stage", false},
                                          {"ms", "ms", true},
                                          {"spread", "spread, %", true},
                                          {"share", "of the frame, %", true},
                                          {"mb", "MB", true},
                                          {"stream_ms", "streamed, ms", true},
                                          {"near", "of that, %", true},
                                          {"state", "", false},
                                          {0}};

static void stage_row(ts_table *t, const ts_speed_frame *frame, u32 k, double a_second, const char *stage)
{
	u32 runs = frame->set->n_runs;
	char name[80];
	ts_speed_value value = ts_speed_row_value(&frame->row, k, runs);
	ts_speed_value whole = ts_speed_row_value(&frame->row, TS_SPEED_WHOLE, runs);
	double bytes = k < TS_SPEED_WHOLE ? (double)frame->last.moved[k] : NAN;
	double streamed = bytes / a_second;
	snprintf(name, sizeof name, "%s by %s", frame->set->name, frame->method->name);
	ts_table_text(t, name);
	ts_table_text(t, stage);
	ts_table_real(t, 1e3 * value.median, 2);
	ts_table_real(t, value.spread, 1);
	ts_table_known(t, 100 * value.median / whole.median, 1);
	ts_table_known(t, 1e-6 * bytes, 1);
	ts_table_known(t, 1e3 * streamed, 2);
	ts_table_known(t, streamed < value.median ? 100 * streamed / value.median : NAN, 1);
	ts_table_text(t, ts_speed_state(&value));
}

void ts_speed_print_stages(const ts_speed *speed)
{
	ts_table t =
		ts_table_begin("stages", "Stages, and how long streams of what they read and wrote would take", stage_columns);
	double a_second = ts_speed_row_value(&speed->machine.stream, 0, speed->n_runs).median;
	t.timed = true;
	for (u32 i = 0; i < speed->n_sets; i++) {
		for (u32 k = 0; k < speed->sets[i].n_frames; k++) {
			const ts_speed_frame *frame = &speed->sets[i].frame[k];
			for (u32 s = 0; s < frame->last.n_timings; s++)
				stage_row(&t, frame, s, a_second, frame->last.timings[s].stage);
			stage_row(&t, frame, TS_SPEED_WHOLE, a_second, "all");
		}
	}
	ts_report_table(speed->report, &t);
}

static const ts_speed_frame *find(const ts_speed_set **set, const ts_speed *speed, const ts_speed_term *term)
{
	*set = NULL;
	for (u32 i = 0; i < speed->n_sets; i++) {
		if (strcmp(speed->sets[i].name, term->scene) != 0) continue;
		*set = &speed->sets[i];
		for (u32 k = 0; k < (*set)->n_frames; k++) {
			if (term->method != NULL && strcmp((*set)->frame[k].method->name, term->method) == 0)
				return &(*set)->frame[k];
		}
	}
	return NULL;
}

static double seconds_of(const ts_speed_frame *frame, const char *stages, u32 run)
{
	const double *values = frame->row.values + (size_t)run * TS_SPEED_VALUES;
	const ts_measure *m = &frame->last;
	if (stages[0] == 0) return values[TS_SPEED_WHOLE];
	double sum = 0;
	char stage[32];
	while (ts_words_item(&stages, stage, sizeof stage)) {
		const ts_timing *timing = ts_measure_timing(m, stage);
		if (timing != NULL) sum += values[timing - m->timings];
	}
	return sum > 0 ? sum : NAN;
}

static double counted(const ts_speed_frame *frame, const char *name)
{
	const ts_counter *counter = ts_measure_counter(frame->set->wants_points ? &frame->whole : &frame->last, name);
	return counter != NULL ? (double)counter->value : NAN;
}

static double of_frame(const ts_speed_frame *frame, const ts_speed_term *term, u32 run, bool *quiet)
{
	const ts_speed_set *set = frame->set;
	double cores = set->how.threads;
	if (term->kind == TS_SPEED_COUNT) return counted(frame, term->what);
	if (term->kind == TS_SPEED_MINIMA) {
		*quiet &= set->minima.quiet[run];
		return counted(frame, term->what) / (set->minima.values[run] * cores);
	}
	*quiet &= frame->row.quiet[run];
	if (term->kind == TS_SPEED_CASTING) return frame->row.values[(size_t)run * TS_SPEED_VALUES + TS_SPEED_CASTS];
	return seconds_of(frame, term->what, run) * (term->kind == TS_SPEED_CORES ? cores : 1);
}

/* A term in a run; *quiet becomes false where its row was not. */
static double term_in(const ts_speed *speed, const ts_speed_term *term, u32 run, bool *quiet)
{
	const ts_speed_set *set;
	if (term->kind == TS_SPEED_ONE) return 1;
	const ts_speed_frame *frame = find(&set, speed, term);
	if (set == NULL || (frame == NULL && term->method != NULL)) return NAN;
	const ts_params *params = &set->params;
	switch (term->kind) {
	case TS_SPEED_PIXELS: return (double)TS_PARAM(params, width) * TS_PARAM(params, height);
	case TS_SPEED_TEXELS: return set->bare != NULL ? (double)ts_bare_n_rays(set->bare) : NAN;
	case TS_SPEED_SURFELS: return set->scene->n_surfels;
	case TS_SPEED_RAYS: *quiet &= set->rays.quiet[run]; return set->rays.values[run];
	case TS_SPEED_POINTS: *quiet &= set->drawn.quiet[run]; return set->drawn.values[run];
	default: return of_frame(frame, term, run, quiet) / (term->per != NULL ? counted(frame, term->per) : 1);
	}
}

static ts_speed_value figure_of(const ts_speed *speed, const ts_speed_figure *figure)
{
	double values[speed->n_runs];
	bool quiet[speed->n_runs];
	for (u32 run = 0; run < speed->n_runs; run++) {
		quiet[run] = true;
		double below = term_in(speed, &figure->below, run, &quiet[run]);
		values[run] = figure->scale * term_in(speed, &figure->above, run, &quiet[run]) / below;
	}
	return ts_speed_sum(values, quiet, speed->n_runs);
}

static const ts_column figure_columns[] = {{"figure", "figure", false},
                                           {"here", "here", true},
                                           {"unit", "", false},
                                           {"spread", "spread, %", true},
                                           {"goal", "goal", false},
                                           {"verdict", "verdict", false},
                                           {0}};

static void figure_row(ts_table *t, const ts_speed_figure *figure, const ts_speed_value *value)
{
	char goal[32] = "";
	const char *how = figure->bound == TS_SPEED_LEAST ? "at least" : "at most", *verdict = "";
	bool judged = figure->bound != TS_SPEED_SHOWN;
	bool met = figure->bound == TS_SPEED_LEAST ? value->median >= figure->goal : value->median <= figure->goal;
	if (judged) {
		snprintf(goal, sizeof goal, "%s %g", how, figure->goal);
		verdict = !value->quiet ? "not judged: busy" : met ? "met" : "not met";
	}
	ts_table_text(t, figure->text);
	ts_table_real(t, value->median, figure->decimals);
	ts_table_text(t, figure->unit);
	ts_table_real(t, value->spread, 1);
	ts_table_text(t, goal);
	ts_table_text(t, verdict);
}

void ts_speed_print_figures(const ts_speed *speed, const ts_speed_of *const *lists)
{
	ts_table t = ts_table_begin("figures", "Figures", figure_columns);
	t.timed = true;
	for (; *lists != NULL; lists++) {
		for (const ts_speed_figure *figure = (*lists)->figures; figure != NULL && figure->text != NULL; figure++) {
			ts_speed_value value = figure_of(speed, figure);
			if (!isnan(value.median)) figure_row(&t, figure, &value);
		}
	}
	ts_report_table(speed->report, &t);
}
