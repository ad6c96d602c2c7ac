/* `render EFFECT [SCENE]` of one frame. The report is printed after the files are written, so that a reader that goes
 * away costs no picture. */
#include "cli/render.h"
#include <stdlib.h>
#include "cli/line/cli.h"
#include "study/asked/reads.h"
#include "study/asked/sweep.h"
#include "study/results/folder.h"

enum { DARK = 8 };
enum { TRUTH_RAYS = 1 << 25 }; /* per truth of --truth: about 10 s on two cores */

static ts_status prepare_traces(ts_render *render)
{
	const ts_job *job = render->job;
	if (!ts_render_traces(job)) return TS_OK;
	for (u32 i = 0; i < render->n_methods; i++) {
		if (ts_tracing_make(&render->tracings[i], job, render->methods[i]) != TS_OK) return TS_ERROR;
		if (render->n_methods > 1 && !job->output.self_contained) render->tracings[i].options.shared = &render->shared;
	}
	return ts_tracing_check(render->tracings, render->methods, render->n_methods, render->scene, &job->params,
	                        ts_render_output(job));
}

static ts_status work(ts_render *render, ts_report *report)
{
	const ts_job *job = render->job;
	ts_status status = ts_render_open(render);
	if (status == TS_OK) status = prepare_traces(render);
	if (status != TS_OK) return status;
	ts_render_report_head(render, report);
	ts_render_truths_missing(render, report);
	status = ts_report_print(report);
	if (status == TS_OK) status = ts_render_make(render);
	if (status != TS_OK) return status;
	status = ts_render_compare(render);
	if (status != TS_OK) return status;
	ts_render_report_body(render, report);
	status = ts_report_check(report);
	if (status != TS_OK || !ts_render_writes(job)) return status;
	if (!job->output.no_images) status = ts_render_write(render);
	return status == TS_OK ? ts_results_report(report) : status;
}

/* One line per method with a note. */
static void say_notes(const ts_render *render)
{
	for (u32 i = 0; i < render->n_methods; i++) {
		if (render->measures[i].note[0] != '\0') ts_say("%s: %s", render->methods[i]->name, render->measures[i].note);
	}
}

static bool is_sky(const ts_picture *picture, u64 i, f32 exposure)
{
	(void)exposure;
	return picture->seen != NULL && picture->seen[i] == 0;
}

/* Brighter than is displayed. */
static bool is_white(const ts_picture *picture, u64 i, f32 exposure)
{
	const f32 *p = picture->radiance + 3 * i;
	return ts_min(ts_min(p[0], p[1]), p[2]) * (picture->gain * exposure) > 1.0f;
}

static bool is_black(const ts_picture *picture, u64 i, f32 exposure)
{
	(void)exposure;
	const u8 *p = picture->srgb + 3 * i;
	return p[0] <= DARK && p[1] <= DARK && p[2] <= DARK;
}

/* Pictures that show nothing: those with more than so many percent of such pixels. */
static const struct {
	bool (*is)(const ts_picture *picture, u64 pixel, f32 exposure);
	u32 percent;
	const char *what, *advice;
} nothings[] = {
	{is_sky, 99, "sky", "--eye and --target, or --camera; info says where the scene is"},
	{is_white, 95, "white", "--exposure auto"},
	{is_black, 95, "black", "--lamp X,Y,Z, --eye and --target, or --set image.exposure=8"},
};

static void advise(const ts_picture *picture, const char *name, u64 n, f32 exposure)
{
	for (size_t k = 0; k < sizeof nothings / sizeof *nothings && picture->srgb != NULL; k++) {
		u64 found = 0;
		for (u64 i = 0; i < n; i++) found += nothings[k].is(picture, i, exposure);
		if (found * 100 <= n * nothings[k].percent) continue;
		ts_say("%s: more than %u %% of the picture is %s; try %s", name, (unsigned)nothings[k].percent,
		       nothings[k].what, nothings[k].advice);
		return;
	}
}

void ts_render_advise(const ts_render *render)
{
	const ts_params *p = &render->job->params;
	u64 n = (u64)TS_PARAM(p, width) * TS_PARAM(p, height);
	bool mirrors = ts_effect_find(render->effect)->mirrors && render->scene->info.n_reflectors > 0;
	if (mirrors && (render->mirrors == NULL || render->mirrors->n_reflective == 0))
		ts_say("no mirror is in the picture; try --mirror X,Y,Z,R, another --eye and --target, or --camera");
	for (u32 i = 0; i < render->n_methods; i++)
		advise(&render->pictures[i], render->methods[i]->name, n, TS_PARAM(p, image_exposure));
}

static ts_status work_in_folder(ts_render *render, void *user)
{
	(void)user;
	const ts_job *job = render->job;
	bool files = ts_render_writes(job);
	ts_status status = files ? ts_results_begin(ts_render_output(job), job->output.force) : TS_OK;
	if (status != TS_OK) return status;
	ts_report report;
	ts_report_begin(&report, job->output.json);
	report.quiet = job->output.quiet;
	status = work(render, &report);
	if (status == TS_OK && files) {
		ts_report_line(&report, "%s", "");
		ts_report_line(&report, "The files are in %s", ts_render_output(job));
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
	if (status == TS_OK) ts_render_advise(render);
	return status;
}

void ts_render_help(void)
{
	ts_help_row rows[TS_MAX_METHODS];
	const ts_effect *last = NULL;
	u32 n = 0;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		if ((*at)->effect != last) rows[n++] = (ts_help_row){(*at)->effect->name, (*at)->effect->doc};
		last = (*at)->effect;
	}
	ts_help_table("Effects", rows, n);
	const ts_builtin_info *b;
	for (n = 0; n < TS_MAX_METHODS && (b = ts_builtin_at(n)) != NULL; n++) rows[n] = (ts_help_row){b->name, b->doc};
	ts_help_table("Built-in scenes", rows, n);
}

static bool is_read(const ts_job *job, const ts_pipeline *const *methods, u32 n_methods, const char *param)
{
	const ts_params *taken = job->sweep.n == 0 ? &job->params : NULL;
	bool read = ts_render_scene_reads(job, param);
	for (u32 i = 0; i < n_methods && !read; i++) read = ts_reads_method(methods[i], taken, param);
	for (u32 t = 0; ts_truths()[t] != NULL && !read; t++) {
		read = (job->truths & 1u << t) != 0 && ts_reads("truth", ts_truths()[t]->name, param);
	}
	return read;
}

/* Warns of each parameter that had no effect, after a render that works: a failure is one line. */
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

static bool is_set(const ts_job *job, const char *param)
{
	size_t n, row = 0;
	const ts_param_info *params = ts_param_table(&n);
	while (strcmp(params[row].name, param) != 0) row++;
	return job->set[row];
}

/* Truths that no option names get limited work, except with --frames, where their flicker is judged. */
static ts_status choose_truths(ts_job *job)
{
	if (!job->judged) return TS_OK;
	bool limited = job->truth == NULL && job->frames.step == 0 && !is_set(job, "truth.rays");
	if (limited) TS_PARAM_SET(&job->params, truth_rays, TRUTH_RAYS);
	return ts_truths_find(&job->truths, job->effect, job->truth);
}

ts_status ts_render_command(ts_cli *cli)
{
	ts_job *job = &cli->job;
	job->effect = cli->arguments[0];
	job->scenes = cli->n_arguments > 1 ? cli->arguments[1] : "atrium";
	if (ts_selftest_require() != TS_OK || ts_effect_check(job->effect) != TS_OK) return TS_ERROR;
	if (job->output.dir != NULL && !ts_render_writes(job)) {
		return ts_fail("--output: --no-images writes no files; leave one of the two out");
	}
	bool series = job->sweep.n > 0 || job->frames.step > 0;
	if (job->shard.of > 0 && (!series || job->output.no_images)) {
		return ts_fail("--shard: of pictures of several frames or combinations: --frames, or --set NAME=A,B");
	}
	if (choose_truths(job) != TS_OK) return TS_ERROR;
	ts_measure_keep_memory();
	ts_effect_params(job, job->effect);
	if (job->exposed && cli->parts == NULL && ts_exposure_choose(job) != TS_OK) return TS_ERROR;
	if (job->output.report != NULL && ts_render_page_check(job) != TS_OK) return TS_ERROR;
	ts_status status = series ? ts_render_series(cli) : ts_render_with(job, work_in_folder, NULL);
	if (status == TS_OK && job->output.report != NULL) status = ts_render_page(cli);
	return status == TS_OK ? say_unread(job) : status;
}
