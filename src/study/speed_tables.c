/* The tables of `bench speed`: limits, stages, and figures computed from both. */
#include <math.h>
#include <stdio.h>
#include <string.h>
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

void ts_speed_print_figures(const ts_speed *speed)
{
	ts_table t = ts_table_begin("figures", "Figures", figure_columns);
	t.timed = true;
	for (const ts_speed_of *const *list = speed->lists; *list != NULL; list++) {
		for (const ts_speed_figure *figure = (*list)->figures; figure->text != NULL; figure++) {
			ts_speed_value value = ts_speed_figure_value(speed, *list, figure);
			if (!isnan(value.median)) figure_row(&t, figure, &value);
		}
	}
	ts_report_table(speed->report, &t);
}
