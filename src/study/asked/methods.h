/* Finds the pipelines that --method names. */
#ifndef TS_STUDY_ASKED_METHODS_H
#define TS_STUDY_ASKED_METHODS_H
#include "methods/pipeline.h"
#include "study/asked/job.h"

enum { TS_MAX_METHODS = 16 };

/* The pipelines of `effect` that the comma-separated `names` name, in that order, each once; NULL or "all": all. */
ts_status ts_methods_find(const ts_pipeline *methods[TS_MAX_METHODS], u32 *n, const char *effect, const char *names);

/* Fails if there is no such effect; the message names the nearest. */
ts_status ts_effect_check(const char *effect);
/* Sets parameters that were not typed as the effect wants them: shadows are shown without mirrors. */
void ts_effect_params(ts_job *job, const char *effect);

#endif
