/* Digests of the files that a trace of this run would hold, without writing them: lines that `sha256sum -c` reads. Part
 * of the core. */
#ifndef TS_TRACE_EMITTED_SUMS_H
#define TS_TRACE_EMITTED_SUMS_H
#include <stdio.h>
#include "model/digest.h"
#include "trace/emitted/emit.h"

typedef struct {
	char hex[TS_N_BUFFERS][TS_DIGEST_BYTES]; /* "": not made */
	ts_digest digest[TS_N_BUFFERS];
} ts_sums;

/* A ts_take_chunk whose user is a ts_sums, which must be zero before. Fails only where the work is cancelled. */
ts_status ts_sums_take(void *sums, const ts_chunk *chunk);
/* Ends all digests; call it once, also after a failure. */
void ts_sums_end(ts_sums *sums);
/* Runs a pipeline as for a trace, and computes the digests. */
ts_status ts_sums_of(ts_sums *sums, const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params,
                     const ts_how *how);
/* Prints a line for each buffer, in the order of the pipeline's stages, then of each stage's outputs. */
void ts_sums_print(const ts_sums *sums, const ts_pipeline *pipeline, FILE *out);

#endif
