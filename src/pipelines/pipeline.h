/* A pipeline: a method of a paper applied to an effect. */
#ifndef TS_PIPELINES_PIPELINE_H
#define TS_PIPELINES_PIPELINE_H
#include "../stages/stage.h"

typedef struct {
	const char *name;    /* as in --method */
	const char *effect;  /* as in render EFFECT */
	const char *paper;
	const char *doc;
	ts_status (*run)(ts_run *run);
	/* Estimated peak of the frame's buffers in bytes, before running. */
	u64 (*estimate)(const ts_scene *scene, const ts_params *params);
} ts_pipeline;

/* All pipelines, ended by a row without a name. */
extern const ts_pipeline ts_pipeline_table[];
const ts_pipeline *ts_pipeline_find(const char *effect, const char *name);

#endif
