/* Which devices there are, and what they can do. */
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include "backends/cuda/cu.h"
#include "backends/devices/driver.h"
#include "model/library.h"

static const char none[] = "no CUDA device; NVIDIA's driver brings libcuda.so.1";

static bool find_calls(void *library, ts_cu_calls *call)
{
#define NAME(name, in_library, parameters) #in_library,
	static const char *const names[] = {TS_CU_CALLS(NAME)};
#undef NAME
	return ts_library_find(call, names, sizeof names / sizeof *names, library);
}

/* The driver's calls, found once: the driver stays loaded as long as the process lives. */
static ts_cu_calls calls;
static const ts_cu driver = {.call = &calls};

static ts_status start(void)
{
	static bool begun;
	if (begun) return TS_OK;
	void *library;
	ts_status status = ts_driver_open(&library, "libcuda.so.1", RTLD_NOW | RTLD_LOCAL, "cuda", none);
	if (status != TS_OK) return status;
	if (!find_calls(library, &calls)) return ts_fail("backend cuda: NVIDIA's driver is older than CUDA 11.0");
	CUresult result = calls.Init(0);
	if (result == CUDA_ERROR_NO_DEVICE) return ts_driver_none("cuda", none);
	begun = result == CUDA_SUCCESS;
	return begun ? TS_OK : ts_cu_failed(&driver, "the driver", result);
}

static ts_status count(u32 *n)
{
	int all = 0;
	ts_status status = start();
	*n = 0;
	if (status != TS_OK) return status;
	CUresult result = calls.DeviceGetCount(&all);
	if (result != CUDA_SUCCESS) return ts_cu_failed(&driver, "the devices", result);
	*n = all < 0 ? 0 : all < TS_MAX_DEVICES ? (u32)all : TS_MAX_DEVICES;
	return *n > 0 ? TS_OK : ts_driver_none("cuda", none);
}

static u32 attribute(CUdevice device, int which)
{
	int value = 0;
	return calls.DeviceGetAttribute(&value, which, device) == CUDA_SUCCESS && value > 0 ? (u32)value : 0;
}

static ts_device describe(CUdevice device)
{
	enum { PTX_MAJOR = 7 };
	ts_device d = {.rounded = true, .denormals = true, .little_endian = true};
	size_t memory = 0;
	int version = 0;
	u32 major = attribute(device, CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR);
	u32 minor = attribute(device, CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR);
	calls.DeviceGetName(d.name, (int)sizeof d.name, device);
	calls.DeviceTotalMem(&memory, device);
	calls.DriverGetVersion(&version);
	snprintf(d.platform, sizeof d.platform, "compute capability %u.%u", major, minor);
	snprintf(d.driver, sizeof d.driver, "CUDA %d.%d", version / 1000, version % 1000 / 10);
	ts_line_clean(d.name);
	d.atomics = major >= PTX_MAJOR;
	d.memory = d.most = memory;
	return d;
}

ts_status ts_cu_devices(ts_device devices[TS_MAX_DEVICES], u32 *n)
{
	u32 all;
	ts_status status = count(&all);
	*n = 0;
	for (u32 i = 0; i < all; i++) {
		CUdevice device;
		if (calls.DeviceGet(&device, (int)i) == CUDA_SUCCESS) devices[(*n)++] = describe(device);
	}
	return status;
}

ts_status ts_cu_find(ts_cu *cu, u32 index)
{
	u32 n;
	ts_status status = count(&n);
	if (status != TS_OK) return status;
	cu->call = &calls;
	if (index >= n) return ts_fail("device %u: there are %u devices, from 0", index, n);
	CUresult result = calls.DeviceGet(&cu->device, (int)index);
	if (result != CUDA_SUCCESS) return ts_cu_failed(cu, "the device", result);
	cu->about = describe(cu->device);
	cu->most = (ts_cu_limits){.groups = attribute(cu->device, CU_DEVICE_ATTRIBUTE_MAX_GRID_DIM_X),
	                          .items = attribute(cu->device, CU_DEVICE_ATTRIBUTE_MAX_THREADS_PER_BLOCK)};
	return TS_OK;
}

ts_status ts_cu_open_device(ts_cu *cu)
{
	if (!cu->about.atomics) {
		return ts_fail("backend cuda: %s has %s; the kernels need 7.0, that of Volta", cu->about.name,
		               cu->about.platform);
	}
	CUresult result = cu->call->DevicePrimaryCtxRetain(&cu->context, cu->device);
	if (result == CUDA_SUCCESS) result = ts_cu_enter(cu);
	return result == CUDA_SUCCESS ? TS_OK : ts_cu_failed(cu, "a context", result);
}
