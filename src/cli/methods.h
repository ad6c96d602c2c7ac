/* Which pipelines --method names. */
#ifndef TS_CLI_METHODS_H
#define TS_CLI_METHODS_H
#include "../pipelines/pipeline.h"

enum { TS_MAX_METHODS = 16 };

/* The pipelines of `effect` that the comma-separated `names` name, in that order, each once; NULL or "all": all. */
ts_status ts_methods_find(const ts_pipeline *methods[TS_MAX_METHODS], u32 *n, const char *effect, const char *names);

#endif
