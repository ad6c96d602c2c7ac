/* Functions that the stages of points share. */
#ifndef TS_METHODS_POINTS_POINTS_H
#define TS_METHODS_POINTS_POINTS_H
#include "methods/stages.h"

typedef struct ts_points_args ts_points_args;
typedef struct ts_scatter_args ts_scatter_args;
typedef struct ts_lookup_args ts_lookup_args;

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

/* Launches that put points, stored or made from pieces, into the off-screen views of the batch. */
typedef struct {
	ts_launch stored, pieces;
} ts_scatters;

ts_scatter_args ts_scatter_values(const ts_run *run);
/* Fills the buffers of `args`, runs the launch for the points, and counts. Does nothing if there are no views
 * (scatter.c). */
ts_status ts_scatter_run(ts_run *run, const ts_scatters *own, void *args, size_t bytes, u32 n_views);

enum { TS_MAX_BOUNCES = 3 };

/* The buffers of each bounce. */
typedef struct {
	ts_dim entries;
	ts_buffer_id offset;   /* entries before each sample of the bounce before */
	ts_buffer_id queue;    /* entries; pixels at the first bounce */
	ts_buffer_id found;    /* points seen */
	ts_buffer_id radiance; /* of the entries */
} ts_bounce_buffers;
static const ts_bounce_buffers ts_bounce_table[TS_MAX_BOUNCES] = {
	{TS_DIM_mirror_pixels, TS_B_none, TS_B_mirror_pixel_record, TS_B_lookup_point, TS_B_shade_radiance},
	{TS_DIM_second_bounces, TS_B_lookup_second_offset, TS_B_lookup_second_parent, TS_B_lookup_second_point,
     TS_B_shade_second_radiance},
	{TS_DIM_third_bounces, TS_B_lookup_third_offset, TS_B_lookup_third_parent, TS_B_lookup_third_point,
     TS_B_shade_third_radiance},
};

/* Arguments of the kernels of bounce 0, 1 or 2, without pointers (lookup.c). */
ts_lookup_args ts_lookup_values(const ts_run *run, u32 bounce);

#endif
