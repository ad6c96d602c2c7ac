/* Edited kernels, whose fast paths the build left out. */
#include "backends/fast.h"
#include <stdatomic.h>

#define FAST(kernel)
#define AT_ONCE(kernel)
#define EDITED(kernel) [TS_KERNEL_##kernel] = #kernel,
static const char *const edited[TS_N_KERNELS] = {
#include "fast.inc"
};
#undef EDITED
#undef AT_ONCE
#undef FAST

bool ts_fast_edited(ts_kernel kernel)
{
	static atomic_bool reported[TS_N_KERNELS];
	if (edited[kernel] == NULL) return false;
	if (!atomic_exchange(&reported[kernel], true)) {
		ts_say("%s runs without its fast path: the kernel was edited before the build", edited[kernel]);
	}
	return true;
}
