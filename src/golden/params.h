/* params.txt of a golden, NAME=VALUE lines: effect, method, scene, its options (scene/places.h) and the parameters that
 * they read. The file is untrusted. Part of the core. */
#ifndef TS_GOLDEN_PARAMS_H
#define TS_GOLDEN_PARAMS_H
#include "golden/golden.h"
#include "scene/places.h"

/* Bytes of a value, of a scene and of its options; the last frame that a golden may be of. */
enum { TS_GOLDEN_VALUE = 64, TS_GOLDEN_SCENE = 200, TS_GOLDEN_PLACES = 2048, TS_GOLDEN_FRAME = 1000 };

/* The content of params.txt. A parameter that the file does not name, because it was added later, has its default. */
typedef struct {
	char effect[TS_GOLDEN_VALUE], method[TS_GOLDEN_VALUE];
	char scene[TS_GOLDEN_SCENE];   /* a built-in one, or a file's path from the folder that the golden stands in */
	char places[TS_GOLDEN_PLACES]; /* NAME=TEXT lines */
	ts_params params;
} ts_golden_settings;

ts_status ts_golden_read_params(ts_golden_settings *settings, const ts_golden_dir *dir);

/* Appends a line to the options of the scene. */
ts_status ts_golden_place(ts_golden_settings *settings, const char *name, const char *text);
/* Refuses a scene that cannot be a golden's, and parameters beyond the limits. */
ts_status ts_golden_bound(const ts_golden_settings *settings);

/* ts_builtin_open, or what opens files too. */
typedef ts_status ts_golden_opener(ts_scene **scene, const char *spec, const ts_params *params,
                                   const ts_scene_options *options);
/* Opens the scene and computes a golden as ts_golden_compute does; refuses a run that does not fit the machine.
 *   name     that of the golden, for messages
 *   folder   the one from which the paths of scenes go
 * Release by ts_golden_free, also after a failure. */
ts_status ts_golden_make(ts_golden *golden, const char *name, const ts_pipeline *pipeline,
                         const ts_golden_settings *settings, const char *folder, ts_golden_opener *open,
                         const ts_how *how);

#endif
