/* Tables by name, of the program and of files. */
#include <stdlib.h>
#include "study/tables/tables.h"
#include "tests/model/test.h"
#include "tests/scratch.h"
#include "tools/tools.h"

static const char small[] = "table small\neffect reflections\nscenes atrium\nvariant epr = epr\npart one \"One\"\n"
							"\tms \"\" 2 = epr.ms.frame\n";

static void write_file(const char *path, const char *text, size_t bytes)
{
	FILE *file = fopen(path, "wb");
	assert_non_null(file);
	assert_int_equal(fwrite(text, 1, bytes, file), bytes);
	assert_int_equal(fclose(file), 0);
}

static void tables_are_found_by_name(void **state)
{
	(void)state;
	ts_tables *tables;
	const ts_bench_row *row;
	assert_int_equal(ts_tables_open(&tables), TS_OK);
	assert_int_equal(ts_tables_find(&row, tables, "epr-3"), TS_OK);
	assert_true(strcmp(row->name, "epr-3") == 0 && row->paper != NULL && row->run == NULL);
	assert_int_equal(ts_tables_find(&row, tables, "ssagh-5"), TS_OK);
	assert_true(row->paper == NULL && row->run != NULL);
	assert_int_equal(ts_tables_find(&row, tables, "speed"), TS_OK);
	assert_int_equal(ts_tables_find(&row, tables, "epr-33"), TS_ERROR);
	assert_string_equal(ts_error_message(),
	                    "bench: no table \"epr-33\"; the nearest is epr-3, and \"touchstone list benches\" lists all");
	ts_tables_close(tables);
}

static void a_file_has_its_own_tables_alone(void **state)
{
	(void)state;
	ts_tables *tables;
	const ts_bench_row *row;
	const char *path = scratch_path("my.table");
	write_file(path, small, sizeof small - 1);
	assert_int_equal(ts_tables_open_file(&tables, path), TS_OK);
	assert_string_equal(ts_tables_at(tables, 0)->name, "small");
	assert_null(ts_tables_at(tables, 1));
	assert_null(ts_tables_claim(tables, 0));
	assert_int_equal(ts_tables_find(&row, tables, "epr-3"), TS_ERROR);
	ts_tables_close(tables);
}

static void a_file_that_is_no_text_is_refused(void **state)
{
	(void)state;
	ts_tables *tables;
	const char *path = scratch_path("my.table");
	write_file(path, small, sizeof small); /* with the byte that ends the string */
	assert_int_equal(ts_tables_open_file(&tables, path), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "a byte of it is 0"));
	assert_null(tables);
	assert_int_equal(ts_tables_open_file(&tables, scratch_path("no.table")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "No such file"));
	assert_null(tables);
}

int main(void)
{
	ts_tools_begin();
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(tables_are_found_by_name),
		cmocka_unit_test(a_file_has_its_own_tables_alone),
		cmocka_unit_test(a_file_that_is_no_text_is_refused),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
