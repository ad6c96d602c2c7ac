/* What tests on OpenCL devices need. */
#ifndef TS_TESTS_BACKENDS_DEVICE_H
#define TS_TESTS_BACKENDS_DEVICE_H
#include "../model/test.h"
#include "../../src/backends/backend.h"

/* Skips the test where there is no device, or fails it if TS_REQUIRE names opencl. */
static inline void device_need(void)
{
	ts_device devices[TS_MAX_DEVICES];
	const char *require = getenv("TS_REQUIRE");
	if (ts_opencl_kind.devices(devices) != 0) return;
	if (require != NULL && strstr(require, "opencl") != NULL) fail_msg("no OpenCL device");
	printf("no OpenCL device\n");
	skip();
}

/* Kernels once built are kept, whoever runs the test. */
static inline void device_keep_kernels(void)
{
	char path[512];
	const char *build = getenv("BUILD");
	snprintf(path, sizeof path, "%s/pocl", build != NULL ? build : "build/release");
	setenv("POCL_CACHE_DIR", path, 0);
}

#endif
