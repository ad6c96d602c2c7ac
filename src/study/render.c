/* One render: runs its methods and truths, and compares the results. */
#include "study/render.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "image/codec.h"
#include "image/flip.h"
#include "scene/sources.h"
#include "study/asked/reads.h"

bool ts_render_traces(const ts_job *job)
{
	const ts_output *output = &job->output;
	return output->trace || output->trace_only != NULL || output->crop != NULL || output->margins ||
	       output->self_contained || output->compress || output->viewer;
}

bool ts_render_writes(const ts_job *job) { return ts_render_traces(job) || !job->output.no_images; }

const char *ts_render_output(const ts_job *job) { return job->output.dir != NULL ? job->output.dir : "out"; }

bool ts_render_scene_reads(const ts_job *job, const char *param)
{
	return ts_reads("scene", ts_builtin_is(job->scenes) ? "built-in" : "file", param);
}

ts_picture *ts_render_picture(ts_render *render, u32 i)
{
	return i < TS_MAX_METHODS ? &render->pictures[i] : &render->truths[i - TS_MAX_METHODS];
}

u32 ts_render_place(const ts_render *render, u32 i)
{
	u32 place = i < render->n_methods ? i : render->n_methods;
	for (u32 t = TS_MAX_METHODS; t < i; t++) place += render->job->truths >> (t - TS_MAX_METHODS) & 1;
	return place;
}

u32 ts_render_count(const ts_render *render) { return ts_render_place(render, TS_MAX_SHOWN); }

void ts_render_name(char *name, size_t bytes, const ts_render *render, u32 i)
{
	if (i < TS_MAX_METHODS) {
		snprintf(name, bytes, "%s", render->methods[i]->name);
	} else {
		ts_picture_truth_name(name, bytes, ts_truths()[i - TS_MAX_METHODS]);
	}
}

const ts_picture *ts_render_shown(const ts_render *render, u32 i)
{
	const ts_picture *picture = i < TS_MAX_METHODS ? &render->pictures[i] : &render->truths[i - TS_MAX_METHODS];
	return picture->srgb != NULL ? picture : NULL;
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
	return status == TS_OK ? ts_render_truths_of(render, after->method, run) : status;
}

static ts_status run_method(ts_render *render, u32 i)
{
	const ts_job *job = render->job;
	after_method after = {render, render->methods[i], i};
	ts_measure *measure = &render->measures[i];
	bool series = job->sweep.n > 0 || job->frames.step > 0;
	measure->pictures = job->output.no_images ? NULL : &render->stages[i];
	measure->rays = job->truths != 0;
	measure->history = &render->histories[i];
	measure->notes = !series;
	measure->whole = series;
	measure->trace = ts_render_traces(job) ? &render->tracings[i].options : NULL;
	measure->viewer = job->output.viewer ? render->tracings[i].viewer : NULL;
	return ts_measure_run(measure, render->methods[i], render->scene, &job->params, &job->how, take_picture, &after);
}

static ts_status compare_light(ts_pair *pair, const ts_params *p)
{
	const ts_picture *a = pair->reference, *b = pair->image, *of = b->near != NULL ? b : a;
	ts_status status = ts_picture_light(&pair->light, a, b, b->seen, p);
	pair->parted = of->near != NULL;
	if (status == TS_OK && pair->parted) status = ts_picture_light(&pair->near, a, b, of->near, p);
	if (status == TS_OK && pair->parted) status = ts_picture_light(&pair->elsewhere, a, b, of->elsewhere, p);
	return status;
}

static double flicker(const ts_pair *pair, const u8 *mask, const ts_params *p)
{
	const ts_picture *reference = pair->reference, *image = pair->image;
	return ts_metrics_flicker(reference->before, reference->srgb, image->before, image->srgb, mask, TS_PARAM(p, width),
	                          TS_PARAM(p, height));
}

static void compare_change(ts_pair *pair, const u8 *mirrors_still, const ts_params *p)
{
	bool known = pair->reference->before != NULL && pair->image->before != NULL;
	pair->flicker = known ? flicker(pair, NULL, p) : NAN;
	pair->reflective_flicker = known && mirrors_still != NULL ? flicker(pair, mirrors_still, p) : NAN;
}

static ts_status compare(ts_render *render, const ts_picture *reference, const ts_picture *image, const char *share)
{
	const ts_params *p = &render->job->params;
	if (reference->srgb == NULL || image->srgb == NULL || render->n_pairs == TS_MAX_PAIRS) return TS_OK;
	ts_pair *pair = &render->pairs[render->n_pairs++];
	*pair = (ts_pair){.reference = reference, .image = image, .share = share};
	pair->chosen = ts_picture_chosen(reference, image);
	pair->all = ts_picture_metrics(reference, image, NULL, p);
	compare_change(pair, render->mirrors_still, p);
	if (render->mirrors != NULL)
		pair->reflective = ts_picture_metrics(reference, image, render->mirrors->reflective, p);
	return compare_light(pair, p);
}

/* The truth of that name; NULL: not made, or the name is "". */
static const ts_picture *truth_named(const ts_render *render, const char *name)
{
	u32 t = 0;
	while (ts_truths()[t] != NULL && strcmp(ts_truths()[t]->name, name) != 0) t++;
	return ts_truths()[t] != NULL ? &render->truths[t] : NULL;
}

ts_status ts_render_compare(ts_render *render)
{
	ts_status status = TS_OK;
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		for (u32 i = 0; i < render->n_methods && status == TS_OK; i++) {
			status = compare(render, &render->truths[t], &render->pictures[i], ts_truths()[t]->share);
		}
	}
	for (u32 t = 0; ts_truths()[t] != NULL && status == TS_OK; t++) {
		const ts_picture *against = truth_named(render, ts_truths()[t]->against);
		if (against != NULL) status = compare(render, against, &render->truths[t], ts_truths()[t]->against_share);
	}
	for (u32 i = 0; i < render->n_methods; i++) {
		for (u32 j = i + 1; j < render->n_methods && status == TS_OK; j++) {
			status = compare(render, &render->pictures[j], &render->pictures[i], "");
		}
	}
	return status;
}

static void find_mirrors(ts_render *render)
{
	render->mirrors = NULL;
	for (u32 i = 0; i < TS_MAX_SHOWN && render->mirrors == NULL; i++) {
		const ts_picture *picture = ts_render_shown(render, i);
		if (picture != NULL && picture->reflective != NULL) render->mirrors = picture;
	}
}

ts_status ts_render_make(ts_render *render)
{
	ts_status status = TS_OK;
	for (u32 i = 0; i < render->n_methods && status == TS_OK; i++) {
		if (render->pictures[i].srgb == NULL) status = run_method(render, i);
	}
	if (status == TS_OK) status = ts_render_truths_rest(render);
	find_mirrors(render);
	return status;
}

/* Bytes a pixel of a picture: radiance, colours and marks; of a file of EXR, with a copy that is read back; and of a
 * picture on a page, decoded, with its PNG as text. */
enum { PICTURE_BYTES = 17, FILE_BYTES = 36, PAGE_BYTES = 12 };

static ts_leaves leaves_of(const ts_render *render)
{
	const ts_output *output = &render->job->output;
	const ts_params *params = &render->job->params;
	const u64 pixels = (u64)TS_PARAM(params, width) * TS_PARAM(params, height), n = ts_render_count(render);
	const u64 page = output->report != NULL ? pixels * PAGE_BYTES * n + (n > 1 ? TS_FLIP_BYTES : 0) : 0;
	const u64 file = output->no_images ? 0 : pixels * (FILE_BYTES + PICTURE_BYTES);
	return (ts_leaves){.pictures = pixels * PICTURE_BYTES * n, .writing = file > page ? file : page};
}

ts_status ts_render_open(ts_render *render)
{
	const ts_job *job = render->job;
	ts_status status = job->output.no_images ? TS_OK : ts_image_load(ts_render_output(job));
	if (status == TS_OK && render->scene == NULL)
		status = ts_scene_load(&render->own, job->scenes, &job->params, &job->scene.options);
	if (status != TS_OK) return status;
	if (render->scene == NULL) render->scene = render->own;
	const ts_leaves leaves = leaves_of(render);
	return ts_measure_estimate(&render->estimate, render->methods, render->n_methods, job->truths, render->scene,
	                           &job->params, &leaves);
}

void ts_render_clear(ts_render *render)
{
	for (u32 i = 0; i < TS_MAX_METHODS; i++) {
		ts_picture_free(&render->pictures[i]);
		ts_stage_pictures_free(&render->stages[i]);
	}
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) ts_picture_free(&render->truths[t]);
	render->mirrors = NULL;
	render->n_pairs = 0;
}

ts_status ts_render_begin(ts_render *render, const ts_job *job)
{
	render->job = job;
	render->effect = job->effect;
	render->folder = "";
	return ts_methods_find(render->methods, &render->n_methods, render->effect, job->method);
}

void ts_render_end(ts_render *render)
{
	ts_render_clear(render);
	for (u32 i = 0; i < TS_MAX_METHODS; i++) free(render->histories[i].n);
	ts_scene_free(render->own);
}

ts_status ts_render_with(const ts_job *job, ts_status (*with)(ts_render *render, void *user), void *user)
{
	ts_render *render = ts_alloc_zero(1, sizeof *render, "a render");
	if (render == NULL) return TS_ERROR;
	ts_status status = ts_render_begin(render, job);
	if (status == TS_OK) status = with(render, user);
	ts_render_end(render);
	free(render);
	return status;
}
