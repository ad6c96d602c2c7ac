/* Margins of segment.h, for ports that round otherwise (PORTING 7): how near the segments of a block were to others.
 * This second pass takes depths as given and changes no decision. If a port decides the test of two neighbours
 * otherwise, the labels of all texels that are connected with either may change, with sweeps as well as with
 * components; the rest of the block keeps its labels. */
#ifndef TS_KERNELS_HULLS_SEGMENT_MARGIN_H
#define TS_KERNELS_HULLS_SEGMENT_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/hulls/segment.h"

#define TS_MARGIN_FAR 1048576.0f /* in 8 ulps: the distance of a number from 0 */
#define TS_BLOCK_PAIRS 2048u     /* pairs of neighbours, and of texels with places beyond the block */

#define TS_ROWS_ts_segment_margin_args(ARG) \
	ARG(IN, f32, depths, depth_grid_depth) \
	ARG(OUT, f32, margin, segment_margin) \
	ARG(VALUE, u32, grid, none) \
	ARG(VALUE, f32, step, none) /* t */
TS_ARGS(ts_segment_margin_args);

/* The distance of two numbers that are not negative, in 8 ulps of the greater. Two zeros are far apart, since neither
 * was rounded. */
TS_FN f32 ts_k_margin_between(f32 a, f32 b)
{
	f32 most = ts_max(a, b);
	return most > 0.0f ? (ts_abs(a - b) / most) * TS_MARGIN_FAR : TS_MARGIN_FAR;
}

TS_FN f32 ts_k_apart_margin(f32 from, f32 to, f32 step)
{
	f32 room = step * (1.0f - from);
	return ts_k_margin_between(ts_abs(from - to), room);
}

/* Two neighbours of a block, as texels of the grid; `is` is false if the second lies in another block. */
typedef struct {
	u64 p, q;
	bool is;
} ts_neighbours;

/* Pair k: a texel, row by row, and the texel to its right (k even) or below it (k odd). */
TS_FN ts_neighbours ts_k_neighbours(u32 grid, u32 block, u32 k)
{
	u32 x = (k / 2u) % TS_BLOCK;
	u32 y = (k / 2u) / TS_BLOCK;
	u32 right = x + 1u - k % 2u;
	u32 below = y + k % 2u;
	ts_neighbours r;
	r.is = right < TS_BLOCK && below < TS_BLOCK;
	r.p = ts_k_block_texel(grid, block, x, y);
	r.q = r.is ? ts_k_block_texel(grid, block, right, below) : r.p;
	return r;
}

TS_FN void ts_k_segment_margin_pair(const ts_segment_margin_args *args, const ts_neighbours *pair)
{
	f32 a = args->depths[pair->p];
	f32 b = args->depths[pair->q];
	f32 margin = ts_put(ts_min(ts_k_apart_margin(a, b, args->step), ts_k_apart_margin(b, a, args->step)));
	args->margin[pair->p] = ts_min(args->margin[pair->p], margin);
	args->margin[pair->q] = ts_min(args->margin[pair->q], margin);
}

/* Gives both texels of a connected pair the lesser of their margins; returns whether they differed. */
TS_FN bool ts_k_segment_margin_spread(const ts_segment_margin_args *args, const ts_neighbours *pair)
{
	f32 a = args->depths[pair->p];
	f32 b = args->depths[pair->q];
	f32 p = args->margin[pair->p];
	f32 q = args->margin[pair->q];
	if (p == q || (ts_k_is_apart(a, b, args->step) && ts_k_is_apart(b, a, args->step))) return false;
	args->margin[pair->p] = ts_min(p, q);
	args->margin[pair->q] = ts_min(p, q);
	return true;
}

/* map over blocks: goes forth and back over the pairs until connected texels have the least margin of their tests */
TS_FN void ts_k_segment_margin_item(const ts_segment_margin_args *args, u64 i)
{
	u32 block = (u32)i;
	bool spreads = true;
	/* Start with no test. */
	for (u32 p = 0u; p < TS_BLOCK_TEXELS; p++) {
		args->margin[ts_k_block_texel(args->grid, block, p % TS_BLOCK, p / TS_BLOCK)] = TS_MARGIN_FAR;
	}
	/* Give both texels of each pair the least margin of their tests. */
	for (u32 k = 0u; k < TS_BLOCK_PAIRS; k++) {
		ts_neighbours pair = ts_k_neighbours(args->grid, block, k);
		if (pair.is) ts_k_segment_margin_pair(args, &pair);
	}
	/* Spread the least margin over connected texels, since one test decided otherwise may give them all other labels;
	 * going forth and back needs few passes. */
	for (u32 pass = 0u; spreads; pass++) {
		spreads = false;
		for (u32 k = 0u; k < TS_BLOCK_PAIRS; k++) {
			ts_neighbours pair = ts_k_neighbours(args->grid, block, pass % 2u == 0u ? k : TS_BLOCK_PAIRS - 1u - k);
			if (pair.is && ts_k_segment_margin_spread(args, &pair)) spreads = true;
		}
	}
}

#endif
