/* A run's buffers in memory, as a trace. */
#ifndef TS_TRACE_KEEP_H
#define TS_TRACE_KEEP_H
#include "read.h"

/* What is kept of a run. */
typedef struct {
	bool whole;              /* all, also what only a trace has; else only: */
	bool keep[TS_N_BUFFERS]; /* what the method makes of it */
	bool margins;            /* also how near decisions were */
} ts_keep;

/* Runs a pipeline and keeps its buffers. Those of the scene are not copied: it must outlive the trace. On failure
 * *trace is NULL. */
ts_status ts_trace_keep(ts_trace **trace, const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params,
                        const ts_how *how, const ts_keep *keep);

#endif
