/* Figures: those of a scene and of parameters, those that follow from others in closed form, and the paper's row that
 * is the nearest. */
#include <math.h>
#include "study/bench_paper.h"
#include "tests/model/test.h"

/* clang-format off */
enum { A, B, RATIO, SAVED, PERCENT, MORE, DIFFERENCE, SUM, GROWTH, RATE, N };
static const ts_bench_figure figures[] = {
	[A] = { "a", "a", TS_FIGURE_COUNTER, 0, 0, 2, "a" },
	[B] = { "b", "b", TS_FIGURE_TIME, 0, 0, 2, "" },
	[RATIO] = { "ratio", "", TS_FIGURE_RATIO, A, B, 2, "" },
	[SAVED] = { "saved", "", TS_FIGURE_SAVED, A, B, 2, "" },
	[PERCENT] = { "percent", "", TS_FIGURE_PERCENT, A, B, 2, "" },
	[MORE] = { "more", "", TS_FIGURE_MORE, A, B, 2, "" },
	[DIFFERENCE] = { "difference", "", TS_FIGURE_DIFFERENCE, A, A, 2, "" },
	[SUM] = { "sum", "", TS_FIGURE_SUM, A, RATIO, 2, "" },
	[GROWTH] = { "growth", "", TS_FIGURE_GROWTH, A, B, 2, "" },
	[RATE] = { "rate", "", TS_FIGURE_RATE, A, B, 2, "" },
	{ 0 },
};
/* clang-format on */

static void derive(double *values, double a, double b, const double *before)
{
	for (u32 i = 0; i < N; i++) values[i] = NAN;
	values[A] = a;
	values[B] = b;
	ts_bench_derive(values, before, figures);
}

static void derived_figures_follow_their_closed_form(void **state)
{
	(void)state;
	double v[TS_BENCH_FIGURES], before[TS_BENCH_FIGURES];
	derive(before, 2, 4, NULL);
	assert_true(isnan(before[GROWTH]));
	derive(v, 6, 12, before);
	assert_true(v[RATIO] == 0.5 && v[SAVED] == 50 && v[PERCENT] == 50 && v[MORE] == -600 / 255.0);
	assert_true(v[DIFFERENCE] == 0 && v[SUM] == 18.5 && v[RATE] == 1e3 / 12);
	assert_float_equal(v[GROWTH], 1, 1e-12);
	for (double e = -2; e <= 3; e += 0.5) { /* a power law's exponent */
		derive(before, 3 * pow(5, e), 5, NULL);
		derive(v, 3 * pow(40, e), 40, before);
		assert_float_equal(v[GROWTH], e, 1e-9);
	}
	derive(v, 6, 0, before);
	assert_true(isnan(v[RATIO]) && isnan(v[RATE]) && isnan(v[PERCENT]) && v[MORE] == 600 / 255.0);
	derive(v, 6, 5, before); /* b did not grow */
	derive(before, 6, 5, NULL);
	derive(v, 6, 5, before);
	assert_true(isnan(v[GROWTH]));
}

static void a_given_figure_is_not_derived(void **state)
{
	(void)state;
	double v[TS_BENCH_FIGURES] = {6, 3, NAN, 7, NAN, NAN, NAN, NAN, NAN, NAN};
	ts_bench_derive(v, NULL, figures);
	assert_true(v[SAVED] == 7 && v[RATIO] == 2);
}

/* A time, and all that is made of one. */
static void figures_made_of_a_time_are_timed(void **state)
{
	(void)state;
	static const bool right[N] = {[B] = true,    [RATIO] = true, [SAVED] = true,  [PERCENT] = true,
	                              [MORE] = true, [SUM] = true,   [GROWTH] = true, [RATE] = true};
	for (u32 i = 0; i < N; i++) assert_int_equal(ts_bench_is_timed(figures, i), right[i]);
}

/* Every parameter that is a number, by its name. */
static void every_parameter_is_measured_by_its_name(void **state)
{
	(void)state;
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	ts_scene scene = {.n_triangles = 11, .n_surfels = 13};
	ts_bench_case *c = calloc(1, sizeof *c);
	assert_non_null(c);
	c->scene = &scene;
	ts_params_default(&c->params);
	TS_PARAM_SET(&c->params, width, 500);
	TS_PARAM_SET(&c->params, height, 300);
	for (size_t i = 0; i < n; i++) {
		const ts_bench_figure asked[] = {
			{"p", "", TS_FIGURE_PARAM, 0, 0, 0, table[i].name}, {"t", "", TS_FIGURE_TRIANGLES, 0, 0, 0, ""},
			{"s", "", TS_FIGURE_SURFELS, 0, 0, 0, ""},          {"m", "", TS_FIGURE_PIXELS, 0, 0, 0, ""},
			{"c", "", TS_FIGURE_COUNTER, 0, 0, 0, "points"},    {0}};
		char text[64];
		double v[5];
		ts_params_format(&c->params, i, text, sizeof text);
		ts_bench_measure(v, asked, c);
		assert_true(v[0] == strtod(text, NULL));
		assert_true(v[1] == 11 && v[2] == 13 && fabs(v[3] - 0.15) < 1e-12 && isnan(v[4]));
	}
	free(c);
}

/* ---- the paper's row ---- */

static const ts_paper_row rows[] = {{"One", "atrium", "sponza", 10, {1000, 2, 3}},
                                    {"Two", "town", "city", 10, {2500, 0, 5}},
                                    {"Three", "atrium", "sponza", 20, {90000, 4, 7}},
                                    {0}};

static ts_paper_line compared(bool by_triangles, const char *spec, u32 objects, double triangles)
{
	const ts_paper_table table = {.figures = figures, .rows = rows, .by_triangles = by_triangles};
	ts_paper_line line = {.objects = objects, .here = {triangles}};
	ts_paper_compare(&line, &table, spec);
	return line;
}

static void a_scenes_name_finds_its_row(void **state)
{
	(void)state;
	static const struct {
		const char *spec;
		u32 objects;
		const ts_paper_row *row;
	} cases[] = {{"atrium", 10, &rows[0]},
	             {"atrium:triangles=5", 20, &rows[2]},
	             {"atrium", 15, NULL},
	             {"atriums", 10, NULL},
	             {"town", 10, &rows[1]},
	             {"models/Sponza-2.gltf", 10, &rows[0]},
	             {"/a/b/CITY.ply", 10, &rows[1]},
	             {"/a/city/house.ply", 10, NULL}};
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		ts_paper_line line = compared(false, cases[i].spec, cases[i].objects, 1);
		assert_ptr_equal(line.row, cases[i].row);
		assert_true(line.row != NULL ? line.paper[A] == line.row->figures[A] : isnan(line.paper[A]));
	}
	ts_paper_line two = compared(false, "town", 10, 1);
	assert_true(isnan(two.paper[B]) && two.paper[RATIO] == 5 && isnan(two.paper[PERCENT]));
}

/* The row whose triangles are the nearest as a ratio. */
static void the_nearest_ratio_finds_its_row(void **state)
{
	(void)state;
	for (double triangles = 1; triangles < 1e7; triangles *= 1.07) {
		const ts_paper_row *right = triangles < sqrt(1000.0 * 2500)    ? &rows[0]
		                            : triangles < sqrt(2500.0 * 90000) ? &rows[1]
		                                                               : &rows[2];
		assert_ptr_equal(compared(true, "town", 7, triangles).row, right);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(derived_figures_follow_their_closed_form),
		cmocka_unit_test(a_given_figure_is_not_derived),
		cmocka_unit_test(figures_made_of_a_time_are_timed),
		cmocka_unit_test(every_parameter_is_measured_by_its_name),
		cmocka_unit_test(a_scenes_name_finds_its_row),
		cmocka_unit_test(the_nearest_ratio_finds_its_row),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
