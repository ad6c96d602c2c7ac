/* Where splats of many points may be: in the world, and on a cube face. */
#ifndef TS_BACKENDS_SPLAT_EXTENT_H
#define TS_BACKENDS_SPLAT_EXTENT_H
#include "splat_batch.h"

/* How far from their points splats reach, along the axes of the world. */
typedef struct {
	f32 along[3];
} ts_splat_reach;

/* Of splats, from the eye on the face's axes: right, up, ahead. */
typedef struct {
	ts_range of[3];
} ts_splat_extent;

/* Of a live piece's splats. */
ts_splat_reach ts_splat_reach_of(const ts_splat_live *live, u64 at);

ts_splat_extent ts_splat_extent_of(const ts_splat_face *f, const ts_splat_bounds *points, const ts_splat_reach *reach);
/* All splats lie beyond one side of the face. */
bool ts_splat_is_beside(const ts_splat_face *f, const ts_splat_extent *e);
/* Texels that the splats may touch, and more; all, where some may be behind the eye. */
ts_box ts_splat_extent_box(const ts_splat_face *f, const ts_splat_extent *e);

/* No distance of any of the points from the eye, as kernels tell it, is less. */
f32 ts_splat_nearest(ts_v3 eye, const ts_splat_bounds *points);
/* True if every texel of the box already holds a distance below those of the points. */
bool ts_splat_is_hidden(const ts_splat_face *f, ts_box box, const ts_splat_bounds *points);

#endif
