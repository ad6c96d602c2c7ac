/* The ground truth of SSAGH section 5: every pixel gathers from every triangle of light itself, E = sum of M F with
 * F the form factor of the triangle's part above the pixel's horizon, if it faces the pixel (METHODS 11). In the
 * order of the triangles. */
#ifndef TS_KERNELS_DIRECT_H
#define TS_KERNELS_DIRECT_H
#include "../base/args.h"
#include "form_factor.h"
#include "../raster/gbuffer.h"

#define TS_ROWS_ts_direct_args(ARG) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, ts_patch, patches, rsm_patch) \
	ARG(OUT, f32, irradiance, indirect_irradiance) \
	ARG(VALUE, u64, n_patches, none)
TS_ARGS(ts_direct_args);

TS_FN ts_v3 ts_k_direct(TS_GLOBAL const ts_patch *patch, ts_v3 p, ts_v3 n)
{
	f32 factor = ts_k_form_factor(p, n, ts_load3(patch->a), ts_load3(patch->b), ts_load3(patch->c));
	return ts_scale(ts_load3(patch->exitance), factor);
}

/* map over pixels */
TS_FN void ts_k_direct_item(const ts_direct_args *args, u64 i)
{
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	ts_v3 p = ts_load3(pixel->position);
	ts_v3 n = ts_load3(pixel->normal);
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	u64 end = pixel->depth == TS_SKY ? 0u : args->n_patches;
	for (u64 k = 0u; k < end; k++) sum = ts_add(sum, ts_k_direct(&args->patches[k], p, n));
	ts_store3(args->irradiance + i * 3u, sum);
}

#endif
