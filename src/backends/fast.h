/* The fast paths of the backend in C: ts_c_fast_<kernel>(args, n, threads) runs all items, with the same bits as
 * launching the kernel. False if it does not for these arguments, or there is no memory: then nothing was done. */
#ifndef TS_BACKENDS_FAST_H
#define TS_BACKENDS_FAST_H
#include "backends/backend.h"
#include "model/core.h"

typedef bool ts_fast_path(const void *args, u64 n, u32 threads);

/* ts_c_at_once_<kernel>(source, args, n, threads) does what launching the kernel over all pairs of a traversal does;
 * see `at_once` of ts_backend. False: as above. */
typedef bool ts_at_once(const void *source, const void *args, u64 n, u32 threads);

/* Every fast path, once: FAST(kernel, checksum), and AT_ONCE(kernel, checksum). The build leaves out those whose
 * kernel's text has another checksum (scripts/fast-paths). */
#define FAMILY(name) FAMILY_FILE(FAMILY_C, name, fast.def)
#define FAST(kernel, checksum) ts_fast_path ts_c_fast_##kernel;
#define AT_ONCE(kernel, checksum) ts_at_once ts_c_at_once_##kernel;
#include "families.def"
#undef AT_ONCE
#undef FAST

/* Whether the kernel was edited, so that it runs by itself alone: nothing that has its bits stands in for it. Says so
 * once. */
bool ts_fast_edited(ts_kernel kernel);

#endif
