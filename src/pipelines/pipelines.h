/* The pipelines, and what they share. */
#ifndef TS_PIPELINES_PIPELINES_H
#define TS_PIPELINES_PIPELINES_H
#include "pipeline.h"

ts_status ts_epr_run(ts_run *run);
u64 ts_epr_estimate(const ts_scene *scene, const ts_params *params);
ts_status ts_mvr_run(ts_run *run);
u64 ts_mvr_estimate(const ts_scene *scene, const ts_params *params);

/* Runs stages by name, ended by NULL, in order; stops at the first failure. */
ts_status ts_run_stages(ts_run *run, const char *const *names);
/* Bytes of the buffers that every pipeline makes. */
u64 ts_common_estimate(const ts_scene *scene, const ts_params *params);

#endif
