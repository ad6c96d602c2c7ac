/* Values of many items in vector lanes, and choices that vector loops can make. */
#ifndef TS_BACKENDS_C_RASTER_LANES_H
#define TS_BACKENDS_C_RASTER_LANES_H
#include <string.h>
#include "kernels/base/scene.h"

enum { TS_LANES = 16, TS_ABREAST = 64 };

/* Loops run over whole vectors of lanes. */
static inline u32 ts_whole_lanes(u32 n) { return (n + TS_LANES - 1) / TS_LANES * TS_LANES; }

/* Gives the lanes behind lane n - 1 of the last vector its values. Of arrays of TS_ABREAST elements of 32 bits each, as
 * many as the bytes hold, one behind another. */
static inline void ts_repeat_last(void *arrays, size_t bytes, u32 n)
{
	enum { ELEMENT = sizeof(u32), ARRAY = TS_ABREAST * ELEMENT };
	for (size_t k = 0; k < bytes / ARRAY && n > 0; k++) {
		u8 *array = (u8 *)arrays + k * ARRAY;
		for (u32 i = n; i < ts_whole_lanes(n); i++) memcpy(array + i * ELEMENT, array + (n - 1) * ELEMENT, ELEMENT);
	}
}

typedef struct {
	f32 x[TS_ABREAST], y[TS_ABREAST], z[TS_ABREAST];
} ts_lanes3;

static inline ts_v3 ts_lane3(const ts_lanes3 *from, u32 i) { return ts_v3_make(from->x[i], from->y[i], from->z[i]); }

static inline void ts_set_lane3(ts_lanes3 *to, u32 i, ts_v3 v)
{
	to->x[i] = v.x;
	to->y[i] = v.y;
	to->z[i] = v.z;
}

/* Copies the positions of the corners a, b and c of a triangle. */
static inline void ts_set_corners(ts_lanes3 corner[3], u32 i, const ts_arrays *scene, u32 triangle)
{
	const u32 *vertex = scene->triangles[triangle].vertex;
	for (u32 k = 0; k < 3; k++) ts_set_lane3(&corner[k], i, ts_load3(scene->vertices[vertex[k]].position));
}

/* p if `which` is 1, otherwise q; `which` is a number, which vector loops can hold. */
static inline ts_v3 ts_choose_lane(u32 which, ts_v3 p, ts_v3 q)
{
	return ts_v3_make(which != 0u ? p.x : q.x, which != 0u ? p.y : q.y, which != 0u ? p.z : q.z);
}

#endif
