/* Buffers on a device. */
#include "backends/devices/resident.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum { HOST, BOTH, DEVICE } place;

typedef struct {
	ts_store *store;
	void *part[TS_PARTS];
	u32 n_parts;
	u64 part_bytes; /* of each but the last */
	u8 *data;
	u64 bytes;
	place place; /* where the newest contents are */
	bool mapped;
} resident;

static void keep(ts_store *store)
{
	if (store->failure[0] == 0) snprintf(store->failure, sizeof store->failure, "%s", ts_error_message());
}

static ts_status wait(ts_store *store)
{
	ts_status status = store->busy ? store->wait(store) : TS_OK;
	store->busy = false;
	return status;
}

ts_status ts_store_finish(ts_store *store)
{
	ts_status status = wait(store);
	if (status == TS_OK && store->failure[0] != 0) status = ts_fail_as(TS_KIND_DEVICE, "%s", store->failure);
	store->failure[0] = 0;
	return status;
}

static u8 *part_data(const resident *r, u32 part) { return r->data + part * r->part_bytes; }

static u64 bytes_of_part(const resident *r, u32 part)
{
	u64 left = r->bytes - part * r->part_bytes;
	return left < r->part_bytes ? left : r->part_bytes;
}

static ts_status make_parts(resident *r)
{
	for (u32 i = 0; i < r->n_parts; i++) {
		r->part[i] = r->store->make(r->store, part_data(r, i), bytes_of_part(r, i));
		if (r->part[i] == NULL) return TS_ERROR;
	}
	return TS_OK;
}

static void free_parts(resident *r)
{
	for (u32 i = 0; i < r->n_parts; i++) {
		if (r->part[i] != NULL) r->store->free(r->store, r->part[i]);
	}
	free(r);
}

static ts_status make(ts_store *store, ts_buffer *buffer, u64 part_bytes)
{
	const ts_device *about = store->about;
	u64 n_parts = (buffer->bytes + part_bytes - 1) / part_bytes;
	if (part_bytes > about->most || n_parts > TS_PARTS) {
		return ts_fail_as(TS_KIND_DEVICE, "a buffer of %.1f GB; %s allocates %.1f GB at once",
		                  (double)buffer->bytes / 1e9, about->name, (double)about->most / 1e9);
	}
	resident *r = ts_alloc_zero(1, sizeof *r, "device buffer");
	if (r == NULL) return TS_ERROR;
	*r = (resident){.store = store,
	                .n_parts = (u32)n_parts,
	                .part_bytes = part_bytes,
	                .data = buffer->data,
	                .bytes = buffer->bytes,
	                .place = store->unified ? BOTH : HOST};
	if (make_parts(r) != TS_OK) {
		free_parts(r);
		return TS_ERROR;
	}
	buffer->resident = r;
	return TS_OK;
}

static ts_status unmap(resident *r)
{
	ts_status status = TS_OK;
	r->store->busy |= r->mapped;
	for (u32 i = 0; r->mapped && i < r->n_parts && status == TS_OK; i++) {
		status = r->store->unmap(r->store, r->part[i], part_data(r, i));
	}
	r->mapped = false;
	return status;
}

static ts_status upload(resident *r)
{
	ts_status status = TS_OK;
	for (u32 i = 0; i < r->n_parts && status == TS_OK; i++) {
		status = r->store->upload(r->store, r->part[i], part_data(r, i), bytes_of_part(r, i));
	}
	r->place = BOTH;
	return status;
}

static ts_status fetch(void *buffer)
{
	resident *r = buffer;
	ts_status status = TS_OK;
	if (r->place != DEVICE) return TS_OK;
	for (u32 i = 0; i < r->n_parts && status == TS_OK; i++) {
		status = r->store->download(r->store, r->part[i], part_data(r, i), bytes_of_part(r, i));
	}
	r->mapped = r->store->unified && status == TS_OK;
	r->place = BOTH;
	if (status == TS_OK) return TS_OK;
	memset(r->data, 0, r->bytes);
	keep(r->store);
	return TS_ERROR;
}

/* Ensures that nothing uses the memory when the frame frees it. */
static void release(void *buffer)
{
	resident *r = buffer;
	if (unmap(r) != TS_OK) keep(r->store);
	if (wait(r->store) != TS_OK) keep(r->store);
	free_parts(r);
}

/* A buffer made with another size of parts is made again. */
static ts_status require(ts_store *store, ts_buffer *buffer, u64 part_bytes)
{
	resident *r = buffer->resident;
	if (r != NULL && r->part_bytes == part_bytes) return TS_OK;
	if (r != NULL) {
		if (fetch(r) != TS_OK) return TS_ERROR;
		release(r);
		buffer->resident = NULL;
	}
	return make(store, buffer, part_bytes);
}

ts_status ts_store_use(ts_store *store, void *parts[TS_PARTS], ts_buffer *buffer, u64 part_bytes, ts_access access)
{
	memset(parts, 0, TS_PARTS * sizeof *parts);
	if (buffer->bytes == 0) return TS_OK;
	if (require(store, buffer, part_bytes != 0 ? part_bytes : buffer->bytes) != TS_OK) return TS_ERROR;
	resident *r = buffer->resident;
	ts_status status = r->place == HOST && access != TS_OVERWRITES ? upload(r) : TS_OK;
	if (status == TS_OK && access != TS_READS) status = unmap(r);
	if (access != TS_READS) r->place = DEVICE;
	store->busy = true;
	memcpy(parts, r->part, sizeof r->part);
	return status;
}

const ts_residence ts_store_residence = {fetch, release};
