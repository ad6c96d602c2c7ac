/* What tests on devices need: each kind of backend that has one here. */
#ifndef TS_TESTS_BACKENDS_DEVICE_H
#define TS_TESTS_BACKENDS_DEVICE_H
#include <dlfcn.h>
#include "backends/backend.h"
#include "tests/status.h"

static const ts_backend_kind *const device_kinds[] = {&ts_opencl_kind, &ts_vulkan_kind, &ts_cuda_kind};
enum { DEVICE_KINDS = sizeof device_kinds / sizeof *device_kinds };

/* Fails where there is none if TS_REQUIRE names the kind. */
static inline bool device_is_there(const ts_backend_kind *kind)
{
	ts_device devices[TS_MAX_DEVICES];
	u32 n;
	const char *require = getenv("TS_REQUIRE");
	if (kind->devices(devices, &n) == TS_OK) return true;
	if (require != NULL && strstr(require, kind->name) != NULL) fail_msg("no device for %s", kind->name);
	printf("no device for %s\n", kind->name);
	return false;
}

/* Calls a test for each kind that there is, and skips it where there is none. */
static inline void device_each(void (*test)(const ts_backend_kind *kind))
{
	u32 n = 0;
	for (u32 i = 0; i < DEVICE_KINDS; i++) {
		if (!device_is_there(device_kinds[i])) continue;
		test(device_kinds[i]);
		n++;
	}
	if (n == 0) skip();
}

static inline ts_backend *device_open(const ts_backend_kind *kind, ts_backend_options options)
{
	ts_backend *backend = NULL;
	if (options.build == NULL) options.build = "";
	if (kind->open(&backend, &options) != TS_OK) fail_msg("%s", ts_error_message());
	return backend;
}

/* Kernels once built are kept, whoever runs the test. Of CUDA a driver is there in any case: tests/backends/cuda. */
static inline void device_begin(void)
{
	static const char *const names[][2] = {{"POCL_CACHE_DIR", "pocl"}, {"MESA_SHADER_CACHE_DIR", "mesa-limited"}};
	const char *build = getenv("BUILD");
	char path[512];
	for (u32 i = 0; i < 2; i++) {
		snprintf(path, sizeof path, "%s/%s", build != NULL ? build : "build/release", names[i][1]);
		setenv(names[i][0], path, 0);
	}
	snprintf(path, sizeof path, "%s/cuda/libcuda.so.1", build != NULL ? build : "build/release");
	if (dlopen(path, RTLD_NOW | RTLD_LOCAL) == NULL) printf("%s\n", dlerror());
}

#endif
