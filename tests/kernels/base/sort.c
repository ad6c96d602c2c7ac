/* Lists in order, whatever came first. */
#include <stdlib.h>
#include <string.h>
#include "kernels/base/sort.h"
#include "tests/kernels/seeded.h"

static int by_number(const void *a, const void *b)
{
	u32 x = *(const u32 *)a, y = *(const u32 *)b;
	return (x > y) - (x < y);
}

static void lists_are_sorted_whatever_came_first(void **state)
{
	(void)state;
	for (u32 i = 0; i < 3000; i++) {
		u32 list[70], right[70], n = below(65), offset[2] = {3, 3 + n};
		for (u32 k = 0; k < 70; k++) right[k] = list[k] = i % 3 == 0 ? bits() : i % 3 == 1 ? below(9) : k;
		ts_sort_args args = {.offset = offset, .entries = list};
		ts_k_leaf_sort_item(&args, 0);
		qsort(right + 3, n, sizeof *right, by_number);
		assert_memory_equal(list, right, sizeof list);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(lists_are_sorted_whatever_came_first)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
