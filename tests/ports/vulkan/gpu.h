/* What a port needs of Vulkan 1.2, and no more: memory with addresses, and compute shaders that take addresses.
 * Whatever fails ends the program with one line and status 2. */
#ifndef TS_TESTS_PORTS_VULKAN_GPU_H
#define TS_TESTS_PORTS_VULKAN_GPU_H
#include <stddef.h>
#include <stdint.h>

/* The first device that suffices. Returns its name, or NULL if there is none. */
const char *gpu_open(void);
void gpu_close(void);

/* Memory that the host sees as `data` and shaders at `address`. It lives as long as the device. */
typedef struct {
	void *data;
	uint64_t address;
} gpu_memory;
gpu_memory gpu_allocate(size_t bytes);

/* Runs a module of SPIR-V, in rows of groups of 64 items, to its end. The push constants begin with
 * n_items. */
void gpu_run(const char *path, uint64_t n_items, const void *constants, uint32_t bytes);

/* Prints "port: " and the line, and ends the program. */
_Noreturn void gpu_fail(const char *format, ...);

/* The whole file. The caller frees it. */
void *gpu_read(const char *path, size_t *bytes);
#endif
