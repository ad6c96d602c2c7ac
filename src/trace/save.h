/* A trace that is in memory, or part of one, as files: .npy and a trace.json that names them. */
#ifndef TS_TRACE_SAVE_H
#define TS_TRACE_SAVE_H
#include "read.h"
#include "write.h"

/* Writes all buffers to the files that `place` (user) gives, then trace.json. producer: who made them; NULL: this
 * program. The message names the file that could not be written. Files stay. */
ts_status ts_trace_save_files(const ts_trace *trace, const char *producer, ts_trace_place *place, void *user);

#endif
