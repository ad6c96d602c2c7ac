/* Each kernel as an entry point of its name: items [first, n) of a grid of one dimension. scripts/ptx compiles this
 * file once for all kernels, and once for each folder OF of src/kernels. */
#include "backends/cuda/builtins.h"

#ifdef OF
/* clang-format off */
#define TEXT(path) QUOTED(path)
#define QUOTED(path) #path
#define KERNELS_H TEXT(kernels/OF/kernels.h)
#define KERNELS_DEF TEXT(kernels/OF/kernels.def)
#define BANDS(kernel, arguments, others)
#define PIECES(kernel, by, arguments, from, unless, n)
/* clang-format on */
#else
#define KERNELS_H "backends/kernels.h"
#define KERNELS_DEF "backends/kernels.def"
#endif
#include KERNELS_H

#define KERNEL(name, arguments) \
	extern "C" __global__ void name(const arguments args, u64 first, u64 n) \
	{ \
		u64 i = first + (u64)__nvvm_read_ptx_sreg_ctaid_x() * __nvvm_read_ptx_sreg_ntid_x() + \
		        __nvvm_read_ptx_sreg_tid_x(); \
		if (i < n) ts_k_##name##_item(&args, i); \
	}
#include KERNELS_DEF
