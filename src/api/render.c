/* Renderings. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <touchstone/render.h>
#include "api/api.h"
#include "study/figure.h"
#include "study/render.h"

typedef struct {
	ts_figure of;
	char name[128];
} named;

typedef struct difference {
	struct difference *next;
	ts_picture picture;
	ts_rendering_picture shown;
	char name[64];
} difference;

struct ts_rendering {
	ts_job job;
	ts_render render;
	const char *methods[TS_MAX_METHODS], *truths[TS_MAX_TRUTHS + 1]; /* names */
	u8 *before[TS_MAX_SHOWN];                                        /* srgb of the frame before */
	ts_rendering_picture pictures[TS_MAX_SHOWN + TS_MAX_METHODS * TS_MAX_STAGE_PICTURES];
	char names[TS_MAX_METHODS * TS_MAX_STAGE_PICTURES][64];
	size_t n_pictures;
	difference *differences; /* that were asked for */
	named **figures;
	size_t n_figures, capacity;
};

static void free_difference(difference *d)
{
	if (d != NULL) ts_picture_free(&d->picture);
	free(d);
}

static ts_name_scope scope_of(const ts_rendering *r)
{
	return (ts_name_scope){r->methods, r->truths, r->render.n_methods, NULL, 0, false};
}

static ts_figure_source source_of(const ts_rendering *r)
{
	const ts_render *render = &r->render;
	return (ts_figure_source){
		render->scene, &r->job.params, render->methods, render->measures, render->pictures, render->truths, NULL};
}

/* Copies what the frame before leaves to this one. */
static ts_status take_before(ts_rendering *r, const ts_rendering *before)
{
	size_t n = (size_t)TS_PARAM(&r->job.params, width) * TS_PARAM(&r->job.params, height) * 3;
	if (before->render.scene != r->render.scene || strcmp(before->render.effect, r->render.effect) != 0 ||
	    before->render.n_methods != r->render.n_methods || before->job.truths != r->job.truths ||
	    memcmp(before->render.methods, r->render.methods, sizeof r->render.methods) != 0 ||
	    TS_PARAM(&before->job.params, width) != TS_PARAM(&r->job.params, width) ||
	    TS_PARAM(&before->job.params, height) != TS_PARAM(&r->job.params, height))
		return ts_fail("ts_rendering_options.before: is of another scene, effect, size, methods or truths");
	for (u32 i = 0; i < TS_MAX_METHODS; i++) {
		const ts_history *from = &before->render.histories[i];
		if (from->n == NULL) continue;
		r->render.histories[i] = *from;
		r->render.histories[i].n = ts_alloc(from->n_cubes, sizeof *from->n, "sizes of cubes");
		if (r->render.histories[i].n == NULL) return TS_ERROR;
		memcpy(r->render.histories[i].n, from->n, from->n_cubes * sizeof *from->n);
	}
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		const ts_picture *from = ts_render_shown(&before->render, i);
		if (from == NULL) continue;
		r->before[i] = ts_alloc(n, 1, "the frame before");
		if (r->before[i] == NULL) return TS_ERROR;
		memcpy(r->before[i], from->srgb, n);
	}
	return TS_OK;
}

static ts_status refuse_absent(const ts_rendering *r)
{
	u32 absent = ts_render_truths_absent(&r->render);
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		const ts_truth_kind *kind = ts_truths()[t];
		if ((absent >> t & 1) == 0) continue;
		if (kind->exists != NULL && !kind->exists(r->render.scene, &r->job.params))
			return ts_fail("truth %s: none of %s; %s", kind->name, r->render.scene->name, kind->why_not);
		return ts_fail("truth %s: takes more than truth.rays; 0 makes it", kind->name);
	}
	return TS_OK;
}

static ts_rendering_picture shown(const ts_rendering *r, const char *name, const ts_picture *picture)
{
	const ts_params *p = &r->job.params;
	return (ts_rendering_picture){name,          TS_PARAM(p, width), TS_PARAM(p, height),
	                              picture->srgb, picture->radiance,  ts_sampling_is_part(&picture->sampling)};
}

static void list_pictures(ts_rendering *r)
{
	ts_render *render = &r->render;
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		const ts_picture *picture = ts_render_shown(render, i);
		if (picture != NULL) r->pictures[r->n_pictures++] = shown(r, picture->name, picture);
	}
	for (u32 i = 0, n = 0; i < render->n_methods; i++) {
		ts_stage_pictures_finish(&render->stages[i], render->pictures[i].srgb);
		for (u32 k = 0; k < render->stages[i].n; k++, n++) {
			const ts_stage_picture *stage = &render->stages[i].picture[k];
			snprintf(r->names[n], sizeof r->names[n], "%s-%s", r->methods[i], stage->name);
			r->pictures[r->n_pictures++] =
				(ts_rendering_picture){r->names[n], stage->width, stage->height, stage->rgb, NULL, 0};
		}
	}
}

static ts_status add_figure(ts_rendering *r, const char *format, ...) __attribute__((format(printf, 2, 3)));
static ts_status add_figure(ts_rendering *r, const char *format, ...)
{
	va_list arguments;
	void *figures = r->figures;
	named *f = ts_alloc_zero(1, sizeof *f, "a figure");
	if (f == NULL) return TS_ERROR;
	va_start(arguments, format);
	vsnprintf(f->name, sizeof f->name, format, arguments);
	va_end(arguments);
	const ts_name_scope scope = scope_of(r);
	ts_status status = ts_name_find(&f->of, &scope, f->name);
	if (status == TS_OK) status = ts_grow(&figures, &r->capacity, r->n_figures + 1, sizeof *r->figures, "figures");
	if (status != TS_OK) {
		free(f);
		return status;
	}
	r->figures = figures;
	r->figures[r->n_figures++] = f;
	return TS_OK;
}

/* Counters have _ for what is no letter or digit. */
static ts_status list_counters(ts_rendering *r, u32 method)
{
	const ts_measure *m = &r->render.measures[method];
	ts_status status = TS_OK;
	for (u32 i = 0; i < m->n_counters && status == TS_OK; i++) {
		char name[64];
		ts_figure_counter(name, sizeof name, m->counters[i].name);
		status = add_figure(r, "%s.count.%s", r->methods[method], name);
	}
	return status;
}

static ts_status list_stages(ts_rendering *r, u32 method)
{
	const ts_measure *m = &r->render.measures[method];
	ts_status status = TS_OK;
	for (u32 i = 0; i < m->n_timings && status == TS_OK; i++)
		status = add_figure(r, "%s.ms.%s", r->methods[method], m->timings[i].stage);
	return status;
}

static ts_status list_buffers(ts_rendering *r, u32 method)
{
	const ts_measure *m = &r->render.measures[method];
	ts_status status = TS_OK;
	for (u32 id = 0; id < TS_N_BUFFERS && status == TS_OK; id++)
		if (m->bytes[id] > 0) status = add_figure(r, "%s.bytes.%s", r->methods[method], ts_buffer_table[id].name);
	return status;
}

static ts_status list_errors(ts_rendering *r, u32 method, const char *row)
{
	ts_status status = TS_OK;
	for (u32 i = 0; i < r->render.n_methods && status == TS_OK; i++)
		if (i != method) status = add_figure(r, "%s.%s.%s", r->methods[method], row, r->methods[i]);
	for (u32 t = 0; r->truths[t] != NULL && status == TS_OK; t++)
		if (r->render.truths[t].srgb != NULL) status = add_figure(r, "%s.%s.%s", r->methods[method], row, r->truths[t]);
	return status;
}

static ts_status list_row(ts_rendering *r, u32 method, const ts_figure_row *row)
{
	switch (row->object) {
	case TS_FIGURE_OF_COUNTER: return list_counters(r, method);
	case TS_FIGURE_OF_STAGES: return row->timed && strcmp(row->name, "ms") == 0 ? list_stages(r, method) : TS_OK;
	case TS_FIGURE_OF_BUFFERS: return list_buffers(r, method);
	case TS_FIGURE_OF_IMAGE: return list_errors(r, method, row->name);
	default: return add_figure(r, "%s.%s", r->methods[method], row->name);
	}
}

static ts_status list_figures(ts_rendering *r)
{
	ts_status status = TS_OK;
	for (const ts_figure_row *row = ts_figure_rows; row->name != NULL && status == TS_OK; row++)
		if (row->of_case && row->object == TS_FIGURE_ALONE) status = add_figure(r, "%s", row->name);
	for (u32 i = 0; i < r->render.n_methods; i++) {
		for (const ts_figure_row *row = ts_figure_rows; row->name != NULL && status == TS_OK; row++)
			if (!row->of_case) status = list_row(r, i, row);
	}
	return status;
}

static ts_status make(ts_rendering *r, const ts_rendering_options *options)
{
	ts_job *job = &r->job;
	ts_status status = ts_render_begin(&r->render, job);
	job->method = NULL; /* the caller's */
	if (status == TS_OK && options->truths != NULL) status = ts_truths_find(&job->truths, job->effect, options->truths);
	if (status == TS_OK) status = ts_render_open(&r->render);
	if (status == TS_OK) status = refuse_absent(r);
	for (u32 i = 0; i < r->render.n_methods; i++) r->methods[i] = r->render.methods[i]->name;
	for (u32 t = 0; ts_truths()[t] != NULL; t++) r->truths[t] = ts_truths()[t]->name;
	if (status == TS_OK && options->before != NULL) status = take_before(r, options->before);
	if (status == TS_OK) status = ts_render_make(&r->render);
	if (status == TS_OK && ts_cancelled()) return ts_fail_as(TS_KIND_CANCELLED, "%s: cancelled", job->effect);
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) ts_render_picture(&r->render, i)->before = r->before[i];
	if (status == TS_OK) list_pictures(r);
	return status == TS_OK ? list_figures(r) : status;
}

ts_status ts_rendering_make(ts_context *context, ts_rendering **rendering, const ts_scene *scene,
                            const ts_params *params, const char *effect, const ts_rendering_options *options)
{
	ts_rendering_options ours = {0};
	if (TS_LACKS(rendering)) return TS_ERROR;
	*rendering = NULL;
	if (TS_LACKS(context) || TS_LACKS(scene) || TS_LACKS(params) || TS_LACKS(effect)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_rendering_options") != TS_OK) return TS_ERROR;
	if (ts_api_effect(effect) != TS_OK || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_rendering *made = ts_alloc_zero(1, sizeof *made, "a rendering");
	ts_status status = made != NULL ? TS_OK : TS_ERROR;
	if (status == TS_OK) {
		made->job = (ts_job){.effect = ts_effect_find(effect)->name, .params = *params, .how = context->how};
		made->job.method = ours.methods;
		made->job.output.no_images = ours.stages == 0;
		made->render.scene = scene;
		status = make(made, &ours);
	}
	ts_api_leave();
	if (status == TS_OK) {
		*rendering = made;
	} else {
		ts_rendering_free(made);
	}
	return status;
}

void ts_rendering_free(ts_rendering *rendering)
{
	if (rendering == NULL) return;
	ts_render_end(&rendering->render);
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) free(rendering->before[i]);
	for (size_t i = 0; i < rendering->n_figures; i++) free(rendering->figures[i]);
	free(rendering->figures);
	for (difference *d = rendering->differences, *next; d != NULL; d = next) {
		next = d->next;
		free_difference(d);
	}
	free(rendering);
}

const ts_rendering_picture *ts_rendering_picture_at(const ts_rendering *rendering, size_t i)
{
	return rendering != NULL && i < rendering->n_pictures ? &rendering->pictures[i] : NULL;
}

/* Finds the pictures of the eye's size whose names are those of "difference-FIRST-SECOND". */
static bool find_two(const ts_picture *of[2], const ts_render *render, const char *name)
{
	for (u32 i = 0; i < TS_MAX_SHOWN * TS_MAX_SHOWN; i++) {
		char both[64];
		of[0] = ts_render_shown(render, i / TS_MAX_SHOWN);
		of[1] = ts_render_shown(render, i % TS_MAX_SHOWN);
		if (of[0] == NULL || of[1] == NULL || of[0] == of[1]) continue;
		snprintf(both, sizeof both, "difference-%s-%s", of[0]->name, of[1]->name);
		if (strcmp(both, name) == 0) return true;
	}
	return false;
}

static ts_status make_difference(difference **made, const ts_rendering *r, const char *name)
{
	const ts_picture *of[2];
	if (!find_two(of, &r->render, name)) return ts_fail("%.60s: there is no such picture", name);
	difference *d = *made = ts_alloc_zero(1, sizeof *d, "a difference");
	if (d == NULL) return TS_ERROR;
	snprintf(d->name, sizeof d->name, "%s", name);
	ts_status status = ts_picture_difference(&d->picture, of[0], of[1], &r->job.params,
	                                         ts_effect_find(r->render.effect)->difference_scale);
	d->shown = shown(r, d->name, &d->picture);
	d->shown.estimated = ts_picture_chosen(of[0], of[1]) != NULL;
	return status;
}

static const ts_rendering_picture *find_picture(const ts_rendering *r, const char *name)
{
	for (size_t i = 0; i < r->n_pictures; i++)
		if (strcmp(r->pictures[i].name, name) == 0) return &r->pictures[i];
	for (const difference *d = r->differences; d != NULL; d = d->next)
		if (strcmp(d->name, name) == 0) return &d->shown;
	return NULL;
}

ts_status ts_rendering_picture_named(ts_context *context, const ts_rendering_picture **picture, ts_rendering *rendering,
                                     const char *name)
{
	difference *made = NULL;
	if (TS_LACKS(picture)) return TS_ERROR;
	*picture = NULL;
	if (TS_LACKS(context) || TS_LACKS(rendering) || TS_LACKS(name)) return TS_ERROR;
	*picture = find_picture(rendering, name);
	if (*picture != NULL) return TS_OK;
	if (ts_api_enter_alone(context) != TS_OK) return TS_ERROR;
	ts_status status = make_difference(&made, rendering, name);
	ts_api_leave();
	if (status == TS_OK) {
		made->next = rendering->differences;
		rendering->differences = made;
		*picture = &made->shown;
	} else {
		free_difference(made);
	}
	return status;
}

/* As in a context, the host's floating-point environment has no part in it. */
static double value_of(double *error, const ts_rendering *r, const ts_figure *figure)
{
	const ts_figure_source source = source_of(r);
	ts_floats_hold(1);
	double value = ts_figure_value(figure, &source);
	if (error != NULL) *error = ts_figure_error(figure, &source);
	ts_floats_give();
	return value;
}

ts_status ts_rendering_figure_at(ts_rendering_figure *figure, const ts_rendering *rendering, size_t i)
{
	if (TS_LACKS(figure) || TS_LACKS(rendering)) return TS_ERROR;
	if (ts_api_room(figure->bytes, sizeof *figure, sizeof *figure, "ts_rendering_figure") != TS_OK) return TS_ERROR;
	if (i >= rendering->n_figures) {
		ts_fail("there are %zu figures", rendering->n_figures);
		return TS_SKIPPED;
	}
	const ts_figure *of = &rendering->figures[i]->of;
	*figure = (ts_rendering_figure){figure->bytes, rendering->figures[i]->name, of->row->unit, .timed = of->row->timed};
	figure->value = value_of(&figure->error, rendering, of);
	return TS_OK;
}

ts_status ts_rendering_figure_named(double *value, const ts_rendering *rendering, const char *name)
{
	ts_figure f;
	if (TS_LACKS(value)) return TS_ERROR;
	*value = NAN;
	if (TS_LACKS(rendering) || TS_LACKS(name)) return TS_ERROR;
	const ts_name_scope scope = scope_of(rendering);
	if (ts_name_find(&f, &scope, name) != TS_OK) return TS_ERROR;
	*value = value_of(NULL, rendering, &f);
	return isnan(*value) ? ts_fail("%s: was not measured", name) : TS_OK;
}
