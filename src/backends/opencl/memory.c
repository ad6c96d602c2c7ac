/* Parts of buffers on the device. A device that shares the host's memory uses the frame's buffers, mapped while the
 * host reads them; others use copies. */
#include "backends/opencl/cl.h"

static ts_cl *of(ts_store *store) { return (ts_cl *)((u8 *)store - offsetof(ts_cl, store)); }

static void *make(ts_store *store, void *data, u64 bytes)
{
	cl_mem_flags flags = CL_MEM_READ_WRITE | (store->unified ? CL_MEM_USE_HOST_PTR : 0);
	cl_int status;
	cl_mem part = ts_cl_call.CreateBuffer(of(store)->context, flags, bytes, store->unified ? data : NULL, &status);
	if (status == CL_SUCCESS) return part;
	ts_cl_failed("device memory", status);
	return NULL;
}

static void release(ts_store *store, void *part)
{
	(void)store;
	ts_cl_call.ReleaseMemObject(part);
}

static ts_status to_device(cl_int status)
{
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a transfer to the device", status);
}

static ts_status upload(ts_store *store, void *part, const void *data, u64 bytes)
{
	return to_device(ts_cl_call.EnqueueWriteBuffer(of(store)->queue, part, CL_FALSE, 0, bytes, data, 0, NULL, NULL));
}

static ts_status unmap(ts_store *store, void *part, void *data)
{
	return to_device(ts_cl_call.EnqueueUnmapMemObject(of(store)->queue, part, data, 0, NULL, NULL));
}

static ts_status download(ts_store *store, void *part, void *data, u64 bytes)
{
	cl_command_queue queue = of(store)->queue;
	cl_int status;
	if (store->unified)
		ts_cl_call.EnqueueMapBuffer(queue, part, CL_TRUE, CL_MAP_READ, 0, bytes, 0, NULL, NULL, &status);
	else
		status = ts_cl_call.EnqueueReadBuffer(queue, part, CL_TRUE, 0, bytes, data, 0, NULL, NULL);
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a transfer from the device", status);
}

/* A driver keeps the order, so waiting is only needed where the host reads. */
static ts_status wait(ts_store *store)
{
	cl_int status = ts_cl_call.Finish(of(store)->queue);
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("kernels", status);
}

void ts_cl_open_store(ts_cl *cl, bool unified)
{
	cl->store = (ts_store){.about = &cl->about,
	                       .unified = unified,
	                       .make = make,
	                       .free = release,
	                       .upload = upload,
	                       .download = download,
	                       .unmap = unmap,
	                       .wait = wait};
}
