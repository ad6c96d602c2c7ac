/* The kernels on OpenCL 1.2 devices with 64-bit atomics, shared by the files of this folder, the only one that names
 * OpenCL. The loader is opened at run time, and finds the drivers. */
#ifndef TS_BACKENDS_OPENCL_CL_H
#define TS_BACKENDS_OPENCL_CL_H
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include "backends/devices/device.h"

/* The functions that are called. */
/* clang-format off */
#define TS_CL_CALLS(CALL) \
	CALL(GetPlatformIDs) CALL(GetPlatformInfo) CALL(GetDeviceIDs) CALL(GetDeviceInfo) CALL(CreateContext) \
	CALL(ReleaseContext) CALL(CreateCommandQueue) CALL(ReleaseCommandQueue) CALL(CreateProgramWithSource) \
	CALL(BuildProgram) CALL(GetProgramBuildInfo) CALL(ReleaseProgram) CALL(CreateKernel) CALL(ReleaseKernel) \
	CALL(SetKernelArg) CALL(CreateBuffer) CALL(ReleaseMemObject) CALL(EnqueueReadBuffer) CALL(EnqueueWriteBuffer) \
	CALL(EnqueueFillBuffer) CALL(EnqueueMapBuffer) CALL(EnqueueUnmapMemObject) CALL(EnqueueNDRangeKernel) \
	CALL(Finish)
/* clang-format on */
#define TS_CL_CALL(name) __typeof__(&cl##name) name;
typedef struct {
	TS_CL_CALLS(TS_CL_CALL)
} ts_cl_calls;
#undef TS_CL_CALL

/* Valid where there are devices. */
extern ts_cl_calls ts_cl_call;

enum { TS_CL_PROGRAMS = 32 };

typedef struct {
	ts_backend backend;
	ts_device about;
	char device_line[288], flags[256];
	cl_device_id device;
	cl_context context;
	cl_command_queue queue;
	cl_program programs[TS_CL_PROGRAMS]; /* built as they are needed */
	cl_kernel kernels[TS_N_KERNELS];     /* likewise */
	size_t work_group;
	const char *options; /* of the user, for the compiler */
	u64 part_bytes;      /* of parted arrays; 0: none is in parts, and the kernels know of none */
	ts_store store;
} ts_cl;

/* A failed call as one line. */
ts_status ts_cl_failed(const char *what, cl_int status);

/* device.c: ts_opencl_kind's devices, and the one of an index. */
ts_status ts_cl_devices(ts_device devices[TS_MAX_DEVICES], u32 *n);
ts_status ts_cl_find(cl_device_id *device, ts_device *about, u32 index);
/* entry.c: the entry points of a program's kernels, which the caller frees; NULL without memory. */
char *ts_cl_entries(const ts_cl *cl, u32 program);
/* program.c: the program of each kernel; sets cl->flags, for cl->part_bytes; makes a kernel, unless it is there;
 * releases all kernels. */
extern const u32 ts_cl_program_of[TS_N_KERNELS];
ts_status ts_cl_put_flags(ts_cl *cl);
ts_status ts_cl_make_kernel(ts_cl *cl, ts_kernel kernel);
void ts_cl_forget_programs(ts_cl *cl);

/* memory.c */
void ts_cl_open_store(ts_cl *cl, bool unified);

#endif
