/* The loops over the items of the kernels of a header, ITEMS, whose rows are ITEMS_DEF. The Makefile compiles this file
 * once per header that has kernels, so that editing a header compiles few of them again. */
#include "backends/backend.h"
#include ITEMS
#define TS_FILE __BASE_FILE__ " of " ITEMS

#define KERNEL(name, args_type) \
	void ts_c_items_##name(const void *args, u64 begin, u64 end); \
	void ts_c_items_##name(const void *args, u64 begin, u64 end) \
	{ \
		const args_type a = *(const args_type *)args; \
		for (u64 i = begin; i < end; i++) ts_k_##name##_item(&a, i); \
	}
#include ITEMS_DEF

#include "backends/selftest.h"
