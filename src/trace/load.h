/* Buffers of traces in memory, as a run that has come as far as they say: what a stage is replayed from. */
#ifndef TS_TRACE_LOAD_H
#define TS_TRACE_LOAD_H
#include "read.h"

typedef struct {
	ts_run run;     /* its frame owns what was loaded; parameters are those of the reference; its plan ts_check makes */
	ts_scene scene; /* the arrays of the frame that are the scene's; nothing else in it is set */
	ts_sizes sizes; /* of records.def, of all batches, as far as they are known (ts_check) */
	const ts_pipeline *pipeline;
	const ts_trace *reference, *candidate;
	const ts_trace_item *item[TS_N_BUFFERS]; /* what was loaded, and from where; NULL: not loaded */
} ts_load;

/* The file of a buffer: the candidate's where it has one, else the reference's; NULL if neither has. candidate may
 * be NULL. */
const ts_trace_item *ts_load_item(const ts_trace *reference, const ts_trace *candidate, ts_buffer_id id);

/* The reference must tell its parameters, and the candidate, of the same method, the same if it tells any.
 * candidate may be NULL. */
ts_status ts_load_match(const ts_trace *reference, const ts_trace *candidate);

/* Loads the buffers `ids`, ended by TS_N_BUFFERS, and scene.info if there is one. The traces, of which `candidate`
 * may be NULL, must match and outlive the load. Fails, before anything is read, if files are missing (all are
 * named), cropped, of more elements than an index can name, or in all larger than a run may be. What the files
 * hold is not checked: ts_check does that, and nothing may run before. On failure *load is NULL; else release it
 * by ts_load_end. */
ts_status ts_load_begin(ts_load **load, const ts_buffer_id *ids, const ts_trace *reference, const ts_trace *candidate,
                        u32 threads);
/* Releases the run and all; NULL is allowed. */
void ts_load_end(ts_load *load);

#endif
