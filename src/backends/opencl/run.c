/* Kernels on a device: an in-order queue; the arguments' pointers become buffers and offsets. */
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../kernels.h"
#include "cl.h"

_Static_assert(sizeof(void *) == 8, "offsets take the place of pointers");

enum { SCAN_CHUNK = 2048 };

static void explain(char text[TS_CL_MESSAGE], const char *what, cl_int status)
{
	static const struct {
		cl_int status;
		const char *name;
	} names[] = {
		{CL_DEVICE_NOT_AVAILABLE, "device not available"},
		{CL_MEM_OBJECT_ALLOCATION_FAILURE, "no memory on the device"},
		{CL_OUT_OF_RESOURCES, "the device is out of resources, or was lost"},
		{CL_OUT_OF_HOST_MEMORY, "no memory on the host"},
		{CL_BUILD_PROGRAM_FAILURE, "the driver's compiler failed"},
		{CL_INVALID_BUILD_OPTIONS, "the driver's compiler does not know the options"},
		{CL_INVALID_WORK_GROUP_SIZE, "the device does not run work groups of this size; see --work-group"},
		{CL_INVALID_BUFFER_SIZE, "larger than the device allocates"},
	};
	const char *name = NULL;
	for (size_t i = 0; i < sizeof names / sizeof *names; i++) name = names[i].status == status ? names[i].name : name;
	if (name == NULL)
		snprintf(text, TS_CL_MESSAGE, "backend opencl: %s: OpenCL error %d", what, status);
	else
		snprintf(text, TS_CL_MESSAGE, "backend opencl: %s: %s (%d)", what, name, status);
}

ts_status ts_cl_failed(const char *what, cl_int status)
{
	char text[TS_CL_MESSAGE];
	explain(text, what, status);
	return ts_fail("%s", text);
}

void ts_cl_keep(ts_cl *cl, const char *what, cl_int status)
{
	if (cl->failure[0] == 0) explain(cl->failure, what, status);
}

static ts_status set(cl_kernel kernel, u32 index, size_t bytes, const void *value)
{
	cl_int status = clSetKernelArg(kernel, index, bytes, value);
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a kernel's argument", status);
}

/* The frame's buffer that a pointer points to, or into; NULL: none. */
static ts_buffer *buffer_of(ts_frame *frame, const ts_launch *launch, const ts_pointer *pointer, const void *args)
{
	const u8 *at;
	memcpy(&at, (const u8 *)args + pointer->offset, sizeof at);
	if (at == NULL) return NULL;
	const ts_bound bound = ts_launch_bound(launch, pointer);
	if (!bound.bound) return NULL;
	ts_buffer *buffer = bound.role == TS_ROLE_WORK    ? &frame->lent[bound.to]
	                    : bound.role == TS_ROLE_TALLY ? &frame->lent[TS_WORK_tallies]
	                                                  : &frame->buffer[bound.to];
	const u8 *begin = buffer->data;
	assert(at >= begin && (at < begin + buffer->bytes || at == begin));
	return buffer;
}

/* A launch that reads a buffer leaves what the host has of it as it is. */
static ts_cl_access access_of(const ts_launch *launch, const ts_pointer *pointer)
{
	bool reads = pointer->row->constant || ts_launch_bound(launch, pointer).role == TS_ROLE_IN;
	return reads ? TS_CL_READS : TS_CL_WRITES;
}

/* The arguments of one pointer, from *index on; the offset takes its place among the values. */
static ts_status set_buffer(ts_cl *cl, ts_frame *frame, const ts_launch *launch, const ts_pointer *pointer, u8 *values,
                            u32 *index)
{
	u64 offset = 0, part_bytes = pointer->row->parted ? cl->part_bytes : 0;
	cl_mem parts[TS_CL_PARTS] = {NULL};
	ts_buffer *buffer = buffer_of(frame, launch, pointer, values);
	if (buffer != NULL) {
		const u8 *at;
		memcpy(&at, values + pointer->offset, sizeof at);
		offset = (u64)(at - (const u8 *)buffer->data);
		if (ts_cl_use(cl, parts, buffer, part_bytes, access_of(launch, pointer)) != TS_OK) return TS_ERROR;
	}
	memcpy(values + pointer->offset, &offset, sizeof offset);
	for (u32 i = 0; i < (part_bytes != 0 ? TS_CL_PARTS : 1); i++) {
		if (set(cl->kernels[launch->kernel], (*index)++, sizeof parts[i], &parts[i]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Arguments 0 and 1 are the values and n; then come the buffers. */
static ts_status set_arguments(ts_cl *cl, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	const ts_pointers *pointers = ts_kernel_pointers(launch->kernel);
	size_t bytes = ts_kernel_args(launch->kernel)->bytes;
	cl_kernel kernel = cl->kernels[launch->kernel];
	u8 values[TS_CL_ARGUMENTS];
	u32 index = 2;
	assert(bytes <= sizeof values);
	memcpy(values, args, bytes);
	for (u32 i = 0; i < pointers->n; i++) {
		if (set_buffer(cl, frame, launch, &pointers->pointer[i], values, &index) != TS_OK) return TS_ERROR;
	}
	if (set(kernel, 0, bytes, values) != TS_OK) return TS_ERROR;
	return set(kernel, 1, sizeof n, &n);
}

static u64 largest_power(u64 most)
{
	u64 power = 1;
	while (power <= most / 2) power *= 2;
	return power;
}

/* From the first buffer on that the device cannot allocate at once, kernels get such arrays in parts. */
static ts_status admit(ts_cl *cl, const ts_buffer *buffer)
{
	if (buffer->bytes <= cl->about.most || cl->part_bytes != 0) return TS_OK;
	cl->part_bytes = largest_power(cl->about.most);
	ts_cl_forget_programs(cl);
	return ts_cl_put_flags(cl);
}

static ts_status admit_all(ts_cl *cl, ts_frame *frame, const ts_launch *launch, const void *args)
{
	const ts_pointers *pointers = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < pointers->n; i++) {
		const ts_pointer *pointer = &pointers->pointer[i];
		ts_buffer *buffer = pointer->row->parted ? buffer_of(frame, launch, pointer, args) : NULL;
		if (buffer != NULL && admit(cl, buffer) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* The same for points that lie by pieces, with one set-up a piece. */
static bool by_pieces(ts_kernel kernel, const void *args)
{
	const ts_splat_args *splat = args;
	return kernel == TS_KERNEL_splat && splat->from.offset != NULL && splat->mark == 0;
}

static ts_status enqueue(ts_cl *cl, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	if (admit_all(cl, frame, launch, args) != TS_OK) return TS_ERROR;
	if (ts_cl_make_kernel(cl, launch->kernel) != TS_OK) return TS_ERROR;
	if (set_arguments(cl, frame, launch, args, n) != TS_OK) return TS_ERROR;
	size_t group = cl->work_group;
	size_t items = group != 0 ? (n + group - 1) / group * group : n;
	const size_t *local = group != 0 ? &group : NULL;
	cl_kernel kernel = cl->kernels[launch->kernel];
	cl_int status = clEnqueueNDRangeKernel(cl->queue, kernel, 1, NULL, &items, local, 0, NULL, NULL);
	cl->busy = true;
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed(ts_kernel_name(launch->kernel), status);
}

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	frame->residence = &ts_cl_residence;
	ts_launch taken = *launch;
	if (by_pieces(launch->kernel, args)) {
		taken.kernel = TS_KERNEL_splat_pieces;
		n = ((const ts_splat_args *)args)->n_pieces;
	}
	return n != 0 ? enqueue((ts_cl *)backend, frame, &taken, args, n) : TS_OK;
}

static ts_status fill(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	ts_cl *cl = (ts_cl *)backend;
	ts_buffer *buffer = &frame->buffer[id];
	cl_mem parts[TS_CL_PARTS];
	frame->residence = &ts_cl_residence;
	if (ts_may_be_parted(id) && admit(cl, buffer) != TS_OK) return TS_ERROR;
	u64 part_bytes = ts_may_be_parted(id) ? cl->part_bytes : 0;
	if (ts_cl_use(cl, parts, buffer, part_bytes, TS_CL_OVERWRITES) != TS_OK) return TS_ERROR;
	cl_int status = CL_SUCCESS;
	for (u32 i = 0; i < TS_CL_PARTS && parts[i] != NULL && status == CL_SUCCESS; i++) {
		u64 left = buffer->bytes - i * part_bytes, bytes = part_bytes != 0 && part_bytes < left ? part_bytes : left;
		u64 pattern = byte * 0x0101010101010101u;
		size_t width = bytes % 8 == 0 ? 8 : bytes % 4 == 0 ? 4 : 1;
		status = clEnqueueFillBuffer(cl->queue, parts[i], &pattern, width, 0, bytes, 0, NULL, NULL);
	}
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a fill", status);
}

static ts_status scan_in(ts_backend *backend, ts_frame *frame, ts_buffer_id id, ts_scan_args *args)
{
	ts_launch step = {TS_KERNEL_scan_sum, {{TS_BINDS_TO, "counts", TS_ROLE_OUT, id}}};
	ts_frame_lend(frame, TS_WORK_other, args->sums, (args->n_chunks + 1) * sizeof *args->sums);
	ts_status status = launch(backend, frame, &step, args, args->n_chunks);
	step.kernel = TS_KERNEL_scan_chunks;
	if (status == TS_OK) status = launch(backend, frame, &step, args, 1);
	step.kernel = TS_KERNEL_scan;
	if (status == TS_OK) status = launch(backend, frame, &step, args, args->n_chunks);
	ts_status recalled = ts_frame_recall(frame, TS_WORK_other);
	return status == TS_OK ? recalled : status;
}

static ts_status scan(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u64 *total)
{
	u64 n = ts_frame_n(frame, id) - 1;
	ts_scan_args args = {.counts = ts_frame_handle(frame, id),
	                     .n = n,
	                     .n_chunks = (n + SCAN_CHUNK - 1) / SCAN_CHUNK,
	                     .chunk = SCAN_CHUNK};
	args.sums = ts_alloc(args.n_chunks + 1, sizeof *args.sums, "prefix sums");
	if (args.sums == NULL) return TS_ERROR;
	ts_status status = scan_in(backend, frame, id, &args);
	if (status == TS_OK) *total = args.sums[args.n_chunks];
	free(args.sums);
	return status;
}

static ts_status finish(ts_backend *backend) { return ts_cl_finish((ts_cl *)backend); }

static void end(ts_backend *backend)
{
	ts_cl *cl = (ts_cl *)backend;
	ts_cl_forget_programs(cl);
	if (cl->queue != NULL) clReleaseCommandQueue(cl->queue);
	if (cl->context != NULL) clReleaseContext(cl->context);
	free(cl);
}

/* What the contract needs of a device. */
static ts_status suffices(const ts_device *about, bool inexact)
{
	if (!about->atomics) return ts_fail("backend opencl: %s has no 64-bit atomics", about->name);
	if (!about->little_endian) return ts_fail("backend opencl: %s is not little-endian", about->name);
	if (about->rounded || inexact) return TS_OK;
	return ts_fail("backend opencl: %s does not round quotients and roots correctly; --inexact runs it all the same",
	               about->name);
}

static ts_status begin(ts_cl *cl, const ts_backend_options *options)
{
	ts_status found = ts_cl_find(&cl->device, &cl->about, options->device);
	if (found != TS_OK) return found;
	if (suffices(&cl->about, options->inexact) != TS_OK) return TS_ERROR;
	cl_int status;
	cl->context = clCreateContext(NULL, 1, &cl->device, NULL, NULL, &status);
	if (status != CL_SUCCESS) return ts_cl_failed("a context", status);
	cl->queue = clCreateCommandQueue(cl->context, cl->device, 0, &status);
	if (status != CL_SUCCESS) return ts_cl_failed("a queue", status);
	cl->options = options->build;
	cl->part_bytes = options->part_bytes;
	if (ts_cl_put_flags(cl) != TS_OK) return TS_ERROR;
	return ts_cl_make_kernel(cl, TS_KERNEL_vectors); /* the first that runs: what the compiler refuses shows here */
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
	cl->backend = (ts_backend){
		"opencl", cl->device_line, cl->about.driver, cl->flags, {0}, launch, fill, scan, finish, end, NULL};
	cl->work_group = options->work_group;
	cl->unified = cl->about.unified && !options->copies;
	*backend = &cl->backend;
	return TS_OK;
}

const ts_backend_kind ts_opencl_kind = {"opencl", ts_cl_devices, open_device};
