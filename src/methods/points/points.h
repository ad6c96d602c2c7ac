/* Functions that the stages of points share. */
#ifndef TS_METHODS_POINTS_POINTS_H
#define TS_METHODS_POINTS_POINTS_H
#include "methods/stages.h"

typedef struct ts_points_args ts_points_args;

/* density.scale as samples per pixel side (cull.c). */
f32 ts_samples_a_pixel(const ts_params *params);
/* The widest inset of a splat's box, by splat.box (splat.c). */
f32 ts_splat_inset(const ts_params *params);
/* Side of the cubes that limit EPR's density with density.cap=greatest, otherwise 0 (split.c). */
u32 ts_greatest_side(const ts_params *params);
/* Samples per side of the pixel in which EPR's culling measures areas, by points.cull_unit. At most 1: where a cube
 * limits the density, a higher density.scale puts no more samples into a pixel (cull.c). */
f32 ts_cull_unit(const ts_params *params);
/* The exposure of colour codes, whose largest stands for scatter.headroom times display white (scatter.c). */
f32 ts_code_exposure(const ts_params *params);
/* Bindings of a launch for stored points, and for points that are made again; path: that of its ts_points_args. */
#define TS_STORED_POINTS(path) TS_IN(path.keys, points_key), TS_IN(path.points, points_record)
#define TS_COUNTED_POINTS(path) TS_IN(path.offset, points_offset)
/* Whether the method counts points and does not store them, so that points are made again from their indices
 * (points.c). */
bool ts_points_again(const ts_run *run);
/* Arguments of the kernels that make points, without pointers (points.c). */
ts_points_args ts_points_values(const ts_run *run);

#endif
