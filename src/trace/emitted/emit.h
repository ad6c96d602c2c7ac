/* The buffers of a traced run as files: names, headers, and data in the order of the file. A run by batches makes some
 * buffers in parts, which become one file here. */
#ifndef TS_TRACE_EMITTED_EMIT_H
#define TS_TRACE_EMITTED_EMIT_H
#include "methods/pipeline.h"
#include "model/frame.h"
#include "output/npy.h"

enum { TS_NPY_DESCR = 2048 };

/* The dtype as numpy writes it: "'<u4'" or "[('centre', '<f4', (3,)), ('piece', '<u4'), ...]". */
void ts_npy_descr(char descr[TS_NPY_DESCR], ts_buffer_id id);

enum { TS_EMIT_NAME = 64 };

/* One part of a buffer's file. */
typedef struct {
	ts_buffer_id id;
	u32 n_dims;
	u64 shape[TS_MAX_DIMS]; /* of the whole file */
	bool first;             /* the first part, before which the file's header is written */
	const void *data;       /* in the byte order of files */
	u64 bytes;
} ts_chunk;

typedef ts_status ts_take_chunk(void *user, const ts_chunk *chunk);

/* Passes the scene's buffers, which the run began with, to `take`. */
ts_status ts_emit_scene(const ts_run *run, ts_take_chunk *take, void *user);
/* Passes the buffers that a stage has just written to `take`; for a hook of the run. */
ts_status ts_emit_stage(const ts_run *run, const ts_stage *stage, ts_take_chunk *take, void *user);

/* True of the buffers that the run began with. */
bool ts_emit_is_scene(ts_buffer_id id);
/* True of the buffers that a run by batches makes a part at a time. */
bool ts_emit_is_batched(ts_buffer_id id);

/* The stage that makes a buffer, or "scene". */
const char *ts_emit_maker(const ts_pipeline *pipeline, ts_buffer_id id);
/* The number of the step that makes a buffer, from 1; margins and unnumbered steps have the number of the step before.
 * 0: the scene. */
u32 ts_emit_number(const ts_pipeline *pipeline, ts_buffer_id id);
/* Writes all buffers: those that no step makes, in the order of records.def, then the others in the order in which
 * steps make them. */
void ts_emit_order(ts_buffer_id ids[TS_N_BUFFERS], const ts_pipeline *pipeline);
/* "04-eye.depth_triangle.npy". */
void ts_emit_name(char name[TS_EMIT_NAME], const ts_pipeline *pipeline, ts_buffer_id id);

#endif
