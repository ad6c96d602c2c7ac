/* A paper's table that is measured: a row for each scene and number of mirrors, the line that a row leaves, and how
 * often each variant runs. */
#include "study/tables/tables.h"
#include "study/tables/text.h"
#include "tests/study/benched.h"
#include "tests/trace/small.h"
#include "tools/tools.h"

static double look(const ts_run *run) { return 0.5 + TS_PARAM(&run->params, frame); }

static const char text[] =
	"table test\ntitle Test\neffect reflections\nscenes " SMALL_SCENE "\nobjects mirrors reflectors.count 1,2,3\n"
	"set cube.max_px=16\nsize width=32,height=18\nlook projected_size\n"
	"variant epr = epr seen\nvariant mvr = mvr once\npart one \"One\"\n\ttriangles \"triangles\" whole = scene.triangles\n"
	"\ttyped \"typed\" 1 = param.reflectors.count\n\tlooked \"looked\" 2 = epr.looked\nfigure ms \"\" 2 = epr.ms.frame\n"
	"paper triangles\n\t\"Paper's\" atrium nofile 2 5\n";
static ts_table_texts *texts;

static ts_paper_table table(bool timed)
{
	ts_paper_table of = *ts_table_texts_at(texts, 0)->paper;
	of.timed = timed;
	of.look = look;
	return of;
}

/* ---- a backend that counts what it launches ---- */

static ts_c_backend in_c;
static u64 n_launches;

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *of, const void *args, u64 n)
{
	(void)backend;
	n_launches++;
	return in_c.backend.launch(&in_c.backend, frame, of, args, n);
}

static char lines[1000];

static void hear(void *user, const char *line)
{
	(void)user;
	snprintf(lines + strlen(lines), sizeof lines - strlen(lines), "%s\n", line);
}

static ts_status measure(const ts_job *job, const void *of) { return ts_paper_bench(job, of); }

/* The report of a table, by json_decref(). */
static json_t *measured(const ts_paper_table *of, const char *objects, u32 runs, u64 *launches)
{
	ts_c_backend counting;
	ts_job job = benched_job();
	job.runs = runs;
	job.objects = objects;
	job.how.backend = &counting.backend;
	ts_c_begin(&in_c, 2);
	counting = in_c;
	counting.backend.launch = launch;
	counting.backend.at_once = NULL;
	n_launches = 0;
	lines[0] = 0;
	ts_listen(&(ts_listener){.line = hear});
	json_t *root = benched(measure, &job, of);
	ts_listen(&(ts_listener){.line = NULL});
	if (launches != NULL) *launches = n_launches;
	return root;
}

static void judge_rows(const char *objects, const u32 *counts, u32 n)
{
	const ts_paper_table of = table(false);
	json_t *root = measured(&of, objects, 1, NULL);
	const json_t *part = json_object_get(root, "one");
	char right[1000] = "";
	u32 row = 0;
	for (u32 i = 0; i < n; i++) {
		const json_t *o = json_array_get(part, row++);
		json_int_t triangles = json_integer_value(json_object_get(o, "triangles"));
		assert_int_equal(json_integer_value(json_object_get(o, "mirrors")), counts[i]);
		assert_true(json_real_value(json_object_get(o, "typed")) == counts[i]);
		assert_true(json_real_value(json_object_get(o, "looked")) == 0.5 && triangles > 1000);
		snprintf(right + strlen(right), 200, "%s, mirrors %u, triangles %lld, typed %u.0, looked 0.50\n", SMALL_SCENE,
		         (unsigned)counts[i], (long long)triangles, (unsigned)counts[i]);
		if (counts[i] != 2) continue;
		o = json_array_get(part, row++);
		assert_string_equal(json_string_value(json_object_get(o, "source")), "paper");
		assert_int_equal(json_integer_value(json_object_get(o, "triangles")), 5);
	}
	assert_int_equal(json_array_size(part), row);
	assert_string_equal(lines, right);
	const json_t *params = json_object_get(root, "params");
	assert_int_equal(json_integer_value(json_object_get(params, "width")), 32);
	assert_int_equal(json_integer_value(json_object_get(params, "cube.max_px")), 16);
	json_decref(root);
}

static void each_scene_and_number_has_a_row(void **state)
{
	(void)state;
	const u32 typed[] = {4, 2}, own[] = {1, 2, 3};
	judge_rows("4,2", typed, 2);
	judge_rows(NULL, own, 3);
}

/* A table of counts runs once, whatever is said; one of times as often as is said, variants that run once but once. */
static void only_tables_of_times_run_again(void **state)
{
	(void)state;
	u64 once, counts, times;
	const ts_paper_table counted = table(false), timed = table(true);
	json_decref(measured(&counted, "2", 1, &once));
	json_decref(measured(&counted, "2", 3, &counts));
	json_decref(measured(&timed, "2", 3, &times));
	assert_int_equal(counts, once);
	assert_true(times > once && times < 3 * once);
	ts_paper_table slow = table(true);
	ts_bench_variant variants[3] = {slow.variants[0], slow.variants[1], {0}};
	variants[1].runs = TS_LONG;
	slow.variants = variants;
	u64 with_long;
	json_decref(measured(&slow, "2", 3, &with_long));
	assert_int_equal(with_long, times);
}

static double exposure(const ts_run *run) { return TS_PARAM(&run->params, image_exposure); }

/* What is set for a model that stands alone goes before the table's defaults, for that model alone. */
static void what_stands_alone_sets_its_own(void **state)
{
	(void)state;
	static const struct {
		const char *alone;
		double wanted;
	} cases[] = {{NULL, 2}, {"bunny.glb,atrium", 2}, {"bunny.glb," SMALL_SCENE, 3}};
	for (u32 i = 0; i < 3; i++) {
		ts_paper_table of = table(false);
		of.look = exposure;
		of.defaults = "image.exposure=2";
		of.alone = cases[i].alone;
		of.alone_set = "image.exposure=3";
		json_t *root = measured(&of, "1", 1, NULL);
		assert_true(benched_real(json_array_get(json_object_get(root, "one"), 0), "looked") == cases[i].wanted);
		json_decref(root);
	}
}

/* What is typed stays, even where it is the parameter's own default. */
static void what_is_typed_stays(void **state)
{
	(void)state;
	size_t n, row = 0;
	const ts_param_info *params = ts_param_table(&n);
	while (strcmp(params[row].name, "octree.levels") != 0) row++;
	for (u32 typed = 0; typed < 2; typed++) {
		ts_job job = {0};
		job.set[row] = typed == 1;
		ts_params_default(&job.params);
		assert_int_equal(ts_bench_set_defaults(&job.params, &job, "octree.levels=7,frame=40", ""), TS_OK);
		assert_true((TS_PARAM(&job.params, octree_levels) == 7) == (typed == 0));
		assert_int_equal(TS_PARAM(&job.params, frame), 40);
		assert_int_equal(ts_bench_set_defaults(&job.params, &job, "seed=9,frame=50", "seed=1"), TS_OK);
		assert_true(TS_PARAM(&job.params, seed) != 9);
	}
}

static void wrong_numbers_of_objects_are_refused(void **state)
{
	(void)state;
	static const char *const bad[] = {"0", "1001", "2,x", "2,"};
	const ts_paper_table of = table(false);
	for (u32 i = 0; i < 4; i++) {
		ts_job job = {.program = "touchstone", .backend = &ts_c_kind, .runs = 1, .objects = bad[i], .how.threads = 1};
		ts_params_default(&job.params);
		assert_int_equal(ts_paper_bench(&job, &of), TS_ERROR);
		says("--objects");
	}
}

/* What stands above a table of a paper. */
static void lines_above_a_table_fit_120_columns(void **state)
{
	(void)state;
	u32 n = 0;
	ts_tables *tables;
	const ts_bench_row *row;
	assert_int_equal(ts_tables_open(&tables), TS_OK);
	for (u32 i = 0; (row = ts_tables_at(tables, i)) != NULL; i++) {
		const ts_paper_table *of = row->paper;
		if (of == NULL) continue;
		size_t note = of->note != NULL ? strlen(of->note) : 0;
		size_t set = strlen("set unless --set says otherwise: ") + strlen(of->defaults);
		if (note > 120 || set > 120 || strlen("set: ") + strlen(of->set) > 120)
			fail_msg("%s: %zu, %zu", of->name, note, set);
		for (u32 k = 0; of->parts[k].title != NULL; k++) assert_true(strlen(of->parts[k].title) <= 120);
		n++;
	}
	ts_tables_close(tables);
	assert_true(n > 20);
}

static int begin(void **state)
{
	ts_tools_begin();
	if (ts_table_texts_read(&texts, text, "test") != TS_OK) fail_msg("%s", ts_error_message());
	return scratch_begin(state);
}

static int end(void **state)
{
	ts_table_texts_free(texts);
	return scratch_remove(state);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_scene_and_number_has_a_row),      cmocka_unit_test(only_tables_of_times_run_again),
		cmocka_unit_test(what_stands_alone_sets_its_own),       cmocka_unit_test(what_is_typed_stays),
		cmocka_unit_test(wrong_numbers_of_objects_are_refused), cmocka_unit_test(lines_above_a_table_fit_120_columns)};
	return cmocka_run_group_tests(tests, begin, end);
}
