/* What the stages of points share. */
#ifndef TS_STAGES_POINTS_H
#define TS_STAGES_POINTS_H
#include "../../kernels/points/points.h"
#include "../stages.h"

/* density.scale as samples a pixel a side (cull.c). */
f32 ts_samples_a_pixel(const ts_params *params);
/* Arguments of the kernels that make points, but pointers (points.c). */
ts_points_args ts_points_values(const ts_run *run);

#endif
