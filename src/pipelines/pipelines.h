/* The pipelines, a file each. */
#ifndef TS_PIPELINES_PIPELINES_H
#define TS_PIPELINES_PIPELINES_H
#include "pipeline.h"

extern const ts_step ts_epr_steps[];
void ts_epr_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_mvr_steps[];
void ts_mvr_prepare(ts_run *run);
void ts_mvr_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

#endif
