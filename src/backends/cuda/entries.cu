/* Each kernel of kernels_of.h as an entry point of its name: items [first, n) of a grid of one dimension. */
#include "backends/cuda/builtins.h"
#include "backends/kernels_of.h"
#include KERNELS_H

#define KERNEL(name, arguments) \
	extern "C" __global__ void name(const arguments args, u64 first, u64 n) \
	{ \
		u64 i = first + (u64)__nvvm_read_ptx_sreg_ctaid_x() * __nvvm_read_ptx_sreg_ntid_x() + \
		        __nvvm_read_ptx_sreg_tid_x(); \
		if (i < n) ts_k_##name##_item(&args, i); \
	}
#include KERNELS_DEF
