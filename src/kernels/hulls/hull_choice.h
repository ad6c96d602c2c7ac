/* The box whose lobes light a pixel (SSAGH section 3; METHODS 11). If several boxes of the pixel's block contain its
 * column, row and depth, the thinnest in depth is chosen, and among equally thin ones that of the least label; the
 * paper names no order. If no box contains the pixel, hull.surface=robust chooses a box that covers the pixel and,
 * widened by t (1 - zn), zn the pixel's, contains its depth; failing that, the box nearest in depth of those that cover
 * the pixel; failing that, the box nearest in depth of the block, then of the blocks around it, ring by ring. */
#ifndef TS_KERNELS_HULLS_HULL_CHOICE_H
#define TS_KERNELS_HULLS_HULL_CHOICE_H
#include "kernels/base/args.h"
#include "kernels/hulls/depth_grid.h"

#define TS_ROWS_ts_choice_args(ARG) \
	ARG(IN, u32, offset, segment_box_offset) \
	ARG(IN, ts_segment, boxes, segment_box) \
	ARG(VALUE, u32, grid, none) \
	ARG(VALUE, u32, robust, none) \
	ARG(VALUE, f32, step, none) /* t */
TS_ARGS(ts_choice_args);

/* A texel of the grid and a depth in it. */
typedef struct {
	u32 x, y;
	f32 depth;
} ts_grid_place;

/* Ranks of a box: 0 it contains the place, 1 it contains the place if widened, 2 it covers the place, 3 it lies
 * elsewhere. The measure is the box's thickness for ranks 0 and 1, otherwise the gap in depth between box and place.
 * The least rank wins, then the least measure, then the first box. */
typedef struct {
	u32 box, rank;
	f32 measure;
} ts_choice;

TS_FN void ts_k_choice_offer(const ts_choice_args *args, ts_grid_place at, u32 b, ts_choice *best)
{
	TS_GLOBAL const ts_segment *box = &args->boxes[b];
	bool covers = at.x >= box->low[0] && at.x <= box->high[0] && at.y >= box->low[1] && at.y <= box->high[1];
	f32 gap = ts_max(ts_max(box->nearest - at.depth, at.depth - box->farthest), 0.0f);
	f32 slack = args->step * (1.0f - at.depth);
	u32 rank = !covers ? 3u : gap > slack ? 2u : gap > 0.0f ? 1u : 0u;
	f32 measure = rank < 2u ? box->farthest - box->nearest : gap;
	if (rank > best->rank || (rank == best->rank && !(measure < best->measure))) return;
	best->box = b;
	best->rank = rank;
	best->measure = measure;
}

TS_FN void ts_k_choice_block(const ts_choice_args *args, ts_grid_place at, u32 block, ts_choice *best)
{
	u64 first = (u64)block * TS_BLOCK_TEXELS;
	u32 end = args->offset[first + TS_BLOCK_TEXELS];
	for (u32 b = args->offset[first]; b < end; b++) ts_k_choice_offer(args, at, b, best);
}

/* Offers the boxes of the blocks at distance `ring`, row by row. */
TS_FN void ts_k_choice_ring(const ts_choice_args *args, ts_grid_place at, i32 ring, ts_choice *best)
{
	i32 side = (i32)(args->grid / TS_BLOCK);
	i32 x = (i32)(at.x / TS_BLOCK);
	i32 y = (i32)(at.y / TS_BLOCK);
	for (i32 j = ts_max_i32(y - ring, 0); j <= ts_min_i32(y + ring, side - 1); j++) {
		i32 stride = ring == 0 || j == y - ring || j == y + ring ? 1 : 2 * ring;
		for (i32 i = x - ring; i <= x + ring; i += stride) {
			if (i >= 0 && i < side) ts_k_choice_block(args, at, (u32)(j * side + i), best);
		}
	}
}

/* The index of the box, or TS_NONE. */
TS_FN u32 ts_k_choose_box(const ts_choice_args *args, ts_grid_place at)
{
	i32 rings = args->robust != 0u ? (i32)(args->grid / TS_BLOCK) : 1;
	/* Start with what a box must beat: robust takes any rank; by the paper rank 0 alone, as no measure is below 0. */
	ts_choice best;
	best.box = TS_NONE;
	best.rank = args->robust != 0u ? 4u : 1u;
	best.measure = 0.0f;
	for (i32 ring = 0; ring < rings && best.box == TS_NONE; ring++) ts_k_choice_ring(args, at, ring, &best);
	return best.box;
}

#endif
