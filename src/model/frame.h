/* A frame: the buffers of one run by name. Each stage reads some of them and adds others. */
#ifndef TS_MODEL_FRAME_H
#define TS_MODEL_FRAME_H
#include "model/table.h"

typedef struct {
	void *data;
	u64 n, bytes; /* elements, and the bytes of all of them */
	u32 n_dims;
	u64 shape[4];
	bool borrowed; /* belongs to the scene */
	bool made;
	void *resident; /* the buffer in the memory of a backend's device; NULL: it is not there */
} ts_buffer;

/* Calls by which a backend with a memory of its own serves the buffers that are resident there. */
typedef struct {
	ts_status (*fetch)(void *resident); /* makes `data` what the device has; kernels may still read it there */
	void (*release)(void *resident);
} ts_residence;

enum { TS_TALLIES = 6, TS_WORK_tallies = 0, TS_WORK_other, TS_WORK_queue, TS_WORK_counts, TS_WORK_kept, TS_N_WORK };

typedef struct {
	ts_buffer buffer[TS_N_BUFFERS];
	u64 bytes, peak_bytes;         /* owned by the frame */
	i64 tally[TS_TALLIES];         /* sums that the kernels of a stage add to */
	ts_buffer lent[TS_N_WORK];     /* memory without a name that kernels work on */
	const ts_residence *residence; /* NULL: all is in host memory */
} ts_frame;

/* Makes a buffer; its contents are undefined. NULL with the message set when there is no memory. A buffer made again
 * (the next batch) replaces the old one. */
void *ts_frame_make(ts_frame *frame, ts_buffer_id id, u32 n_dims, const u64 *shape);
void *ts_frame_make1(ts_frame *frame, ts_buffer_id id, u64 n);
void *ts_frame_make2(ts_frame *frame, ts_buffer_id id, u64 n0, u64 n1);
void *ts_frame_make3(ts_frame *frame, ts_buffer_id id, u64 n0, u64 n1, u64 n2);
/* As ts_frame_make, with zeros in host memory; pages that nobody writes take no memory. */
void *ts_frame_zeros(ts_frame *frame, ts_buffer_id id, u32 n_dims, const u64 *shape);
/* Makes a buffer of memory that outlives the frame. */
void ts_frame_borrow(ts_frame *frame, ts_buffer_id id, const void *data, u64 n);
void ts_frame_borrow_rows(ts_frame *frame, ts_buffer_id id, const void *data, u64 n_rows, u64 n);
/* The handle of a buffer for arguments of kernels; the buffer must exist. Its contents may be on a device. */
void *ts_frame_handle(const ts_frame *frame, ts_buffer_id id);
/* The contents of a buffer, which must exist, in host memory. If fetching fails, they are zeros, and the backend's next
 * `finish` fails. */
void *ts_frame_data(const ts_frame *frame, ts_buffer_id id);
/* Fetches the contents of all buffers to host memory. */
ts_status ts_frame_fetch(ts_frame *frame);
/* Lets kernels work on memory that stays the caller's. Once the memory is recalled, it holds the kernels' results. */
void ts_frame_lend(ts_frame *frame, u32 slot, void *data, u64 bytes);
ts_status ts_frame_recall(ts_frame *frame, u32 slot);
/* Sets the tallies to 0 and returns their handle for arguments of kernels; ts_frame_tally reads one tally. */
i64 *ts_frame_tallies(ts_frame *frame);
i64 ts_frame_tally(ts_frame *frame, u32 index);
u64 ts_frame_n(const ts_frame *frame, ts_buffer_id id);
/* Cuts a buffer of one dimension to its first n elements; its memory is kept. */
void ts_frame_cut(ts_frame *frame, ts_buffer_id id, u64 n);
void ts_frame_drop(ts_frame *frame, ts_buffer_id id);
void ts_frame_clear(ts_frame *frame);

#endif
