/* Kernels that were compiled before: a module each, packed into the library, or in a folder of the user's. */
#ifndef TS_BACKENDS_MODULES_H
#define TS_BACKENDS_MODULES_H
#include "args.h"

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
	u8 *unpacked;       /* as soon as one is asked for */
} ts_modules;

/* Of text, which a zero byte ends; of words, at a multiple of 4. */
typedef struct {
	const u8 *bytes;
	u64 n_bytes;
	u8 *read; /* what ts_module_free frees */
} ts_module;

/* Also after an error the module is to be freed. */
ts_status ts_modules_find(ts_modules *modules, ts_kernel kernel, ts_module *module);
/* The error that a module of the user's folder is no such thing. */
ts_status ts_modules_refuse(const ts_modules *modules, ts_kernel kernel, const char *reason);
void ts_module_free(ts_module *module);
void ts_modules_free(ts_modules *modules);

#endif
