/* Which of 32 views may see a box in world space: one that no plane of its pyramid parts from it. */
#ifndef TS_BACKENDS_VIEW_PLANES_H
#define TS_BACKENDS_VIEW_PLANES_H
#include "../../../kernels/raster/raster.h"

enum { TS_GROUP = 32, TS_PLANES = 5 };

/* About its middle, half its sides. */
typedef struct {
	f32 middle[3], half[3];
} ts_bounds;

/* By plane and view: a point p is outside where normal.(p - eye) + least < 0, by more than `error` times the distance
 * and `level`, which rounding can change. */
typedef struct {
	u32 views; /* bits: those that were set; of others nothing is told */
	f32 eye[3][TS_GROUP];
	f32 normal[TS_PLANES][3][TS_GROUP];
	f32 least[TS_PLANES][TS_GROUP], error[TS_PLANES][TS_GROUP], level[TS_PLANES][TS_GROUP];
} ts_view_planes;

void ts_view_planes_set(ts_view_planes *planes, u32 at, const ts_camera_k *view);
/* Bits of the views that may have a point of the box in their image. */
u32 ts_view_planes_meet(const ts_view_planes *planes, const ts_bounds *box);

#endif
