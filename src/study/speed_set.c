/* A scene of `bench speed` with its methods, and the ways to draw that they are compared with. */
#include <math.h>
#include <string.h>
#include "study/asked/words.h"
#include "study/bench_case.h"
#include "study/speed_work.h"

/* Whether a method is to be measured. */
static bool has_method(const ts_job *job, const char *method)
{
	return job->method == NULL || strcmp(job->method, "all") == 0 || ts_words_listed(job->method, method);
}

/* Casts the rays of the views as truths do. */
static ts_status cast_truth(ts_speed_frame *frame, const ts_run *run)
{
	ts_truth *truth;
	if (ts_truth_new(&truth, run) != TS_OK) return TS_ERROR;
	ts_bare_cast_truth(frame->set->bare, truth, frame->set->how.threads);
	frame->casts = ts_truth_cost_of(truth).seconds / frame->set->how.threads;
	ts_truth_free(truth);
	return TS_OK;
}

/* Takes the inputs of rays and points from the first frame. */
static ts_status take(ts_run *run, void *user)
{
	ts_speed_frame *frame = user;
	ts_speed_set *set = frame->set;
	u64 points = (u64)ts_run_counter(run, "points");
	ts_status status = TS_OK;
	u32 n = run->plan.units;
	bool cubes = ts_run_has_cubes(run);
	if (cubes && n > 0) set->face_bytes = ts_run_n_texels(run, 0, n) / (6 * n) * sizeof(u64);
	if (set->wants_rays && set->bare == NULL) status = ts_bare_new(&set->bare, run);
	bool casts = status == TS_OK && set->wants_rays && frame == set->frame;
	if (casts) status = cast_truth(frame, run);
	if (status != TS_OK || !set->wants_points || !cubes || points == 0 || set->points.n > 0) return status;
	return ts_limit_points_place(&set->points, run, points);
}

static ts_status count(ts_speed_frame *frame)
{
	const ts_speed_set *set = frame->set;
	frame->whole = (ts_measure){.whole = true};
	return ts_measure_run(&frame->whole, frame->method, set->scene, &set->params, &set->how, NULL, NULL);
}

static ts_status measure_frame(double *values, void *of)
{
	ts_speed_frame *frame = of;
	ts_speed_set *set = frame->set;
	ts_status status = set->wants_points && frame->whole.method == NULL ? count(frame) : TS_OK;
	if (status != TS_OK) return status;
	frame->last = (ts_measure){.pictures = NULL};
	ts_measure_touch_memory(frame->bytes);
	status = ts_measure_run(&frame->last, frame->method, set->scene, &set->params, &set->how, take, frame);
	for (u32 k = 0; k < frame->last.n_timings; k++) values[k] = frame->last.timings[k].seconds;
	values[TS_SPEED_WHOLE] = frame->last.seconds;
	values[TS_SPEED_CASTS] = frame->casts;
	return status;
}

static ts_status measure_rays(double *values, void *of)
{
	ts_speed_set *set = of;
	double begin = ts_seconds();
	ts_bare_cast(set->bare, set->how.threads);
	*values = ts_seconds() - begin;
	return TS_OK;
}

static ts_status measure_points(double *values, void *of)
{
	ts_speed_set *set = of;
	double begin = ts_seconds();
	ts_limit_points_draw(&set->points, set->how.threads);
	*values = ts_seconds() - begin;
	return TS_OK;
}

static ts_status measure_minima(double *values, void *of)
{
	ts_speed_set *set = of;
	return ts_limit_minima(values, set->face_bytes, set->how.threads);
}

static ts_status open_frames(ts_speed_set *set, const ts_speed_scene *of, const ts_job *job, u32 runs)
{
	ts_status status = TS_OK;
	for (const char *const *name = of->methods; status == TS_OK && *name != NULL; name++) {
		if (!has_method(job, *name)) continue;
		ts_speed_frame *frame = &set->frame[set->n_frames++];
		ts_estimate estimate;
		frame->method = ts_pipeline_find(of->effect, *name);
		frame->set = set;
		frame->row.measure = measure_frame;
		frame->row.of = frame;
		status = ts_speed_row_begin(&frame->row, TS_SPEED_VALUES, runs);
		if (status != TS_OK) return status;
		bool fits = ts_measure_estimate(&estimate, &frame->method, 1, 0, set->scene, &set->params, NULL) == TS_OK;
		if (!fits) return TS_SKIPPED;
		frame->bytes = estimate.run;
	}
	return status;
}

static ts_status begin_row(ts_speed_row *row, ts_status (*measure)(double *, void *), ts_speed_set *set, u32 runs)
{
	row->measure = measure;
	row->of = set;
	return ts_speed_row_begin(row, 1, runs);
}

ts_status ts_speed_set_open(ts_speed_set *set, const char *spec, const ts_speed_scene *of, const ts_job *job, u32 runs)
{
	snprintf(set->name, sizeof set->name, "%s", of->name);
	set->params = job->params;
	set->how = job->how;
	set->n_runs = runs;
	set->wants_rays = of->rays;
	set->wants_points = of->points;
	ts_status status = ts_bench_set_defaults(&set->params, job, of->set, "");
	if (status == TS_OK) status = ts_scene_load(&set->scene, spec, &set->params, &job->scene.options);
	if (status == TS_OK) status = begin_row(&set->rays, measure_rays, set, runs);
	if (status == TS_OK) status = begin_row(&set->drawn, measure_points, set, runs);
	if (status == TS_OK) status = begin_row(&set->minima, measure_minima, set, runs);
	return status == TS_OK ? open_frames(set, of, job, runs) : status;
}

/* A row with nothing to measure has no values. */
static ts_status run_or_none(ts_speed_row *row, bool there, u32 run, ts_quiet *quiet)
{
	if (there) return ts_speed_row_run(row, run, quiet);
	row->values[run] = NAN;
	return TS_OK;
}

ts_status ts_speed_set_run(ts_speed_set *set, u32 run, ts_quiet *quiet)
{
	ts_status status = TS_OK;
	for (u32 i = 0; i < set->n_frames && status == TS_OK; i++)
		status = ts_speed_row_run(&set->frame[i].row, run, quiet);
	if (status == TS_OK) status = run_or_none(&set->rays, set->bare != NULL, run, quiet);
	if (status == TS_OK) status = run_or_none(&set->drawn, set->points.n > 0, run, quiet);
	if (status == TS_OK) status = run_or_none(&set->minima, set->wants_points && set->face_bytes > 0, run, quiet);
	return status;
}

void ts_speed_set_close(ts_speed_set *set)
{
	for (u32 i = 0; i < set->n_frames; i++) ts_speed_row_end(&set->frame[i].row);
	ts_speed_row_end(&set->rays);
	ts_speed_row_end(&set->drawn);
	ts_speed_row_end(&set->minima);
	ts_bare_free(set->bare);
	ts_limit_points_free(&set->points);
	ts_scene_free(set->scene);
}
