/* Buffers on the device. Where the device has the host's memory, its buffers are the frame's own, mapped while the host
 * reads them; elsewhere they are copies. */
#include <stdlib.h>
#include <string.h>
#include "cl.h"

typedef enum { HOST, BOTH, DEVICE } place;

typedef struct {
	ts_cl *cl;
	cl_mem memory;
	void *data;
	size_t bytes;
	place place;   /* of the newest contents */
	bool mapped;
} resident;

/* A driver takes what follows in order, so waiting is only needed where the host looks. */
ts_status ts_cl_finish(ts_cl *cl)
{
	cl_int status = cl->busy ? clFinish(cl->queue) : CL_SUCCESS;
	cl->busy = false;
	if (status != CL_SUCCESS) return ts_cl_failed("kernels", status);
	return cl->failure[0] == 0 ? TS_OK : ts_fail("%s", cl->failure);
}

static ts_status make(ts_cl *cl, ts_buffer *buffer)
{
	if (buffer->bytes > cl->about.most)
		return ts_fail("a buffer of %.1f GB; %s allocates %.1f GB at most", (double)buffer->bytes / 1e9, cl->about.name,
		               (double)cl->about.most / 1e9);
	resident *r = ts_alloc_zero(1, sizeof *r, "device buffer");
	if (r == NULL) return TS_ERROR;
	cl_mem_flags flags = CL_MEM_READ_WRITE | (cl->unified ? CL_MEM_USE_HOST_PTR : 0);
	cl_int status;
	*r = (resident){.cl = cl, .data = buffer->data, .bytes = buffer->bytes};
	r->memory = clCreateBuffer(cl->context, flags, buffer->bytes, cl->unified ? buffer->data : NULL, &status);
	if (status != CL_SUCCESS) {
		free(r);
		return ts_cl_failed("device memory", status);
	}
	if (cl->unified) r->place = BOTH;
	buffer->resident = r;
	return TS_OK;
}

static cl_int unmap(resident *r)
{
	if (!r->mapped) return CL_SUCCESS;
	r->mapped = false;
	return clEnqueueUnmapMemObject(r->cl->queue, r->memory, r->data, 0, NULL, NULL);
}

ts_status ts_cl_use(ts_cl *cl, cl_mem *memory, ts_buffer *buffer, bool writes)
{
	*memory = NULL;
	if (buffer->bytes == 0) return TS_OK;
	if (buffer->resident == NULL && make(cl, buffer) != TS_OK) return TS_ERROR;
	resident *r = buffer->resident;
	cl_int status = CL_SUCCESS;
	if (r->place == HOST) {
		status = clEnqueueWriteBuffer(cl->queue, r->memory, CL_FALSE, 0, r->bytes, r->data, 0, NULL, NULL);
		r->place = BOTH;
	}
	if (writes) {
		if (status == CL_SUCCESS) status = unmap(r);
		r->place = DEVICE;
	}
	cl->busy = true;
	*memory = r->memory;
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a transfer to the device", status);
}

static ts_status fetch(void *buffer)
{
	resident *r = buffer;
	ts_cl *cl = r->cl;
	if (r->place != DEVICE) return TS_OK;
	cl_int status;
	if (cl->unified) {
		clEnqueueMapBuffer(cl->queue, r->memory, CL_TRUE, CL_MAP_READ, 0, r->bytes, 0, NULL, NULL, &status);
		r->mapped = status == CL_SUCCESS;
	} else {
		status = clEnqueueReadBuffer(cl->queue, r->memory, CL_TRUE, 0, r->bytes, r->data, 0, NULL, NULL);
	}
	r->place = BOTH;
	if (status == CL_SUCCESS) return TS_OK;
	memset(r->data, 0, r->bytes);
	ts_cl_keep(cl, "a transfer from the device", status);
	return ts_fail("%s", cl->failure);
}

/* Nothing may use the memory any more when the frame frees it. */
static void release(void *buffer)
{
	resident *r = buffer;
	ts_cl *cl = r->cl;
	cl->busy |= r->mapped;
	cl_int unmapped = unmap(r), finished = cl->busy ? clFinish(cl->queue) : CL_SUCCESS;
	cl->busy = false;
	if (unmapped != CL_SUCCESS || finished != CL_SUCCESS) ts_cl_keep(cl, "kernels", finished != 0 ? finished : unmapped);
	clReleaseMemObject(r->memory);
	free(r);
}

const ts_residence ts_cl_residence = {fetch, release};
