/* `bench epr-6`: speed against accuracy, as the density of the points, the sampling of the look-ups and the size of the
 * faces vary; after EPR's figure 6, which varies the size of the mirrors. Also how often the cubes limit the density,
 * which EPR 3.2 calls rare: by eq. 3, and with mirrors as the balls that they are. */
#include <math.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "methods/points/tools/benches.h"
#include "study/asked/truths.h"
#include "study/bench_case.h"

/* A point of a curve: its settings and its label. */
typedef struct {
	u32 curve;
	const char *label;
} mark;

static const char *const curves[] = {"EPR, 25 samples", "EPR, adaptive samples", "MVR, trilinear", "MVR, 25 samples",
                                     "EPR, mirrors as balls"};

/* clang-format off */
#define EPR(rho, samples) { "epr", "density.scale=" rho ",lookup.samples=" samples, true, TS_TIMED, NULL }
#define BALL(rho) { "epr", "density.mirror=ball,density.scale=" rho, true, TS_TIMED, NULL }
#define MVR(px, filter) { "mvr", "cube.max_px=" px ",mvr.filter=" filter, true, TS_TIMED, NULL }
/* clang-format on */

/* clang-format off */
static const ts_bench_variant variants[] = {
	EPR("0.25", "fixed"), EPR("0.5", "fixed"), EPR("1", "fixed"), EPR("2", "fixed"),
	EPR("0.25", "adaptive"), EPR("0.5", "adaptive"), EPR("1", "adaptive"), EPR("2", "adaptive"),
	MVR("128", "trilinear"), MVR("256", "trilinear"), MVR("512", "trilinear"),
	MVR("128", "supersample"), MVR("256", "supersample"), MVR("512", "supersample"),
	BALL("0.5"), BALL("1"), BALL("2"),
	{ 0 },
};

static const mark marks[] = {
	{ 0, "1/4" }, { 0, "1/2" }, { 0, "1" }, { 0, "2" }, { 1, "1/4" }, { 1, "1/2" }, { 1, "1" }, { 1, "2" },
	{ 2, "128" }, { 2, "256" }, { 2, "512" }, { 3, "128" }, { 3, "256" }, { 3, "512" },
	{ 4, "1/2" }, { 4, "1" }, { 4, "2" },
};
/* clang-format on */
/* The mark that a claim names: EPR's default. */
enum { AS_PRINTED = 1 };
enum { N_MARKS = sizeof marks / sizeof marks[0] };
_Static_assert(N_MARKS + 1 == sizeof variants / sizeof variants[0], "a mark a variant");

static const ts_column columns[] = {{"curve", "curve", false},
                                    {"set", "set for it", false},
                                    {"points", "points", true},
                                    {"limited", "limited triangles", true},
                                    {"shading", "shading operations", true},
                                    {"lookups", "look-ups", true},
                                    {"ms", "frame, ms", true},
                                    {"rmse", "RMSE", true},
                                    {0}};

static void count_cell(ts_table *table, const ts_measure *m, const char *name)
{
	const ts_counter *counter = ts_measure_counter(m, name);
	if (counter != NULL) {
		ts_table_count(table, counter->value);
	} else {
		ts_table_none(table);
	}
}

static void report_rows(ts_report *report, const ts_bench_case *c, const ts_plot_point *points)
{
	ts_table t = ts_table_begin("epr_6", "Speed against accuracy", columns);
	t.timed = true;
	for (u32 v = 0; v < N_MARKS; v++) {
		ts_table_text(&t, curves[marks[v].curve]);
		ts_table_text(&t, variants[v].set);
		count_cell(&t, &c->measures[v], "points");
		count_cell(&t, &c->measures[v], "density.limited");
		count_cell(&t, &c->measures[v], "shading operations");
		count_cell(&t, &c->measures[v], "look-ups");
		ts_table_real(&t, points[v].x, 2);
		ts_table_real(&t, points[v].y, 3);
	}
	ts_report_table(report, &t);
}

/* A relation that holds up to a bound. */
static void at_most(ts_table *t, const char *text, double here, double most, const char *because)
{
	char bound[32];
	snprintf(bound, sizeof bound, "at most %g", most);
	ts_bench_relation_add(t, &(ts_bench_relation){.text = text,
	                                              .bound = bound,
	                                              .here = here,
	                                              .paper = NAN,
	                                              .decimals = 3,
	                                              .holds = here <= most,
	                                              .because = because});
}

/* Each density, sampling or face is nearer to the truth than the one before in its curve; adaptive sampling, in the
 * marks after the first four, brings nothing. */
static void report_errors(ts_table *t, const ts_plot_point *points)
{
	enum { DENSITIES = 4 };
	double worst = 0, adaptive = INFINITY;
	for (u32 v = 1; v < N_MARKS; v++) {
		if (marks[v].curve == marks[v - 1].curve) worst = fmax(worst, points[v].y / points[v - 1].y);
	}
	for (u32 v = 0; v < DENSITIES; v++) adaptive = fmin(adaptive, points[v + DENSITIES].y / points[v].y);
	at_most(t, "RMSE by that of half the density or face, greatest", worst, 1.01,
	        TS_NOT_ALWAYS "finer points or faces bring nothing more");
	ts_bench_relation_add(t, &(ts_bench_relation){.text = "RMSE by adaptive samples by that of 25, least",
	                                              .bound = "at least 1",
	                                              .here = adaptive,
	                                              .paper = NAN,
	                                              .decimals = 3,
	                                              .holds = adaptive >= 1,
	                                              .because = TS_NOT_ALWAYS "fewer samples are nearer"});
}

static double counted(const ts_bench_case *c, u32 v, const char *name)
{
	const ts_counter *counter = ts_measure_counter(&c->measures[v], name);
	return counter != NULL ? (double)counter->value : NAN;
}

/* "On the rare occasions" (EPR 3.2): at most one triangle in twenty. */
static void report_limits(ts_table *t, const ts_bench_case *c)
{
	double share = counted(c, AS_PRINTED, "density.limited") / counted(c, AS_PRINTED, "pieces");
	at_most(t, "limited triangles by pieces, eq. 3, 1/2", share, 0.05,
	        TS_OURS "eq. 3 takes mirrors to be flat; see density.mirror");
}

/* Medians over the runs; errors from the first. */
static ts_status measure(ts_plot_point *points, ts_bench_case *c)
{
	u32 runs = c->job->runs;
	double *times = ts_alloc(N_MARKS, runs * sizeof *times, "the times");
	ts_status status = times != NULL ? TS_OK : TS_ERROR;
	for (u32 i = 0; i < runs && status == TS_OK; i++) {
		status = ts_bench_case_run(c, i);
		for (u32 v = 0; v < N_MARKS; v++) times[v * runs + i] = 1e3 * c->measures[v].seconds;
	}
	for (u32 v = 0; v < N_MARKS && status == TS_OK; v++) {
		u32 w = TS_PARAM(&c->params, width), h = TS_PARAM(&c->params, height);
		double rmse = ts_metrics_compare(c->truth.srgb, c->images[v].srgb, NULL, w, h).rmse;
		points[v] = (ts_plot_point){marks[v].curve, marks[v].label, ts_median(times + v * runs, runs), rmse, false};
		ts_say("%s, %s: %.2f ms, RMSE %.3f", curves[marks[v].curve], marks[v].label, points[v].x, rmse);
	}
	free(times);
	return status;
}

static ts_status write_plot(const ts_bench_case *c, const ts_plot_point *points)
{
	char title[160], y_axis[64];
	ts_plot plot = {
		.title = title, .x_axis = "whole frame, ms", .y_axis = y_axis, .points = points, .n_points = N_MARKS};
	snprintf(title, sizeof title, "%.60s, %u mirrors, %u x %u (EPR: density.scale; MVR: largest face)", c->scene->name,
	         (unsigned)c->scene->info.n_reflectors, (unsigned)TS_PARAM(&c->params, width),
	         (unsigned)TS_PARAM(&c->params, height));
	snprintf(y_axis, sizeof y_axis, "RMSE to truth %s, grey levels", c->judge->name);
	for (u32 k = 0; k < sizeof curves / sizeof curves[0]; k++) plot.curves[plot.n_curves++] = curves[k];
	return ts_bench_plot("times-epr_6.svg", &plot);
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	ts_plot_point points[N_MARKS];
	ts_params params;
	ts_bench_case *c = ts_alloc_zero(1, sizeof *c, "a case");
	ts_status status = c != NULL ? ts_bench_frame_params(&params, job) : TS_ERROR;
	if (status == TS_OK) {
		*c = (ts_bench_case){.job = job, .effect = "reflections", .variants = variants, .judge = user};
		status = ts_bench_case_open(c, ts_bench_frame_spec(job), &params);
	}
	if (status == TS_OK) status = measure(points, c);
	if (status == TS_OK) {
		ts_bench_head(report, job, true);
		report_rows(report, c, points);
		ts_table claims = ts_bench_relations_begin();
		report_errors(&claims, points);
		report_limits(&claims, c);
		ts_report_table(report, &claims);
		if (job->output.dir != NULL) status = write_plot(c, points);
	}
	if (c != NULL) ts_bench_case_close(c);
	free(c);
	return status;
}

ts_status ts_bench_sweep(const ts_job *job)
{
	const ts_truth_kind *judge;
	char names[64];
	if (ts_bench_truth(&judge, job, "reflections", "C") != TS_OK) return TS_ERROR;
	if (judge != NULL) return ts_bench_with_report(job, work_on, judge);
	ts_truths_list(names, sizeof names, "reflections", " or ");
	return ts_fail("bench epr-6: accuracy needs a truth; write --truth=%s", names);
}
