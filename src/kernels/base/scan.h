/* Exclusive prefix sums of 32-bit counts in three passes: the sum of every chunk, the sums before every chunk, and the
 * counts before every element. Sums are integers, so the size of chunks never changes a result. */
#ifndef TS_KERNELS_BASE_SCAN_H
#define TS_KERNELS_BASE_SCAN_H
#include "kernels/base/args.h"
#include "kernels/base/compat.h"

#define TS_ROWS_ts_scan_args(ARG) \
	ARG(OUT, u32, counts, none) /* n, and one more for the total */ \
	ARG(WORK, u64, sums, other) /* of the chunks, and one more for the total */ \
	ARG(VALUE, u64, n, none) \
	ARG(VALUE, u64, n_chunks, none) \
	ARG(VALUE, u32, chunk, none) /* elements */
TS_ARGS(ts_scan_args);

/* map over chunks */
TS_FN void ts_k_scan_sum_item(const ts_scan_args *args, u64 i)
{
	u64 sum = 0u;
	for (u64 k = i * args->chunk; k < (i + 1u) * args->chunk && k < args->n; k++) sum += args->counts[k];
	args->sums[i] = sum;
}

/* one item, 0, which visits all chunks in order */
TS_FN void ts_k_scan_chunks_item(const ts_scan_args *args, u64 i)
{
	u64 before = 0u;
	if (i != 0u) return;
	for (u64 k = 0u; k < args->n_chunks; k++) {
		u64 sum = args->sums[k];
		args->sums[k] = before;
		before += sum;
	}
	args->sums[args->n_chunks] = before;
	args->counts[args->n] = (u32)before;
}

/* map over chunks */
TS_FN void ts_k_scan_item(const ts_scan_args *args, u64 i)
{
	u64 before = args->sums[i];
	for (u64 k = i * args->chunk; k < (i + 1u) * args->chunk && k < args->n; k++) {
		u32 count = args->counts[k];
		args->counts[k] = (u32)before;
		before += count;
	}
}

#endif
