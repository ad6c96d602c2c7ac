/* A pixel of the G-buffer of screen-space methods (SSAGH section 3; METHODS 11). Its depth is zn = 1 - near / z, with
 * the far plane at infinity, so that 1 - zn is proportional to 1 / z; thresholds and interpolation of hulls rely on
 * that. zn is 1 for the sky, and for nothing else. */
#ifndef TS_KERNELS_RASTER_GPIXEL_H
#define TS_KERNELS_RASTER_GPIXEL_H
#include "kernels/raster/view.h"

#define TS_SKY 1.0f
#define TS_DEEPEST 0.999999940395355224609375f /* 1 - 2^-24: the last number before the sky */

/* zn of an axial depth. */
TS_FN f32 ts_k_screen_depth(f32 near, f32 z)
{
	f32 inverse = near / z;
	return ts_clamp(1.0f - inverse, 0.0f, TS_DEEPEST);
}

TS_FN void ts_k_gpixel_store(TS_GLOBAL ts_gpixel *pixel, ts_v3 p, f32 depth, ts_v3 n, ts_v3 albedo)
{
	ts_store3(pixel->position, p);
	pixel->depth = ts_put(depth);
	ts_store3(pixel->normal, n);
	ts_store3(pixel->albedo, albedo);
	pixel->pad0 = 0u;
	pixel->pad1 = 0u;
}

#endif
