/* Pictures of a table's rows: those that are there, and differences from the first where that is. */
#include "study/results/folder.h"
#include "study/tables/paper.h"
#include "tests/model/test.h"
#include "tests/scratch.h"

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
	c->images[0] = (ts_picture){.name = "epr", .srgb = first};
	c->images[1] = (ts_picture){.name = "mvr", .srgb = second};
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

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(differences_are_from_the_first_picture)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
