/* Writes a trace in memory, or part of one, as files: .npy and a trace.json that names them. */
#ifndef TS_TRACE_SAVE_H
#define TS_TRACE_SAVE_H
#include "trace/read.h"
#include "trace/write.h"

/* Writes all buffers to the files that `place` gives, then trace.json. producer: the name of the trace's producer;
 * NULL: this program. On failure the message names the file that could not be written, and written files stay. */
ts_status ts_trace_save_files(const ts_trace *trace, const char *producer, ts_trace_place *place, void *user);

#endif
