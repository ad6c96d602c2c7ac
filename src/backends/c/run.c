/* The reference backend: a threaded loop over the items of a kernel. */
#include "../backend.h"

typedef void kernel_items(const void *args, u64 begin, u64 end);

/* A kernel is one piece of code: compilers that weigh all kernels together inline less with each that is added. */
#if defined(__GNUC__)
#define WHOLE __attribute__((flatten))
#else
#define WHOLE
#endif

#define KERNEL(name, args_type) \
	WHOLE static void name##_items(const void *args, u64 begin, u64 end) \
	{ \
		const args_type a = *(const args_type *)args; \
		for (u64 i = begin; i < end; i++) ts_k_##name##_item(&a, i); \
	}
#include "../kernels.def"
#undef KERNEL

#define KERNEL(name, args_type) name##_items,
static kernel_items *const kernels[TS_N_KERNELS] = {
#include "../kernels.def"
};
#undef KERNEL

enum { CHUNKS_A_THREAD = 64, LEAST_ITEMS = 16 };

void ts_c_launch(ts_kernel kernel, const void *args, u64 n, u32 threads)
{
	kernel_items *items = kernels[kernel];
	u64 size = n / ((u64)threads * CHUNKS_A_THREAD);
	size = size < LEAST_ITEMS ? LEAST_ITEMS : size;
	i64 chunks = (i64)((n + size - 1) / size);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (chunks > 1)
	for (i64 chunk = 0; chunk < chunks; chunk++) {
		u64 begin = (u64)chunk * size;
		items(args, begin, begin + size < n ? begin + size : n);
	}
}

u64 ts_c_scan(u32 *counts, u64 n)
{
	u64 sum = 0;
	for (u64 i = 0; i < n; i++) {
		u32 count = counts[i];
		counts[i] = (u32)sum;
		sum += count;
	}
	counts[n] = (u32)sum;
	return sum;
}

void ts_c_empty(u64 *texels, u64 n, u32 threads)
{
#pragma omp parallel for schedule(static) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) texels[i] = TS_EMPTY;
}
