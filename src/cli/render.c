/* `render EFFECT [SCENE]`: runs methods and truths on one frame, compares them, writes what came of it, and only then
 * prints it: a reader that went away costs no picture. */
#include <stdlib.h>
#include "cli.h"
#include "../study/folder.h"
#include "render.h"
#include "../scene/sources.h"
#include "../study/reads.h"
#include "render_csv.h"
#include "../study/sweep.h"

static bool traces(const ts_job *job)
{
	return job->output.trace || job->output.trace_only != NULL || job->output.crop != NULL || job->output.margins ||
	       job->output.viewer;
}

static bool writes_files(const ts_job *job) { return traces(job) || !job->output.no_images; }

static const char *output(const ts_job *job) { return job->output.dir != NULL ? job->output.dir : "out"; }

static ts_status prepare_traces(ts_render *render)
{
	const ts_job *job = render->job;
	if (!traces(job)) return TS_OK;
	for (u32 i = 0; i < render->n_methods; i++) {
		if (ts_tracing_make(&render->tracings[i], job, render->methods[i]) != TS_OK) return TS_ERROR;
	}
	return ts_tracing_check(render->tracings, render->methods, render->n_methods, render->scene, &job->params,
	                        output(job));
}

static ts_status take_mask(ts_render *render, const ts_run *run)
{
	if (render->mask != NULL || !run->frame.buffer[TS_B_mirror_pixel_record].made) return TS_OK;
	render->mask =
		ts_alloc_zero(TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), "the reflective pixels");
	const ts_pixel *pixels = ts_frame_data(&run->frame, TS_B_mirror_pixel_record);
	render->n_reflective = ts_frame_n(&run->frame, TS_B_mirror_pixel_record);
	for (u64 i = 0; i < render->n_reflective && render->mask != NULL; i++) render->mask[pixels[i].index] = 1;
	return render->mask != NULL ? TS_OK : TS_ERROR;
}

typedef struct {
	ts_render *render;
	const ts_pipeline *method;
	u32 at; /* its place in render->methods */
} after_method;

static ts_status take_picture(ts_run *run, void *user)
{
	after_method *after = user;
	ts_render *render = after->render;
	ts_picture *picture = &render->pictures[after->at];
	ts_status status = ts_picture_take(picture, after->method->name, run);
	picture->seconds = render->measures[after->at].seconds;
	if (status == TS_OK) status = take_mask(render, run);
	return status == TS_OK ? ts_render_truths_of(render, after->method, run) : status;
}

static ts_status run_all(ts_render *render)
{
	const ts_job *job = render->job;
	ts_status status = TS_OK;
	for (u32 i = 0; i < render->n_methods && status == TS_OK; i++) {
		after_method after = {render, render->methods[i], i};
		render->measures[i].pictures = job->output.no_images ? NULL : &render->stages[i];
		render->measures[i].rays = job->truths != 0;
		render->measures[i].notes = job->sweep.n == 0;
		render->measures[i].trace = traces(job) ? &render->tracings[i].options : NULL;
		render->measures[i].viewer = job->output.viewer ? render->tracings[i].viewer : NULL;
		status = ts_measure_run(&render->measures[i], render->methods[i], render->scene, &job->params, &job->how,
		                        take_picture, &after);
	}
	return status == TS_OK ? ts_render_truths_rest(render) : status;
}

static void compare_light(ts_pair *pair, const ts_params *p)
{
	const ts_picture *of = pair->image->near != NULL ? pair->image : pair->reference;
	const f32 *reference = pair->reference->radiance, *image = pair->image->radiance;
	u32 width = TS_PARAM(p, width), height = TS_PARAM(p, height);
	pair->light = ts_metrics_light(reference, image, pair->image->seen, width, height);
	pair->parted = of->near != NULL;
	if (!pair->parted) return;
	pair->near = ts_metrics_light(reference, image, of->near, width, height);
	pair->elsewhere = ts_metrics_light(reference, image, of->elsewhere, width, height);
}

static void compare(ts_render *render, const ts_picture *reference, const ts_picture *image, const char *share)
{
	const ts_params *p = &render->job->params;
	if (reference->srgb == NULL || image->srgb == NULL || render->n_pairs == TS_MAX_PAIRS) return;
	ts_pair *pair = &render->pairs[render->n_pairs++];
	pair->reference = reference;
	pair->image = image;
	pair->share = share;
	pair->all = ts_metrics_compare(reference->srgb, image->srgb, NULL, TS_PARAM(p, width), TS_PARAM(p, height));
	compare_light(pair, p);
	if (render->mask != NULL) {
		pair->reflective =
			ts_metrics_compare(reference->srgb, image->srgb, render->mask, TS_PARAM(p, width), TS_PARAM(p, height));
	}
}

/* The truth of that name; NULL: it was not made, or "" names none. */
static const ts_picture *truth_named(const ts_render *render, const char *name)
{
	u32 t = 0;
	while (ts_truths()[t] != NULL && strcmp(ts_truths()[t]->name, name) != 0) t++;
	return ts_truths()[t] != NULL ? &render->truths[t] : NULL;
}

static void compare_all(ts_render *render)
{
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		for (u32 i = 0; i < render->n_methods; i++) {
			compare(render, &render->truths[t], &render->pictures[i], ts_truths()[t]->share);
		}
	}
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		const ts_picture *against = truth_named(render, ts_truths()[t]->against);
		if (against != NULL) compare(render, against, &render->truths[t], ts_truths()[t]->against_share);
	}
	for (u32 i = 0; i < render->n_methods; i++) {
		for (u32 j = i + 1; j < render->n_methods; j++) compare(render, &render->pictures[j], &render->pictures[i], "");
	}
}

static ts_status open_scene(ts_render *render)
{
	const ts_job *job = render->job;
	ts_status status = ts_scene_open(&render->scene, job->scenes, &job->params, &job->scene);
	if (status != TS_OK) return status;
	return ts_measure_estimate(&render->estimate, render->methods, render->n_methods, job->truths, render->scene,
	                           &job->params);
}

static ts_status work(ts_render *render, ts_report *report)
{
	const ts_job *job = render->job;
	ts_status status = open_scene(render);
	if (status == TS_OK) status = prepare_traces(render);
	if (status != TS_OK) return status;
	ts_render_report_head(render, report);
	ts_render_truths_missing(render, report);
	status = ts_report_print(report);
	if (status == TS_OK) status = run_all(render);
	if (status != TS_OK) return status;
	compare_all(render);
	ts_render_report_body(render, report);
	status = ts_report_check(report);
	if (status != TS_OK || !writes_files(job)) return status;
	if (!job->output.no_images) status = ts_render_write(render);
	return status == TS_OK ? ts_results_report(report) : status;
}

static void release(ts_render *render)
{
	for (u32 i = 0; i < TS_MAX_METHODS; i++) {
		ts_picture_free(&render->pictures[i]);
		ts_stage_pictures_free(&render->stages[i]);
	}
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) ts_picture_free(&render->truths[t]);
	free(render->mask);
	ts_scene_free(render->scene);
	free(render);
}

/* A line of each method that has something to say. */
static void say_notes(const ts_render *render)
{
	for (u32 i = 0; i < render->n_methods; i++) {
		if (render->measures[i].note[0] != '\0') ts_say("%s: %s", render->methods[i]->name, render->measures[i].note);
	}
}

static ts_status work_in_folder(ts_render *render, void *user)
{
	(void)user;
	const ts_job *job = render->job;
	bool files = writes_files(job);
	ts_status status = files ? ts_results_begin(output(job), job->output.force) : TS_OK;
	if (status != TS_OK) return status;
	ts_report report;
	ts_report_begin(&report, job->output.json);
	status = work(render, &report);
	if (status == TS_OK && files) {
		ts_report_line(&report, "%s", "");
		ts_report_line(&report, "The files are in %s", output(job));
		status = ts_report_check(&report);
	}
	if (status == TS_OK && files) status = ts_folder_commit();
	if (status != TS_OK) {
		ts_folder_discard();
		ts_report_discard(&report);
		return status;
	}
	status = ts_report_end(&report);
	if (status == TS_OK) say_notes(render);
	return status;
}

/* A render whose method and truths are known, passed to `with`. */
static ts_status with_render(const ts_job *job, ts_status (*with)(ts_render *render, void *user), void *user)
{
	ts_render *render = ts_alloc_zero(1, sizeof *render, "a render");
	if (render == NULL) return TS_ERROR;
	render->job = job;
	render->effect = job->effect;
	ts_status status = ts_methods_find(render->methods, &render->n_methods, render->effect, job->method);
	if (status == TS_OK) status = with(render, user);
	release(render);
	return status;
}

/* One combination of a sweep. */
static ts_status work_for_csv(ts_render *render, void *user)
{
	ts_status status = open_scene(render);
	if (status == TS_OK) status = run_all(render);
	if (status == TS_OK) compare_all(render);
	if (status == TS_OK) ts_render_csv(render, user);
	return status;
}

static ts_status sweep(ts_job *job)
{
	ts_csv csv = {.sweep = &job->sweep};
	bool files = writes_files(job) && job->output.dir != NULL;
	if (files) return ts_fail("-o: a sweep prints CSV and writes no files");
	if (traces(job)) return ts_fail("--trace: a sweep writes no traces");
	job->output.no_images = true;
	for (u32 i = 0; i < ts_sweep_count(&job->sweep); i++) {
		ts_status status = ts_sweep_set(&job->sweep, i, &job->params, csv.values);
		if (status == TS_OK) status = with_render(job, work_for_csv, &csv);
		if (status != TS_OK) return status;
	}
	return TS_OK;
}

void ts_render_help(void)
{
	const ts_effect *last = NULL;
	printf("Effects:\n");
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		if ((*at)->effect != last) printf("  %-22s %s\n", (*at)->effect->name, (*at)->effect->doc);
		last = (*at)->effect;
	}
}

static bool is_read(const ts_job *job, const ts_pipeline *const *methods, u32 n_methods, const char *param)
{
	const ts_params *taken = job->sweep.n == 0 ? &job->params : NULL;
	bool read = ts_reads("scene", ts_builtin_is(job->scenes) ? "built-in" : "file", param);
	for (u32 i = 0; i < n_methods && !read; i++) read = ts_reads_method(methods[i], taken, param);
	for (u32 t = 0; ts_truths()[t] != NULL && !read; t++) {
		read = (job->truths & 1u << t) != 0 && ts_reads("truth", ts_truths()[t]->name, param);
	}
	return read;
}

/* A line is said for each parameter that was set in vain, behind a render that works: a failure is one
 * line. */
static ts_status say_unread(const ts_job *job)
{
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n_methods;
	size_t n;
	const ts_param_info *params = ts_param_table(&n);
	if (ts_methods_find(methods, &n_methods, job->effect, job->method) != TS_OK) return TS_ERROR;
	for (size_t i = 0; i < n; i++) {
		if (!job->set[i] || is_read(job, methods, n_methods, params[i].name)) continue;
		ts_say("--set %s: no method, scene or truth of this render reads it", params[i].name);
	}
	return TS_OK;
}

ts_status ts_render_command(ts_cli *cli)
{
	ts_job *job = &cli->job;
	job->effect = cli->arguments[0];
	job->scenes = cli->n_arguments > 1 ? cli->arguments[1] : "atrium";
	if (ts_selftest_require() != TS_OK || ts_effect_check(job->effect) != TS_OK) return TS_ERROR;
	if (job->judged && ts_truths_find(&job->truths, job->effect, job->truth) != TS_OK) return TS_ERROR;
	ts_measure_keep_memory();
	ts_effect_params(job, job->effect);
	ts_status status = job->sweep.n > 0 ? sweep(job) : with_render(job, work_in_folder, NULL);
	return status == TS_OK ? say_unread(job) : status;
}
