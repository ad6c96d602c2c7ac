/* params.txt of a golden, NAME=VALUE lines: effect, method, scene and the parameters that they read. The file is
 * untrusted. Part of the core. */
#ifndef TS_GOLDEN_PARAMS_H
#define TS_GOLDEN_PARAMS_H
#include "golden.h"

enum { TS_GOLDEN_VALUE = 64, TS_GOLDEN_FRAME = 1000 }; /* bytes of a value; the last frame that a golden may be of */

/* The content of params.txt. A parameter that the file does not name, because it was added later, has its default. */
typedef struct {
	char effect[TS_GOLDEN_VALUE], method[TS_GOLDEN_VALUE], scene[TS_GOLDEN_VALUE];
	ts_params params;
} ts_golden_said;

ts_status ts_golden_read_params(ts_golden_said *said, const ts_golden_dir *dir);

/* Refuses parameters beyond the limits of a golden. */
ts_status ts_golden_bound(const ts_params *params);

/* Opens a built-in scene and computes a golden as ts_golden_compute does; refuses a run that does not fit the machine.
 * name: that of the golden, for messages. Release by ts_golden_free, also after a failure. */
ts_status ts_golden_make(ts_golden *golden, const char *name, const ts_pipeline *pipeline, const char *builtin,
                         const ts_params *params, const ts_how *how);

#endif
