/* Kernels that were compiled earlier: one module per kernel, packed into the library, or in a folder of the user. */
#ifndef TS_BACKENDS_DEVICES_MODULES_H
#define TS_BACKENDS_DEVICES_MODULES_H
#include "backends/args.h"

/* All modules, one after the other, packed by zlib (scripts/kernel/packed.py); kernel K's are the bytes from first[K]
 * to first[K + 1]. */
typedef struct {
	const u8 *bytes;
	u64 n_bytes;
	const u32 *first;
} ts_packed;

typedef struct {
	const char *backend, *ending; /* of the names of files */
	ts_packed packed;
	const char *folder; /* of the user's own, or "" */
	u8 *unpacked;       /* made when the first module is asked for */
} ts_modules;

/* A module: text, ended by a zero byte; or words, at a multiple of 4. */
typedef struct {
	const u8 *bytes;
	u64 n_bytes;
	u8 *read; /* what ts_module_free frees */
} ts_module;

/* Finds the module of a kernel. Free *module by ts_module_free, also after an error. */
ts_status ts_modules_find(ts_modules *modules, ts_kernel kernel, ts_module *module);
/* Fails because a file of the user's folder is no valid module. */
ts_status ts_modules_refuse(const ts_modules *modules, ts_kernel kernel, const char *reason);
void ts_module_free(ts_module *module);
void ts_modules_free(ts_modules *modules);

#endif
