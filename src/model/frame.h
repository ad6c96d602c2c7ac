/* A frame: the buffers of one run by name. A stage reads some and adds some. */
#ifndef TS_CORE_FRAME_H
#define TS_CORE_FRAME_H
#include "table.h"

typedef struct {
	void *data;
	u64 n, bytes; /* elements in all, and what they take */
	u32 n_dims;
	u64 shape[4];
	bool borrowed; /* belongs to the scene */
	bool made;
	void *resident; /* what a backend's device holds of it; NULL: nothing */
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
/* The same with zeros in host memory, of which those that nobody writes take none. */
void *ts_frame_zeros(ts_frame *frame, ts_buffer_id id, u32 n_dims, const u64 *shape);
/* Makes a buffer of memory that outlives the frame. */
void ts_frame_borrow(ts_frame *frame, ts_buffer_id id, const void *data, u64 n);
void ts_frame_borrow_rows(ts_frame *frame, ts_buffer_id id, const void *data, u64 n_rows, u64 n);
/* What arguments of kernels hold; the buffer must exist. Its contents may be elsewhere. */
void *ts_frame_handle(const ts_frame *frame, ts_buffer_id id);
/* The contents, fetched to host memory; the buffer must exist. If that fails they are zeros, and
 * the backend's next `finish` says so. */
void *ts_frame_data(const ts_frame *frame, ts_buffer_id id);
/* Fetches all that there is. */
ts_status ts_frame_fetch(ts_frame *frame);
/* Lets kernels work on memory that stays the caller's, until it is recalled: then it holds what they made of it. */
void ts_frame_lend(ts_frame *frame, u32 slot, void *data, u64 bytes);
ts_status ts_frame_recall(ts_frame *frame, u32 slot);
/* Sets the tallies to 0 and returns what arguments of kernels hold; ts_frame_tally reads one. */
i64 *ts_frame_tallies(ts_frame *frame);
i64 ts_frame_tally(ts_frame *frame, u32 index);
u64 ts_frame_n(const ts_frame *frame, ts_buffer_id id);
/* Keeps the first n elements of a buffer of one dimension, and all of its memory. */
void ts_frame_cut(ts_frame *frame, ts_buffer_id id, u64 n);
void ts_frame_drop(ts_frame *frame, ts_buffer_id id);
void ts_frame_clear(ts_frame *frame);

#endif
