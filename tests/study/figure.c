/* Figures of a case by their names: those of the scene and of every parameter, and of variants. */
#include <math.h>
#include <stdlib.h>
#include "study/bench_case.h"
#include "study/figure.h"
#include "tests/model/test.h"

static const char *const variants[] = {"one", "two"};
static const ts_named_list lists[] = {{"both", "splat,lookup"}, {"twice", "splat,splat.tie"}};
static const char *const truths[] = {"other", "truth", NULL};
static const ts_name_scope scope = {variants, truths, 2, lists, 2, false};

static ts_bench_case *make_case(ts_scene *scene)
{
	ts_bench_case *c = calloc(1, sizeof *c);
	assert_non_null(c);
	c->scene = scene;
	ts_params_default(&c->params);
	TS_PARAM_SET(&c->params, width, 500);
	TS_PARAM_SET(&c->params, height, 300);
	c->methods[0] = ts_pipeline_find("reflections", "epr");
	return c;
}

static double value_of(const char *name, const ts_bench_case *c)
{
	ts_figure figure;
	if (ts_name_find(&figure, &scope, name) != TS_OK) fail_msg("%s", ts_error_message());
	ts_picture two[2] = {{.srgb = NULL}, c->truth};
	ts_figure_source source = ts_bench_case_source(c);
	source.truths = two;
	return ts_figure_value(&figure, &source);
}

static void every_parameter_is_measured_by_its_name(void **state)
{
	(void)state;
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	ts_scene scene = {.n_triangles = 11, .n_surfels = 13};
	ts_bench_case *c = make_case(&scene);
	for (size_t i = 0; i < n; i++) {
		char text[64], name[96];
		ts_params_format(&c->params, i, text, sizeof text);
		snprintf(name, sizeof name, "param.%s", table[i].name);
		assert_true(value_of(name, c) == strtod(text, NULL));
	}
	assert_true(value_of("scene.triangles", c) == 11 && value_of("scene.surfels", c) == 13);
	assert_true(value_of("image.width", c) == 500 && value_of("image.height", c) == 300);
	free(c);
}

static double look(const ts_run *run)
{
	(void)run;
	return 0;
}

static void counters_and_times_are_those_of_their_variant(void **state)
{
	(void)state;
	ts_scene scene = {0};
	ts_bench_case *c = make_case(&scene);
	ts_measure *m = &c->measures[0];
	m->counters[m->n_counters++] = (ts_counter){.name = "point-view scatters", .value = 7};
	m->timings[m->n_timings++] = (ts_timing){.stage = "splat", .seconds = 0.5};
	m->seconds = 2;
	m->bytes[TS_B_splat_depth_index] = 100;
	m->bytes[TS_B_splat_tie] = 10;
	assert_true(isnan(value_of("one.looked", c)));
	c->looked[0] = 0.25;
	c->look = look;
	assert_true(value_of("one.count.point_view_scatters", c) == 7 && isnan(value_of("one.count.points", c)));
	assert_true(value_of("one.ms.splat", c) == 500 && value_of("one.ms.both", c) == 500);
	assert_true(isnan(value_of("one.ms.lookup", c)) && value_of("one.spent.lookup", c) == 0);
	assert_true(value_of("one.ms.frame", c) == 2000 && value_of("one.looked", c) == 0.25);
	assert_true(value_of("one.bytes.splat.tie", c) == 10 && value_of("one.bytes.splat", c) == 110);
	assert_true(value_of("one.bytes.twice", c) == 110); /* each buffer once */
	assert_true(value_of("one.bytes.both", c) == 110 && value_of("one.bytes.points", c) == 0);
	assert_true(isnan(value_of("two.ms.frame", c))); /* there is no such method */
	free(c);
}

/* One grey level of difference, and none. */
static void errors_are_to_the_named_picture(void **state)
{
	(void)state;
	ts_scene scene = {0};
	ts_bench_case *c = make_case(&scene);
	static u8 a[500 * 300 * 3], b[500 * 300 * 3], truth[500 * 300 * 3];
	for (size_t i = 0; i < sizeof a; i++) b[i] = 1, truth[i] = 3;
	c->images[0].srgb = a;
	c->images[1].srgb = b;
	c->truth.srgb = truth;
	assert_true(value_of("one.rmse.two", c) == 1 && value_of("one.rmse.truth", c) == 3);
	assert_true(isnan(value_of("one.rmse.other", c)));
	assert_true(value_of("one.rmse.one", c) == 0 && isnan(value_of("two.rmse.one", c)));
	c->truth.srgb = NULL;
	assert_true(isnan(value_of("one.rmse.truth", c)));
	free(c);
}

static void a_name_that_is_none_is_refused(void **state)
{
	(void)state;
	static const char *const bad[][2] = {
		{"three.ms.frame", "no figure or variant above begins so"},
		{"ms.frame", "no figure or variant above begins so"},
		{"one", "no figure or variant above begins so"},
		{"one.", "a variant has no such figure"},
		{"one.rmsx.two", "a variant has no such figure"},
		{"one.rmse", "a variant has no such figure"},
		{"one.rmse.", "a variant has no such figure"},
		{"one.ms.frames", "frames is no stage"},
		{"one.rmse.three", "three is no variant, and no truth"},
		{"one.bytes.nothing", "nothing is no buffer"},
		{"param.widths", "widths is no parameter"},
		{"one.scene.triangles", "a variant has no such figure"},
	};
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		ts_figure figure;
		assert_int_equal(ts_name_find(&figure, &scope, bad[i][0]), TS_ERROR);
		if (strstr(ts_error_message(), bad[i][1]) == NULL) fail_msg("%s: %s", bad[i][0], ts_error_message());
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_parameter_is_measured_by_its_name),
		cmocka_unit_test(counters_and_times_are_those_of_their_variant),
		cmocka_unit_test(errors_are_to_the_named_picture),
		cmocka_unit_test(a_name_that_is_none_is_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
