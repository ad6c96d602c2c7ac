/* Tables by the library: what a file asks is measured, options go before the table's own, and nothing is printed. */
#include <unistd.h>
#include "tests/api/api.h"

static const char text[] = "table small\neffect reflections\nscenes atrium\nobjects mirrors reflectors.count 1,2\n"
						   "size width=80,height=45\ntimed\nvariant epr = epr seen\nvariant mvr = mvr seen\n"
						   "part one \"One\"\n\trmse \"\" 3 = epr.rmse.mvr\n\tn \"\" whole = param.reflectors.count\n"
						   "\twide \"\" whole = image.width\n\tms \"\" 2 = epr.ms.frame\n"
						   "claim \"wide\" wide at most 70 else ours: no\n";

static void a_table_of_a_file_is_measured(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	ts_tree *figures;
	ts_context *context = open_context(2);
	ts_params *params = small_params();
	make_folder(folder);
	snprintf(path, sizeof path, "%s/my.table", folder);
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	fputs(text, file);
	fclose(file);
	const ts_bench_options options = {.bytes = sizeof options, .scenes = SMALL, .objects = "2", .runs = 1};
	done(ts_bench_table(context, &figures, path, params, &options));
	const ts_tree *rows = ts_tree_get(figures, "one"), *row = ts_tree_at(rows, 0);
	assert_int_equal(ts_tree_n(rows), 1);
	assert_int_equal(ts_tree_integer(ts_tree_get(row, "n")), 2);
	assert_int_equal(ts_tree_integer(ts_tree_get(row, "wide")), 64);
	assert_true(ts_tree_real(ts_tree_get(row, "rmse")) > 0 && ts_tree_real(ts_tree_get(row, "ms")) > 0);
	assert_string_equal(ts_tree_text(ts_tree_get(ts_tree_at(ts_tree_get(figures, "relations"), 0), "verdict")),
	                    "holds");
	ts_tree_free(figures);
	refused(ts_bench_table(context, &figures, "epr-33", params, NULL), "the nearest is epr-3");
	refused(ts_bench_table(context, &figures, "start", params, NULL), "which the command alone does");
	refused(ts_bench_table(context, &figures, "/nowhere.table", params, NULL), "No such file");
	assert_null(figures);
	unlink(path);
	rmdir(folder);
	ts_params_free(params);
	ts_context_close(context);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(a_table_of_a_file_is_measured)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
