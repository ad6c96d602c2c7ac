/* The cross-bilateral filter of gathered light (Eisemann and Durand 2004, Petschnigg et al. 2004; MegaViews section
 * 5.1, which gives no weights), along rows, then along columns. A neighbour's weight falls with its distance in pixels,
 * with its angle off the pixel's tangent plane, and with the angle between their normals. The sky takes no part. */
#ifndef TS_KERNELS_VIEWS_BILATERAL_H
#define TS_KERNELS_VIEWS_BILATERAL_H
#include "kernels/base/args.h"
#include "kernels/raster/gpixel.h"

/* Factors of the squared sine of the angle off the plane (a deviation of 1/16), and of 1 - the cosine between
 * normals. */
#define TS_BILATERAL_PLANE 128.0f
#define TS_BILATERAL_NORMAL 32.0f

#define TS_ROWS_ts_bilateral_args(ARG) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, f32, from, none) /* irradiance */ \
	ARG(OUT, f32, to, none) \
	ARG(VALUE, u32, width, none) \
	ARG(VALUE, u32, height, none) \
	ARG(VALUE, u32, radius, none)  /* pixels; a deviation is half of it */ \
	ARG(VALUE, u32, columns, none) /* not 0: along columns, not along rows */
TS_ARGS(ts_bilateral_args);

/* Minus the logarithm of a neighbour's weight, except for the part that depends on the distance in pixels. */
TS_FN f32 ts_k_bilateral_apart(TS_GLOBAL const ts_gpixel *a, TS_GLOBAL const ts_gpixel *b)
{
	ts_v3 n = ts_load3(a->normal);
	ts_v3 way = ts_normalize(ts_sub(ts_load3(b->position), ts_load3(a->position)));
	f32 sine = ts_dot(n, way);
	f32 square = sine * sine;
	f32 plane = square * TS_BILATERAL_PLANE;
	f32 bent = 1.0f - ts_dot(n, ts_load3(b->normal));
	f32 normal = bent * TS_BILATERAL_NORMAL;
	return plane + normal;
}

TS_FN f32 ts_k_bilateral_weight(const ts_bilateral_args *args, u64 a, u64 b, i32 k)
{
	if (k == 0) return 1.0f;
	f32 steps = (f32)(2 * k) / (f32)args->radius;
	f32 square = steps * steps;
	f32 far = square * 0.5f;
	f32 apart = ts_k_bilateral_apart(&args->pixels[a], &args->pixels[b]);
	return ts_flush(ts_exp(-(far + apart)));
}

/* map over pixels and their samples: each sample's picture is filtered by itself */
TS_FN void ts_k_bilateral_item(const ts_bilateral_args *args, u64 i)
{
	/* Find the neighbours along the row or column: as far as the radius reaches, and within the image. */
	i32 place = (i32)(args->columns != 0u ? i / args->width % args->height : i % args->width);
	i32 end = (i32)(args->columns != 0u ? args->height : args->width);
	i64 step = args->columns != 0u ? (i64)args->width : 1;
	i32 low = ts_max_i32(-(i32)args->radius, -place);
	i32 high = ts_min_i32((i32)args->radius, end - 1 - place);
	/* Sum them by their weights (MegaViews 5.1); the sky has no light and takes no part. */
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	f32 weights = 0.0f;
	bool sky = args->pixels[i].depth == TS_SKY;
	for (i32 k = low; k <= high && !sky; k++) {
		u64 other = (u64)((i64)i + k * step);
		if (args->pixels[other].depth == TS_SKY) continue;
		f32 weight = ts_k_bilateral_weight(args, i, other, k);
		sum = ts_mad(sum, ts_load3(args->from + other * 3u), weight);
		weights = weights + weight;
	}
	/* Divide by the sum of weights, which is at least 1, the weight of the pixel itself. */
	f32 divisor = sky ? 1.0f : weights;
	ts_store3(args->to + i * 3u, ts_v3_make(sum.x / divisor, sum.y / divisor, sum.z / divisor));
}

#endif
