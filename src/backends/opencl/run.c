/* Kernels on a device: an in-order queue; the arguments' pointers become buffers and offsets. */
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "backends/opencl/cl.h"

ts_status ts_cl_failed(const char *what, cl_int status)
{
	static const struct {
		cl_int status;
		const char *name;
	} names[] = {
		{CL_DEVICE_NOT_AVAILABLE, "device not available"},
		{CL_MEM_OBJECT_ALLOCATION_FAILURE, "no memory on the device"},
		{CL_OUT_OF_RESOURCES, "the device is out of resources, or was lost"},
		{CL_OUT_OF_HOST_MEMORY, "no memory on the host"},
		{CL_BUILD_PROGRAM_FAILURE, "the driver's compiler failed, or its cache has no room (PoCL: POCL_CACHE_DIR)"},
		{CL_INVALID_BUILD_OPTIONS, "the driver's compiler does not know the options"},
		{CL_INVALID_WORK_GROUP_SIZE, "the device does not run work groups of this size"},
		{CL_INVALID_BUFFER_SIZE, "larger than the device allocates"},
	};
	const char *name = NULL;
	for (size_t i = 0; i < sizeof names / sizeof *names; i++) name = names[i].status == status ? names[i].name : name;
	return name == NULL ? ts_fail_as(TS_KIND_DEVICE, "backend opencl: %s: OpenCL error %d", what, status)
	                    : ts_fail_as(TS_KIND_DEVICE, "backend opencl: %s: %s (%d)", what, name, status);
}

static ts_status set(cl_kernel kernel, u32 index, size_t bytes, const void *value)
{
	cl_int status = ts_cl_call.SetKernelArg(kernel, index, bytes, value);
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a kernel's argument", status);
}

/* Sets the arguments of one pointer, from *index on; the offset takes its place among the values. */
static ts_status set_buffer(ts_cl *cl, ts_frame *frame, const ts_launch *launch, const ts_pointer *pointer, u8 *values,
                            u32 *index)
{
	u64 offset, part_bytes = pointer->row->parted ? cl->part_bytes : 0;
	void *parts[TS_PARTS] = {NULL};
	ts_buffer *buffer = ts_device_buffer(frame, launch, pointer, values, &offset);
	ts_access access = ts_device_access(launch, pointer);
	if (buffer != NULL && ts_store_use(&cl->store, parts, buffer, part_bytes, access) != TS_OK) return TS_ERROR;
	memcpy(values + pointer->offset, &offset, sizeof offset);
	for (u32 i = 0; i < (part_bytes != 0 ? TS_PARTS : 1); i++) {
		if (set(cl->kernels[launch->kernel], (*index)++, sizeof(cl_mem), &parts[i]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Arguments 0 and 1 are the values and n; then come the buffers. */
static ts_status set_arguments(ts_cl *cl, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	const ts_pointers *pointers = ts_kernel_pointers(launch->kernel);
	size_t bytes = ts_kernel_args(launch->kernel)->bytes;
	cl_kernel kernel = cl->kernels[launch->kernel];
	u8 values[TS_ARGUMENTS];
	u32 index = 2;
	assert(bytes <= sizeof values);
	memcpy(values, args, bytes);
	for (u32 i = 0; i < pointers->n; i++) {
		if (set_buffer(cl, frame, launch, &pointers->pointer[i], values, &index) != TS_OK) return TS_ERROR;
	}
	if (set(kernel, 0, bytes, values) != TS_OK) return TS_ERROR;
	return set(kernel, 1, sizeof n, &n);
}

/* Kernels that get arrays in parts are different programs. */
static ts_status admit(ts_cl *cl, u64 part_bytes)
{
	if (cl->part_bytes == part_bytes) return TS_OK;
	cl->part_bytes = part_bytes;
	ts_cl_forget_programs(cl);
	return ts_cl_put_flags(cl);
}

static ts_status enqueue(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	ts_cl *cl = (ts_cl *)backend;
	if (admit(cl, ts_device_parts(&cl->store, cl->part_bytes, frame, launch, args)) != TS_OK) return TS_ERROR;
	if (ts_cl_make_kernel(cl, launch->kernel) != TS_OK) return TS_ERROR;
	if (set_arguments(cl, frame, launch, args, n) != TS_OK) return TS_ERROR;
	size_t group = cl->work_group;
	size_t items = group != 0 ? (n + group - 1) / group * group : n;
	const size_t *local = group != 0 ? &group : NULL;
	cl_kernel kernel = cl->kernels[launch->kernel];
	cl_int status = ts_cl_call.EnqueueNDRangeKernel(cl->queue, kernel, 1, NULL, &items, local, 0, NULL, NULL);
	cl->store.busy = true;
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed(ts_kernel_name(launch->kernel), status);
}

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	return ts_device_launch(backend, frame, launch, args, n, enqueue);
}

static ts_status fill(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	ts_cl *cl = (ts_cl *)backend;
	ts_buffer *buffer = &frame->buffer[id];
	void *parts[TS_PARTS];
	frame->residence = &ts_store_residence;
	if (ts_may_be_parted(id) && admit(cl, ts_device_parts_of(&cl->store, cl->part_bytes, buffer)) != TS_OK)
		return TS_ERROR;
	u64 part_bytes = ts_may_be_parted(id) ? cl->part_bytes : 0;
	if (ts_store_use(&cl->store, parts, buffer, part_bytes, TS_OVERWRITES) != TS_OK) return TS_ERROR;
	cl_int status = CL_SUCCESS;
	for (u32 i = 0; i < TS_PARTS && parts[i] != NULL && status == CL_SUCCESS; i++) {
		u64 left = buffer->bytes - i * part_bytes, bytes = part_bytes != 0 && part_bytes < left ? part_bytes : left;
		u64 pattern = byte * 0x0101010101010101u;
		size_t width = bytes % 8 == 0 ? 8 : bytes % 4 == 0 ? 4 : 1;
		status = ts_cl_call.EnqueueFillBuffer(cl->queue, parts[i], &pattern, width, 0, bytes, 0, NULL, NULL);
	}
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a fill", status);
}

static ts_status finish(ts_backend *backend) { return ts_store_finish(&((ts_cl *)backend)->store); }

static void end(ts_backend *backend)
{
	ts_cl *cl = (ts_cl *)backend;
	ts_cl_forget_programs(cl);
	if (cl->queue != NULL) ts_cl_call.ReleaseCommandQueue(cl->queue);
	if (cl->context != NULL) ts_cl_call.ReleaseContext(cl->context);
	free(cl);
}

/* What the contract needs of a device. */
static ts_status suffices(const ts_device *about, bool inexact)
{
	if (!about->atomics) return ts_fail("backend opencl: %s has no 64-bit atomics", about->name);
	if (!about->little_endian) return ts_fail("backend opencl: %s is not little-endian", about->name);
	if (about->rounded || inexact) return TS_OK;
	return ts_fail("backend opencl: %s does not round quotients and roots correctly; inexact runs it all the same",
	               about->name);
}

static ts_status begin(ts_cl *cl, const ts_backend_options *options)
{
	ts_status found = ts_cl_find(&cl->device, &cl->about, options->device);
	if (found != TS_OK) return found;
	if (suffices(&cl->about, options->inexact) != TS_OK) return TS_ERROR;
	cl_int status;
	cl->context = ts_cl_call.CreateContext(NULL, 1, &cl->device, NULL, NULL, &status);
	if (status != CL_SUCCESS) return ts_cl_failed("a context", status);
	cl->queue = ts_cl_call.CreateCommandQueue(cl->context, cl->device, 0, &status);
	if (status != CL_SUCCESS) return ts_cl_failed("a queue", status);
	cl->options = options->build;
	cl->part_bytes = options->part_bytes;
	if (ts_cl_put_flags(cl) != TS_OK) return TS_ERROR;
	return ts_cl_make_kernel(cl, TS_KERNEL_vectors); /* the first to run: a refusal by the compiler shows here */
}

static ts_status open_device(ts_backend **backend, const ts_backend_options *options)
{
	ts_cl *cl = ts_alloc_zero(1, sizeof *cl, "OpenCL backend");
	*backend = NULL;
	if (cl == NULL) return TS_ERROR;
	ts_status status = begin(cl, options);
	if (status != TS_OK) {
		end(&cl->backend);
		return status;
	}
	snprintf(cl->device_line, sizeof cl->device_line, "%s, %s", cl->about.name, cl->about.platform);
	cl->backend = (ts_backend){.name = "opencl",
	                           .device = cl->device_line,
	                           .compiler = cl->about.driver,
	                           .flags = cl->flags,
	                           .launch = launch,
	                           .fill = fill,
	                           .scan = ts_device_scan,
	                           .finish = finish,
	                           .close = end};
	cl->work_group = options->work_group;
	ts_cl_open_store(cl, cl->about.unified && !options->copies);
	*backend = &cl->backend;
	return TS_OK;
}

const ts_backend_kind ts_opencl_kind = {"opencl", ts_cl_devices, open_device};
