/* Loads buffers of traces into memory, as the state of a run from which a stage can be replayed. */
#ifndef TS_TRACE_LOAD_H
#define TS_TRACE_LOAD_H
#include "trace/read.h"

typedef struct {
	ts_run run;     /* its frame owns the loaded buffers; its parameters are the reference's; ts_check sets its plan */
	ts_scene scene; /* the scene's arrays, which are the frame's; other members are not set */
	ts_sizes sizes; /* of records.def, of all batches, as far as they are known (ts_check) */
	const ts_pipeline *pipeline;
	const ts_trace *reference, *candidate;
	const ts_trace_item *item[TS_N_BUFFERS]; /* the file of each loaded buffer; NULL: not loaded */
} ts_load;

/* The file of a buffer: the candidate's where it has one, else the reference's; NULL if neither has. candidate may
 * be NULL. */
const ts_trace_item *ts_load_item(const ts_trace *reference, const ts_trace *candidate, ts_buffer_id id);

/* Fails unless the reference tells its parameters, and the candidate is of the same method and, if it tells parameters,
 * of the same ones. candidate may be NULL. */
ts_status ts_load_match(const ts_trace *reference, const ts_trace *candidate);

/* Loads the buffers `ids`, ended by TS_N_BUFFERS, and scene.info if there is one. The traces, of which `candidate` may
 * be NULL, must match and outlive the load. Fails, before anything is read, if files are missing (the message names
 * all), cropped, of more elements than an index can name, or together larger than a run may be. The content of the
 * files is not checked: ts_check must do so before any stage runs. On failure *load is NULL; else release it by
 * ts_load_end. */
ts_status ts_load_begin(ts_load **load, const ts_buffer_id *ids, const ts_trace *reference, const ts_trace *candidate,
                        u32 threads);
/* Releases the run and all; NULL is allowed. */
void ts_load_end(ts_load *load);

#endif
