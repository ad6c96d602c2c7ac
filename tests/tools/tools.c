/* What families hand in: handed in again it is the same, and each table of bench has a name of its own and is
 * measured in one way. */
#include "study/asked/truths.h"
#include "study/bench.h"
#include "tests/model/test.h"
#include "tools/tools.h"

static u32 count_benches(void)
{
	u32 n = 0;
	while (ts_benches()[n] != NULL) n++;
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
	for (const ts_bench_row *const *a = ts_benches(); *a != NULL; a++) {
		assert_int_equal(((*a)->paper != NULL) + ((*a)->run != NULL), 1);
		for (const ts_bench_row *const *b = ts_benches(); b < a; b++) assert_string_not_equal((*a)->name, (*b)->name);
	}
}

int main(void)
{
	const struct CMUnitTest tools[] = {cmocka_unit_test(tools_handed_in_again_are_the_same),
	                                   cmocka_unit_test(each_table_has_its_own_name)};
	return cmocka_run_group_tests(tools, NULL, NULL);
}
