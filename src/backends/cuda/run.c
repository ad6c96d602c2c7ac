/* Kernels on a device, in the order of their launches: the arguments' pointers become addresses. */
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "backends/cuda/cu.h"

ts_status ts_cu_failed(const ts_cu *cu, const char *what, CUresult result)
{
	const char *name = NULL, *text = NULL;
	if (cu->call->GetErrorName(result, &name) != CUDA_SUCCESS || name == NULL) name = "an error without a name";
	if (cu->call->GetErrorString(result, &text) != CUDA_SUCCESS || text == NULL) text = "nothing more is known";
	return ts_fail_as(TS_KIND_DEVICE, "backend cuda: %s: %s (%s)", what, text, name);
}

CUresult ts_cu_enter(const ts_cu *cu) { return cu->call->CtxSetCurrent(cu->context); }

static ts_status set_pointer(ts_cu *cu, ts_frame *frame, const ts_launch *launch, const ts_pointer *pointer, u8 *values)
{
	void *parts[TS_PARTS] = {NULL};
	u64 offset;
	CUdeviceptr address = 0;
	ts_buffer *buffer = ts_device_buffer(frame, launch, pointer, values, &offset);
	ts_access access = ts_device_access(launch, pointer);
	if (buffer != NULL && ts_store_use(&cu->store, parts, buffer, 0, access) != TS_OK) return TS_ERROR;
	if (parts[0] != NULL) address = *(CUdeviceptr *)parts[0] + offset;
	memcpy(values + pointer->offset, &address, sizeof address);
	return TS_OK;
}

static ts_status set_pointers(ts_cu *cu, ts_frame *frame, const ts_launch *launch, u8 *values)
{
	const ts_pointers *pointers = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < pointers->n; i++) {
		if (set_pointer(cu, frame, launch, &pointers->pointer[i], values) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Runs items [0, n), as many at once as there may be groups. */
static ts_status dispatch(ts_cu *cu, ts_kernel kernel, u8 *values, u64 n)
{
	u64 most = (u64)cu->most.groups * cu->work_group;
	CUresult result = ts_cu_enter(cu);
	for (u64 first = 0; first < n && result == CUDA_SUCCESS; first += most) {
		void *parameters[] = {values, &first, &n};
		u64 items = n - first < most ? n - first : most;
		u32 groups = (u32)((items + cu->work_group - 1) / cu->work_group);
		result = cu->call->LaunchKernel(cu->functions[kernel], groups, 1, 1, cu->work_group, 1, 1, 0, NULL, parameters,
		                                NULL);
	}
	cu->store.busy = true;
	return result == CUDA_SUCCESS ? TS_OK : ts_cu_failed(cu, ts_kernel_name(kernel), result);
}

static ts_status enqueue(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	ts_cu *cu = (ts_cu *)backend;
	u8 values[TS_ARGUMENTS];
	size_t bytes = ts_kernel_args(launch->kernel)->bytes;
	assert(bytes <= sizeof values);
	memcpy(values, args, bytes);
	if (ts_cu_make_kernel(cu, launch->kernel) != TS_OK) return TS_ERROR;
	if (set_pointers(cu, frame, launch, values) != TS_OK) return TS_ERROR;
	return dispatch(cu, launch->kernel, values, n);
}

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	return ts_device_launch(backend, frame, launch, args, n, enqueue);
}

static ts_status fill(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	ts_cu *cu = (ts_cu *)backend;
	ts_buffer *buffer = &frame->buffer[id];
	void *parts[TS_PARTS];
	frame->residence = &ts_store_residence;
	if (ts_store_use(&cu->store, parts, buffer, 0, TS_OVERWRITES) != TS_OK) return TS_ERROR;
	if (parts[0] == NULL) return TS_OK;
	CUresult result = ts_cu_enter(cu);
	if (result == CUDA_SUCCESS) result = cu->call->MemsetD8(*(CUdeviceptr *)parts[0], byte, buffer->bytes);
	return result == CUDA_SUCCESS ? TS_OK : ts_cu_failed(cu, "a fill", result);
}

static ts_status finish(ts_backend *backend) { return ts_store_finish(&((ts_cu *)backend)->store); }

static void end(ts_backend *backend)
{
	ts_cu *cu = (ts_cu *)backend;
	if (cu->context != NULL && ts_cu_enter(cu) == CUDA_SUCCESS) ts_cu_forget_kernels(cu);
	if (cu->context != NULL) cu->call->DevicePrimaryCtxRelease(cu->device);
	ts_modules_free(&cu->modules);
	free(cu);
}

static ts_status begin(ts_cu *cu, const ts_backend_options *options)
{
	enum { GROUP = 64 };
	ts_status found = ts_cu_find(cu, options->device);
	if (found != TS_OK) return found;
	if (ts_cu_open_device(cu) != TS_OK) return TS_ERROR;
	cu->work_group = options->work_group != 0 ? options->work_group : GROUP;
	if (cu->work_group > cu->most.items) {
		return ts_fail("work group of %u: %s runs at most %u items at once", cu->work_group, cu->about.name,
		               cu->most.items);
	}
	ts_cu_open_modules(cu, options->build);
	ts_cu_open_store(cu);
	return ts_cu_make_kernel(cu, TS_KERNEL_vectors); /* the first to run: a refusal by the driver shows here */
}

static ts_status open_device(ts_backend **backend, const ts_backend_options *options)
{
	ts_cu *cu = ts_alloc_zero(1, sizeof *cu, "CUDA backend");
	*backend = NULL;
	if (cu == NULL) return TS_ERROR;
	ts_status status = begin(cu, options);
	if (status != TS_OK) {
		end(&cu->backend);
		return status;
	}
	snprintf(cu->device_line, sizeof cu->device_line, "%s, %s", cu->about.name, cu->about.platform);
	snprintf(cu->flags, sizeof cu->flags, "group=%u", cu->work_group);
	cu->backend = (ts_backend){.name = "cuda",
	                           .device = cu->device_line,
	                           .compiler = cu->about.driver,
	                           .flags = cu->flags,
	                           .launch = launch,
	                           .fill = fill,
	                           .scan = ts_device_scan,
	                           .finish = finish,
	                           .close = end};
	*backend = &cu->backend;
	return TS_OK;
}

const ts_backend_kind ts_cuda_kind = {"cuda", ts_cu_devices, open_device};
