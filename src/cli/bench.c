/* `bench TABLE`: which tables there are, and tables 1 and 2 of the EPR paper, measured here, with the paper's figures
 * below ours. Ratios are of the same run; times are medians. */
#include <stdlib.h>
#include <touchstone/image.h>
#include "bench.h"
#include "bench_paper.h"

/* One scene with one number of mirrors. */
typedef struct {
	const ts_cli *cli;
	const char *spec;
	u32 objects;
	ts_scene *scene;
	ts_params params;
	u32 truths;
	ts_measure epr, mvr;             /* of the last run */
	double *speedup, *point, *view, *deferred, *deferred2, *total, *mvr_total;  /* a run each, seconds */
	ts_picture image[2], truth;      /* EPR, MVR */
	u32 n_runs;
} bench;

static const ts_column columns_1[] = { { "scene", "scene", false }, { "mirrors", "mirrors", true },
	{ "source", "", false }, { "diameter", "avg res, px", true }, { "epr_ops", "EPR ops", true },
	{ "mvr_ops", "MVR ops", true }, { "ratio", "MVR / EPR", true }, { 0 } };

static const ts_column columns_2[] = { { "scene", "scene", false }, { "mirrors", "mirrors", true },
	{ "source", "", false }, { "triangles", "triangles", true }, { "diameter", "avg res, px", true },
	{ "speedup", "speed-up", true }, { "rmse_difference", "RMSE diff, %", true }, { "total_ms", "EPR, ms", true },
	{ "point_ms", "points, ms", true }, { "view_ms", "views, ms", true }, { "deferred_ms", "deferred, ms", true },
	{ "deferred2_ms", "2 bounces, ms", true }, { "mvr_ms", "MVR, ms", true }, { "points", "points", true }, { 0 } };

static int by_value(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

double ts_median(double *values, u32 n)
{
	qsort(values, n, sizeof *values, by_value);
	return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

static double seconds(const ts_measure *m, const char *const *stages)
{
	double sum = 0;
	for (; *stages != NULL; stages++) {
		const ts_timing *timing = ts_measure_timing(m, *stages);
		sum += timing != NULL ? timing->seconds : 0;
	}
	return sum;
}

/* The deferred part is what neither makes points nor views, so that the parts add up as the paper's do. */
static void split_time(const ts_measure *epr, double *point, double *view, double *deferred)
{
	static const char *const points[] = { "visibility", "split", "cull", "align", "count", "points", NULL };
	static const char *const views[] = { "splat", NULL };
	*point = seconds(epr, points);
	*view = seconds(epr, views);
	*deferred = epr->seconds - *point - *view;
}

static ts_status take_image(ts_run *run, void *user)
{
	bench *b = user;
	bool epr = b->image[0].srgb == NULL;
	ts_status status = ts_picture_take(&b->image[epr ? 0 : 1], epr ? "epr" : "mvr", run);
	if (status == TS_OK && epr && (b->truths & (TS_TRUTH_A | TS_TRUTH_B)) != 0) {
		status = ts_picture_truth(&b->truth, b->truths & (TS_TRUTH_A | TS_TRUTH_B), run);
	}
	return status;
}

static ts_status run_method(bench *b, ts_measure *measure, const char *name, u32 bounces, ts_measure_after after)
{
	ts_params params = b->params;
	params.bounces = bounces;
	*measure = (ts_measure){ .pictures = NULL };
	return ts_measure_run(measure, ts_pipeline_find("reflections", name), b->scene, &params, &b->cli->how,
	                      after, b);
}

/* EPR with one and two bounces and MVR, one after the other. */
static ts_status run_once(bench *b, bool with_times)
{
	u32 i = b->n_runs++;
	double point, view;
	ts_measure second;
	ts_status status = run_method(b, &b->epr, "epr", 1, i == 0 ? take_image : NULL);
	if (status == TS_OK) status = run_method(b, &b->mvr, "mvr", 1, i == 0 ? take_image : NULL);
	if (status != TS_OK || !with_times) return status;
	split_time(&b->epr, &b->point[i], &b->view[i], &b->deferred[i]);
	b->total[i] = b->epr.seconds;
	b->mvr_total[i] = b->mvr.seconds;
	b->speedup[i] = b->mvr.seconds / b->epr.seconds;
	status = run_method(b, &second, "epr", 2, NULL);
	split_time(&second, &point, &view, &b->deferred2[i]);
	return status;
}

static void row_head(ts_table *table, const char *scene, u32 objects, const char *source)
{
	ts_table_text(table, scene);
	ts_table_count(table, objects);
	ts_table_text(table, source);
}

static void add_table_1(ts_table *table, bench *b)
{
	i64 epr = ts_measure_shading(&b->epr), mvr = ts_measure_shading(&b->mvr);
	row_head(table, b->spec, b->objects, "here");
	ts_table_real(table, b->epr.mean_diameter, 1);
	ts_table_count(table, epr);
	ts_table_count(table, mvr);
	if (epr > 0) {
		ts_table_real(table, (double)mvr / (double)epr, 2);
	} else {
		ts_table_none(table);
	}
	const ts_paper_row *p = ts_paper_find(b->spec, b->objects);
	if (p != NULL) {
		row_head(table, p->name, p->objects, "paper");
		ts_table_real(table, p->diameter, 1);
		ts_table_count(table, (i64)p->epr_ops);
		ts_table_count(table, (i64)p->mvr_ops);
		ts_table_real(table, p->ratio, 2);
	}
}

static double rmse_to_truth(const bench *b, u32 image)
{
	return ts_metrics_compare(b->truth.srgb, b->image[image].srgb, NULL, b->params.width, b->params.height).rmse;
}

static void add_paper_2(ts_table *table, const ts_paper_row *p)
{
	row_head(table, p->name, p->objects, "paper");
	ts_table_count(table, (i64)p->triangles);
	ts_table_real(table, p->diameter, 1);
	ts_table_real(table, p->speedup, 2);
	ts_table_real(table, p->rmse_difference, 3);
	ts_table_real(table, p->total_ms, 2);
	ts_table_real(table, p->point_ms, 2);
	ts_table_real(table, p->view_ms, 2);
	ts_table_real(table, p->deferred_ms, 2);
	ts_table_real(table, p->deferred2_ms, 2);
	ts_table_real(table, p->mvr_ms, 2);
	ts_table_count(table, (i64)p->points);
}

static void add_table_2(ts_table *table, bench *b)
{
	u32 n = b->n_runs;
	row_head(table, b->spec, b->objects, "here");
	ts_table_count(table, b->scene->n_triangles);
	ts_table_real(table, b->epr.mean_diameter, 1);
	ts_table_real(table, ts_median(b->speedup, n), 2);
	if (b->truth.srgb != NULL) {
		ts_table_real(table, 100 * (rmse_to_truth(b, 0) - rmse_to_truth(b, 1)) / 255, 3);
	} else {
		ts_table_none(table);
	}
	ts_table_real(table, 1e3 * ts_median(b->total, n), 2);
	ts_table_real(table, 1e3 * ts_median(b->point, n), 2);
	ts_table_real(table, 1e3 * ts_median(b->view, n), 2);
	ts_table_real(table, 1e3 * ts_median(b->deferred, n), 2);
	ts_table_real(table, 1e3 * ts_median(b->deferred2, n), 2);
	ts_table_real(table, 1e3 * ts_median(b->mvr_total, n), 2);
	ts_table_count(table, (i64)b->epr.elements[TS_B_points_record]);
	const ts_paper_row *p = ts_paper_find(b->spec, b->objects);
	if (p != NULL) add_paper_2(table, p);
}

static ts_status measure(bench *b, bool table_2)
{
	const ts_pipeline *const methods[] = { ts_pipeline_find("reflections", "epr"), ts_pipeline_find("reflections", "mvr") };
	u64 bytes;
	ts_status status = ts_measure_estimate(&bytes, methods, 2, b->truths, b->scene, &b->params);
	u32 runs = table_2 ? b->cli->runs : 1;
	while (status == TS_OK && b->n_runs < runs) status = run_once(b, table_2);
	if (status == TS_OK && (b->truths & TS_TRUTH_C) != 0) {
		status = ts_picture_truth_c(&b->truth, b->scene, &b->params, b->cli->how.threads);
	}
	return status;
}

static ts_status bench_one(ts_table *table, const ts_cli *cli, const char *spec, u32 objects, u32 truths, bool table_2)
{
	double *times = ts_alloc_zero(cli->runs, 7 * sizeof *times, "the times");
	if (times == NULL) return TS_ERROR;
	u32 n = cli->runs;
	bench b = { .cli = cli, .spec = spec, .objects = objects, .params = cli->params, .truths = truths,
		.speedup = times, .point = times + n, .view = times + 2 * n, .deferred = times + 3 * n,
		.deferred2 = times + 4 * n, .total = times + 5 * n, .mvr_total = times + 6 * n };
	b.params.reflectors = objects;
	ts_status status = ts_scene_open(&b.scene, spec, &b.params, &cli->scene);
	if (status == TS_OK) status = measure(&b, table_2);
	if (status == TS_OK) (table_2 ? add_table_2 : add_table_1)(table, &b);
	ts_picture_free(&b.image[0]);
	ts_picture_free(&b.image[1]);
	ts_picture_free(&b.truth);
	ts_scene_free(b.scene);
	free(times);
	return status;
}

static ts_status bench_scene(ts_table *table, const ts_cli *cli, const char *spec, u32 truths, bool table_2)
{
	const char *list = cli->objects != NULL ? cli->objects : "1,10,20,50";
	char item[32];
	ts_status status = TS_OK;
	while (status == TS_OK && ts_cli_item(&list, item, sizeof item)) {
		u32 objects;
		status = ts_cli_count(&objects, item, 1, TS_BENCH_OBJECTS, "--objects");
		if (status == TS_OK) status = bench_one(table, cli, spec, objects, truths, table_2);
	}
	return status;
}

static ts_status one_truth(const ts_cli *cli, u32 *truths)
{
	*truths = ts_cli_given(cli, TS_OPT_TRUTH) ? cli->truths : TS_TRUTH_C;
	bool several = (*truths & (*truths - 1)) != 0;
	return several ? ts_fail("bench: one truth is compared with, not several; write --truth=A, B, C or none") : TS_OK;
}

/* Everything that is typed is read once before hours of work. */
static ts_status check_lists(const ts_cli *cli, const char *scenes)
{
	const char *objects = cli->objects;
	char item[32], spec[4096];
	u32 count;
	ts_status status = TS_OK;
	while (status == TS_OK && ts_cli_item(&objects, item, sizeof item)) {
		status = ts_cli_count(&count, item, 1, TS_BENCH_OBJECTS, "--objects");
	}
	while (status == TS_OK && cli->scenes != NULL && ts_cli_item(&scenes, spec, sizeof spec)) {
		ts_scene *scene = NULL;
		ts_params params = cli->params;
		params.reflectors = 1;
		status = ts_scene_open(&scene, spec, &params, &cli->scene);
		ts_scene_free(scene);
	}
	return status;
}

/* The parameters are as typed; each row says how many mirrors it has. */
void ts_bench_head(ts_report *report, const ts_cli *cli)
{
	const ts_params *p = &cli->params;
	ts_report_line(report, "%u x %u pixels, frame %u, %u threads", (unsigned)p->width, (unsigned)p->height,
	               (unsigned)p->frame, (unsigned)cli->how.threads);
	ts_report_run(report, cli);
}

static ts_status paper_table(const ts_cli *cli, bool table_2)
{
	u32 truths;
	ts_status status = one_truth(cli, &truths);
	const char *list = cli->scenes != NULL ? cli->scenes : "atrium,gallery,dining";
	if (status == TS_OK) status = check_lists(cli, list);
	if (status != TS_OK) return status;
	char spec[4096];
	ts_report report;
	ts_report_begin(&report, ts_cli_given(cli, TS_OPT_JSON));
	ts_bench_head(&report, cli);
	ts_table table = table_2 ? ts_table_begin("epr_2", "EPR, table 2", columns_2)
		: ts_table_begin("epr_1", "EPR, table 1: shading operations, one bounce", columns_1);
	while (status == TS_OK && ts_cli_item(&list, spec, sizeof spec)) {
		status = bench_scene(&table, cli, spec, table_2 ? truths : 0, table_2);
	}
	if (status != TS_OK) {
		ts_table_end(&table);
		ts_report_discard(&report);
		return status;
	}
	ts_report_table(&report, &table);
	return ts_report_end(&report);
}

static ts_status epr_1(const ts_cli *cli) { return paper_table(cli, false); }
static ts_status epr_2(const ts_cli *cli) { return paper_table(cli, true); }

static const struct {
	const char *name;
	u64 without;          /* options that say nothing here */
	ts_status (*run)(const ts_cli *cli);
} tables[] = {
	{ "epr-1", TS_OPT_METHOD, epr_1 }, { "epr-2", TS_OPT_METHOD, epr_2 },
	{ "backends", TS_OPT_TRUTH, ts_bench_backends }, { "start", TS_OPT_TRUTH, ts_bench_start },
};

ts_status ts_bench_command(ts_cli *cli)
{
	const char *name = cli->arguments[0];
	for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
		if (strcmp(tables[i].name, name) != 0) continue;
		const ts_option *o = ts_option_table;
		while (o->name != NULL && !ts_cli_given(cli, o->bit & tables[i].without)) o++;
		if (o->name != NULL) return ts_fail("bench %s: takes no --%s", name, o->name);
		return ts_selftest_require() == TS_OK ? tables[i].run(cli) : TS_ERROR;
	}
	return ts_fail("bench: no table \"%s\"; there are epr-1, epr-2, backends and start", name);
}
