/* Writing a trace: a .npy file for each buffer during the run, then trace.json (reference/TRACES.md). The caller
 * chooses the places of files: a folder with all traces of the run, which appears as a whole or not at all. */
#ifndef TS_TRACE_WRITE_H
#define TS_TRACE_WRITE_H
#include "model/digest.h"
#include "trace/emitted/emit.h"
#include "trace/read.h"

/* The path for a new file of the trace, "05-split.piece.npy", or of the scene that traces share, "../scene/..."; the
 * path stays valid. NULL with the message set on failure. */
typedef const char *ts_trace_place(void *user, const char *name);

/* The files of the scene that the traces of one run share: a trace names the file of an earlier trace if its own would
 * have the same digest. To be all 0 before the first trace. */
typedef struct {
	char sha256[TS_N_BUFFERS][TS_DIGEST_BYTES]; /* "": there is no such file yet */
} ts_trace_shared;

typedef struct {
	ts_trace_place *place;
	void *user;
	bool margins;               /* also how near decisions were */
	bool without[TS_N_BUFFERS]; /* digests only: no file */
	u32 crop[4];                /* x, y, width, height of the part of H W buffers that is written; width 0: all */
	ts_trace_shared *shared;    /* NULL: the trace has all its files in its own folder */
	bool compress;
} ts_trace_options;

typedef struct ts_trace_writer ts_trace_writer;

/* Begins a trace of `run`, which has begun but run no stage of `pipeline`, and writes the scene. On failure *writer is
 * NULL and the message names the file that could not be written. The run must be traced. */
ts_status ts_trace_write_begin(ts_trace_writer **writer, const ts_pipeline *pipeline, const ts_run *run,
                               const ts_trace_options *options);
/* Writes the buffers that a stage has just made; to be called from the run's hook. */
ts_status ts_trace_write_stage(ts_trace_writer *writer, const ts_run *run, const ts_stage *stage);
/* Writes trace.json; the trace is complete. */
ts_status ts_trace_write_end(ts_trace_writer *writer, const ts_run *run);
/* Releases the writer, complete or not; NULL is allowed. Files stay. */
void ts_trace_write_free(ts_trace_writer *writer);

/* The expected size of all files together in bytes, before running. */
u64 ts_trace_estimate(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *typed,
                      const ts_trace_options *options);

/* Writes a trace in memory, or part of one, as files: .npy and a trace.json that names them (save.c). Writes all
 * buffers to the files that `place` gives, then trace.json. producer: the name of the trace's producer;
 * NULL: this program. On failure the message names the file that could not be written, and written files stay. */
ts_status ts_trace_save_files(const ts_trace *trace, const char *producer, ts_trace_place *place, void *user);

#endif
