/* Pictures of a table's rows: those that are there, and differences from the first where that is. */
#include <math.h>
#include "study/results/folder.h"
#include "study/tables/text.h"
#include "tests/model/test.h"
#include "tests/scratch.h"
#include "tools/tools.h"

enum { SIDE = 2 };

/* clang-format off */
static const ts_paper_picture pictures[] = { { 0, "first" }, { 1, "second" }, { 0 } };
/* clang-format on */
static const ts_paper_table table = {.effect = "reflections", .pictures = pictures};
static const ts_bench_variant variants[] = {{.method = "epr", .set = ""}, {.method = "mvr", .set = "seed=5"}};

/* Writes the pictures of a case that has the first or not. */
static void check(u8 *first, const char *const *wanted)
{
	u8 second[SIDE * SIDE * 3] = {9, 8, 7};
	f32 light[SIDE * SIDE * 3] = {0.5f};
	const ts_paper_line line = {.scene = "a"};
	char name[] = "a";
	ts_scene scene = {.name = name};
	ts_bench_case *c = calloc(1, sizeof *c);
	assert_non_null(c);
	ts_params_default(&c->params);
	TS_PARAM_SET(&c->params, width, SIDE);
	TS_PARAM_SET(&c->params, height, SIDE);
	c->scene = &scene;
	c->effect = table.effect;
	c->variants = variants;
	c->images[0] = (ts_picture){.name = "epr", .srgb = first, .radiance = light};
	c->images[1] = (ts_picture){.name = "mvr", .srgb = second, .radiance = light};
	assert_int_equal(ts_results_begin(scratch_path("results"), false), TS_OK);
	assert_int_equal(ts_paper_pictures(&table, c, &line, 1), TS_OK);
	size_t n = 0;
	for (; wanted[n] != NULL; n++) assert_string_equal(ts_folder_name(n), wanted[n]);
	assert_null(ts_folder_name(n));
	ts_folder_discard();
	free(c);
}

static void differences_are_from_the_first_picture(void **state)
{
	(void)state;
	u8 first[SIDE * SIDE * 3] = {0};
	const char *const both[] = {"1-a-first.png", "1-a-second.png", "1-a-difference-second.png", NULL};
	const char *const one[] = {"1-a-second.png", NULL};
	check(first, both);
	check(NULL, one);
}

/* As the PSNR of equal pictures: the curve has the other rows, and ends. */
static void infinite_figures_are_left_out_of_a_plot(void **state)
{
	(void)state;
	static const char text[] = "table test\neffect reflections\nscenes atrium\nvariant one = epr\npart one \"\"\n"
							   "\tx \"x\" 0 = 1\n\ty \"y\" 0 = 1\nplot \"x\" \"y\" x y\n";
	ts_table_texts *texts;
	static char svg[100000];
	ts_paper_line lines[4] = {{.scene = "a", .here = {1, 2}},
	                          {.scene = "a", .here = {2, INFINITY}},
	                          {.scene = "a", .here = {3, 4}},
	                          {.scene = "a", .here = {4, 5e-324}}};
	ts_tools_begin();
	assert_int_equal(ts_table_texts_read(&texts, text, "test"), TS_OK);
	if (ts_results_begin(scratch_path("plots"), true) != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(ts_paper_plots(ts_table_texts_at(texts, 0)->paper, lines, 4), TS_OK);
	assert_int_equal(ts_folder_commit(), TS_OK);
	FILE *in = fopen(scratch_path("plots/one_1.svg"), "r");
	assert_non_null(in);
	svg[fread(svg, 1, sizeof svg - 1, in)] = 0;
	fclose(in);
	assert_true(strstr(svg, "inf") == NULL && strstr(svg, "nan") == NULL && strstr(svg, "</svg>") != NULL);
	ts_table_texts_free(texts);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(differences_are_from_the_first_picture),
	                                   cmocka_unit_test(infinite_figures_are_left_out_of_a_plot)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
