/* A driver of CUDA without a GPU, for tests: libcuda.so.1 with one device, whose memory is its own, and which runs PTX
 * as it stands: ptx.py makes C of it, an instruction a statement, and the compiler of C a library. What a driver
 * refuses, this refuses too: calls without a context, memory that was not allocated, and all that comes after a kernel
 * that failed. Items of a group run from the last to the first. Leaks end the process. CUDA_VISIBLE_DEVICES, empty, and
 * CUDA_CACHE_PATH, a folder for what was compiled, are NVIDIA's. Of this driver:
 *   TS_CUDA_FAIL  CALL:N:RESULT: the N-th call of that name fails, as cuMemAlloc_v2:3:2; of "kernel", the N-th kernel,
 *                 which shows as the host waits
 *   TS_CUDA_OLD   a device before Volta */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "backends/cuda/cu.h"

enum { INVALID_VALUE = 1, OUT_OF_MEMORY = 2, INVALID_CONTEXT = 201, INVALID_PTX = 218, NOT_FOUND = 500 };
enum { BLOCKS = 4096, MODULES = 1024 };
#define EXPORT __attribute__((visibility("default")))

typedef void kernel(u8 **given, u32 ctaid, u32 ntid, u32 tid);
typedef struct {
	kernel *run;
	const u32 *sizes; /* of its parameters, ended by 0 */
} function;

static struct {
	u8 *data;
	size_t bytes;
} blocks[BLOCKS];
static struct {
	void *library;
	function function;
} modules[MODULES];
static int context, failed; /* a kernel's result, which stays */
static void *current;

/* The result that TS_CUDA_FAIL asks of this call, or 0. */
static int asked(const char *call)
{
	static int n;
	char name[64];
	int at, result;
	const char *fail = getenv("TS_CUDA_FAIL");
	if (fail == NULL || sscanf(fail, "%63[^:]:%d:%d", name, &at, &result) != 3 || strcmp(name, call) != 0) return 0;
	return ++n == at ? result : 0;
}

#define BEGIN \
	do { \
		int result = asked(__func__); \
		if (result != 0) return result; \
	} while (0)
#define BEGIN_WORK \
	BEGIN; \
	do { \
		if (current != &context) return INVALID_CONTEXT; \
		if (failed != 0) return failed; \
	} while (0)

EXPORT CUresult cuInit(unsigned flags)
{
	BEGIN;
	if (flags != 0) return INVALID_VALUE;
	const char *visible = getenv("CUDA_VISIBLE_DEVICES");
	return visible == NULL || visible[0] != 0 ? CUDA_SUCCESS : CUDA_ERROR_NO_DEVICE;
}

EXPORT CUresult cuDriverGetVersion(int *version)
{
	*version = 11020;
	return CUDA_SUCCESS;
}

EXPORT CUresult cuGetErrorName(CUresult result, const char **name)
{
	*name = result == OUT_OF_MEMORY ? "CUDA_ERROR_OUT_OF_MEMORY" : "CUDA_ERROR_OF_THIS_TEST";
	return CUDA_SUCCESS;
}

EXPORT CUresult cuGetErrorString(CUresult result, const char **text)
{
	*text = result == OUT_OF_MEMORY ? "out of memory" : NULL;
	return result == OUT_OF_MEMORY ? CUDA_SUCCESS : INVALID_VALUE;
}

EXPORT CUresult cuDeviceGetCount(int *count)
{
	BEGIN;
	*count = 1;
	return CUDA_SUCCESS;
}

EXPORT CUresult cuDeviceGet(CUdevice *device, int index)
{
	BEGIN;
	*device = 7;
	return index == 0 ? CUDA_SUCCESS : INVALID_VALUE;
}

EXPORT CUresult cuDeviceGetName(char *name, int bytes, CUdevice device)
{
	snprintf(name, (size_t)bytes, "PTX as C");
	return device == 7 ? CUDA_SUCCESS : INVALID_VALUE;
}

EXPORT CUresult cuDeviceTotalMem_v2(size_t *bytes, CUdevice device)
{
	*bytes = (size_t)4 << 30;
	return device == 7 ? CUDA_SUCCESS : INVALID_VALUE;
}

EXPORT CUresult cuDeviceGetAttribute(int *value, int attribute, CUdevice device)
{
	const char *old = getenv("TS_CUDA_OLD");
	*value = attribute == CU_DEVICE_ATTRIBUTE_MAX_THREADS_PER_BLOCK      ? 1024
	         : attribute == CU_DEVICE_ATTRIBUTE_MAX_GRID_DIM_X           ? 1000
	         : attribute == CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR ? (old != NULL ? 6 : 7)
	                                                                     : 0;
	return device == 7 ? CUDA_SUCCESS : INVALID_VALUE;
}

EXPORT CUresult cuDevicePrimaryCtxRetain(CUcontext *made, CUdevice device)
{
	BEGIN;
	*made = &context;
	return device == 7 ? CUDA_SUCCESS : INVALID_VALUE;
}

static void leaks(const char *what)
{
	fprintf(stderr, "driver of the test: %s were not freed\n", what);
	abort();
}

EXPORT CUresult cuDevicePrimaryCtxRelease_v2(CUdevice device)
{
	for (int i = 0; i < BLOCKS; i++) {
		if (blocks[i].data != NULL && failed == 0) leaks("blocks of memory");
		free(blocks[i].data);
		blocks[i].data = NULL;
	}
	for (int i = 0; i < MODULES; i++) {
		if (modules[i].library != NULL && failed == 0) leaks("modules");
	}
	failed = 0;
	return device == 7 ? CUDA_SUCCESS : INVALID_VALUE;
}

EXPORT CUresult cuCtxSetCurrent(CUcontext to)
{
	BEGIN;
	current = to;
	return to == &context ? CUDA_SUCCESS : INVALID_CONTEXT;
}

EXPORT CUresult cuCtxSynchronize(void)
{
	BEGIN_WORK;
	return CUDA_SUCCESS;
}

/* The folder's name for what a text becomes. */
static void path_of(char path[512], const char *text)
{
	const char *cache = getenv("CUDA_CACHE_PATH");
	u64 hash = 0xcbf29ce484222325u;
	for (const char *c = text; *c != 0; c++) hash = (hash ^ (u8)*c) * 0x100000001b3u;
	snprintf(path, 512, "%s/%016llx", cache != NULL ? cache : TS_CACHE, (unsigned long long)hash);
}

/* In files of this process, for another may compile the same text. The paths are the script's arguments. */
static int compile(const char *text, const char *path)
{
	static const char script[] =
		"set -eu; trap 'rm -f -- \"$1\".*' EXIT; /usr/bin/python3 \"$2/ptx.py\" < \"$1.ptx\" > \"$1.c\"; "
		"${CC:-gcc} -O1 -std=c11 -shared -fPIC -ffp-contract=off -fno-strict-aliasing -w -I\"$2\" \"$1.c\" "
		"-o \"$1.so\" -lm -Wl,-z,defs; mv -- \"$1.so\" \"$3.so\"";
	char at[560], ptx[576];
	snprintf(at, sizeof at, "%s.%d", path, (int)getpid());
	snprintf(ptx, sizeof ptx, "%s.ptx", at);
	FILE *file = fopen(ptx, "w");
	if (file == NULL) return INVALID_PTX;
	fputs(text, file);
	fclose(file);
	char *words[] = {"sh", "-c", (char *)script, "sh", at, TS_PTX, (char *)path, NULL};
	pid_t child;
	int status;
	if (posix_spawn(&child, "/bin/sh", NULL, NULL, words, environ) != 0) return INVALID_PTX;
	return waitpid(child, &status, 0) == child && status == 0 ? CUDA_SUCCESS : INVALID_PTX;
}

EXPORT CUresult cuModuleLoadDataEx(CUmodule *module, const void *image, unsigned n, int *options, void **values)
{
	char path[512], library[528];
	BEGIN_WORK;
	path_of(path, image);
	snprintf(library, sizeof library, "%s.so", path);
	if (access(library, R_OK) != 0 && compile(image, path) != CUDA_SUCCESS) {
		if (n == 2 && options[0] == CU_JIT_ERROR_LOG_BUFFER && options[1] == CU_JIT_ERROR_LOG_BUFFER_SIZE_BYTES)
			snprintf(values[0], (size_t)values[1], "ptxas: this is not\nwhat ptx.py knows\n");
		return INVALID_PTX;
	}
	for (int i = 0; i < MODULES; i++) {
		if (modules[i].library != NULL) continue;
		modules[i].library = dlopen(library, RTLD_NOW | RTLD_LOCAL);
		*module = &modules[i];
		return modules[i].library != NULL ? CUDA_SUCCESS : INVALID_PTX;
	}
	return OUT_OF_MEMORY;
}

EXPORT CUresult cuModuleUnload(CUmodule module)
{
	BEGIN;
	void **library = module;
	dlclose(*library);
	*library = NULL;
	return CUDA_SUCCESS;
}

EXPORT CUresult cuModuleGetFunction(CUfunction *found, CUmodule module, const char *name)
{
	char sizes[128];
	BEGIN_WORK;
	int i = (int)((u8 *)module - (u8 *)modules) / (int)sizeof *modules;
	function *f = &modules[i].function;
	snprintf(sizes, sizeof sizes, "%s_sizes", name);
	*(void **)&f->run = dlsym(modules[i].library, name);
	f->sizes = dlsym(modules[i].library, sizes);
	*found = f;
	return f->run != NULL && f->sizes != NULL ? CUDA_SUCCESS : NOT_FOUND;
}

/* Filled with what is no use, so that what was not written shows. */
EXPORT CUresult cuMemAlloc_v2(CUdeviceptr *address, size_t bytes)
{
	BEGIN_WORK;
	if (bytes == 0) return INVALID_VALUE;
	for (int i = 0; i < BLOCKS; i++) {
		if (blocks[i].data != NULL) continue;
		blocks[i].data = malloc(bytes);
		if (blocks[i].data == NULL) return OUT_OF_MEMORY;
		blocks[i].bytes = bytes;
		memset(blocks[i].data, 0xa5, bytes);
		*address = (CUdeviceptr)blocks[i].data;
		return CUDA_SUCCESS;
	}
	return OUT_OF_MEMORY;
}

EXPORT CUresult cuMemFree_v2(CUdeviceptr address)
{
	BEGIN_WORK;
	for (int i = 0; i < BLOCKS; i++) {
		if (blocks[i].data != (u8 *)address) continue;
		free(blocks[i].data);
		blocks[i].data = NULL;
		return CUDA_SUCCESS;
	}
	return INVALID_VALUE;
}

static int is_inside(CUdeviceptr at, size_t bytes)
{
	for (int i = 0; i < BLOCKS; i++) {
		u64 begin = (u64)blocks[i].data;
		if (begin != 0 && at >= begin && at + bytes <= begin + blocks[i].bytes) return 1;
	}
	return 0;
}

EXPORT CUresult cuMemcpyHtoD_v2(CUdeviceptr to, const void *from, size_t bytes)
{
	BEGIN_WORK;
	if (!is_inside(to, bytes)) return INVALID_VALUE;
	memcpy((void *)to, from, bytes);
	return CUDA_SUCCESS;
}

EXPORT CUresult cuMemcpyDtoH_v2(void *to, CUdeviceptr from, size_t bytes)
{
	BEGIN_WORK;
	if (!is_inside(from, bytes)) return INVALID_VALUE;
	memcpy(to, (const void *)from, bytes);
	return CUDA_SUCCESS;
}

EXPORT CUresult cuMemsetD8_v2(CUdeviceptr to, unsigned char byte, size_t bytes)
{
	BEGIN_WORK;
	if (!is_inside(to, bytes)) return INVALID_VALUE;
	memset((void *)to, byte, bytes);
	return CUDA_SUCCESS;
}

enum { PARAMETERS = 16 };
_Static_assert(TS_POINTERS * 12 < 4096, "parameters of a kernel");

EXPORT CUresult cuLaunchKernel(CUfunction of, unsigned grid_x, unsigned grid_y, unsigned grid_z, unsigned block_x,
                               unsigned block_y, unsigned block_z, unsigned shared, CUstream stream, void **parameters,
                               void **extra)
{
	static _Alignas(16) u8 copies[PARAMETERS][4096];
	u8 *given[PARAMETERS];
	const function *f = of;
	BEGIN_WORK;
	if (grid_x == 0 || grid_x > 1000 || grid_y != 1 || grid_z != 1 || block_x == 0 || block_x > 1024 || block_y != 1 ||
	    block_z != 1 || shared != 0 || stream != NULL || extra != NULL)
		return INVALID_VALUE;
	for (int i = 0; f->sizes[i] != 0; i++) {
		given[i] = copies[i];
		memcpy(copies[i], parameters[i], f->sizes[i]);
	}
	failed = asked("kernel");
	if (failed != 0) return CUDA_SUCCESS;
#pragma omp parallel for schedule(dynamic)
	for (unsigned group = 0; group < grid_x; group++) {
		for (unsigned item = block_x; item-- > 0;) f->run(given, group, block_x, item);
	}
	return CUDA_SUCCESS;
}
