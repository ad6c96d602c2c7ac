/* Colours in 32 bits, with the distance (iVIR section 4; METHODS 9) or without it (EPR section 3.5; METHODS 18). */
#ifndef TS_KERNELS_POINTS_COLOUR_CODE_H
#define TS_KERNELS_POINTS_COLOUR_CODE_H
#include "kernels/base/num.h"
#include "kernels/base/vec.h"

/* ---- 13 bits of distance and 19 of colour: a 32-bit minimum keeps the nearest ---- */

#define TS_FAR_BITS 20.0f /* far / near is 2 to this power */

/* floor(8191 log(d / near) / log(far / near)): steps of 0.17 per cent. At most 8190, so that no code with a colour is
 * all ones, which means an empty texel. */
TS_FN u32 ts_k_depth_code(f32 distance, f32 near)
{
	f32 doublings = ts_log2(ts_max(distance / near, 1.0f));
	return (u32)ts_min_i32(ts_floor_i32((8191.0f * doublings) / TS_FAR_BITS), 8190);
}

/* The code of a channel: the square root of the exposed radiance, at most 1. The root spends the few bits where the eye
 * distinguishes shades. */
TS_FN u32 ts_k_channel_code(f32 radiance, f32 exposure, f32 most)
{
	return (u32)ts_fix(ts_sqrt(ts_flush(ts_clamp(radiance * exposure, 0.0f, 1.0f))) * most, 0, 7);
}

TS_FN f32 ts_k_channel_radiance(u32 code, f32 exposure, f32 most)
{
	f32 root = (f32)code / most;
	return (root * root) / exposure;
}

TS_FN u32 ts_k_colour_code(ts_v3 radiance, f32 exposure)
{
	return (ts_k_channel_code(radiance.x, exposure, 63.0f) << 13) |
	       (ts_k_channel_code(radiance.y, exposure, 127.0f) << 6) | ts_k_channel_code(radiance.z, exposure, 63.0f);
}

TS_FN ts_v3 ts_k_colour_radiance(u32 code, f32 exposure)
{
	return ts_v3_make(ts_k_channel_radiance((code >> 13) & 63u, exposure, 63.0f),
	                  ts_k_channel_radiance((code >> 6) & 127u, exposure, 127.0f),
	                  ts_k_channel_radiance(code & 63u, exposure, 63.0f));
}

/* ---- 9 bits per channel and 5 of a common exponent: RGB9_E5 of OpenGL's EXT_texture_shared_exponent ---- */

#define TS_MOST_SHARED 65280.0f /* 510 x 2^7, so that no colour is all ones, which means an empty texel */

/* A channel in units of 2^(exponent - 24), rounded. */
TS_FN u32 ts_k_shared_channel(f32 channel, i32 exponent)
{
	f32 units = ts_u2f((u32)(151 - exponent) << 23);
	return (u32)ts_floor_i32(channel * units + 0.5f);
}

/* Red in the lowest 9 bits, then green, blue and the exponent. */
TS_FN u32 ts_k_shared_code(ts_v3 radiance)
{
	f32 r = ts_clamp(radiance.x, 0.0f, TS_MOST_SHARED);
	f32 g = ts_clamp(radiance.y, 0.0f, TS_MOST_SHARED);
	f32 b = ts_clamp(radiance.z, 0.0f, TS_MOST_SHARED);
	f32 most = ts_max(ts_max(r, g), b);
	i32 exponent = ts_max_i32((i32)(ts_f2u(most) >> 23) - 127, -16) + 16;
	if (ts_k_shared_channel(most, exponent) == 512u) exponent++;
	return ts_k_shared_channel(r, exponent) | (ts_k_shared_channel(g, exponent) << 9) |
	       (ts_k_shared_channel(b, exponent) << 18) | ((u32)exponent << 27);
}

TS_FN ts_v3 ts_k_shared_radiance(u32 code)
{
	f32 unit = ts_u2f(((code >> 27) + 103u) << 23);
	return ts_v3_make((f32)(code & 511u) * unit, (f32)((code >> 9) & 511u) * unit, (f32)((code >> 18) & 511u) * unit);
}

#endif
