/* Which kernels have a fast path. */
#include "fast.h"

#define FAMILY(name) FAMILY_FILE(backends/c/name/fast.def)
#define FAST(kernel) [TS_KERNEL_##kernel] = ts_c_fast_##kernel,
static ts_fast_path *const paths[TS_N_KERNELS] = {
#include "../../families.def"
};
#undef FAST
#undef FAMILY

bool ts_c_fast(ts_kernel kernel, const void *args, u64 n, u32 threads)
{
	return paths[kernel] != NULL && paths[kernel](args, n, threads);
}
