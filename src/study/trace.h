/* The traces that --trace, --trace-only and --crop ask for. */
#ifndef TS_STUDY_TRACE_H
#define TS_STUDY_TRACE_H
#include "study/asked/job.h"
#include "trace/write.h"

/* A method's trace in the output folder, under trace-METHOD. */
typedef struct {
	ts_trace_options options;
	char folder[32], viewer[32]; /* folders of the output: of the trace, and of copies for viewers */
} ts_tracing;

/* Reads the options into *tracing, which must not be moved afterwards. The message names the typed text. */
ts_status ts_tracing_make(ts_tracing *tracing, const ts_job *job, const ts_pipeline *method);
/* Refuses traces for which the disk that holds `dir`, or the folder in which `dir` is to be made, has no room. */
ts_status ts_tracing_check(const ts_tracing *tracings, const ts_pipeline *const *methods, u32 n, const ts_scene *scene,
                           const ts_params *params, const char *dir);

#endif
