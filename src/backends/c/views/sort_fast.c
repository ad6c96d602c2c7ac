/* Fast path of the sorting of lists, with the same bits: lists that are sorted already, as one thread or an ordered
 * pass leaves them, stay. */
#include "backends/fast.h"
#include "kernels/base/sort.h"

enum { LISTS_A_CHUNK = 16 };

static bool is_sorted(const u32 *entries, u32 n)
{
	u32 falls = 0;
	for (u32 k = 1; k < n; k++) falls |= entries[k] < entries[k - 1] ? 1u : 0u;
	return falls == 0;
}

bool ts_c_fast_leaf_sort(const void *of, u64 n, u32 threads)
{
	const ts_sort_args *args = of;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, LISTS_A_CHUNK) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) {
		if (ts_stopped(stop)) continue;
		u32 first = args->offset[i];
		if (!is_sorted(args->entries + first, args->offset[i + 1] - first)) ts_k_leaf_sort_item(args, (u64)i);
	}
	return true;
}

#include "backends/selftest.h"
