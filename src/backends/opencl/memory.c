/* Buffers on the device. Where the device has the host's memory, its buffers are the frame's own, mapped while the host
 * reads them; elsewhere they are copies. */
#include <stdlib.h>
#include <string.h>
#include "cl.h"

typedef enum { HOST, BOTH, DEVICE } place;

typedef struct {
	ts_cl *cl;
	cl_mem part[TS_CL_PARTS];
	u32 n_parts;
	u64 part_bytes; /* of each but the last */
	u8 *data;
	u64 bytes;
	place place; /* of the newest contents */
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

static u8 *part_data(const resident *r, u32 part) { return r->data + part * r->part_bytes; }

static size_t bytes_of_part(const resident *r, u32 part)
{
	u64 left = r->bytes - part * r->part_bytes;
	return left < r->part_bytes ? left : r->part_bytes;
}

static cl_int make_parts(resident *r)
{
	cl_mem_flags flags = CL_MEM_READ_WRITE | (r->cl->unified ? CL_MEM_USE_HOST_PTR : 0);
	cl_int status = CL_SUCCESS;
	for (u32 i = 0; i < r->n_parts && status == CL_SUCCESS; i++) {
		void *data = r->cl->unified ? part_data(r, i) : NULL;
		r->part[i] = clCreateBuffer(r->cl->context, flags, bytes_of_part(r, i), data, &status);
	}
	return status;
}

static void release_parts(resident *r)
{
	for (u32 i = 0; i < r->n_parts; i++) {
		if (r->part[i] != NULL) clReleaseMemObject(r->part[i]);
	}
	free(r);
}

static ts_status make(ts_cl *cl, ts_buffer *buffer, u64 part_bytes)
{
	u64 n_parts = (buffer->bytes + part_bytes - 1) / part_bytes;
	if (part_bytes > cl->about.most || n_parts > TS_CL_PARTS) {
		return ts_fail("a buffer of %.1f GB; %s allocates %.1f GB at once", (double)buffer->bytes / 1e9, cl->about.name,
		               (double)cl->about.most / 1e9);
	}
	resident *r = ts_alloc_zero(1, sizeof *r, "device buffer");
	if (r == NULL) return TS_ERROR;
	*r = (resident){.cl = cl,
	                .n_parts = (u32)n_parts,
	                .part_bytes = part_bytes,
	                .data = buffer->data,
	                .bytes = buffer->bytes,
	                .place = cl->unified ? BOTH : HOST};
	cl_int status = make_parts(r);
	if (status != CL_SUCCESS) {
		release_parts(r);
		return ts_cl_failed("device memory", status);
	}
	buffer->resident = r;
	return TS_OK;
}

static cl_int unmap(resident *r)
{
	cl_int status = CL_SUCCESS;
	r->cl->busy |= r->mapped;
	for (u32 i = 0; r->mapped && i < r->n_parts && status == CL_SUCCESS; i++) {
		status = clEnqueueUnmapMemObject(r->cl->queue, r->part[i], part_data(r, i), 0, NULL, NULL);
	}
	r->mapped = false;
	return status;
}

static cl_int upload(resident *r)
{
	cl_int status = CL_SUCCESS;
	for (u32 i = 0; i < r->n_parts && status == CL_SUCCESS; i++) {
		status = clEnqueueWriteBuffer(r->cl->queue, r->part[i], CL_FALSE, 0, bytes_of_part(r, i), part_data(r, i), 0,
		                              NULL, NULL);
	}
	r->place = BOTH;
	return status;
}

static cl_int download_part(const resident *r, u32 part)
{
	cl_command_queue queue = r->cl->queue;
	size_t bytes = bytes_of_part(r, part);
	cl_int status;
	if (!r->cl->unified) {
		return clEnqueueReadBuffer(queue, r->part[part], CL_TRUE, 0, bytes, part_data(r, part), 0, NULL, NULL);
	}
	clEnqueueMapBuffer(queue, r->part[part], CL_TRUE, CL_MAP_READ, 0, bytes, 0, NULL, NULL, &status);
	return status;
}

static ts_status fetch(void *buffer)
{
	resident *r = buffer;
	ts_cl *cl = r->cl;
	if (r->place != DEVICE) return TS_OK;
	cl_int status = CL_SUCCESS;
	for (u32 i = 0; i < r->n_parts && status == CL_SUCCESS; i++) status = download_part(r, i);
	r->mapped = cl->unified && status == CL_SUCCESS;
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
	cl_int unmapped = unmap(r), finished = cl->busy ? clFinish(cl->queue) : CL_SUCCESS;
	cl->busy = false;
	if (unmapped != CL_SUCCESS || finished != CL_SUCCESS)
		ts_cl_keep(cl, "kernels", finished != 0 ? finished : unmapped);
	release_parts(r);
}

/* A buffer made before there were parts, or the other way round, is made again. */
static ts_status require(ts_cl *cl, ts_buffer *buffer, u64 part_bytes)
{
	resident *r = buffer->resident;
	if (r != NULL && r->part_bytes == part_bytes) return TS_OK;
	if (r != NULL) {
		if (fetch(r) != TS_OK) return TS_ERROR;
		release(r);
		buffer->resident = NULL;
	}
	return make(cl, buffer, part_bytes);
}

ts_status ts_cl_use(ts_cl *cl, cl_mem parts[TS_CL_PARTS], ts_buffer *buffer, u64 part_bytes, ts_cl_access access)
{
	memset(parts, 0, TS_CL_PARTS * sizeof *parts);
	if (buffer->bytes == 0) return TS_OK;
	if (require(cl, buffer, part_bytes != 0 ? part_bytes : buffer->bytes) != TS_OK) return TS_ERROR;
	resident *r = buffer->resident;
	cl_int status = r->place == HOST && access != TS_CL_OVERWRITES ? upload(r) : CL_SUCCESS;
	if (status == CL_SUCCESS && access != TS_CL_READS) status = unmap(r);
	if (access != TS_CL_READS) r->place = DEVICE;
	cl->busy = true;
	memcpy(parts, r->part, sizeof r->part);
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed("a transfer to the device", status);
}

const ts_residence ts_cl_residence = {fetch, release};
