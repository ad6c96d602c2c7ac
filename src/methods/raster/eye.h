/* The eye's picture: samples of its pixels. */
#ifndef TS_METHODS_RASTER_EYE_H
#define TS_METHODS_RASTER_EYE_H
#include "kernels/raster/eye_sample.h"
#include "methods/stages.h"

/* Samples of each pixel. */
u32 ts_eye_samples(const ts_params *params);
/* Elements of the eye's buffers: pixels, times their samples. */
u64 ts_eye_size(const ts_run *run);

#endif
