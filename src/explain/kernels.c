/* The kernels as C that reports what it computes, written by scripts/explained; `make DEVICES=` leaves them out. */
#include "explain/told.h"
#ifdef TS_LEFT_OUT
const bool ts_told_here = false;
void ts_told_item(u32 kernel, const void *args, u64 item)
{
	(void)kernel;
	(void)args;
	(void)item;
}
#else
const bool ts_told_here = true;
#include "backends/kernels.h"
#include "explained.inc"

typedef void told_item(const void *args, u64 item);

#define KERNEL(name, args_type) \
	static void item_##name(const void *args, u64 item) { told_ts_k_##name##_item(args, item); }
#include "backends/kernels.def"

#define KERNEL(name, args_type) item_##name,
static told_item *const items[] = {
#include "backends/kernels.def"
};

void ts_told_item(u32 kernel, const void *args, u64 item) { items[kernel](args, item); }
#endif

#include "backends/selftest.h"
