/* SPDX-License-Identifier: Apache-2.0 */
/* Traces: the buffers of every stage of a run. One is made by a run, read from a folder (reference/TRACES.md), or put
 * together from a port's own arrays.
 *
 *   ts_context *context; ts_params *params; ts_scene *scene; ts_trace *trace;
 *   const ts_buffer_view *image;
 *   if (ts_context_open(&context, NULL) == TS_OK && ts_params_make(&params) == TS_OK &&
 *       ts_scene_open(context, &scene, "atrium", params, NULL) == TS_OK &&
 *       ts_trace_run(context, &trace, scene, params, "reflections", "epr", NULL) == TS_OK &&
 *       (image = ts_trace_buffer(trace, "image.srgb")) != NULL) {
 *           ... image->data: image->shape[0] rows of image->shape[1] pixels, 3 bytes each ...
 *   } */
#ifndef TOUCHSTONE_TRACE_H
#define TOUCHSTONE_TRACE_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/params.h>
#include <touchstone/scene.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_trace ts_trace;

/* What is kept of a run. All members but `bytes` may be 0. */
typedef struct {
	size_t bytes;        /* sizeof(ts_run_options) */
	const char *buffers; /* "image.srgb,image.radiance": these alone, by a run that leaves out the stages which only a
	                      * whole trace needs; NULL: all */
	int margins;         /* not 0: also the margins: how near each decision was to another */
	int arrival;         /* not 0: points in the order of their arrival, which differs from run to run */
} ts_run_options;

/* Runs `method` of `effect`, a row of ts_method_at, and keeps its buffers in memory. The scene's own buffers are not
 * copied: the scene must outlive the trace. The scene's mirrors are those of the parameters it was opened with; frame,
 * size and everything else are taken from params.
 * In: options NULL: all defaults.
 * Out: *trace is to be released by ts_trace_close; NULL on failure. */
TS_API ts_status ts_trace_run(ts_context *context, ts_trace **trace, const ts_scene *scene, const ts_params *params,
                              const char *effect, const char *method, const ts_run_options *options);

/* How a trace is written; all but `bytes` may be 0. */
typedef struct {
	size_t bytes; /* sizeof(ts_write_options) */
	int margins;  /* not 0: also the margins: how near each decision was to another */
	int arrival;  /* not 0: points in the order of their arrival, which differs from run to run */
	int compress; /* not 0: each file is compressed by zstd */
} ts_write_options;

/* Runs a method and writes its trace to a folder, which must be absent or empty, a buffer at a time while the run goes
 * on: for traces larger than memory. The folder appears as a whole, or not at all. A process writes one folder at a
 * time, and another thread waits.
 * In: options NULL: all defaults. */
TS_API ts_status ts_trace_write(ts_context *context, const char *folder, const ts_scene *scene, const ts_params *params,
                                const char *effect, const char *method, const ts_write_options *options);

/* Opens the trace in a folder by its trace.json, or a golden's folder (golden.h) as a trace: of what is neither small
 * nor its picture, image.srgb, it has the digests alone. Files are untrusted: everything is checked, and nothing
 * outside the folder is opened but files of the folder "scene" beside it. The files must not change until
 * ts_trace_close. */
TS_API ts_status ts_trace_open(ts_context *context, ts_trace **trace, const char *folder);

/* Opens one .npy file as a trace of one buffer, of any method that has the buffer. The file's name, "BUFFER.npy" or
 * "NN-BUFFER.npy", names the buffer. */
TS_API ts_status ts_trace_open_npy(ts_context *context, ts_trace **trace, const char *path);

/* Opens a folder without trace.json as a candidate of the reference's method.
 * In: list: "BUFFER=FILE,...", files of that folder. A file that is no .npy holds raw little-endian elements; the first
 *   dimension follows from its size, and the others are the reference's. arrival not 0: points stand in any order. */
TS_API ts_status ts_trace_open_list(ts_context *context, ts_trace **trace, const char *folder, const char *list,
                                    int arrival, const ts_trace *reference);

/* Makes a candidate without buffers, of the method and the parameters of `reference`. arrival not 0: its points stand
 * in any order. */
TS_API ts_status ts_trace_candidate(ts_context *context, ts_trace **trace, const ts_trace *reference, int arrival);

/* Gives a candidate of ts_trace_candidate a buffer, or puts another in its place: an array of the shape that
 * records.def says, in C order. The array is not copied: it must exist and not change until ts_trace_close or until
 * another array takes its place.
 * In: bytes: the size of the whole array. */
TS_API ts_status ts_trace_put(ts_trace *trace, const char *buffer, uint32_t n_dims, const uint64_t *shape,
                              const void *data, size_t bytes);

/* Writes the buffers that a trace has, a candidate's or what ts_trace_replay made for instance, and a trace.json to a
 * folder, which must be absent or empty, and which appears as a whole or not at all.
 * In: producer: who made the buffers, for comparisons to print; NULL: this library. */
TS_API ts_status ts_trace_save(ts_context *context, const ts_trace *trace, const char *folder, const char *producer);

/* Fails unless a reference can be replayed: it must be canonical and name its parameters. The candidate, unless NULL,
 * must be of the same method, and of the same parameters if it names any. */
TS_API ts_status ts_trace_match(const ts_trace *reference, const ts_trace *candidate);

/* Not 0 if the run of a trace had this stage: some parameters leave stages out. */
TS_API int ts_trace_takes(const ts_trace *trace, const char *stage);

/* A buffer of a trace. */
typedef struct {
	const char *name;    /* "stage.buffer" */
	const char *element; /* a scalar (f32, u8, u32, u64) or a record of records.def */
	size_t element_bytes;
	const void *data; /* C order; belongs to the trace, the scene, or the caller of ts_trace_put */
	uint32_t n_dims;
	uint64_t shape[4];
} ts_buffer_view;

/* The run of a trace. */
typedef struct {
	const char *folder;          /* or the file; for a trace in memory, its name in messages */
	const char *effect, *method; /* for a single file: any method that has its buffer */
	const char *producer;        /* name and version; "" if not known */
	int arrival;                 /* not 0: points may stand in any order */
	int has_params;              /* not 0: the trace names the parameters of its run */
} ts_trace_info;

/* Describes the run; the result belongs to the trace. */
TS_API const ts_trace_info *ts_trace_about(ts_trace *trace);

/* Not 0 if the trace has the buffer of that name. */
TS_API int ts_trace_has(const ts_trace *trace, const char *name);

/* The buffer of that name, read from its file if need be; valid until ts_trace_close or ts_trace_put. NULL with the
 * message set if there is no such buffer, the trace lacks it, or its file cannot be read. */
TS_API const ts_buffer_view *ts_trace_buffer(ts_trace *trace, const char *name);

/* The same without reading: data is NULL while the buffer is only in a file. */
TS_API const ts_buffer_view *ts_trace_look(ts_trace *trace, const char *name);

/* SHA-256 of the .npy file of a buffer, as a trace in a folder has it: 64 hexadecimal digits and a 0. */
TS_API ts_status ts_trace_digest(ts_trace *trace, const char *name, char hex[65]);

/* Runs a method and calls `each` with the digest of every buffer, in the order of the stages, without keeping any
 * buffer: for scenes whose traces are larger than memory. `each` gets user, and must not call the library. */
TS_API ts_status ts_run_digests(ts_context *context, const ts_scene *scene, const ts_params *params, const char *effect,
                                const char *method, void (*each)(void *user, const char *buffer, const char *hex),
                                void *user);

/* A counter of the run: "points", "shading operations", ... 0 if the trace is not of a run, or the run has no such
 * counter. */
TS_API int64_t ts_trace_counter(const ts_trace *trace, const char *name);

/* Releases a trace and the buffers that it read; NULL is allowed. */
TS_API void ts_trace_close(ts_trace *trace);

#ifdef __cplusplus
}
#endif
#endif
