/* Heapsort (Williams 1964), in place, of lists that were appended in any order: the triangles or views of the leaves of
 * octrees, and the surfels of pixels. */
#ifndef TS_KERNELS_BASE_SORT_H
#define TS_KERNELS_BASE_SORT_H
#include "kernels/base/args.h"

#define TS_ROWS_ts_sort_args(ARG) \
	ARG(IN, u32, offset, none) /* of each list */ \
	ARG(OUT, u32, entries, none)
TS_ARGS(ts_sort_args);

/* Moves entry k of a heap of n entries down to its place. */
TS_FN void ts_k_sift(TS_GLOBAL u32 *heap, u32 k, u32 n)
{
	u32 value = heap[k];
	for (u32 child = 2u * k + 1u; child < n; child = 2u * k + 1u) {
		if (child + 1u < n && heap[child] < heap[child + 1u]) child++;
		if (heap[child] <= value) break;
		heap[k] = heap[child];
		k = child;
	}
	heap[k] = value;
}

/* map over lists: sorts the entries of each */
TS_FN void ts_k_leaf_sort_item(const ts_sort_args *args, u64 i)
{
	TS_GLOBAL u32 *heap = args->entries + args->offset[i];
	u32 n = args->offset[i + 1u] - args->offset[i];
	for (u32 k = n / 2u; k-- > 0u;) ts_k_sift(heap, k, n);
	for (u32 left = n; left-- > 1u;) {
		u32 greatest = heap[0];
		heap[0] = heap[left];
		heap[left] = greatest;
		ts_k_sift(heap, 0u, left);
	}
}

#endif
