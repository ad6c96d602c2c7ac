/* The ground truth of SSAGH section 5: every pixel itself gathers from every triangle of light that faces the pixel. E
 * is the sum of M F, F the form factor of the triangle's part above the pixel's horizon (METHODS 11), plus the
 * irradiance of lights without extent. Sums are in the order of the triangles, then of the lights. */
#ifndef TS_KERNELS_HULLS_DIRECT_H
#define TS_KERNELS_HULLS_DIRECT_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/hulls/form_factor.h"
#include "kernels/raster/gpixel.h"

#define TS_ROWS_ts_direct_args(ARG) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, ts_patch, patches, rsm_patch) \
	ARG(IN_OPT, ts_light, lamps, lamp_light) \
	ARG(IN_OPT, ts_lamp, shapes, lamp_shape) \
	ARG(OUT, f32, irradiance, indirect_irradiance) \
	ARG(VALUE, u64, n_patches, none) \
	ARG(VALUE, u32, n_lamps, none) /* 0: patches are of surfaces */
TS_ARGS(ts_direct_args);

TS_FN ts_v3 ts_k_direct(TS_GLOBAL const ts_patch *patch, ts_v3 p, ts_v3 n)
{
	f32 factor = ts_k_form_factor(p, n, ts_load3(patch->a), ts_load3(patch->b), ts_load3(patch->c));
	return ts_scale(ts_load3(patch->exitance), factor);
}

TS_FN ts_v3 ts_k_direct_point(TS_GLOBAL const ts_light *light, ts_v3 p, ts_v3 n)
{
	ts_v3 way;
	f32 arrives = ts_k_light(light, p, &way);
	return ts_scale(ts_load3(light->intensity), arrives * ts_max(ts_flush(ts_dot(n, way)), 0.0f));
}

/* map over pixels and their samples */
TS_FN void ts_k_direct_item(const ts_direct_args *args, u64 i)
{
	/* Read the surface of the pixel; the sky gathers nothing. */
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	ts_v3 p = ts_load3(pixel->position);
	ts_v3 n = ts_load3(pixel->normal);
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	bool sky = pixel->depth == TS_SKY;
	/* Sum exitance times form factor over all triangles, in order (SSAGH 5). */
	u64 end = sky ? 0u : args->n_patches;
	for (u64 k = 0u; k < end; k++) sum = ts_add(sum, ts_k_direct(&args->patches[k], p, n));
	/* Add the lights without extent, each of which is one direction and has no form factor. */
	for (u32 k = 0u; k < args->n_lamps && !sky; k++) {
		if (!(args->shapes[k].radius > 0.0f)) sum = ts_add(sum, ts_k_direct_point(&args->lamps[k], p, n));
	}
	ts_store3(args->irradiance + i * 3u, sum);
}

#endif
