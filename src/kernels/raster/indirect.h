/* The picture of indirect light alone, or of the light of lamps: Lo = albedo / pi E (METHODS 11), plus specular
 * reflection if there is any; the sky has the background. */
#ifndef TS_KERNELS_RASTER_INDIRECT_H
#define TS_KERNELS_RASTER_INDIRECT_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/base/srgb.h"
#include "kernels/raster/gpixel.h"

#define TS_BOUNCE_GAIN 8.0f /* light of one bounce is dim beside direct light */

#define TS_ROWS_ts_indirect_args(ARG) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, f32, irradiance, indirect_irradiance) \
	ARG(IN_OPT, f32, specular, indirect_specular) \
	ARG(OUT, f32, radiance, image_radiance) \
	ARG(OUT_OPT, u8, srgb, image_srgb) /* NULL: for samples, which have no display value */ \
	ARG(VALUE, f32, exposure, none) \
	ARG(VALUE, f32, gain, none) /* factor of display values, except the sky's */
TS_ARGS(ts_indirect_args);

/* map over pixels and their samples */
TS_FN void ts_k_image_indirect_item(const ts_indirect_args *args, u64 i)
{
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	ts_v3 light = ts_scale(ts_load3(args->irradiance + i * 3u), TS_PER_PI);
	bool sky = pixel->depth == TS_SKY;
	ts_v3 radiance = sky ? ts_k_background() : ts_mul(ts_load3(pixel->albedo), light);
	if (!sky && args->specular != NULL) radiance = ts_add(radiance, ts_load3(args->specular + i * 3u));
	f32 exposure = args->exposure * (sky ? 1.0f : args->gain);
	TS_GLOBAL u8 *srgb = args->srgb != NULL ? args->srgb + i * 3u : NULL;
	ts_k_show(args->radiance + i * 3u, srgb, radiance, exposure);
}

#endif
