/* Prefix sums, as the host makes them between two kernels. */
#ifndef TS_TESTS_KERNELS_SUMS_H
#define TS_TESTS_KERNELS_SUMS_H
#include "kernels/base/compat.h"

/* n counts become the sums of those before each, and one more of all. */
static inline void prefix_sums(u32 *counts, u32 n)
{
	u32 total = 0;
	for (u32 i = 0; i <= n; i++) {
		u32 count = counts[i];
		counts[i] = total;
		total += i < n ? count : 0;
	}
}

#endif
