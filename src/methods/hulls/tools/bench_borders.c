/* `bench ssagh-borders`: how our deviations from the paper affect the borders of blocks: a ramp for light that grazes
 * its own surface, and corners at pixels within their boxes (METHODS 11). */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/image.h>
#include "methods/hulls/tools/borders.h"
#include "methods/hulls/tools/tools.h"
#include "methods/pipeline.h"
#include "study/bench_case.h"

enum { OURS, FACING, RECTANGLE, N_CHOICES };

static const struct {
	const char *name, *set;
} choices[N_CHOICES] = {
	[OURS] = {"as it is", ""},
	[FACING] = {"corner.facing=paper", "corner.facing=paper"},
	[RECTANGLE] = {"hull.corners=rectangle", "hull.corners=rectangle"},
};

/* For one scene and choice. */
typedef struct {
	double relative; /* RMSE in radiance */
	ts_borders borders;
	ts_facing_pairs pairs;
} seams;

/* The least ratio over scenes of the other choice's figure to ours. */
typedef struct {
	double facing_across, facing_relative, rectangle_across;
} least;

typedef struct {
	const ts_job *job;
	ts_table table;
	least least;
} work;

/* clang-format off */
static const ts_column columns[] = { { "scene", "scene", false }, { "choice", "choice", false },
	{ "relative_rmse", "relative RMSE", true }, { "across_percent", "across, %", true },
	{ "within_percent", "within, %", true }, { "counted_percent", "count, %", true },
	{ "full_percent", "in full, %", true }, { 0 } };
/* clang-format on */

static double percent(u64 part, u64 all) { return all > 0 ? 100 * (double)part / (double)all : NAN; }

/* Only the choice with the ramp and the default corners counts the pairs that the ramp leaves out or dims. */
static void add_row(ts_table *table, const char *scene, u32 choice, const seams *s)
{
	bool counted = choice == OURS;
	ts_table_text(table, scene);
	ts_table_text(table, choices[choice].name);
	ts_table_known(table, s->relative, 4);
	ts_table_known(table, 100 * s->borders.across, 3);
	ts_table_known(table, 100 * s->borders.within, 3);
	ts_table_known(table, counted ? percent(s->pairs.counted, s->pairs.facing) : NAN, 1);
	ts_table_known(table, counted ? percent(s->pairs.full, s->pairs.facing) : NAN, 1);
	ts_table_say(table);
}

/* To be ended by ts_run_end, also on failure. */
static ts_status run_begin(ts_run *run, const work *w, const ts_scene *scene, const ts_params *params,
                           const char *method)
{
	ts_run_begin(run, scene, params, w->job->how.threads);
	ts_run_how(run, &w->job->how);
	ts_status status = ts_pipeline_run(ts_pipeline_find("indirect", method), run);
	return status == TS_OK ? ts_frame_fetch(&run->frame) : status;
}

static ts_status relative_error(double *error, const ts_run *hulls, const ts_run *direct)
{
	u64 n;
	const u64 *keys = ts_pipeline_seen(direct, &n);
	u8 *seen = ts_alloc(n, 1, "pixels that see a surface");
	if (seen == NULL) return TS_ERROR;
	for (u64 i = 0; i < n; i++) seen[i] = keys[i] != TS_EMPTY;
	const f32 *reference = ts_frame_data(&direct->frame, TS_B_image_radiance);
	const f32 *image = ts_frame_data(&hulls->frame, TS_B_image_radiance);
	u32 width = TS_PARAM(&direct->params, width), height = TS_PARAM(&direct->params, height);
	*error = ts_metrics_light(reference, image, seen, width, height).relative;
	free(seen);
	return TS_OK;
}

static ts_status measure(seams *s, const ts_run *hulls, const ts_run *direct)
{
	const ts_frame *frame = &hulls->frame;
	ts_borders_of of = {.pixels = ts_frame_data(frame, TS_B_gbuffer_pixel),
	                    .boxes = ts_frame_data(frame, TS_B_hull_box),
	                    .hulls = ts_frame_data(frame, TS_B_indirect_irradiance),
	                    .direct = ts_frame_data(&direct->frame, TS_B_indirect_irradiance),
	                    .width = TS_PARAM(&hulls->params, width),
	                    .height = TS_PARAM(&hulls->params, height),
	                    .grid = TS_PARAM(&hulls->params, depth_grid_px)};
	s->borders = ts_borders_measure(&of);
	s->pairs = ts_facing_count(ts_frame_data(frame, TS_B_corner_moment), ts_frame_n(frame, TS_B_corner_moment),
	                           ts_frame_data(frame, TS_B_rsm_patch), ts_frame_n(frame, TS_B_rsm_patch));
	return relative_error(&s->relative, hulls, direct);
}

static ts_status run_choice(seams *s, const work *w, const ts_run *direct, u32 choice)
{
	ts_run run;
	ts_params params = direct->params;
	if (ts_bench_set(&params, choices[choice].set) != TS_OK) return TS_ERROR;
	ts_status status = run_begin(&run, w, direct->scene, &params, "hulls");
	if (status == TS_OK) status = measure(s, &run, direct);
	ts_run_end(&run);
	return status;
}

static void compare(least *l, const seams *s)
{
	const seams *ours = &s[OURS], *facing = &s[FACING], *rectangle = &s[RECTANGLE];
	l->facing_across = fmin(l->facing_across, facing->borders.across / ours->borders.across);
	l->facing_relative = fmin(l->facing_relative, facing->relative / ours->relative);
	l->rectangle_across = fmin(l->rectangle_across, rectangle->borders.across / ours->borders.across);
}

static ts_status measure_scene(work *w, const char *name, const ts_scene *scene, const ts_params *params)
{
	ts_run direct;
	seams s[N_CHOICES];
	ts_status status = run_begin(&direct, w, scene, params, "direct");
	for (u32 k = 0; k < N_CHOICES && status == TS_OK; k++) {
		status = run_choice(&s[k], w, &direct, k);
		if (status == TS_OK) add_row(&w->table, name, k, &s[k]);
	}
	if (status == TS_OK) compare(&w->least, s);
	ts_run_end(&direct);
	return status;
}

static ts_status add_scene(void *user, const char *spec)
{
	work *w = user;
	ts_scene *scene;
	ts_params params = w->job->params;
	const char *slash = strrchr(spec, '/');
	if (ts_scene_load(&scene, spec, &params, &w->job->scene.options) != TS_OK) return TS_ERROR;
	ts_status status = measure_scene(w, slash != NULL ? slash + 1 : spec, scene, &params);
	ts_scene_free(scene);
	return status;
}

static void add_relation(ts_table *table, const char *text, double here, const char *because)
{
	bool any = isfinite(here);
	ts_bench_relation_add(table, &(ts_bench_relation){.text = text,
	                                                  .bound = "at least 1",
	                                                  .here = any ? here : NAN,
	                                                  .paper = NAN,
	                                                  .decimals = 3,
	                                                  .holds = any && here >= 1,
	                                                  .because = because});
}

static void report_relations(ts_report *report, const least *l)
{
	ts_table t = ts_bench_relations_begin();
	add_relation(&t, "corner.facing=paper: across borders, by ours, least", l->facing_across,
	             TS_ELSEWHERE "no corner is near a triangle of light");
	add_relation(&t, "corner.facing=paper: relative RMSE, by ours, least", l->facing_relative,
	             TS_ELSEWHERE "no corner is near a triangle of light");
	add_relation(&t, "hull.corners=rectangle: across borders, by ours, least", l->rectangle_across,
	             TS_ELSEWHERE "few boxes end where another surface begins");
	ts_report_table(report, &t);
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	(void)user;
	work w = {.job = job, .least = {INFINITY, INFINITY, INFINITY}};
	w.table = ts_table_begin("ssagh_borders", "SSAGH 3: irradiance that changes otherwise than direct's", columns);
	ts_bench_head(report, job, true);
	ts_report_line(report, "Across borders of blocks and within boxes, by the irradiance of direct.");
	ts_report_line(report, "Pairs of a corner and a triangle of light in front of it: those that the ramp counts.");
	ts_status status = ts_bench_scenes(job, "atrium,gallery,dining", "sponza.glb,sibenik.glb,breakfast_room.glb",
	                                   report, add_scene, &w);
	if (status != TS_OK) {
		ts_table_end(&w.table);
		return status;
	}
	ts_report_table(report, &w.table);
	report_relations(report, &w.least);
	return TS_OK;
}

ts_status ts_bench_borders(const ts_job *job)
{
	ts_job own = *job;
	ts_status status = ts_bench_set(&own.params, "reflectors.count=0");
	return status == TS_OK ? ts_bench_with_report(&own, work_on, NULL) : status;
}
