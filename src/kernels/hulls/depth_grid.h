/* The depth grid: the screen's depth down-sampled to G x G, G a multiple of 32, in blocks of 32 x 32 (SSAGH section 3).
 * Columns and rows may be scaled differently. A texel shows the pixel at the texel's centre; a pixel lies in the texel
 * at the pixel's centre (METHODS 11). */
#ifndef TS_KERNELS_HULLS_DEPTH_GRID_H
#define TS_KERNELS_HULLS_DEPTH_GRID_H
#include "kernels/base/args.h"
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

#define TS_BLOCK 32u
#define TS_BLOCK_TEXELS 1024u

/* floor((i + 1/2) to / from) */
TS_FN u32 ts_k_resample(u32 i, u32 from, u32 to) { return (u32)((((u64)i * 2u + 1u) * to) / ((u64)from * 2u)); }

TS_FN u32 ts_k_block_of(u32 grid, u32 x, u32 y) { return (y / TS_BLOCK) * (grid / TS_BLOCK) + x / TS_BLOCK; }

/* The column or row of texels at whose pixels the right or lower corners of a box gather: the last of the box, or the
 * next one, where the rectangle of the box ends, if the grid has it. */
TS_FN u32 ts_k_box_end(u32 high, u32 grid, u32 rectangle)
{
	return rectangle != 0u && high + 1u < grid ? high + 1u : high;
}

/* Texel (x, y) of a block. */
TS_FN u64 ts_k_block_texel(u32 grid, u32 block, u32 x, u32 y)
{
	u32 blocks = grid / TS_BLOCK;
	u64 row = (u64)(block / blocks) * TS_BLOCK + y;
	return row * grid + (u64)(block % blocks) * TS_BLOCK + x;
}

/* The pixel that a texel shows. */
TS_FN u64 ts_k_grid_pixel(u32 grid, u32 width, u32 height, u32 x, u32 y)
{
	return (u64)ts_k_resample(y, grid, height) * width + ts_k_resample(x, grid, width);
}

#define TS_ROWS_ts_depth_grid_args(ARG) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(OUT, f32, depths, depth_grid_depth) \
	ARG(VALUE, u32, grid, none) \
	ARG(VALUE, u32, width, none) \
	ARG(VALUE, u32, height, none)
TS_ARGS(ts_depth_grid_args);

/* map over texels of the grid */
TS_FN void ts_k_depth_grid_item(const ts_depth_grid_args *args, u64 i)
{
	u32 x = (u32)(i % args->grid);
	u32 y = (u32)(i / args->grid);
	args->depths[i] = args->pixels[ts_k_grid_pixel(args->grid, args->width, args->height, x, y)].depth;
}

#endif
