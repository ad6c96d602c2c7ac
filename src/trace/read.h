/* Opening a trace, ours or a port's. Everything in it is untrusted: names, counts, types and sizes are checked before
 * anything is read, and no file is opened but those of the folder and, where trace.json is of version 2, of the folder
 * "scene" beside it. */
#ifndef TS_TRACE_READ_H
#define TS_TRACE_READ_H
#include "../methods/pipeline.h"
#include <touchstone/trace.h>
#include "npy.h"
#include "reader.h"

/* All elements of a compressed file, once they were asked for. */
typedef struct {
	void *data; /* NULL: not yet */
} ts_unpacked;

/* A buffer's file. */
typedef struct {
	char *path;            /* NULL: the trace has no such file */
	const void *memory;    /* where the elements are if not in that file, which may not be there then */
	void *owned;           /* the same, if the trace releases it */
	ts_unpacked *unpacked; /* of a compressed file; else NULL. Copies of the item share it */
	ts_npy npy;
	bool cropped;
	u32 crop[4]; /* x, y, width, height */
} ts_trace_item;

struct ts_trace {
	char *dir;
	const ts_pipeline *pipeline;
	bool arrival;             /* points stand in any order */
	bool old_names;           /* some of its names are of renamed.def */
	bool open;                /* a candidate that ts_trace_put fills */
	const ts_stage *replayed; /* a stage that was replayed, whose outputs these are; NULL: it is of none */
	bool has_params;
	ts_params params;   /* if it has them */
	char producer[128]; /* its name and version, clean */
	ts_trace_item item[TS_N_BUFFERS];
	ts_buffer_view view[TS_N_BUFFERS];    /* as ts_trace_buffer handed them out */
	ts_trace_info info;                   /* as ts_trace_about did */
	ts_counter counters[TS_MAX_COUNTERS]; /* of the run that made it */
	u32 n_counters;
};

/* A trace without buffers, whose messages call it `dir`; NULL with the message set. */
ts_trace *ts_trace_new(const char *dir);

/* Opens the trace in folder `dir` by its trace.json. The message says what is wrong, in which file, and what would be
 * right. On failure *trace is NULL; else release it by ts_trace_close. */
ts_status ts_trace_open_folder(ts_trace **trace, const char *dir);

/* Opens a folder without trace.json as a candidate of `pipeline`, by a list "NAME=FILE,..." of buffers and their files
 * there: .npy, or else raw little-endian elements, whose first dimension follows from the size and whose others are
 * those of `like`. */
ts_status ts_trace_open_layout(ts_trace **trace, const char *dir, const char *layout, bool arrival,
                               const ts_trace *like);

/* Opens one .npy file as a trace of nothing else. Which buffer it holds, its name says: "NAME.npy" or "NN-NAME.npy". */
ts_status ts_trace_open_file(ts_trace **trace, const char *path, ts_buffer_id *id);

/* A reader of the elements of a buffer that is there; NULL with the message set. */
ts_reader *ts_trace_read(const ts_trace_item *item, ts_buffer_id id);

/* Copies all elements of a buffer that is there; TS_ERROR: its file cannot be read. */
ts_status ts_trace_copy(void *to, const ts_trace_item *item, ts_buffer_id id);

/* The buffer of that name, or of that old name; false if there is none. */
bool ts_trace_find(ts_buffer_id *id, const char *name);

#endif
