/* The loops over the items of the kernels of a header, ITEMS, whose rows are ITEMS_DEF. The Makefile compiles this file
 * for each header that has kernels, so that an edit of one compiles few again. */
#include "../backend.h"
#include ITEMS
#define TS_FILE __BASE_FILE__ " of " ITEMS

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
#include ITEMS_DEF

#include "../selftest.h"
