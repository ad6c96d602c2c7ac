/* Figures of `bench speed`: each term in closed form of what rows hold; sets that have nothing to measure; and names of
 * which nothing is measured. */
#include <math.h>
#include "study/speed_work.h"
#include "tests/status.h"

enum { RUNS = 3 };

/* A set of frames by epr and mvr: stage "eye" takes `seconds` and the whole twice that, ten times more each run. */
typedef struct {
	ts_scene scene;
	ts_speed_set set;
	double values[2][RUNS * TS_SPEED_VALUES], rays[RUNS], drawn[RUNS], minima[RUNS];
	bool quiet[RUNS];
} world;

static void fill(world *w, const char *name, double seconds)
{
	static const char *const methods[] = {"epr", "mvr"};
	w->scene = (ts_scene){.n_surfels = 50};
	w->set = (ts_speed_set){.scene = &w->scene, .n_frames = 2, .n_runs = RUNS, .how.threads = 4};
	snprintf(w->set.name, sizeof w->set.name, "%s", name);
	ts_params_default(&w->set.params);
	TS_PARAM_SET(&w->set.params, width, 20);
	TS_PARAM_SET(&w->set.params, height, 10);
	for (u32 k = 0; k < 2; k++) {
		ts_speed_frame *frame = &w->set.frame[k];
		frame->method = ts_pipeline_find("reflections", methods[k]);
		frame->set = &w->set;
		frame->row = (ts_speed_row){.values = w->values[k], .quiet = w->quiet, .n_values = TS_SPEED_VALUES};
		frame->last.n_timings = 1;
		frame->last.timings[0].stage = "eye";
		frame->last.n_counters = 1;
		frame->last.counters[0] = (ts_counter){"points", 8 << k};
		for (u32 run = 0; run < RUNS; run++) {
			double *values = w->values[k] + run * TS_SPEED_VALUES;
			values[0] = seconds * (k + 1) * pow(10, run);
			values[TS_SPEED_WHOLE] = 2 * values[0];
			values[TS_SPEED_CASTS] = 3 * values[0];
			w->rays[run] = 5 * values[0];
			w->drawn[run] = 7 * values[0];
			w->minima[run] = 11;
			w->quiet[run] = true;
		}
	}
	w->set.rays = (ts_speed_row){.values = w->rays, .quiet = w->quiet, .n_values = 1};
	w->set.drawn = (ts_speed_row){.values = w->drawn, .quiet = w->quiet, .n_values = 1};
	w->set.minima = (ts_speed_row){.values = w->minima, .quiet = w->quiet, .n_values = 1};
}

#define ONE \
	{ \
		TS_SPEED_ONE, NULL, NULL, NULL, NULL \
	}
#define OF(kind, scene, method, what) \
	{ \
		TS_SPEED_##kind, scene, method, what, NULL \
	}

/* Of the second of the runs, which is the median. */
static const struct {
	ts_speed_figure figure;
	double right;
} cases[] = {
	{{"stage", "", 1, 2, OF(TIME, "a", "epr", "eye"), ONE, TS_SPEED_SHOWN, 0}, 10},
	{{"frame", "", 1, 2, OF(TIME, "a", "epr", ""), ONE, TS_SPEED_SHOWN, 0}, 20},
	{{"frame of the second", "", 1, 2, OF(TIME, "a", "mvr", ""), ONE, TS_SPEED_SHOWN, 0}, 40},
	{{"frame of another set", "", 1, 2, OF(TIME, "b", "epr", ""), ONE, TS_SPEED_SHOWN, 0}, 60},
	{{"cores", "", 1, 2, OF(CORES, "b", "mvr", "eye"), ONE, TS_SPEED_SHOWN, 0}, 240},
	{{"casting", "", 1, 2, OF(CASTING, "a", "epr", ""), ONE, TS_SPEED_SHOWN, 0}, 30},
	{{"rays", "", 2, 2, OF(RAYS, "a", NULL, ""), ONE, TS_SPEED_SHOWN, 0}, 200},
	{{"points", "", 1, 2, OF(POINTS, "a", NULL, ""), ONE, TS_SPEED_SHOWN, 0}, 140},
	{{"count", "", 1, 2, OF(COUNT, "a", "mvr", "points"), ONE, TS_SPEED_LEAST, 16}, 16},
	{{"pixels", "", 1, 2, OF(PIXELS, "a", NULL, ""), ONE, TS_SPEED_MOST, 199}, 200},
	{{"surfels", "", 0.5, 2, OF(SURFELS, "b", NULL, ""), ONE, TS_SPEED_MOST, 25}, 25},
	{{"minima", "", 44, 2, OF(MINIMA, "a", "epr", "points"), ONE, TS_SPEED_LEAST, 9}, 8},
	{{"ratio", "", 6, 2, OF(TIME, "a", "epr", ""), OF(TIME, "b", "mvr", ""), TS_SPEED_SHOWN, 0}, 1},
	{{"per", "", 1, 2, {TS_SPEED_TIME, "a", "epr", "eye", "points"}, ONE, TS_SPEED_SHOWN, 0}, 1.25},
	{{"no set", "", 1, 2, OF(TIME, "c", "epr", ""), ONE, TS_SPEED_SHOWN, 0}, NAN},
	{{"no method", "", 1, 2, OF(TIME, "a", "ivir", ""), ONE, TS_SPEED_SHOWN, 0}, NAN},
	{{"no stage", "", 1, 2, OF(TIME, "a", "epr", "splat"), ONE, TS_SPEED_SHOWN, 0}, NAN},
	{{"no rays", "", 1, 2, OF(TEXELS, "a", NULL, ""), ONE, TS_SPEED_SHOWN, 0}, NAN},
};
enum { CASES = sizeof cases / sizeof *cases };

static const char *verdict_of(const ts_speed_figure *figure, double value)
{
	bool met = figure->bound == TS_SPEED_LEAST ? value >= figure->goal : value <= figure->goal;
	return figure->bound == TS_SPEED_SHOWN ? "" : met ? "met" : "not met";
}

static void figures_follow_from_their_rows(void **state)
{
	(void)state;
	static world w[2];
	static ts_speed_figure figures[CASES + 1];
	ts_speed_set sets[2];
	ts_report report;
	fill(&w[0], "a", 1);
	fill(&w[1], "b", 3);
	for (u32 i = 0; i < 2; i++) {
		sets[i] = w[i].set;
		for (u32 k = 0; k < 2; k++) sets[i].frame[k].set = &sets[i];
	}
	for (u32 i = 0; i < CASES; i++) figures[i] = cases[i].figure;
	const ts_speed_of of = {.figures = figures};
	const ts_speed_of *const lists[] = {&of, NULL};
	ts_report_begin(&report, true);
	const ts_speed speed = {.report = &report, .n_runs = RUNS, .sets = sets, .n_sets = 2};
	ts_speed_print_figures(&speed, lists);
	const json_t *rows = json_object_get(report.root, "figures");
	u32 row = 0;
	for (u32 i = 0; i < CASES; i++) {
		if (isnan(cases[i].right)) continue;
		const json_t *o = json_array_get(rows, row++);
		assert_string_equal(json_string_value(json_object_get(o, "figure")), cases[i].figure.text);
		assert_float_equal(json_real_value(json_object_get(o, "here")), cases[i].right, 1e-9 * cases[i].right);
		assert_string_equal(json_string_value(json_object_get(o, "verdict")),
		                    verdict_of(&cases[i].figure, cases[i].right));
	}
	assert_int_equal(json_array_size(rows), row);
	ts_report_discard(&report);
}

/* ---- sets ---- */

static ts_status count(double *values, void *of)
{
	values[0] = ++*(u32 *)of;
	return TS_OK;
}

static ts_status refuse(double *values, void *of)
{
	(void)values, (void)of;
	return ts_fail("not measured");
}

/* Rows that have something to measure are measured, the others have no values; after a failure nothing is. */
static void only_rows_with_something_are_measured(void **state)
{
	(void)state;
	for (u32 mask = 0; mask < 16; mask++) {
		ts_quiet quiet = {.threads = 1, .best = 1e9, .anyway = true};
		u32 n[4] = {0};
		ts_speed_set set = {
			.n_frames = 1, .wants_points = (mask & 4) != 0, .face_bytes = 8, .points.n = (mask & 2) / 2};
		if ((mask & 1) != 0) set.bare = (ts_bare *)n;
		ts_speed_row *const rows[] = {&set.frame[0].row, &set.rays, &set.drawn, &set.minima};
		for (u32 i = 0; i < 4; i++) {
			rows[i]->measure = i == 0 && (mask & 8) != 0 ? refuse : count;
			rows[i]->of = &n[i];
			assert_int_equal(ts_speed_row_begin(rows[i], 1, 1), TS_OK);
		}
		bool good = (mask & 8) == 0;
		assert_int_equal(ts_speed_set_run(&set, 0, &quiet), good ? TS_OK : TS_ERROR);
		const bool there[] = {true, (mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0};
		for (u32 i = 0; i < 4; i++) {
			assert_int_equal(n[i], good && there[i]);
			if (good) assert_int_equal(isnan(rows[i]->values[0]), !there[i]);
			ts_speed_row_end(rows[i]);
		}
	}
}

/* ---- names ---- */

static void refuses(const ts_job *job, const char *words) { refused(ts_bench_speed(job), words); }

static void unknown_names_are_refused(void **state)
{
	(void)state;
	static const ts_speed_scene scenes[] = {
		{.name = "room", .methods = "epr,mvr"}, {.name = "hall", .methods = "ivir"}, {0}};
	static const ts_speed_growth growths[] = {{.name = "pixels"}, {0}};
	static const ts_speed_of of[] = {{.scenes = scenes}, {.growths = growths}};
	static const ts_speed_of *const lists[] = {&of[0], &of[1], NULL};
	ts_speed_use(lists);
	refuses(&(ts_job){.scenes = "rooms"},
	        "--scene rooms: nothing of that name is measured; the nearest is room; there are room, "
	        "hall, pixels");
	refuses(&(ts_job){.scenes = "hall,none"}, "--scene none: nothing of that name is measured");
	refuses(&(ts_job){.scenes = "hall,room", .objects = "3"}, "--objects are the values of one growth");
	refuses(&(ts_job){.objects = "3"}, "--objects are the values of one growth");
	refuses(&(ts_job){.scenes = "pixels", .objects = "3", .method = "vir"}, "--method vir: no frame is measured by it");
	refuses(&(ts_job){.method = "mvr,epr2"}, "--method epr2: no frame is measured by it");
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(figures_follow_from_their_rows),
	                                   cmocka_unit_test(only_rows_with_something_are_measured),
	                                   cmocka_unit_test(unknown_names_are_refused)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
