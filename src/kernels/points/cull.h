/* Stochastic culling: a piece with an area A below a tenth of a pixel is dropped with probability 1 - 10 A (EPR section
 * 3.2; METHODS 2). The same triangles are dropped in every frame. */
#ifndef TS_KERNELS_POINTS_CULL_H
#define TS_KERNELS_POINTS_CULL_H
#include "kernels/base/area.h"
#include "kernels/base/args.h"
#include "kernels/base/records.h"

#define TS_ROWS_ts_cull_args(ARG) \
	ARG(IN, ts_piece, pieces, split_piece) \
	ARG(IN, f32, scale, split_density) \
	ARG(OUT, u32, keep, cull_keep) \
	ARG(VALUE, f32, unit, none) /* samples per pixel side: below 1 for the eye's pixels, 1 for samples */ \
	ARG(VALUE, u32, seed, none) \
	ARG(VALUE, u32, enabled, none)
TS_ARGS(ts_cull_args);

#define TS_STREAM_CULL 1u

/* The probability of being dropped, in steps of 2^-24; 0 from a tenth of a pixel up. */
TS_FN i32 ts_k_cull_threshold(f32 pixels)
{
	f32 p = 1.0f - 10.0f * pixels;
	return ts_max_i32(ts_fix(p, 24, 25), 0);
}

/* The piece's area in pixels. */
TS_FN f32 ts_k_cull_pixels(const ts_cull_args *args, u64 i)
{
	TS_GLOBAL const ts_piece *piece = &args->pieces[i];
	f32 s = args->scale[i] / args->unit;
	return (ts_k_area(ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c)) * s) * s;
}

/* The piece's random number, in steps of 2^-24. */
TS_FN i32 ts_k_cull_chance(const ts_cull_args *args, u64 i)
{
	TS_GLOBAL const ts_piece *piece = &args->pieces[i];
	u32 id = piece->path == 1u ? piece->triangle : piece->triangle ^ ts_pcg(piece->path);
	return (i32)(ts_random(id, TS_STREAM_CULL, args->seed) >> 8);
}

/* map over pieces */
TS_FN void ts_k_cull_item(const ts_cull_args *args, u64 i)
{
	bool drop = args->enabled != 0u && ts_k_cull_chance(args, i) < ts_k_cull_threshold(ts_k_cull_pixels(args, i));
	args->keep[i] = args->scale[i] > 0.0f && !drop ? 1u : 0u;
}

#endif
