/* Lists are sorted by the fast path as by the plain kernel: in order, nearly, with equal entries, in any order. */
#include "backends/fast.h"
#include "kernels/base/sort.h"
#include "tests/kernels/seeded.h"

enum { N = 300, LISTS = 50, ENTRIES = LISTS * 40 };

static u32 random_list(u32 *list, u32 how)
{
	u32 n = below(41), spread = below(8) == 0 ? 0 : 3;
	for (u32 k = 0; k < n; k++) list[k] = how == 0 ? bits() : (k > 0 ? list[k - 1] : 0) + below(spread + 1);
	if (how == 1 && n > 1) list[n - 1] = list[below(n)];
	if (how == 2 && n > 1) list[0] = below(2) == 0 ? TS_NONE : list[n - 1];
	return n;
}

static void fast_sorting_equals_the_kernel(void **state)
{
	(void)state;
	static u32 offset[LISTS + 1], entries[2][ENTRIES];
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		u32 start = n_random, threads = 1 + below(7);
		for (u32 k = 0; k < LISTS; k++) {
			offset[k + 1] = offset[k] + random_list(entries[0] + offset[k], below(4));
		}
		memcpy(entries[1], entries[0], sizeof entries[0]);
		ts_sort_args args = {.offset = offset, .entries = entries[0]};
		for (u64 k = 0; k < LISTS; k++) ts_k_leaf_sort_item(&args, k);
		args.entries = entries[1];
		assert_true(ts_c_fast_leaf_sort(&args, LISTS, threads));
		if (memcmp(entries[0], entries[1], sizeof entries[0]) != 0) fail_msg("random %u: %u threads", start, threads);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_sorting_equals_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
