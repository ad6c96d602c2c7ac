/* Figures of `bench speed`, run by run. */
#include <math.h>
#include <string.h>
#include "study/speed_work.h"

static double rays(const ts_speed_set *set, u32 run, bool *quiet)
{
	*quiet &= set->rays.quiet[run];
	return 1e3 * set->rays.values[run];
}

static double points(const ts_speed_set *set, u32 run, bool *quiet)
{
	*quiet &= set->drawn.quiet[run];
	return 1e3 * set->drawn.values[run];
}

static double casting(const ts_speed_set *set, u32 run, bool *quiet)
{
	const ts_speed_row *row = &set->frame[0].row;
	*quiet &= row->quiet[run];
	return 1e3 * row->values[(size_t)run * TS_SPEED_VALUES + TS_SPEED_CASTS];
}

static double minima(const ts_speed_set *set, u32 run, bool *quiet)
{
	*quiet &= set->minima.quiet[run];
	return 1e-6 * set->minima.values[run];
}

static double texels(const ts_speed_set *set, u32 run, bool *quiet)
{
	(void)run, (void)quiet;
	return set->bare != NULL ? (double)ts_bare_n_rays(set->bare) : NAN;
}

const ts_speed_own ts_speed_owns[] = {
	{"rays", "time of Embree for the off-screen views", "ms", rays},
	{"casting", "time of truths' rays for those of the first method", "ms", casting},
	{"points", "time of as many bare points as the first method has", "ms", points},
	{"minima", "scattered minima of a thread, into faces as they are", "M/s", minima},
	{"texels", "texels of the off-screen views", "", texels},
	{0},
};

static const ts_speed_set *find_set(const ts_speed *speed, const char *name)
{
	u32 i = 0;
	while (i < speed->n_sets && strcmp(speed->sets[i].name, name) != 0) i++;
	return i < speed->n_sets ? &speed->sets[i] : NULL;
}

static const ts_speed_frame *find_frame(const ts_speed_set *set, const char *method)
{
	u32 i = 0;
	while (i < set->n_frames && strcmp(set->frame[i].method->name, method) != 0) i++;
	return i < set->n_frames ? &set->frame[i] : NULL;
}

/* What was measured in a run. */
static ts_measure measure_of(const ts_speed_frame *frame, u32 run)
{
	const double *values = frame->row.values + (size_t)run * TS_SPEED_VALUES;
	const ts_measure *counted = frame->set->wants_points ? &frame->whole : &frame->last;
	ts_measure m = frame->last;
	m.seconds = values[TS_SPEED_WHOLE];
	for (u32 k = 0; k < m.n_timings; k++) m.timings[k].seconds = values[k];
	memcpy(m.counters, counted->counters, sizeof m.counters);
	m.n_counters = counted->n_counters;
	return m;
}

/* A figure of a method, or of the scene. */
static double of_frame(const ts_speed_set *set, const char *method, const ts_figure *figure, u32 run, bool *quiet)
{
	ts_figure of = *figure;
	ts_measure measure;
	ts_figure_source source = {.scene = set->scene, .params = &set->params, .measures = &measure};
	if (!figure->row->of_case) {
		const ts_speed_frame *frame = find_frame(set, method);
		if (frame == NULL) return NAN;
		measure = measure_of(frame, run);
		source.methods = &frame->method;
		if (figure->row->timed) *quiet &= frame->row.quiet[run];
	}
	of.variant = 0;
	return ts_figure_value(&of, &source);
}

static double value_in(const ts_speed *speed, const ts_speed_of *of, const ts_speed_name *name, u32 run, bool *quiet)
{
	if (name->scene == TS_NONE) return speed->job->how.threads;
	const ts_speed_scene *scene = &of->scenes[name->scene];
	const ts_speed_set *set = find_set(speed, scene->name);
	if (set == NULL) return NAN;
	if (name->own != NULL) return name->own->value(set, run, quiet);
	const char *method = name->figure.row->of_case ? NULL : scene->methods[name->figure.variant];
	return of_frame(set, method, &name->figure, run, quiet);
}

/* Whether a figure's expression has the name of this number. */
static bool has(const ts_speed_figure *figure, u32 name)
{
	u32 i = 0;
	while (i < figure->n_terms && (figure->terms[i].kind != TS_TERM_MEASURED || figure->terms[i].at != name)) i++;
	return i < figure->n_terms;
}

ts_speed_value ts_speed_figure_value(const ts_speed *speed, const ts_speed_of *of, const ts_speed_figure *figure)
{
	double values[speed->n_runs], measured[of->n_names];
	bool quiet[speed->n_runs];
	const ts_expression_values given = {.measured = measured};
	for (u32 run = 0; run < speed->n_runs; run++) {
		quiet[run] = true;
		for (u32 k = 0; k < of->n_names; k++)
			measured[k] = has(figure, k) ? value_in(speed, of, &of->names[k], run, &quiet[run]) : NAN;
		values[run] = ts_expression_value(figure->terms, figure->n_terms, &given);
	}
	return ts_speed_sum(values, quiet, speed->n_runs);
}
