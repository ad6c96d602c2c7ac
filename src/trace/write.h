/* Writing a trace: a .npy file a buffer while the run goes on, then trace.json (reference/TRACES.md). Where files go is
 * the caller's: a folder that appears as a whole or not at all, with all traces of the run. */
#ifndef TS_TRACE_WRITE_H
#define TS_TRACE_WRITE_H
#include "../model/digest.h"
#include "emit.h"

/* The path for a new file of the trace, "05-split.piece.npy", or of the scene that traces share, "../scene/..."; it
 * stays valid. NULL with the message set. */
typedef const char *ts_trace_place(void *user, const char *name);

/* The files of the scene that the traces of one run share, by what they hold: a trace names the file that another wrote
 * if its own would have the same digest. All 0 before the first trace. */
typedef struct {
	char sha256[TS_N_BUFFERS][TS_DIGEST_BYTES]; /* "": there is no such file yet */
} ts_trace_shared;

typedef struct {
	ts_trace_place *place;
	void *user;
	bool margins;               /* also how near decisions were */
	bool without[TS_N_BUFFERS]; /* digests only: no file */
	u32 crop[4];                /* x, y, width, height of the part of H W buffers that is written; width 0: all */
	ts_trace_shared *shared;    /* NULL: the trace has all of its files itself */
	bool compress;
} ts_trace_options;

typedef struct ts_trace_writer ts_trace_writer;

/* Begins a trace of what `run`, begun but not run, will make by `pipeline`, and writes the scene. The message names the
 * file that could not be written. On failure *writer is NULL. The run must be traced. */
ts_status ts_trace_write_begin(ts_trace_writer **writer, const ts_pipeline *pipeline, const ts_run *run,
                               const ts_trace_options *options);
/* Writes what a stage has just made: call it from the run's hook. */
ts_status ts_trace_write_stage(ts_trace_writer *writer, const ts_run *run, const ts_stage *stage);
/* Writes trace.json; the trace is complete. */
ts_status ts_trace_write_end(ts_trace_writer *writer, const ts_run *run);
/* Releases the writer, complete or not; NULL is allowed. Files stay. */
void ts_trace_write_free(ts_trace_writer *writer);

/* Bytes that the files are expected to have in all, before running. */
u64 ts_trace_estimate(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params,
                      const ts_trace_options *options);

#endif
