/* What triangles are drawn into: keys depth << 32 | triangle, or depths alone (CONTRACT rule 24). */
#ifndef TS_KERNELS_RASTER_TARGET_H
#define TS_KERNELS_RASTER_TARGET_H
#include "kernels/base/num.h"

/* Texels of one view: keys, or depths alone; the other pointer is NULL. */
typedef struct {
	TS_GLOBAL u64 *keys;
	TS_GLOBAL u32 *depths;
} ts_target;

TS_FN ts_target ts_k_keys(TS_GLOBAL u64 *keys)
{
	ts_target r;
	r.keys = keys;
	r.depths = NULL;
	return r;
}

TS_FN void ts_k_draw_texel(const ts_target *target, u64 at, f32 z, u32 triangle)
{
	if (target->keys != NULL) {
		ts_min_u64(&target->keys[at], ((u64)ts_f2u(ts_put(z)) << 32) | triangle);
	} else {
		ts_min_u32(&target->depths[at], ts_f2u(ts_put(z)));
	}
}

#endif
