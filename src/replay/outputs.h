/* What a replayed stage made, as a small trace: its .npy files and a trace.json that names them. */
#ifndef TS_TRACE_OUTPUTS_H
#define TS_TRACE_OUTPUTS_H
#include "replay.h"
#include "../trace/write.h"

/* Writes the outputs of the stage that ran in `load` to the files that `place` (user) gives, then trace.json. The
 * message names the file that could not be written. Files stay. */
ts_status ts_outputs_write(const ts_load *load, const ts_stage *stage, ts_trace_place *place, void *user);

#endif
