/* The boxes of the segments in columns, rows and depth (SSAGH section 3; METHODS 11). Least and greatest values are
 * integer minima, since floats from +0 on sort like their bits. The list of boxes then has one for each label that some
 * texel has, except the sky's. */
#ifndef TS_KERNELS_HULLS_SEGMENT_BOX_H
#define TS_KERNELS_HULLS_SEGMENT_BOX_H
#include "kernels/base/args.h"
#include "kernels/hulls/segment.h"

#define TS_RANGE 6u /* least column, row and their complements, bits of depth and their complement */
#define TS_SKY_BITS 0x3f800000u

#define TS_ROWS_ts_segment_extent_args(ARG) \
	ARG(IN, f32, depths, depth_grid_depth) \
	ARG(IN, u32, labels, segment_label) \
	ARG(MIN, u32, least, segment_extent) \
	ARG(VALUE, u32, grid, none)
TS_ARGS(ts_segment_extent_args);

/* scatter over texels of the grid: skips updates that a neighbour of the same segment makes needless */
TS_FN void ts_k_segment_extent_item(const ts_segment_extent_args *args, u64 i)
{
	/* Find the segment of the texel. */
	u32 x = (u32)(i % args->grid);
	u32 y = (u32)(i / args->grid);
	u32 label = args->labels[i];
	u64 segment = (u64)ts_k_block_of(args->grid, x, y) * TS_BLOCK_TEXELS + label;
	TS_GLOBAL u32 *least = args->least + segment * TS_RANGE;
	/* See which neighbours in the block are of the same segment. */
	bool left = x % TS_BLOCK > 0u && args->labels[i - 1u] == label;
	bool above = y % TS_BLOCK > 0u && args->labels[i - args->grid] == label;
	bool right = x % TS_BLOCK < TS_BLOCK - 1u && args->labels[i + 1u] == label;
	bool below = y % TS_BLOCK < TS_BLOCK - 1u && args->labels[i + args->grid] == label;
	/* Update columns and rows (SSAGH 3) only at the segment's edges: a neighbour farther out makes a wider update. */
	if (!left) ts_min_u32(&least[0], x);
	if (!above) ts_min_u32(&least[1], y);
	if (!right) ts_min_u32(&least[2], ~x);
	if (!below) ts_min_u32(&least[3], ~y);
	/* Update depths as bits, which sort like the numbers (SSAGH 3), unless the left neighbour's update covers this
	 * one. */
	u32 bits = ts_f2u(args->depths[i]);
	u32 before = left ? ts_f2u(args->depths[i - 1u]) : bits;
	if (!left || bits < before) ts_min_u32(&least[4], bits);
	if (!left || bits > before) ts_min_u32(&least[5], ~bits);
}

#define TS_ROWS_ts_segment_box_args(ARG) \
	ARG(IN, u32, least, segment_extent) \
	ARG(OUT, u32, offset, segment_box_offset) /* counts, then their prefix sums */ \
	ARG(OUT, ts_segment, boxes, segment_box) \
	ARG(TALLY, i64, n_labels, 0) /* labels that texels have */
TS_ARGS(ts_segment_box_args);

/* map over labels: 1 where there is a box */
TS_FN void ts_k_segment_box_count_item(const ts_segment_box_args *args, u64 i)
{
	TS_GLOBAL const u32 *least = args->least + i * TS_RANGE;
	bool used = least[0] != TS_NONE;
	if (used) ts_add_i64(args->n_labels, 1);
	args->offset[i] = used && least[4] < TS_SKY_BITS ? 1u : 0u;
}

/* emit over labels */
TS_FN void ts_k_segment_box_item(const ts_segment_box_args *args, u64 i)
{
	/* Leave out labels without a box. */
	if (args->offset[i + 1u] == args->offset[i]) return;
	/* Store the extent; greatest values were kept as complements. */
	TS_GLOBAL const u32 *least = args->least + i * TS_RANGE;
	TS_GLOBAL ts_segment *box = &args->boxes[args->offset[i]];
	box->low[0] = least[0];
	box->low[1] = least[1];
	box->high[0] = ~least[2];
	box->high[1] = ~least[3];
	box->nearest = ts_put(ts_u2f(least[4]));
	box->farthest = ts_put(ts_u2f(~least[5]));
	/* Name the block and the label, by which the list is sorted. */
	box->label = (u32)i;
	box->pad = 0u;
}

#endif
