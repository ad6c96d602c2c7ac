/* The picture of indirect light alone: Lo = albedo / pi E (SPEC 3.7), and the background in the sky. */
#ifndef TS_KERNELS_INDIRECT_H
#define TS_KERNELS_INDIRECT_H
#include "gbuffer.h"
#include "image.h"

typedef struct {
	TS_GLOBAL const ts_gpixel *pixels; /* gbuffer.pixel */
	TS_GLOBAL const f32 *irradiance;   /* indirect.irradiance */
	TS_GLOBAL f32 *radiance;           /* image.radiance */
	TS_GLOBAL u8 *srgb;                /* image.srgb */
	f32 exposure;
} ts_indirect_args;

/* map over pixels */
TS_FN void ts_k_indirect_image_item(const ts_indirect_args *args, u64 i)
{
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	ts_v3 light = ts_scale(ts_load3(args->irradiance + i * 3u), 0.3183098733425140380859375f);
	ts_v3 radiance = pixel->depth == TS_SKY ? ts_k_background() : ts_mul(ts_load3(pixel->albedo), light);
	ts_k_show(args->radiance + i * 3u, args->srgb + i * 3u, radiance, args->exposure);
}

#endif
