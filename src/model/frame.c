/* The buffers of one run. */
#include "model/frame.h"
#include <assert.h>
#include <stdlib.h>
#include "model/shape.h"

static ts_status fetch(const ts_frame *frame, const ts_buffer *buffer)
{
	return buffer->resident != NULL ? frame->residence->fetch(buffer->resident) : TS_OK;
}

static void release(const ts_frame *frame, ts_buffer *buffer)
{
	if (buffer->resident != NULL) frame->residence->release(buffer->resident);
	buffer->resident = NULL;
}

typedef void *allocator(size_t count, size_t size, const char *what);

static void *make(ts_frame *frame, ts_buffer_id id, u32 n_dims, const u64 *shape, allocator *allocate)
{
	assert(id < TS_N_BUFFERS && n_dims >= 1 && n_dims <= 4);
	ts_frame_drop(frame, id);
	const ts_buffer_info *info = &ts_buffer_table[id];
	u64 n;
	if (!ts_shape_count(&n, n_dims, shape) || n > SIZE_MAX) {
		ts_fail_as(TS_KIND_MEMORY, "%s: its shape has more elements than a process can address", info->name);
		return NULL;
	}
	if (n > (ts_memory_limit() - frame->bytes) / info->element_bytes) {
		ts_fail_as(
			TS_KIND_MEMORY,
			"%s: %.1f GB beside the %.1f GB of the other buffers; a run may use %.1f GB: choose a smaller image, fewer "
			"reflectors, or lower density.scale, depth_map.px, lamp.views_a_pass, cube.max_px or octree.levels",
			info->name, (double)n * (double)info->element_bytes / 1e9, (double)frame->bytes / 1e9,
			(double)ts_memory_limit() / 1e9);
		return NULL;
	}
	void *data = allocate((size_t)n, info->element_bytes, info->name);
	if (!data) return NULL;
	ts_buffer *buffer = &frame->buffer[id];
	*buffer = (ts_buffer){.data = data, .n = n, .bytes = n * info->element_bytes, .n_dims = n_dims, .made = true};
	memcpy(buffer->shape, shape, n_dims * sizeof *shape);
	frame->bytes += buffer->bytes;
	frame->peak_bytes = frame->bytes > frame->peak_bytes ? frame->bytes : frame->peak_bytes;
	return data;
}

void *ts_frame_make(ts_frame *frame, ts_buffer_id id, u32 n_dims, const u64 *shape)
{
	return make(frame, id, n_dims, shape, ts_alloc);
}

void *ts_frame_zeros(ts_frame *frame, ts_buffer_id id, u32 n_dims, const u64 *shape)
{
	return make(frame, id, n_dims, shape, ts_alloc_zero);
}

void *ts_frame_make1(ts_frame *frame, ts_buffer_id id, u64 n) { return ts_frame_make(frame, id, 1, &n); }

void *ts_frame_make2(ts_frame *frame, ts_buffer_id id, u64 n0, u64 n1)
{
	return ts_frame_make(frame, id, 2, (u64[]){n0, n1});
}

void *ts_frame_make3(ts_frame *frame, ts_buffer_id id, u64 n0, u64 n1, u64 n2)
{
	return ts_frame_make(frame, id, 3, (u64[]){n0, n1, n2});
}

void ts_frame_borrow(ts_frame *frame, ts_buffer_id id, const void *data, u64 n)
{
	assert(id < TS_N_BUFFERS);
	ts_frame_drop(frame, id);
	frame->buffer[id] = (ts_buffer){.data = (void *)(uintptr_t)data,
	                                .n = n,
	                                .bytes = n * ts_buffer_table[id].element_bytes,
	                                .n_dims = 1,
	                                .shape = {n},
	                                .borrowed = true,
	                                .made = true};
}

void ts_frame_borrow_rows(ts_frame *frame, ts_buffer_id id, const void *data, u64 n_rows, u64 n)
{
	ts_frame_borrow(frame, id, data, n_rows * n);
	frame->buffer[id].n_dims = 2;
	frame->buffer[id].shape[0] = n_rows;
	frame->buffer[id].shape[1] = n;
}

void *ts_frame_handle(const ts_frame *frame, ts_buffer_id id)
{
	assert(id < TS_N_BUFFERS && frame->buffer[id].made);
	return frame->buffer[id].data;
}

void *ts_frame_data(const ts_frame *frame, ts_buffer_id id)
{
	void *data = ts_frame_handle(frame, id);
	fetch(frame, &frame->buffer[id]);
	return data;
}

ts_status ts_frame_fetch(ts_frame *frame)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (fetch(frame, &frame->buffer[id]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

void ts_frame_lend(ts_frame *frame, u32 slot, void *data, u64 bytes)
{
	release(frame, &frame->lent[slot]);
	frame->lent[slot] = (ts_buffer){.data = data, .n = bytes, .bytes = bytes, .borrowed = true};
}

ts_status ts_frame_recall(ts_frame *frame, u32 slot)
{
	ts_status status = fetch(frame, &frame->lent[slot]);
	ts_frame_lend(frame, slot, NULL, 0);
	return status;
}

i64 *ts_frame_tallies(ts_frame *frame)
{
	ts_frame_lend(frame, TS_WORK_tallies, frame->tally, sizeof frame->tally);
	memset(frame->tally, 0, sizeof frame->tally);
	return frame->tally;
}

i64 ts_frame_tally(ts_frame *frame, u32 index)
{
	fetch(frame, &frame->lent[TS_WORK_tallies]);
	return frame->tally[index];
}

u64 ts_frame_n(const ts_frame *frame, ts_buffer_id id)
{
	assert(id < TS_N_BUFFERS && frame->buffer[id].made);
	return frame->buffer[id].n;
}

void ts_frame_cut(ts_frame *frame, ts_buffer_id id, u64 n)
{
	ts_buffer *buffer = &frame->buffer[id];
	assert(buffer->made && buffer->n_dims == 1 && n <= buffer->n);
	frame->bytes -= buffer->bytes - n * ts_buffer_table[id].element_bytes;
	buffer->n = buffer->shape[0] = n;
	buffer->bytes = n * ts_buffer_table[id].element_bytes;
}

void ts_frame_drop(ts_frame *frame, ts_buffer_id id)
{
	assert(id < TS_N_BUFFERS);
	ts_buffer *buffer = &frame->buffer[id];
	release(frame, buffer);
	if (buffer->made && !buffer->borrowed) {
		frame->bytes -= buffer->bytes;
		free(buffer->data);
	}
	*buffer = (ts_buffer){0};
}

void ts_frame_clear(ts_frame *frame)
{
	for (u32 slot = 0; slot < TS_N_WORK; slot++) ts_frame_lend(frame, slot, NULL, 0);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) ts_frame_drop(frame, (ts_buffer_id)id);
}
