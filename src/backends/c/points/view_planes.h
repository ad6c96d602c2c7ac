/* The views, of at most 32, that may see a box in world space: those without a plane of their pyramid that separates
 * the box. */
#ifndef TS_BACKENDS_C_POINTS_VIEW_PLANES_H
#define TS_BACKENDS_C_POINTS_VIEW_PLANES_H
#include "kernels/raster/view.h"

enum { TS_GROUP = 32, TS_PLANES = 5 };

/* A box: its middle, and half its sides. */
typedef struct {
	f32 middle[3], half[3];
} ts_bounds;

/* By plane and view: a point p is outside where normal.(p - eye) + least < 0 by more than the rounding error, `error`
 * times the distance plus `level`. */
typedef struct {
	u32 views; /* bits of the views that were set; bits of other views mean nothing */
	f32 eye[3][TS_GROUP];
	f32 normal[TS_PLANES][3][TS_GROUP];
	f32 least[TS_PLANES][TS_GROUP], error[TS_PLANES][TS_GROUP], level[TS_PLANES][TS_GROUP];
} ts_view_planes;

void ts_view_planes_set(ts_view_planes *planes, u32 at, const ts_camera_k *view);
/* Bits of the views that may have a point of the box in their image. */
u32 ts_view_planes_meet(const ts_view_planes *planes, const ts_bounds *box);

#endif
