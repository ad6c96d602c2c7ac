/* Pictures: of runs, and of the truths. */
#include "study/picture.h"
#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "kernels/base/srgb.h"
#include "methods/stages.h"

static const ts_picture_mark *const *lists;

void ts_picture_marks_use(const ts_picture_mark *const *marks) { lists = marks; }

static u64 n_pixels(const ts_params *params) { return (u64)TS_PARAM(params, width) * TS_PARAM(params, height); }

/* Seen by any sample. */
static void mark_seen(ts_picture *picture, const ts_run *run)
{
	u64 n;
	const u64 *seen = ts_pipeline_seen(run, &n);
	for (u64 i = 0; i < n; i++) picture->seen[i % n_pixels(&run->params)] |= seen[i] != TS_EMPTY;
}

static ts_status mark(ts_picture *picture, const ts_run *run)
{
	ts_status status = TS_OK;
	assert(lists != NULL);
	for (const ts_picture_mark *const *list = lists; *list != NULL; list++) {
		for (const ts_picture_mark *rule = *list; *rule != NULL && status == TS_OK; rule++) {
			status = (*rule)(picture, run);
		}
	}
	return status;
}

ts_status ts_picture_take(ts_picture *picture, const char *name, const ts_run *run)
{
	size_t n = (size_t)n_pixels(&run->params) * 3;
	snprintf(picture->name, sizeof picture->name, "%s", name);
	picture->radiance = ts_alloc(n, sizeof(f32), "a picture");
	picture->srgb = ts_alloc(n, 1, "a picture");
	picture->seen = ts_alloc_zero(n / 3, 1, "a picture");
	if (picture->radiance == NULL || picture->srgb == NULL || picture->seen == NULL) return TS_ERROR;
	memcpy(picture->radiance, ts_frame_data(&run->frame, TS_B_image_radiance), n * sizeof(f32));
	memcpy(picture->srgb, ts_frame_data(&run->frame, TS_B_image_srgb), n);
	mark_seen(picture, run);
	bool gathers = run->pipeline != NULL && ts_pipeline_maker(run->pipeline, TS_B_indirect_irradiance) != NULL;
	picture->gain = gathers ? ts_image_gain(run) : 1.0f;
	return mark(picture, run);
}

ts_status ts_picture_make(ts_picture *picture, const char *name, f32 *radiance, const ts_params *params)
{
	size_t n = (size_t)n_pixels(params) * 3;
	snprintf(picture->name, sizeof picture->name, "%s", name);
	picture->radiance = radiance;
	picture->srgb = ts_alloc(n, 1, "a picture");
	for (size_t i = 0; i < n && picture->srgb != NULL; i++) {
		picture->srgb[i] = (u8)ts_srgb_byte(TS_PARAM(params, image_exposure) * radiance[i]);
	}
	return picture->srgb != NULL ? TS_OK : TS_ERROR;
}

void ts_picture_free(ts_picture *picture)
{
	free(picture->radiance);
	free(picture->srgb);
	free(picture->seen);
	free(picture->reflective);
	free(picture->near);
	free(picture->elsewhere);
	free(picture->chosen);
	free(picture->all_srgb);
	free(picture->all_radiance);
	*picture = (ts_picture){.radiance = NULL};
}

static const u8 *srgb_of(const ts_picture *picture)
{
	return picture->chosen != NULL ? picture->all_srgb : picture->srgb;
}

const u8 *ts_picture_chosen(const ts_picture *a, const ts_picture *b)
{
	if (a->chosen == NULL || b->chosen == NULL) return a->chosen != NULL ? a->chosen : b->chosen;
	return a->sampling.chance < b->sampling.chance ? a->chosen : b->chosen;
}

ts_metrics ts_picture_metrics(const ts_picture *reference, const ts_picture *image, const u8 *mask,
                              const ts_params *params)
{
	u32 width = TS_PARAM(params, width), height = TS_PARAM(params, height);
	const ts_metrics_part part = {reference->srgb, image->srgb, srgb_of(reference), srgb_of(image),
	                              ts_picture_chosen(reference, image)};
	return part.chosen != NULL ? ts_metrics_estimate(&part, mask, width, height)
	                           : ts_metrics_compare(reference->srgb, image->srgb, mask, width, height);
}

static const f32 *radiance_of(const ts_picture *picture)
{
	return picture->chosen != NULL ? picture->all_radiance : picture->radiance;
}

ts_status ts_picture_light(ts_light_metrics *light, const ts_picture *reference, const ts_picture *image,
                           const u8 *mask, const ts_params *params)
{
	const f32 *a = radiance_of(reference), *b = radiance_of(image);
	const u8 *chosen = ts_picture_chosen(reference, image);
	u32 width = TS_PARAM(params, width), height = TS_PARAM(params, height), n = width * height;
	u8 *both = chosen != NULL && mask != NULL ? ts_alloc(n, 1, "chosen pixels") : NULL;
	if (chosen != NULL && mask != NULL && both == NULL) return TS_ERROR;
	for (u32 i = 0; both != NULL && i < n; i++) both[i] = chosen[i] && mask[i];
	*light = ts_metrics_light(a, b, both != NULL ? both : chosen != NULL ? chosen : mask, width, height);
	if (chosen != NULL) light->relative = NAN;
	free(both);
	return TS_OK;
}

ts_status ts_picture_difference(ts_picture *difference, const ts_picture *image, const ts_picture *reference,
                                const ts_params *params, u32 scale)
{
	size_t n = (size_t)TS_PARAM(params, width) * TS_PARAM(params, height) * 3;
	*difference = (ts_picture){.srgb = ts_alloc(n, 1, "a difference")};
	difference->radiance = ts_alloc(n, sizeof *difference->radiance, "a difference");
	if (difference->srgb == NULL || difference->radiance == NULL) return TS_ERROR;
	for (size_t i = 0; i < n; i++) {
		u32 d = (u32)abs(image->srgb[i] - reference->srgb[i]) * scale;
		difference->srgb[i] = (u8)(d < 255 ? d : 255);
		difference->radiance[i] = image->radiance[i] - reference->radiance[i];
	}
	return TS_OK;
}

double ts_picture_change(const ts_picture *picture, const u8 *mask, const ts_params *params)
{
	if (picture->before == NULL) return NAN;
	return ts_metrics_flicker(picture->srgb, picture->srgb, picture->before, picture->srgb, mask,
	                          TS_PARAM(params, width), TS_PARAM(params, height));
}

void ts_picture_truth_name(char *name, size_t bytes, const ts_truth_kind *kind)
{
	snprintf(name, bytes, "truth-%s", kind->name);
	for (; *name != 0; name++) *name = (char)tolower(*name);
}

/* Takes over the results of all rays at the chosen pixels. */
static ts_status keep_chosen(ts_picture *picture, ts_picture *all, const ts_params *params)
{
	u32 n = TS_PARAM(params, width) * TS_PARAM(params, height);
	picture->all_srgb = all->srgb;
	picture->all_radiance = all->radiance;
	all->srgb = NULL;
	all->radiance = NULL;
	picture->chosen = ts_alloc(n, 1, "a picture");
	if (picture->chosen == NULL) return TS_ERROR;
	for (u32 i = 0; i < n; i++) picture->chosen[i] = ts_sampling_chooses(&picture->sampling, i);
	return TS_OK;
}

/* Traces a truth, and shows its stage. */
static ts_status trace(ts_picture *picture, const ts_truth_kind *kind, ts_truth *tree, ts_run *run,
                       ts_sampling *sampling)
{
	char name[sizeof picture->name];
	ts_picture_truth_name(name, sizeof name, kind);
	ts_status status = kind->trace(tree, run, sampling);
	if (status == TS_OK) status = ts_run_stage(run, ts_stage_find(kind->image));
	if (status == TS_OK) status = ts_frame_fetch(&run->frame);
	return status == TS_OK ? ts_picture_take(picture, name, run) : status;
}

/* Traces a truth in part once more: all rays, at the chosen pixels. */
static ts_status trace_all(ts_picture *picture, const ts_truth_kind *kind, ts_truth *tree, ts_run *run)
{
	ts_picture all = {.radiance = NULL};
	ts_sampling *sampling = &picture->sampling;
	ts_status status = TS_OK;
	sampling->chosen = ts_sampling_is_part(sampling);
	if (sampling->chosen) status = trace(&all, kind, tree, run, sampling);
	if (status == TS_OK && kind->missed != NULL) {
		status = kind->missed(&picture->n_hits, &picture->n_missed, tree, run, sampling);
	}
	if (status == TS_OK && sampling->chosen) status = keep_chosen(picture, &all, &run->params);
	ts_picture_free(&all);
	return status;
}

/* Sets the cost of this picture's rays: the seconds of all threads, divided by their number. */
static void keep_cost(ts_picture *picture, const ts_truth_cost *before, const ts_truth *tree, u32 threads)
{
	ts_truth_cost after = ts_truth_cost_of(tree);
	picture->cost.rays = after.rays - before->rays;
	picture->cost.seconds = (after.seconds - before->seconds) / threads;
	picture->shading = picture->seconds - picture->cost.seconds;
}

static ts_status take_truth(ts_picture *picture, const ts_truth_kind *kind, ts_truth *tree, ts_run *run)
{
	double begin = ts_seconds();
	ts_truth_cost before = ts_truth_cost_of(tree);
	ts_status status;
	TS_PARAM_READER("truth", kind->name, picture->sampling = ts_sampling_of(&run->params));
	TS_PARAM_READER("truth", kind->name, status = trace(picture, kind, tree, run, &picture->sampling));
	if (status == TS_OK) TS_PARAM_READER("truth", kind->name, status = trace_all(picture, kind, tree, run));
	picture->seconds = ts_seconds() - begin;
	keep_cost(picture, &before, tree, run->c.threads);
	return status;
}

ts_status ts_picture_truth(ts_picture *picture, const ts_truth_kind *kind, ts_run *run)
{
	double begin = ts_seconds();
	ts_truth *tree;
	ts_status status = ts_truth_new(&tree, run);
	if (status == TS_OK) status = take_truth(picture, kind, tree, run);
	ts_truth_free(tree);
	picture->seconds = ts_seconds() - begin;
	return status;
}

ts_status ts_picture_truths_begun(ts_picture pictures[], u32 truths, const ts_truth_kind *first, const char *effect,
                                  const ts_scene *scene, const ts_params *params, u32 threads)
{
	ts_run run;
	ts_truth *tree = NULL;
	ts_run_begin(&run, scene, params, threads);
	ts_status status;
	TS_PARAM_READER("truth", first->name, status = first->begin(&run, effect));
	if (status == TS_OK) status = ts_truth_new(&tree, &run);
	const ts_truth_kind *const *kinds = ts_truths();
	for (u32 t = 0; kinds[t] != NULL && status == TS_OK; t++) {
		bool meant = (truths & 1u << t) != 0 && kinds[t]->begin == first->begin;
		if (meant) status = take_truth(&pictures[t], kinds[t], tree, &run);
	}
	ts_truth_free(tree);
	ts_run_end(&run);
	return status;
}

static ts_status make_alone(ts_picture *picture, const ts_truth_kind *kind, const ts_scene *scene,
                            const ts_params *params, u32 threads)
{
	f32 *radiance;
	char name[sizeof picture->name];
	ts_picture all = {.radiance = NULL};
	ts_sampling *sampling = &picture->sampling;
	*sampling = ts_sampling_of(params);
	ts_picture_truth_name(name, sizeof name, kind);
	ts_status status = kind->radiance(&radiance, scene, params, threads, sampling);
	if (status == TS_OK) status = ts_picture_make(picture, name, radiance, params);
	sampling->chosen = ts_sampling_is_part(sampling);
	if (status != TS_OK || !sampling->chosen) return status;
	status = kind->radiance(&radiance, scene, params, threads, sampling);
	if (status == TS_OK) status = ts_picture_make(&all, name, radiance, params);
	if (status == TS_OK) status = keep_chosen(picture, &all, params);
	ts_picture_free(&all);
	return status;
}

ts_status ts_picture_truth_alone(ts_picture *picture, const ts_truth_kind *kind, const ts_scene *scene,
                                 const ts_params *params, u32 threads)
{
	double begin = ts_seconds();
	ts_status status;
	TS_PARAM_READER("truth", kind->name, status = make_alone(picture, kind, scene, params, threads));
	picture->seconds = ts_seconds() - begin;
	return status;
}
