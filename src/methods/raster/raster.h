/* Functions that the stages of rasterization share, or that others call. */
#ifndef TS_METHODS_RASTER_RASTER_H
#define TS_METHODS_RASTER_RASTER_H
#include "methods/stages.h"

typedef struct ts_shadow_test_args ts_shadow_test_args;
typedef struct ts_illuminate_args ts_illuminate_args;

/* Samples of each pixel of the eye (eye.c). */
u32 ts_eye_samples(const ts_params *params);
/* Elements of the eye's buffers: pixels, times their samples (eye.c). */
u64 ts_eye_size(const ts_run *run);
/* The values of a comparison with the depth maps of the batch (shadow_test.c). */
ts_shadow_test_args ts_resolve_values(const ts_run *run);

extern const ts_launch ts_mip_averaged;
/* Makes levels 1 and up of the mip chains of the batch's cubes; `args` are those that made level 0 (illuminate.c). */
ts_status ts_mip_make(ts_run *run, ts_illuminate_args args);

#endif
