/* `bench nv40-crumbs`: pixels along edges that no surface explains, with and without the backs of two-sided triangles
 * among the surfels (FIGURES 38). */
#include <math.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "methods/surfels/tools/tools.h"
#include "study/asked/truths.h"
#include "study/bench_case.h"

/* clang-format off */
static const struct {
	const char *name, *method, *set;
} filters[] = {
	{ "lesser radius", "deferred", "" }, { "exact EWA", "ewa", "" },
	{ "object filter", "deferred", "ewa.filter=object" },
};
/* clang-format on */
enum { N_FILTERS = sizeof filters / sizeof filters[0], N_SIDES = 2 };

static const char *const sides[N_SIDES] = {"surfels.sides=material", "surfels.sides=front"};

typedef struct {
	u8 *marks; /* 1 at crumbs */
	u64 crumbs, covered, n_new;
	double psnr;
} found;

typedef struct {
	const ts_job *job;
	const ts_truth_kind *judge;
	ts_table rows, relations;
} work;

static const ts_column columns[] = {
	{"scene", "scene", false},
	{"filter", "filter", false},
	{"crumbs", "crumbs", true},
	{"crumbs_front", "fronts alone", true},
	{"crumbs_new", "new", true},
	{"psnr", "PSNR, dB", true},
	{"psnr_front", "fronts alone", true},
	{"covered", "covered", true},
	{"backs_alone", "backs alone", true},
	{0},
};

static ts_status take(ts_run *run, void *user) { return ts_picture_take(user, "image", run); }

static ts_status judge_picture(found *r, const ts_picture *picture, const ts_picture *truth, const ts_params *params)
{
	u32 width = TS_PARAM(params, width), height = TS_PARAM(params, height);
	r->marks = ts_alloc(width, height, "the crumbs");
	if (r->marks == NULL) return TS_ERROR;
	r->crumbs = ts_metrics_crumbs(r->marks, truth->radiance, picture->radiance, width, height);
	r->psnr = ts_metrics_compare(truth->srgb, picture->srgb, NULL, width, height).psnr;
	for (size_t i = 0; i < (size_t)width * height; i++) r->covered += picture->seen[i];
	return TS_OK;
}

static ts_status run_filter(found *r, const work *w, u32 filter, const ts_scene *scene, const ts_params *params,
                            const ts_picture *truth)
{
	ts_params own = *params;
	ts_measure measure = {.pictures = NULL};
	ts_picture picture = {.name = ""};
	const ts_pipeline *method = ts_pipeline_find(w->judge->effects, filters[filter].method);
	ts_status status = ts_bench_set(&own, filters[filter].set);
	if (status == TS_OK) status = ts_measure_run(&measure, method, scene, &own, &w->job->how, take, &picture);
	if (status == TS_OK) status = judge_picture(r, &picture, truth, &own);
	ts_picture_free(&picture);
	return status;
}

static ts_status make_truth(ts_picture *truth, const work *w, const ts_scene *scene, const ts_params *params)
{
	ts_estimate estimate;
	const ts_pipeline *method = ts_pipeline_find(w->judge->effects, filters[0].method);
	if (ts_measure_estimate(&estimate, &method, 1, ts_truth_bit(w->judge), scene, params, NULL) != TS_OK)
		return TS_ERROR;
	return ts_picture_truth_alone(truth, w->judge, scene, params, w->job->how.threads);
}

/* Runs each filter. The truth does not depend on surfels: the first sides that are sampled make it for all. */
static ts_status run_sides(found *r, const work *w, const char *spec, const char *set, ts_picture *truth)
{
	ts_scene *scene = NULL;
	ts_params params = w->job->params;
	ts_status status = ts_bench_set(&params, set);
	if (status == TS_OK) status = ts_scene_load(&scene, spec, &params, &w->job->scene.options);
	if (status == TS_OK && truth->radiance == NULL) status = make_truth(truth, w, scene, &params);
	for (u32 k = 0; k < N_FILTERS && status == TS_OK; k++) status = run_filter(&r[k], w, k, scene, &params, truth);
	ts_scene_free(scene);
	return status;
}

/* Crumbs of the second where the first has none. */
static u64 count_new(const found *first, const found *second, size_t n_pixels)
{
	u64 n = 0;
	for (size_t i = 0; i < n_pixels; i++) n += second->marks[i] > first->marks[i];
	return n;
}

static void add_row(ts_table *t, const char *scene, u32 filter, const found *both, const found *front)
{
	ts_table_text(t, scene);
	ts_table_text(t, filters[filter].name);
	ts_table_count(t, (i64)both->crumbs);
	ts_table_count(t, (i64)front->crumbs);
	ts_table_count(t, (i64)front->n_new);
	ts_table_real(t, both->psnr, 2);
	ts_table_real(t, front->psnr, 2);
	ts_table_count(t, (i64)both->covered);
	ts_table_count(t, (i64)both->covered - (i64)front->covered);
	ts_table_say(t);
}

static void add_relation(ts_table *t, const char *scene, const char *what, const char *bound, double here, bool holds)
{
	char text[160];
	snprintf(text, sizeof text, "%.96s: %s", scene, what);
	ts_bench_relation_add(
		t, &(ts_bench_relation){.text = text,
	                            .bound = bound,
	                            .here = here,
	                            .paper = NAN,
	                            .decimals = 3,
	                            .holds = holds,
	                            .because = TS_NOT_ALWAYS "sheets seen from behind have holes; see surfels.sides"});
}

/* Judges a scene by its worst filter. */
static void add_relations(ts_table *t, const char *scene, found r[N_SIDES][N_FILTERS])
{
	double left = 0, gained = INFINITY, opened = 0;
	for (u32 k = 0; k < N_FILTERS; k++) {
		const found *both = &r[0][k], *front = &r[1][k];
		left = fmax(left, (double)front->crumbs / (double)both->crumbs);
		gained = fmin(gained, front->psnr - both->psnr);
		opened = fmax(opened, 100 * (double)front->n_new / (double)both->covered);
	}
	add_relation(t, scene, "crumbs of fronts alone / all", "at most 1", left, left <= 1);
	add_relation(t, scene, "dB of fronts alone over all", "at least 0", gained, gained >= 0);
	add_relation(t, scene, "new crumbs, % of the surface", "at most 0.3", opened, opened <= 0.3);
}

static ts_status add_scene(void *user, const char *spec)
{
	work *w = user;
	found r[N_SIDES][N_FILTERS] = {{{.marks = NULL}}};
	ts_picture truth = {.name = ""};
	ts_status status = TS_OK;
	const char *slash = strrchr(spec, '/'), *scene = slash != NULL ? slash + 1 : spec;
	size_t n_pixels = (size_t)TS_PARAM(&w->job->params, width) * TS_PARAM(&w->job->params, height);
	for (u32 i = 0; i < N_SIDES && status == TS_OK; i++) status = run_sides(r[i], w, spec, sides[i], &truth);
	for (u32 k = 0; k < N_FILTERS && status == TS_OK; k++) {
		r[1][k].n_new = count_new(&r[0][k], &r[1][k], n_pixels);
		add_row(&w->rows, scene, k, &r[0][k], &r[1][k]);
	}
	if (status == TS_OK) add_relations(&w->relations, scene, r);
	for (u32 i = 0; i < N_SIDES * N_FILTERS; i++) free(r[i / N_FILTERS][i % N_FILTERS].marks);
	ts_picture_free(&truth);
	return status;
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	work w = {.job = job, .judge = user};
	w.rows = ts_table_begin("nv40_crumbs", "Crumbs along edges, with backs and without", columns);
	w.relations = ts_bench_relations_begin();
	ts_bench_head(report, job, true);
	ts_status status =
		ts_bench_scenes(job, "atrium", "armadillo_86k.glb,dragon_80k.glb,bunny.glb,sponza.glb", report, add_scene, &w);
	ts_report_table(report, &w.rows);
	ts_report_table(report, &w.relations);
	return status;
}

ts_status ts_bench_crumbs(const ts_job *job)
{
	ts_job own = *job;
	const ts_truth_kind *judge;
	ts_status status = ts_bench_truth(&judge, job, "surfels", "surface");
	const char *defaults = "eye.distance=outside,surfels.from_mesh=60000,truth.grid_rays=8";
	if (status == TS_OK) status = ts_bench_set_defaults(&own.params, job, defaults, "");
	if (status == TS_OK && !job->sized) status = ts_bench_set(&own.params, "width=400,height=500");
	return status == TS_OK ? ts_bench_with_report(&own, work_on, judge) : status;
}
