/* The loops over the items of the kernels of kernels_of.h. */
#include "../backend.h"
#include "../kernels_of.h"
#include KERNELS_H
#ifdef OF
#define TS_FILE __BASE_FILE__ " of " TEXT(OF)
#endif

/* A kernel is one piece of code: compilers that weigh all kernels together inline less with each that is added. */
#if defined(__GNUC__)
#define WHOLE __attribute__((flatten))
#else
#define WHOLE
#endif

#define KERNEL(name, args_type) \
	WHOLE void ts_c_items_##name(const void *args, u64 begin, u64 end); \
	WHOLE void ts_c_items_##name(const void *args, u64 begin, u64 end) \
	{ \
		const args_type a = *(const args_type *)args; \
		for (u64 i = begin; i < end; i++) ts_k_##name##_item(&a, i); \
	}
#include KERNELS_DEF

#include "../selftest.h"
