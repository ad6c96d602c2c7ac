/* params.txt of a golden, NAME=VALUE lines: effect, method, scene and the parameters that they read. The file is
 * untrusted. Part of the core. */
#ifndef TS_GOLDEN_PARAMS_H
#define TS_GOLDEN_PARAMS_H
#include "golden.h"

enum { TS_GOLDEN_VALUE = 64, TS_GOLDEN_FRAME = 1000 }; /* bytes of a value; the last frame that a golden may be of */

/* What it says. A parameter that it does not name, because that is younger, has its default. */
typedef struct {
	char effect[TS_GOLDEN_VALUE], method[TS_GOLDEN_VALUE], scene[TS_GOLDEN_VALUE];
	ts_params params;
} ts_golden_said;

ts_status ts_golden_read_params(ts_golden_said *said, const ts_golden_dir *dir);

/* Refuses parameters of more than a golden may show. */
ts_status ts_golden_bound(const ts_params *params);

/* Opens a built-in scene and computes, as ts_golden_compute; refuses what does not fit the machine. name: of the
 * golden, in messages. ts_golden_free also after a failure. */
ts_status ts_golden_make(ts_golden *golden, const char *name, const ts_pipeline *pipeline, const char *builtin,
                         const ts_params *params, const ts_how *how);

#endif
