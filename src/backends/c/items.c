/* The loops over the items of kernels: of those of the folder OF of src/kernels, of all without OF. The Makefile
 * compiles this file once for each folder. */
#include "../backend.h"
#ifdef OF
/* clang-format off */
#define TEXT(path) QUOTED(path)
#define QUOTED(path) #path
#define KERNELS_H TEXT(../../kernels/OF/kernels.h)
#define KERNELS_DEF TEXT(../../kernels/OF/kernels.def)
#define TS_FILE __BASE_FILE__ " of " TEXT(OF)
/* clang-format on */
#else
#define KERNELS_H "../kernels.h"
#define KERNELS_DEF "../kernels.def"
#endif
#include KERNELS_H

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
