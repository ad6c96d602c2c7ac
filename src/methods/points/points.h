/* What the stages of points share. */
#ifndef TS_STAGES_POINTS_H
#define TS_STAGES_POINTS_H
#include "../../kernels/points/points.h"
#include "../stages.h"

/* density.scale as samples a pixel a side (cull.c). */
f32 ts_samples_a_pixel(const ts_params *params);
/* Bindings of a launch, `path` being its ts_points_args: of stored points; of points that are made again. */
#define TS_STORED_POINTS(path) TS_IN(path.keys, points_key), TS_IN(path.points, points_record)
#define TS_COUNTED_POINTS(path) TS_IN(path.offset, points_offset)
/* The method stores no points, but counts them: whoever is given an index makes its point again (points.c). */
bool ts_points_again(const ts_run *run);
/* Arguments of the kernels that make points, but pointers (points.c). */
ts_points_args ts_points_values(const ts_run *run);

#endif
