/* What families hand in: handed in again it is the same, and each table of bench has a name of its own and is
 * measured in one way. */
#include "study/asked/truths.h"
#include "study/tables/tables.h"
#include "tests/model/test.h"
#include "tools/tools.h"

static u32 count_benches(void)
{
	u32 n = 0;
	ts_tables *tables;
	if (ts_tables_open(&tables) != TS_OK) fail_msg("%s", ts_error_message());
	while (ts_tables_at(tables, n) != NULL) n++;
	ts_tables_close(tables);
	return n;
}

static u32 count_truths(void)
{
	u32 n = 0;
	while (ts_truths()[n] != NULL) n++;
	return n;
}

static void tools_handed_in_again_are_the_same(void **state)
{
	(void)state;
	u32 benches = count_benches(), truths = count_truths();
	const ts_truth_kind *first = ts_truths()[0];
	assert_true(benches > 2 && truths > 0);
	ts_tools_begin();
	assert_int_equal(count_benches(), benches);
	assert_int_equal(count_truths(), truths);
	assert_ptr_equal(ts_truths()[0], first);
}

static void each_table_has_its_own_name(void **state)
{
	(void)state;
	const ts_bench_row *row;
	ts_tables *tables;
	if (ts_tables_open(&tables) != TS_OK) fail_msg("%s", ts_error_message());
	for (u32 i = 0; (row = ts_tables_at(tables, i)) != NULL; i++) {
		assert_int_equal((row->paper != NULL) + (row->run != NULL) + (row->speed != NULL), 1);
		for (u32 k = 0; k < i; k++) assert_string_not_equal(row->name, ts_tables_at(tables, k)->name);
	}
	ts_tables_close(tables);
}

int main(void)
{
	const struct CMUnitTest tools[] = {cmocka_unit_test(tools_handed_in_again_are_the_same),
	                                   cmocka_unit_test(each_table_has_its_own_name)};
	return cmocka_run_group_tests(tools, NULL, NULL);
}
