/* Columns of a table: what is given is not derived, what is made of a time is timed; and the paper's row is found
 * by name or by its nearest figure. */
#include <math.h>
#include "study/tables/text.h"
#include "tests/model/test.h"
#include "tools/tools.h"

enum { A, B, RATIO, MORE, LESS, N };
static const char text[] = "table test\neffect reflections\nscenes atrium\nvariant one = epr\npart all \"\"\n"
						   "\ta \"\" 2 = one.count.a\n\tb \"\" 2 = one.ms.frame\n\tratio \"\" 2 = a / b\n"
						   "\tmore \"\" 2 = 2 * a\n\tless \"\" 2 = ratio - 1\n"
						   "paper a b less\n\tOne atrium Sponza 10 1000 2 3\n\tTwo gallery city 10 2500 - 5\n"
						   "\tThree atrium sponza 20 90000 4 7\n";

static ts_table_texts *texts;
static ts_paper_table table;

static int begin(void **state)
{
	(void)state;
	ts_tools_begin();
	if (ts_table_texts_read(&texts, text, "test") != TS_OK) fail_msg("%s", ts_error_message());
	table = *ts_table_texts_at(texts, 0)->paper;
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_table_texts_free(texts);
	return 0;
}

/* The paper's ratio is derived of what it prints; what is measured is not. */
static void a_given_figure_is_not_derived(void **state)
{
	(void)state;
	double v[TS_BENCH_FIGURES] = {6, 3, NAN, 7, NAN}, none[TS_BENCH_FIGURES] = {NAN, NAN, NAN, NAN, NAN};
	ts_bench_derive(v, NULL, NULL, table.figures);
	assert_true(v[MORE] == 7 && v[RATIO] == 2 && v[LESS] == 1);
	ts_bench_derive(none, NULL, NULL, table.figures);
	for (u32 i = 0; i < N; i++) assert_true(isnan(none[i]));
	ts_bench_derive(none, (const double[]){8, 4}, NULL, table.figures);
	assert_true(none[A] == 8 && none[B] == 4 && none[MORE] == 16 && none[LESS] == 1);
}

/* What no number of 64 bits counts is shown as it is. */
static void cells_hold_any_value(void **state)
{
	(void)state;
	static const ts_column columns[] = {{"a", "a", true}, {0}};
	const ts_bench_figure whole = {.decimals = TS_WHOLE};
	ts_table t = ts_table_begin("t", "", columns);
	const double values[] = {12345, 1e70, -1e300, INFINITY, NAN};
	static const char *const shown[] = {"12,345", "1e+70", "-1e+300", "equal", "-"};
	for (u32 i = 0; i < 5; i++) {
		ts_bench_cell(&t, &whole, values[i]);
		assert_string_equal(t.cells[i].text, shown[i]);
	}
	ts_table_end(&t);
}

/* A time, and all that is made of one. */
static void figures_made_of_a_time_are_timed(void **state)
{
	(void)state;
	static const bool right[N] = {[B] = true, [RATIO] = true, [LESS] = true};
	for (u32 i = 0; i < N; i++) assert_int_equal(table.figures[i].timed, right[i]);
}

/* ---- the paper's row ---- */

static ts_paper_line compared(u32 nearest, const char *spec, u32 objects, double a)
{
	ts_paper_line line = {.objects = objects, .here = {a}};
	table.nearest = nearest;
	ts_paper_compare(&line, &table, spec);
	return line;
}

static void a_scenes_name_finds_its_row(void **state)
{
	(void)state;
	static const struct {
		const char *spec;
		u32 objects;
		int row;
	} cases[] = {{"atrium", 10, 0},
	             {"atrium:triangles=1.05M", 10, 0},
	             {"atrium:triangles=5", 20, 2},
	             {"atrium", 15, -1},
	             {"atriums", 10, -1},
	             {"gallery", 10, 1},
	             {"models/Sponza-2.gltf", 10, 0},
	             {"/a/b/CITY.ply", 10, 1},
	             {"/a/city/house.ply", 10, -1}};
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		ts_paper_line line = compared(TS_NO_FIGURE, cases[i].spec, cases[i].objects, 1);
		assert_ptr_equal(line.row, cases[i].row >= 0 ? &table.rows[cases[i].row] : NULL);
		assert_true(line.row != NULL ? line.paper[A] == line.row->figures[A] : isnan(line.paper[A]));
	}
	ts_paper_line two = compared(TS_NO_FIGURE, "gallery", 10, 1);
	assert_true(isnan(two.paper[B]) && two.paper[LESS] == 5 && isnan(two.paper[RATIO]));
}

/* The row whose figure is the nearest as a ratio. */
static void the_nearest_ratio_finds_its_row(void **state)
{
	(void)state;
	for (double triangles = 1; triangles < 1e7; triangles *= 1.07) {
		const ts_paper_row *right = triangles < sqrt(1000.0 * 2500)    ? &table.rows[0]
		                            : triangles < sqrt(2500.0 * 90000) ? &table.rows[1]
		                                                               : &table.rows[2];
		assert_ptr_equal(compared(A, "gallery", 7, triangles).row, right);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_given_figure_is_not_derived),    cmocka_unit_test(cells_hold_any_value),
		cmocka_unit_test(figures_made_of_a_time_are_timed), cmocka_unit_test(a_scenes_name_finds_its_row),
		cmocka_unit_test(the_nearest_ratio_finds_its_row),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
