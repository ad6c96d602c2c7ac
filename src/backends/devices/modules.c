/* Kernels that were compiled ahead. */
#include "backends/devices/modules.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { MOST_OF_FILE = 16 << 20, PATH = 1024 };

static ts_status unpack(ts_modules *modules)
{
	const ts_packed *packed = &modules->packed;
	if (modules->unpacked != NULL) return TS_OK;
	uLongf bytes = packed->first[TS_N_KERNELS];
	u8 *unpacked = ts_alloc(bytes + 1, 1, "the kernels");
	if (unpacked == NULL) return TS_ERROR;
	if (uncompress(unpacked, &bytes, packed->bytes, packed->n_bytes) != Z_OK || bytes != packed->first[TS_N_KERNELS]) {
		free(unpacked);
		return ts_fail_as(TS_KIND_MEMORY, "backend %s: no memory to unpack the kernels", modules->backend);
	}
	modules->unpacked = unpacked;
	return TS_OK;
}

static ts_status path_of(const ts_modules *modules, ts_kernel kernel, char path[PATH])
{
	int n = snprintf(path, PATH, "%s/%s.%s", modules->folder, ts_kernel_name(kernel), modules->ending);
	return n >= 0 && n < PATH ? TS_OK : ts_fail("build: at most 900 characters are taken");
}

ts_status ts_modules_refuse(const ts_modules *modules, ts_kernel kernel, const char *reason)
{
	char path[PATH];
	if (path_of(modules, kernel, path) != TS_OK) return TS_ERROR;
	return ts_fail("build: %s: %s; one NAME.%s for each kernel is wanted", path, reason, modules->ending);
}

static ts_status read_open(const ts_modules *modules, ts_kernel kernel, FILE *file, ts_module *module)
{
	u8 *bytes = ts_alloc(MOST_OF_FILE, 1, modules->folder);
	if (bytes == NULL) return TS_ERROR;
	module->bytes = module->read = bytes;
	module->n_bytes = fread(bytes, 1, MOST_OF_FILE - 1, file);
	if (ferror(file)) return ts_modules_refuse(modules, kernel, strerror(errno));
	if (!feof(file)) return ts_modules_refuse(modules, kernel, "not less than 16 MiB");
	bytes[module->n_bytes] = 0;
	return TS_OK;
}

static ts_status read_module(const ts_modules *modules, ts_kernel kernel, ts_module *module)
{
	char path[PATH];
	if (path_of(modules, kernel, path) != TS_OK) return TS_ERROR;
	FILE *file = fopen(path, "rb");
	if (file == NULL) return ts_modules_refuse(modules, kernel, strerror(errno));
	ts_status status = read_open(modules, kernel, file, module);
	fclose(file);
	return status;
}

ts_status ts_modules_find(ts_modules *modules, ts_kernel kernel, ts_module *module)
{
	const u32 *first = modules->packed.first + kernel;
	*module = (ts_module){.read = NULL};
	if (modules->folder[0] != 0) return read_module(modules, kernel, module);
	if (first[0] == first[1]) {
		return ts_fail("backend %s: built without its kernels; `make` without DEVICES= adds them, CUDA's by clang",
		               modules->backend);
	}
	if (unpack(modules) != TS_OK) return TS_ERROR;
	*module = (ts_module){.bytes = modules->unpacked + first[0], .n_bytes = first[1] - first[0]};
	return TS_OK;
}

void ts_module_free(ts_module *module)
{
	free(module->read);
	module->read = NULL;
}

void ts_modules_free(ts_modules *modules)
{
	free(modules->unpacked);
	modules->unpacked = NULL;
}
