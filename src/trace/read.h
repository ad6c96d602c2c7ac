/* Opening a trace, ours or a port's. Its content is untrusted: names, counts, types and sizes are checked before data
 * is read, and only files of the folder are opened, and for trace.json of version 2 also those of the folder "scene"
 * beside it. */
#ifndef TS_TRACE_READ_H
#define TS_TRACE_READ_H
#include <touchstone/trace.h>
#include "methods/pipeline.h"
#include "model/digest.h"
#include "trace/emitted/emit.h"
#include "trace/reader.h"

/* All elements of a compressed file, unpacked at the first use. */
typedef struct {
	void *data; /* NULL: not yet */
} ts_unpacked;

/* A buffer's file. */
typedef struct {
	char *path;            /* NULL: the trace has no such file */
	bool typed;            /* its user typed the path, which may be a link */
	const void *memory;    /* the elements, if they are in memory; then the file need not exist */
	void *owned;           /* the same memory, if the trace must release it */
	ts_unpacked *unpacked; /* of a compressed file; else NULL. Copies of the item share it */
	ts_npy npy;
	bool cropped;
	u32 crop[4]; /* x, y, width, height */
	char
		sha256[TS_DIGEST_BYTES]; /* of a file that is left out, by trace.json, with its shape in `npy`; "": not known */
} ts_trace_item;

struct ts_trace {
	char *dir;
	const ts_pipeline *pipeline;
	bool arrival;             /* points stand in any order */
	bool open;                /* a candidate that ts_trace_put fills */
	const ts_stage *replayed; /* the replayed stage whose outputs the trace holds; NULL: none */
	bool has_params;
	ts_params params;   /* if the trace has them */
	char producer[128]; /* name and version of the producer, by ts_line_clean */
	ts_trace_item item[TS_N_BUFFERS];
	ts_buffer_view view[TS_N_BUFFERS];    /* results of ts_trace_buffer */
	ts_trace_info info;                   /* result of ts_trace_about */
	ts_counter counters[TS_MAX_COUNTERS]; /* of the run that made it */
	u32 n_counters;
};

/* Makes a trace without buffers; messages call it `dir`. NULL with the message set on failure. */
ts_trace *ts_trace_new(const char *dir);

/* Opens the trace in folder `dir` by its trace.json. The message says what is wrong, in which file, and what would be
 * right. On failure *trace is NULL; else release it by ts_trace_close. */
ts_status ts_trace_open_folder(ts_trace **trace, const char *dir);

/* Opens a folder without trace.json as a candidate of `pipeline`, by a list "NAME=FILE,..." of buffers and their files
 * there: .npy, or else raw little-endian elements, whose first dimension follows from the size and whose others are
 * those of `like`. */
ts_status ts_trace_open_layout(ts_trace **trace, const char *dir, const char *layout, bool arrival,
                               const ts_trace *like);

/* Opens one .npy file as a trace of one buffer. The file's name tells the buffer: "NAME.npy" or "NN-NAME.npy". */
ts_status ts_trace_open_file(ts_trace **trace, const char *path, ts_buffer_id *id);

/* Opens a reader of the elements of a buffer that the trace has; NULL with the message set on failure. */
ts_reader *ts_trace_read(const ts_trace_item *item, ts_buffer_id id);

/* Copies all elements of a buffer that the trace has; TS_ERROR: its file cannot be read. */
ts_status ts_trace_copy(void *to, const ts_trace_item *item, ts_buffer_id id);

/* The SHA-256 of the file that a trace holds, or would hold, of the buffer. */
ts_status ts_trace_sha256(char hex[TS_DIGEST_BYTES], const ts_trace_item *item, ts_buffer_id id);

/* Finds the buffer of a name; false if there is none. */
bool ts_trace_find(ts_buffer_id *id, const char *name);

#endif
