/* The kernels as C that tells what it computes, which scripts/explained writes. */
#include "told.h"
#include "../backends/kernels.h"
#include "explained.inc"

typedef void told_item(const void *args, u64 item);

#define KERNEL(name, args_type) \
	static void item_##name(const void *args, u64 item) { told_ts_k_##name##_item(args, item); }
#include "../backends/kernels.def"
#undef KERNEL

#define KERNEL(name, args_type) item_##name,
static told_item *const items[] = {
#include "../backends/kernels.def"
};
#undef KERNEL

void ts_told_item(u32 kernel, const void *args, u64 item) { items[kernel](args, item); }

#include "../backends/selftest.h"
