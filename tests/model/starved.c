/* One allocation that failed is remembered, whatever follows. */
#include "../../src/model/core.h"
#include "test.h"

static void test_remembered(void **state)
{
	(void)state;
	assert_int_equal(ts_starved_check("a list"), TS_OK);
	void *memory = ts_starved_malloc(16);
	assert_non_null(memory);
	free(memory);
	assert_int_equal(ts_starved_check("a list"), TS_OK);
	volatile size_t too_much = SIZE_MAX / 2;
	assert_null(ts_starved_malloc(too_much));
	for (int i = 0; i < 2; i++) {
		assert_int_equal(ts_starved_check("a list"), TS_ERROR);
		assert_string_equal(ts_error_message(), "a list: out of memory");
		memory = ts_starved_malloc(16);
		free(memory);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_remembered)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
