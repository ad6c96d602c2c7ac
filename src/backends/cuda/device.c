/* Which devices there are, and what they can do. */
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include "backends/cuda/cu.h"
#include "model/library.h"

static ts_status no_device(void)
{
	ts_fail("backend cuda: no CUDA device; NVIDIA's driver brings libcuda.so.1");
	return TS_SKIPPED;
}

static bool find_calls(void *library, ts_cu_calls *call)
{
#define NAME(name, in_library, parameters) #in_library,
	static const char *const names[] = {TS_CU_CALLS(NAME)};
#undef NAME
	return ts_library_find(call, names, sizeof names / sizeof *names, library);
}

/* The driver's calls, found once: the driver stays loaded as long as the process lives. */
static ts_cu_calls calls;

static ts_status start(void)
{
	static bool begun;
	static ts_cu about = {.call = &calls};
	if (begun) return TS_OK;
	void *library = dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL);
	if (library == NULL) return no_device();
	if (!find_calls(library, &calls)) return ts_fail("backend cuda: NVIDIA's driver is older than CUDA 11.0");
	CUresult result = calls.Init(0);
	if (result == CUDA_ERROR_NO_DEVICE) return no_device();
	begun = result == CUDA_SUCCESS;
	return begun ? TS_OK : ts_cu_failed(&about, "the driver", result);
}

static CUresult count(u32 *n)
{
	int all = 0;
	CUresult result = calls.DeviceGetCount(&all);
	*n = result != CUDA_SUCCESS || all < 0 ? 0 : all < TS_MAX_DEVICES ? (u32)all : TS_MAX_DEVICES;
	return result;
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

u32 ts_cu_devices(ts_device devices[TS_MAX_DEVICES])
{
	u32 n = 0, found = 0;
	if (start() != TS_OK || count(&n) != CUDA_SUCCESS) return 0;
	for (u32 i = 0; i < n; i++) {
		CUdevice device;
		if (calls.DeviceGet(&device, (int)i) == CUDA_SUCCESS) devices[found++] = describe(device);
	}
	return found;
}

ts_status ts_cu_find(ts_cu *cu, u32 index)
{
	ts_status status = start();
	u32 n = 0;
	if (status != TS_OK) return status;
	cu->call = &calls;
	CUresult result = count(&n);
	if (result != CUDA_SUCCESS) return ts_cu_failed(cu, "the devices", result);
	if (n == 0) return no_device();
	if (index >= n) {
		return ts_fail("device %u: there are %u devices, from 0", index, n);
	}
	result = calls.DeviceGet(&cu->device, (int)index);
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
