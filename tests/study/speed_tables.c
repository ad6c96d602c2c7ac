/* Figures of `bench speed`: each term in closed form of what rows hold; sets that have nothing to measure; and names of
 * which nothing is measured. */
#include <math.h>
#include "study/speed_work.h"
#include "study/tables/text.h"
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

/* Of the second of the runs, which is the median; times are in milliseconds. */
static const struct {
	const char *text;
	double right;
	ts_speed_bound bound;
	double goal;
} cases[] = {
	{"a.epr.ms.eye", 10e3, TS_SPEED_SHOWN, 0},
	{"a.epr.ms.frame", 20e3, TS_SPEED_SHOWN, 0},
	{"a.mvr.ms.frame", 40e3, TS_SPEED_SHOWN, 0},
	{"b.epr.ms.frame", 60e3, TS_SPEED_SHOWN, 0},
	{"threads * b.mvr.ms.eye", 240e3, TS_SPEED_SHOWN, 0},
	{"a.casting", 30e3, TS_SPEED_SHOWN, 0},
	{"2 * a.rays", 200e3, TS_SPEED_SHOWN, 0},
	{"a.points", 140e3, TS_SPEED_SHOWN, 0},
	{"a.mvr.count.points", 16, TS_SPEED_LEAST, 16},
	{"a.image.width * a.image.height", 200, TS_SPEED_MOST, 199},
	{"0.5 * b.scene.surfels", 25, TS_SPEED_MOST, 25},
	{"11 * a.epr.count.points / (1000000 * a.minima)", 8, TS_SPEED_LEAST, 9},
	{"6 * a.epr.ms.frame / b.mvr.ms.frame", 1, TS_SPEED_SHOWN, 0},
	{"a.epr.ms.eye / a.epr.count.points", 1250, TS_SPEED_SHOWN, 0},
	{"c.epr.ms.frame", NAN, TS_SPEED_SHOWN, 0},
	{"a.ivir.ms.frame", NAN, TS_SPEED_SHOWN, 0},
	{"a.epr.ms.splat", NAN, TS_SPEED_SHOWN, 0},
	{"a.texels", NAN, TS_SPEED_SHOWN, 0},
};
enum { CASES = sizeof cases / sizeof *cases };

/* The text of tables that has all cases. */
static ts_table_texts *read_cases(void)
{
	static const char *const bounds[] = {"", "at least", "at most"};
	static char text[4096];
	size_t n = 0;
	ts_table_texts *texts;
	for (const char *frame = "abc"; *frame != 0; frame++)
		n += (size_t)snprintf(text + n, sizeof text - n, "frame %c = reflections epr,mvr,ivir atrium\n", *frame);
	for (u32 i = 0; i < CASES; i++) {
		char goal[24] = "";
		if (cases[i].bound != TS_SPEED_SHOWN) snprintf(goal, sizeof goal, "%g", cases[i].goal);
		n += (size_t)snprintf(text + n, sizeof text - n, "speed \"%s\" \"\" 2 %s %s = %s\n", cases[i].text,
		                      bounds[cases[i].bound], goal, cases[i].text);
	}
	assert_true(n < sizeof text);
	if (ts_table_texts_read(&texts, text, "cases") != TS_OK) fail_msg("%s", ts_error_message());
	return texts;
}

static const char *verdict_of(u32 i)
{
	double value = cases[i].right, goal = cases[i].goal;
	bool met = cases[i].bound == TS_SPEED_LEAST ? value >= goal : value <= goal;
	return cases[i].bound == TS_SPEED_SHOWN ? "" : met ? "met" : "not met";
}

static void figures_follow_from_their_rows(void **state)
{
	(void)state;
	static world w[2];
	ts_speed_set sets[2];
	ts_report report;
	ts_table_texts *texts = read_cases();
	fill(&w[0], "a", 1);
	fill(&w[1], "b", 3);
	for (u32 i = 0; i < 2; i++) {
		sets[i] = w[i].set;
		for (u32 k = 0; k < 2; k++) sets[i].frame[k].set = &sets[i];
	}
	const ts_speed_of *const lists[] = {ts_table_texts_speed(texts), NULL};
	const ts_job job = {.how.threads = 4};
	ts_report_begin(&report, true);
	const ts_speed speed = {.job = &job, .lists = lists, .report = &report, .n_runs = RUNS, .sets = sets, .n_sets = 2};
	ts_speed_print_figures(&speed);
	const json_t *rows = json_object_get(report.root, "figures");
	u32 row = 0;
	for (u32 i = 0; i < CASES; i++) {
		if (isnan(cases[i].right)) continue;
		const json_t *o = json_array_get(rows, row++);
		assert_string_equal(json_string_value(json_object_get(o, "figure")), cases[i].text);
		assert_float_equal(json_real_value(json_object_get(o, "here")), cases[i].right, 1e-9 * cases[i].right);
		assert_string_equal(json_string_value(json_object_get(o, "verdict")), verdict_of(i));
	}
	assert_int_equal(json_array_size(rows), row);
	ts_report_discard(&report);
	ts_table_texts_free(texts);
}

/* A figure is quiet in runs in which all that it is made of was. */
static void a_busy_run_counts_where_it_is_named(void **state)
{
	(void)state;
	static world w;
	ts_table_texts *texts = read_cases();
	fill(&w, "a", 1);
	for (u32 k = 0; k < 2; k++) w.set.frame[k].set = &w.set;
	bool busy[RUNS] = {true, false, false};
	w.set.rays.quiet = busy;
	const ts_job job = {.how.threads = 4};
	const ts_speed_of *of = ts_table_texts_speed(texts);
	const ts_speed speed = {.job = &job, .n_runs = RUNS, .sets = &w.set, .n_sets = 1};
	ts_speed_value rays = ts_speed_figure_value(&speed, of, &of->figures[6]);
	ts_speed_value points = ts_speed_figure_value(&speed, of, &of->figures[7]);
	assert_true(rays.quiet && rays.median == 20e3 * 1 && points.median == 140e3);
	busy[0] = false;
	rays = ts_speed_figure_value(&speed, of, &of->figures[6]);
	assert_true(!rays.quiet && rays.median == 200e3);
	busy[0] = true;
	for (u32 k = 0; k < 2; k++) w.set.frame[k].row.quiet = busy;
	ts_speed_value timed = ts_speed_figure_value(&speed, of, &of->figures[0]);
	assert_true(timed.quiet && timed.median == 1e3);
	busy[0] = false;
	timed = ts_speed_figure_value(&speed, of, &of->figures[0]);
	ts_speed_value counted = ts_speed_figure_value(&speed, of, &of->figures[8]);
	assert_true(!timed.quiet && timed.median == 10e3);
	assert_true(counted.quiet && counted.median == 16); /* a busy machine counts no more points */
	ts_table_texts_free(texts);
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

static void unknown_names_are_refused(void **state)
{
	(void)state;
	static const ts_speed_scene scenes[][2] = {{{.name = "room", .methods = {"epr", "mvr"}}, {0}},
	                                           {{.name = "hall", .methods = {"ivir"}}, {0}}};
	static const ts_speed_growth growths[][2] = {{{.param = NULL}}, {{.of.name = "pixels"}, {.param = NULL}}};
	static const ts_speed_of of[] = {{.scenes = scenes[0], .growths = growths[0]},
	                                 {.scenes = scenes[1], .growths = growths[1]}};
	static const ts_speed_of *const lists[] = {&of[0], &of[1], NULL};
#define REFUSES(...) refused(ts_bench_speed(&(ts_job)__VA_ARGS__, lists), words)
	const char *words =
		"--scene rooms: nothing of that name is measured; the nearest is room; there are room, hall, pixels";
	REFUSES({.scenes = "rooms"});
	words = "--scene none: nothing of that name is measured";
	REFUSES({.scenes = "hall,none"});
	words = "--objects are the values of one growth";
	REFUSES({.scenes = "hall,room", .objects = "3"});
	REFUSES({.objects = "3"});
	words = "--method vir: no frame is measured by it";
	REFUSES({.scenes = "pixels", .objects = "3", .method = "vir"});
	words = "--method epr2: no frame is measured by it";
	REFUSES({.method = "mvr,epr2"});
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(figures_follow_from_their_rows), cmocka_unit_test(a_busy_run_counts_where_it_is_named),
		cmocka_unit_test(only_rows_with_something_are_measured), cmocka_unit_test(unknown_names_are_refused)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
