/* Allocation: no overflow, no crash, a message with the name. */
#include "model/core.h"
#include "tests/model/test.h"

static void zero_bytes_give_a_pointer(void **state)
{
	(void)state;
	void *a = ts_alloc(0, 8, "nothing"), *b = ts_alloc_zero(5, 0, "nothing");
	assert_non_null(a);
	assert_non_null(b);
	free(a);
	free(b);
}

static void zeroed_memory_is_zero(void **state)
{
	(void)state;
	unsigned char *bytes = ts_alloc_zero(1000, 3, "bytes");
	assert_non_null(bytes);
	for (int i = 0; i < 3000; i++) assert_int_equal(bytes[i], 0);
	free(bytes);
}

static void refuses(size_t count, size_t size)
{
	ts_fail("old");
	assert_null(ts_alloc(count, size, "points.record"));
	assert_non_null(strstr(ts_error_message(), "points.record"));
	ts_fail("old");
	assert_null(ts_alloc_zero(count, size, "points.record"));
	assert_non_null(strstr(ts_error_message(), "points.record"));
}

static void absurd_sizes_are_refused(void **state)
{
	(void)state;
	refuses(SIZE_MAX, 2);
	refuses(SIZE_MAX / 2 + 1, 2);
	refuses((size_t)1 << 33, (size_t)1 << 31);
	refuses(2, SIZE_MAX);
	refuses((size_t)PTRDIFF_MAX, 1);
}

static void growing_keeps_the_contents(void **state)
{
	(void)state;
	uint32_t *array = NULL;
	size_t capacity = 0, moves = 0;
	for (uint32_t i = 0; i < 100000; i++) {
		size_t before = capacity;
		assert_int_equal(ts_grow((void **)&array, &capacity, i + 1, sizeof *array, "numbers"), TS_OK);
		assert_true(capacity > i && capacity >= 16);
		if (i < 16) assert_int_equal(capacity, 16);
		moves += capacity != before;
		array[i] = i;
	}
	assert_true(moves <= 18);
	for (uint32_t i = 0; i < 100000; i++) assert_int_equal(array[i], i);
	free(array);
}

static void failed_growth_leaves_the_array(void **state)
{
	(void)state;
	uint64_t *array = NULL;
	size_t capacity = 0;
	assert_int_equal(ts_grow((void **)&array, &capacity, 3, sizeof *array, "numbers"), TS_OK);
	array[2] = 42;
	void *before = array;
	size_t capacity_before = capacity;
	assert_int_equal(ts_grow((void **)&array, &capacity, SIZE_MAX / 4, sizeof *array, "numbers"), TS_ERROR);
	assert_ptr_equal(array, before);
	assert_int_equal(capacity, capacity_before);
	assert_int_equal(array[2], 42);
	assert_non_null(strstr(ts_error_message(), "numbers"));
	free(array);
}

static void memory_of_the_machine_is_plausible(void **state)
{
	(void)state;
	assert_in_range(ts_memory_total(), (uint64_t)1 << 26, (uint64_t)1 << 50);
}

/* 64 MiB more and, when released, less. */
static void memory_in_use_is_counted(void **state)
{
	(void)state;
	if (TS_TEST_SANITIZED) skip();
	size_t bytes = (size_t)64 << 20;
	uint64_t before = ts_memory_used();
	char *memory = ts_alloc(bytes, 1, "bytes");
	assert_non_null(memory);
	memset(memory, 1, bytes);
	assert_int_equal(memory[bytes / 2], 1);
	uint64_t full = ts_memory_used();
	free(memory);
	assert_in_range(full, before + bytes / 2, before + 2 * bytes);
	assert_true(ts_memory_used() < full);
}

static void the_clock_never_goes_back(void **state)
{
	(void)state;
	double last = ts_seconds();
	for (int i = 0; i < 10000; i++) {
		double now = ts_seconds();
		assert_true(now >= last);
		last = now;
	}
}

int main(void)
{
	const struct CMUnitTest memory[] = {
		cmocka_unit_test(zero_bytes_give_a_pointer),      cmocka_unit_test(zeroed_memory_is_zero),
		cmocka_unit_test(absurd_sizes_are_refused),       cmocka_unit_test(growing_keeps_the_contents),
		cmocka_unit_test(failed_growth_leaves_the_array), cmocka_unit_test(memory_of_the_machine_is_plausible),
		cmocka_unit_test(memory_in_use_is_counted),       cmocka_unit_test(the_clock_never_goes_back),
	};
	return cmocka_run_group_tests(memory, NULL, NULL);
}
