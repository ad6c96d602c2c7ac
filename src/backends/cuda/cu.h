/* The kernels on NVIDIA GPUs from Volta on, shared by the files of this folder, the only one that names CUDA. The
 * driver's library is opened at run time. Its interface is documented and binary-stable; the functions that are called
 * are declared here, so that no toolkit is needed. */
#ifndef TS_BACKENDS_CUDA_CU_H
#define TS_BACKENDS_CUDA_CU_H
#include "backends/devices/device.h"
#include "backends/devices/modules.h"

typedef int CUresult, CUdevice;
typedef u64 CUdeviceptr;
typedef void *CUcontext, *CUmodule, *CUfunction, *CUstream;
enum { CUDA_SUCCESS = 0, CUDA_ERROR_NO_DEVICE = 100 };
enum { CU_JIT_ERROR_LOG_BUFFER = 5, CU_JIT_ERROR_LOG_BUFFER_SIZE_BYTES = 6 };
enum {
	CU_DEVICE_ATTRIBUTE_MAX_THREADS_PER_BLOCK = 1,
	CU_DEVICE_ATTRIBUTE_MAX_GRID_DIM_X = 5,
	CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR = 75,
	CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR = 76,
};

/* The functions that are called: CALL(name, symbol of the library, parameters). */
/* clang-format off */
#define TS_CU_CALLS(CALL) \
	CALL(Init, cuInit, (unsigned flags)) \
	CALL(DriverGetVersion, cuDriverGetVersion, (int *version)) \
	CALL(GetErrorName, cuGetErrorName, (CUresult result, const char **name)) \
	CALL(GetErrorString, cuGetErrorString, (CUresult result, const char **text)) \
	CALL(DeviceGetCount, cuDeviceGetCount, (int *count)) \
	CALL(DeviceGet, cuDeviceGet, (CUdevice *device, int index)) \
	CALL(DeviceGetName, cuDeviceGetName, (char *name, int bytes, CUdevice device)) \
	CALL(DeviceTotalMem, cuDeviceTotalMem_v2, (size_t *bytes, CUdevice device)) \
	CALL(DeviceGetAttribute, cuDeviceGetAttribute, (int *value, int attribute, CUdevice device)) \
	CALL(DevicePrimaryCtxRetain, cuDevicePrimaryCtxRetain, (CUcontext *context, CUdevice device)) \
	CALL(DevicePrimaryCtxRelease, cuDevicePrimaryCtxRelease_v2, (CUdevice device)) \
	CALL(CtxSetCurrent, cuCtxSetCurrent, (CUcontext context)) \
	CALL(CtxSynchronize, cuCtxSynchronize, (void)) \
	CALL(ModuleLoadDataEx, cuModuleLoadDataEx, \
	     (CUmodule *module, const void *image, unsigned n, int *options, void **values)) \
	CALL(ModuleUnload, cuModuleUnload, (CUmodule module)) \
	CALL(ModuleGetFunction, cuModuleGetFunction, (CUfunction *function, CUmodule module, const char *name)) \
	CALL(MemAlloc, cuMemAlloc_v2, (CUdeviceptr *address, size_t bytes)) \
	CALL(MemFree, cuMemFree_v2, (CUdeviceptr address)) \
	CALL(MemcpyHtoD, cuMemcpyHtoD_v2, (CUdeviceptr to, const void *from, size_t bytes)) \
	CALL(MemcpyDtoH, cuMemcpyDtoH_v2, (void *to, CUdeviceptr from, size_t bytes)) \
	CALL(MemsetD8, cuMemsetD8_v2, (CUdeviceptr to, unsigned char byte, size_t bytes)) \
	CALL(LaunchKernel, cuLaunchKernel, \
	     (CUfunction function, unsigned grid_x, unsigned grid_y, unsigned grid_z, unsigned block_x, unsigned block_y, \
	      unsigned block_z, unsigned shared, CUstream stream, void **parameters, void **extra))
/* clang-format on */
#define TS_CU_CALL(name, symbol, parameters) CUresult(*name) parameters;
typedef struct {
	TS_CU_CALLS(TS_CU_CALL)
} ts_cu_calls;
#undef TS_CU_CALL

typedef struct {
	u32 groups, items; /* of a launch; of a group */
} ts_cu_limits;

typedef struct {
	ts_backend backend;
	ts_device about;
	char device_line[288], flags[64];
	const ts_cu_calls *call;
	CUdevice device;
	CUcontext context; /* the device's primary one */
	ts_cu_limits most;
	u32 work_group;
	ts_modules modules;
	CUmodule loaded[TS_N_KERNELS]; /* as they are needed */
	CUfunction functions[TS_N_KERNELS];
	ts_store store;
} ts_cu;

/* A failed call as one line. */
ts_status ts_cu_failed(const ts_cu *cu, const char *what, CUresult result);
/* Makes this device's context current for the calls that follow. */
CUresult ts_cu_enter(const ts_cu *cu);

/* device.c: ts_cuda_kind's devices; the one of an index, TS_SKIPPED without any; opened. */
ts_status ts_cu_devices(ts_device devices[TS_MAX_DEVICES], u32 *n);
ts_status ts_cu_find(ts_cu *cu, u32 index);
ts_status ts_cu_open_device(ts_cu *cu);

/* memory.c */
void ts_cu_open_store(ts_cu *cu);

/* program.c: where PTX comes from; makes a kernel, unless it is there; releases all of them. */
void ts_cu_open_modules(ts_cu *cu, const char *folder);
ts_status ts_cu_make_kernel(ts_cu *cu, ts_kernel kernel);
void ts_cu_forget_kernels(ts_cu *cu);

#endif
