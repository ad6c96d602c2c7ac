/* trace.json: the description of a trace, its run and its producer. */
#ifndef TS_TRACE_DESCRIBE_H
#define TS_TRACE_DESCRIBE_H
#include <jansson.h>
#include "methods/stage.h"
#include "model/digest.h"
#include "trace/emitted/emit.h"

/* Name, version and commit of this program; name, device, compiler and flags of its backend. New references, or NULL
 * without memory. */
json_t *ts_producer(const ts_run *run);
/* Rounding, contraction and denormals of the run's backend; for the C backend measured now in this process. */
json_t *ts_arithmetic(const ts_run *run);

/* Files of a trace of version 1 are plain .npy files of its folder. In version 2 they may also be compressed, or files
 * of the scene that the traces of one run share. */
enum { TS_TRACE_VERSION = 1, TS_TRACE_VERSION_SHARED = 2 };

/* The folder of the shared files, as traces name it. */
#define TS_TRACE_SCENE "../scene/"

enum { TS_TRACE_NAME = TS_EMIT_NAME + 16 };

/* A buffer of a trace. */
typedef struct {
	bool made;
	bool has_file; /* false: the trace has only its digest */
	bool shared;   /* the file is in TS_TRACE_SCENE */
	char name[TS_TRACE_NAME];
	char descr[TS_NPY_DESCR];
	u32 n_dims;
	u64 shape[TS_MAX_DIMS];
	bool cropped;
	char sha256[TS_DIGEST_BYTES];
} ts_trace_file;

typedef struct {
	const ts_pipeline *pipeline;
	const ts_run *run;
	const ts_trace_file *files; /* TS_N_BUFFERS */
	const u32 *crop;
	int version;
} ts_trace_description;

/* A new reference, or NULL without memory. The same run gives the same text. */
json_t *ts_trace_describe(const ts_trace_description *about);
/* Writes trace.json, and releases `root`. */
ts_status ts_trace_write_json(const char *path, json_t *root);

/* The parameters as trace.json holds them: an object of texts. A new reference, or NULL without memory. */
json_t *ts_trace_params(const ts_params *params);

#endif
