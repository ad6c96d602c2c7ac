/* Elements of a file, in any order, through a few blocks of memory: how traces that are larger than memory are read. */
#ifndef TS_TRACE_READER_H
#define TS_TRACE_READER_H
#include "kernels/base/compat.h"
#include "model/core.h"

typedef struct ts_reader ts_reader;

/* Reads an open file, which the reader closes, and which is closed also on failure; its data, n elements, begin at
 * data_at. NULL with the message set on failure. */
ts_reader *ts_reader_open(int file, const char *path, u64 data_at, u64 n, size_t element_bytes);
/* As ts_reader_open, for n elements in memory, which must outlive the reader. */
ts_reader *ts_reader_memory(const void *data, u64 n, size_t element_bytes);
/* The elements from `first` to the end of a block; sets *n to their number, at least 1. Valid until the next call with
 * this reader. NULL with the message set if the file cannot be read, or the work is cancelled. `first` must be below
 * the number of elements. */
const void *ts_reader_at(ts_reader *reader, u64 first, u64 *n);
/* NULL is allowed. */
void ts_reader_close(ts_reader *reader);

#endif
