/* The fast paths of the reference: ts_c_fast_<kernel>(args, n, threads) runs all items, with the same bits as launching
 * the kernel. False if it does not for these arguments, or there is no memory: then nothing was done. */
#ifndef TS_BACKENDS_FAST_H
#define TS_BACKENDS_FAST_H
#include "backend.h"

typedef bool ts_fast_path(const void *args, u64 n, u32 threads);

/* Every fast path, once: FAST(kernel). */
#define FAMILY(name) FAMILY_FILE(FAMILY_C, name, fast.def)
#define FAST(kernel) ts_fast_path ts_c_fast_##kernel;
#include "../families.def"
#undef FAST
#undef FAMILY

#endif
