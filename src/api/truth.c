/* Ground truth. */
#include <pthread.h>
#include <stdlib.h>
#include <touchstone/truth.h>
#include "api/api.h"
#include "study/asked/truths.h"
#include "study/measure.h"

static ts_truth_info infos[TS_MAX_TRUTHS];
static size_t n_infos;

static void list(void)
{
	ts_api_ready();
	for (const ts_truth_kind *const *kind = ts_truths(); *kind != NULL; kind++) {
		infos[n_infos++] = (ts_truth_info){(*kind)->name,  (*kind)->effects, (*kind)->doc,
		                                   (*kind)->share, (*kind)->against, (*kind)->against_share};
	}
}

const ts_truth_info *ts_truth_at(size_t i)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, list);
	return i < n_infos ? &infos[i] : NULL;
}

typedef struct {
	ts_truth_image image; /* first: what callers hold */
	ts_picture picture;
} made;

typedef struct {
	const ts_truth_kind *kind;
	const ts_context *context;
	const ts_scene *scene;
	const ts_params *params;
	const char *effect;
	ts_picture *picture;
} job;

static ts_status trace_behind(ts_run *run, void *user)
{
	const job *j = user;
	return ts_picture_truth(j->picture, j->kind, run);
}

/* Traces in a run of the first method that makes the truth's inputs. */
static ts_status trace_in_run(job *j)
{
	ts_measure measure = {.pictures = NULL};
	for (const ts_pipeline *const *p = ts_pipelines(); *p != NULL; p++) {
		if (strcmp((*p)->effect->name, j->effect) != 0 || !ts_truth_starts_from(j->kind, *p)) continue;
		return ts_measure_run(&measure, *p, j->scene, j->params, &j->context->how, trace_behind, j);
	}
	return ts_fail("truth %s: no method of %s makes what it starts from", j->kind->name, j->effect);
}

static ts_status trace(job *j)
{
	const ts_truth_kind *kind = j->kind;
	u32 threads = j->context->how.threads;
	if (kind->exists != NULL && !kind->exists(j->scene, j->params)) {
		return ts_fail("truth %s: none of %s; %s", kind->name, j->scene->name, kind->why_not);
	}
	if (kind->radiance != NULL) return ts_picture_truth_alone(j->picture, kind, j->scene, j->params, threads);
	if (kind->begin == NULL) return trace_in_run(j);
	ts_picture pictures[TS_MAX_TRUTHS] = {{.radiance = NULL}};
	u32 bit = ts_truth_bit(kind), t = 0;
	while (bit >> t != 1) t++;
	ts_status status = ts_picture_truths_begun(pictures, bit, kind, j->effect, j->scene, j->params, threads);
	*j->picture = pictures[t];
	return status;
}

static ts_status render(made *m, job *j)
{
	ts_status status = trace(j);
	if (status == TS_OK && ts_cancelled()) return ts_fail_as(TS_KIND_CANCELLED, "truth %s: cancelled", j->kind->name);
	m->image = (ts_truth_image){TS_PARAM(j->params, width), TS_PARAM(j->params, height), m->picture.radiance,
	                            m->picture.srgb, ts_sampling_is_part(&m->picture.sampling)};
	return status;
}

static ts_status find(const ts_truth_kind **kind, const char *effect, const char *name)
{
	char names[256];
	if (ts_api_effect(effect) != TS_OK) return TS_ERROR;
	*kind = ts_truths_one(name, effect);
	if (*kind != NULL) return TS_OK;
	ts_truths_list(names, sizeof names, effect, " and ");
	return ts_fail("truth \"%.40s\": no truth of %s; it has %s", name, effect, names);
}

ts_status ts_truth_render(ts_context *context, ts_truth_image **image, const ts_scene *scene, const ts_params *params,
                          const char *effect, const char *truth)
{
	job j = {.context = context, .scene = scene, .params = params, .effect = effect};
	if (TS_LACKS(image)) return TS_ERROR;
	*image = NULL;
	if (TS_LACKS(context) || TS_LACKS(scene) || TS_LACKS(params) || TS_LACKS(effect) || TS_LACKS(truth)) {
		return TS_ERROR;
	}
	if (find(&j.kind, effect, truth) != TS_OK || ts_api_enter(context) != TS_OK) return TS_ERROR;
	made *m = ts_alloc_zero(1, sizeof *m, "a picture");
	j.picture = m != NULL ? &m->picture : NULL;
	ts_status status = m != NULL ? render(m, &j) : TS_ERROR;
	ts_api_leave();
	if (status == TS_OK) {
		*image = &m->image;
	} else {
		ts_truth_image_free(m != NULL ? &m->image : NULL);
	}
	return status;
}

void ts_truth_image_free(ts_truth_image *image)
{
	made *m = (made *)image;
	if (m != NULL) ts_picture_free(&m->picture);
	free(m);
}
