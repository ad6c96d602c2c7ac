/* Bounds of the splats of many points: in the world, and on a cube face. */
#ifndef TS_BACKENDS_C_POINTS_SPLAT_EXTENT_H
#define TS_BACKENDS_C_POINTS_SPLAT_EXTENT_H
#include "backends/c/points/splat_batch.h"

/* The reach of splats from their points, along the axes of the world, and the slack of their squares. */
typedef struct {
	f32 along[3], slack;
} ts_splat_reach;

/* The extent of splats, from the eye, on the face's axes: right, up, ahead. */
typedef struct {
	ts_range of[3];
} ts_splat_extent;

/* The reach of a live piece's splats. */
ts_splat_reach ts_splat_reach_of(const ts_splat_live *live, u64 at);

ts_splat_extent ts_splat_extent_of(const ts_splat_face *f, const ts_splat_bounds *points, const ts_splat_reach *reach);
/* Whether all splats lie beyond one side of the face. */
bool ts_splat_is_beside(const ts_splat_face *f, const ts_splat_extent *e);
/* A box of all texels that the splats may touch; the whole face if splats may be behind the eye. */
ts_box ts_splat_extent_box(const ts_splat_face *f, const ts_splat_extent *e);

/* A lower bound of the points' distances from the eye, as kernels compute them. */
f32 ts_splat_nearest(ts_v3 eye, const ts_splat_bounds *points);
/* Whether every texel of the box already holds a distance below those of the points. */
bool ts_splat_is_hidden(const ts_splat_face *f, ts_box box, const ts_splat_bounds *points);

#endif
