/* The truths of a render. */
#include "study/render.h"

/* Whether the truth at that row is asked for and not yet made. */
static bool lacks(const ts_render *render, u32 truth)
{
	return (render->job->truths & 1u << truth) != 0 && render->truths[truth].srgb == NULL;
}

const ts_pipeline *ts_render_truth_method(const ts_render *render, const ts_truth_kind *kind)
{
	for (u32 i = 0; i < render->n_methods; i++) {
		if (ts_truth_starts_from(kind, render->methods[i])) return render->methods[i];
	}
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_pipeline *p = *at;
		if (strcmp(p->effect->name, render->effect) == 0 && ts_truth_starts_from(kind, p)) return p;
	}
	return NULL;
}

static void show_truth(const ts_truth_kind *kind)
{
	char label[32];
	snprintf(label, sizeof label, "truth %s", kind->name);
	ts_progress(label, 0, 1);
}

ts_status ts_render_truths_of(ts_render *render, const ts_pipeline *method, ts_run *run)
{
	ts_status status = TS_OK;
	for (u32 t = 0; ts_truths()[t] != NULL && status == TS_OK; t++) {
		const ts_truth_kind *kind = ts_truths()[t];
		if (!lacks(render, t) || ts_render_truth_method(render, kind) != method) continue;
		show_truth(kind);
		status = ts_picture_truth(&render->truths[t], kind, run);
	}
	return status;
}

static bool exists(const ts_render *render, const ts_truth_kind *kind)
{
	bool does = kind->exists == NULL;
	if (!does) TS_PARAM_READER("truth", kind->name, does = kind->exists(render->scene, &render->job->params));
	return does;
}

/* The truth needs more than params.truth_rays, and cannot be made in part. */
static bool is_left_out(const ts_render *render, const ts_truth_kind *kind)
{
	u64 rays = 0, most = 0;
	const ts_params *params = &render->job->params;
	if (kind->rays == NULL) return false;
	TS_PARAM_READER("truth", kind->name, rays = kind->rays(render->scene, params), most = TS_PARAM(params, truth_rays));
	return most > 0 && rays > most;
}

u32 ts_render_truths_absent(const ts_render *render)
{
	u32 absent = 0;
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		const ts_truth_kind *kind = ts_truths()[t];
		if (lacks(render, t) && (!exists(render, kind) || is_left_out(render, kind))) absent |= 1u << t;
	}
	return absent;
}

typedef struct {
	ts_render *render;
	const ts_pipeline *method;
} unseen;

static ts_status take_after(ts_run *run, void *user)
{
	unseen *u = user;
	return ts_render_truths_of(u->render, u->method, run);
}

static ts_status take_unseen(ts_render *render, const ts_pipeline *method)
{
	const ts_job *job = render->job;
	unseen u = {render, method};
	ts_measure measure = {.pictures = NULL};
	return ts_measure_run(&measure, method, render->scene, &job->params, &job->how, take_after, &u);
}

ts_status ts_render_truths_rest(ts_render *render)
{
	const ts_job *job = render->job;
	const ts_params *params = &job->params;
	u32 threads = job->how.threads, absent = ts_render_truths_absent(render);
	ts_status status = TS_OK;
	for (u32 t = 0; ts_truths()[t] != NULL && status == TS_OK; t++) {
		const ts_truth_kind *kind = ts_truths()[t];
		if (!lacks(render, t) || (absent >> t & 1) != 0) continue;
		show_truth(kind);
		if (kind->radiance != NULL) {
			status = ts_picture_truth_alone(&render->truths[t], kind, render->scene, params, threads);
		} else if (kind->begin != NULL) {
			status = ts_picture_truths_begun(render->truths, job->truths, kind, render->effect, render->scene, params,
			                                 threads);
		} else {
			status = take_unseen(render, ts_render_truth_method(render, kind));
		}
	}
	ts_progress("truth", 1, 1);
	return status;
}

void ts_render_truth_missing(char *line, size_t bytes, const ts_render *render, u32 truth)
{
	const ts_truth_kind *kind = ts_truths()[truth];
	if (!exists(render, kind)) {
		snprintf(line, bytes, "truth %s: none of %s; %s", kind->name, render->scene->name, kind->why_not);
	} else {
		snprintf(line, bytes, "truth %s: left out, as it takes more than truth.rays; --set truth.rays=0 makes it",
		         kind->name);
	}
}

void ts_render_truths_missing(const ts_render *render, ts_report *report)
{
	u32 absent = ts_render_truths_absent(render);
	char line[TS_MISSING_LINE];
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		if ((absent >> t & 1) == 0) continue;
		ts_render_truth_missing(line, sizeof line, render, t);
		ts_report_line(report, "%s", line);
	}
}
