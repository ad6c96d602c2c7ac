/* Keeps a run's buffers in memory as a trace. */
#ifndef TS_TRACE_KEEP_H
#define TS_TRACE_KEEP_H
#include "trace/read.h"

/* Which buffers of a run are kept. */
typedef struct {
	bool whole;              /* all buffers, also those that only a trace has; false: only */
	bool keep[TS_N_BUFFERS]; /* these, as far as the method makes them */
	bool margins;            /* also how near decisions were */
} ts_keep;

/* Runs a pipeline and keeps its buffers. The scene's buffers are not copied, so the scene must outlive the trace. On
 * failure *trace is NULL. */
ts_status ts_trace_keep(ts_trace **trace, const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params,
                        const ts_how *how, const ts_keep *keep);

#endif
