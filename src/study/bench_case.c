/* One scene with one number of mirrors or lights, by several methods that take turns, so that other load on the machine
 * affects all equally. */
#include "study/bench_case.h"
#include <math.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "study/asked/truths.h"
#include "study/asked/words.h"

/* The variant whose image is kept. */
typedef struct {
	ts_bench_case *c;
	u32 variant;
} seen;

/* Whether nobody has set a parameter. */
static bool is_free(const ts_params *params, const ts_job *job, const char *name)
{
	char here[64], there[64];
	size_t n, row = 0;
	ts_params defaults;
	const ts_param_info *table = ts_param_table(&n);
	while (row + 1 < n && strcmp(table[row].name, name) != 0) row++;
	if (job->set[row]) return false;
	ts_params_default(&defaults);
	ts_params_format(params, row, here, sizeof here);
	ts_params_format(&defaults, row, there, sizeof there);
	return strcmp(here, there) == 0;
}

/* Whether the list "NAME=VALUE,..." sets a parameter. */
static bool sets(const char *list, const char *name)
{
	char item[64];
	while (ts_words_item(&list, item, sizeof item)) {
		item[strcspn(item, "=")] = 0;
		if (strcmp(item, name) == 0) return true;
	}
	return false;
}

/* With a job, sets only free parameters that the list `but` does not set. */
static ts_status set(ts_params *params, const ts_job *job, const char *list, const char *but)
{
	char item[64];
	ts_status status = TS_OK;
	if (list[0] == 0) list = NULL;
	while (status == TS_OK && ts_words_item(&list, item, sizeof item)) {
		char *value = strchr(item, '=');
		*value = 0;
		if (job == NULL || (is_free(params, job, item) && !sets(but, item)))
			status = ts_params_set(params, item, value + 1);
	}
	return status;
}

ts_status ts_bench_set(ts_params *params, const char *list) { return set(params, NULL, list, ""); }

ts_status ts_bench_set_defaults(ts_params *params, const ts_job *job, const char *list, const char *but)
{
	return set(params, job, list, but);
}

ts_status ts_bench_case_params(ts_params *params, const ts_bench_case *c, u32 variant)
{
	*params = c->params;
	return ts_bench_set(params, c->variants[variant].set);
}

/* Opens it again with surfels if it has none and needs some. */
static ts_status open_scene(ts_bench_case *c)
{
	ts_status status = ts_scene_load(&c->scene, c->spec, &c->params, &c->job->scene.options);
	if (status != TS_OK || c->sampled == 0 || c->scene->n_surfels > 0) return status;
	ts_scene_free(c->scene);
	c->scene = NULL;
	TS_PARAM_SET(&c->params, surfels_from_mesh, c->sampled);
	return ts_scene_load(&c->scene, c->spec, &c->params, &c->job->scene.options);
}

ts_status ts_bench_case_open(ts_bench_case *c, const char *spec, const ts_params *params)
{
	u32 truths = c->judge != NULL ? ts_truth_bit(c->judge) : 0;
	c->spec = spec;
	c->params = *params;
	ts_status status = open_scene(c);
	for (u32 v = 0; v < TS_BENCH_VARIANTS; v++) c->looked[v] = NAN;
	bool judged = c->judge == NULL || c->judge->exists == NULL;
	if (status == TS_OK && !judged && !c->judge->exists(c->scene, &c->params))
		status = ts_fail("truth %s: none of %s; %s", c->judge->name, c->scene->name, c->judge->why_not);
	for (u32 v = 0; status == TS_OK && c->variants[v].method != NULL; v++) {
		ts_params own;
		ts_estimate estimate;
		c->n_variants++;
		c->methods[v] = ts_pipeline_find(c->effect, c->variants[v].method);
		bool takes_long = c->variants[v].runs == TS_LONG || (c->methods[v] != NULL && c->methods[v]->only_named);
		if (takes_long && c->hurried) c->methods[v] = NULL;
		if (c->methods[v] == NULL) continue;
		status = ts_bench_case_params(&own, c, v);
		if (status == TS_OK) status = ts_measure_estimate(&estimate, &c->methods[v], 1, truths, c->scene, &own, NULL);
	}
	return status;
}

/* Also makes the truth that starts from the run. */
static ts_status take_image(ts_run *run, void *user)
{
	seen *s = user;
	ts_bench_case *c = s->c;
	const ts_pipeline *method = c->methods[s->variant];
	ts_status status = ts_picture_take(&c->images[s->variant], method->name, run);
	c->images[s->variant].before = c->before[s->variant];
	if (c->look != NULL) c->looked[s->variant] = c->look(run);
	bool judges = c->judge != NULL && c->truth.srgb == NULL && ts_truth_starts_from(c->judge, method);
	return status == TS_OK && judges ? ts_picture_truth(&c->truth, c->judge, run) : status;
}

static ts_status run_variant(ts_bench_case *c, u32 v, bool first)
{
	ts_params params;
	seen s = {c, v};
	bool takes = first && c->variants[v].seen;
	if (ts_bench_case_params(&params, c, v) != TS_OK) return TS_ERROR;
	ts_how how = c->job->how;
	if (c->variants[v].runs == TS_ALONE) how.threads = 1;
	c->measures[v] = (ts_measure){.rays = c->rays && takes, .history = &c->histories[v], .whole = true};
	return ts_measure_run(&c->measures[v], c->methods[v], c->scene, &params, &how, takes ? take_image : NULL, &s);
}

/* Makes a truth that no variant's run has made. */
static ts_status make_truth(ts_bench_case *c)
{
	ts_picture pictures[TS_MAX_TRUTHS] = {{.name = ""}};
	u32 threads = c->job->how.threads, row = 0;
	if (c->judge->radiance != NULL) return ts_picture_truth_alone(&c->truth, c->judge, c->scene, &c->params, threads);
	if (c->judge->begin == NULL) return TS_OK;
	while (ts_truths()[row] != c->judge) row++;
	ts_status status = ts_picture_truths_begun(pictures, 1u << row, c->judge, c->effect, c->scene, &c->params, threads);
	c->truth = pictures[row];
	return status;
}

/* Keeps the images that the next frame is compared with. */
static void end_frame(ts_bench_case *c)
{
	for (u32 v = 0; v < c->n_variants; v++) {
		free(c->before[v]);
		c->before[v] = c->images[v].srgb;
		c->images[v].srgb = NULL;
		ts_picture_free(&c->images[v]);
	}
	ts_picture_free(&c->truth);
}

ts_status ts_bench_case_run(ts_bench_case *c, u32 run)
{
	ts_status status = TS_OK;
	if (run == 0) end_frame(c);
	for (u32 v = 0; status == TS_OK && v < c->n_variants; v++) {
		ts_bench_runs runs = c->variants[v].runs;
		bool rests = ((runs == TS_ONCE || runs == TS_LONG) && run > 0) || (runs == TS_FIRST && c->begun);
		if (c->methods[v] != NULL && !rests) status = run_variant(c, v, run == 0);
	}
	c->begun = true;
	return status == TS_OK && run == 0 && c->judge != NULL ? make_truth(c) : status;
}

void ts_bench_case_close(ts_bench_case *c)
{
	end_frame(c);
	for (u32 v = 0; v < c->n_variants; v++) {
		free(c->histories[v].n);
		free(c->before[v]);
	}
	ts_scene_free(c->scene);
}

ts_figure_source ts_bench_case_source(const ts_bench_case *c)
{
	return (ts_figure_source){
		c->scene, &c->params, c->methods, c->measures, c->images, &c->truth, c->look != NULL ? c->looked : NULL};
}
