/* Depth segments of each block of the grid (SSAGH section 3, algorithm 1; METHODS 11). Two neighbours are apart, going
 * from depth d_c to d_n, if |d_c - d_n| > t (1 - d_c): since 1 - zn is proportional to 1 / z, this is a relative step
 * of axial depth. The sky, 1, is apart from everything else. */
#ifndef TS_KERNELS_HULLS_SEGMENT_H
#define TS_KERNELS_HULLS_SEGMENT_H
#include "kernels/base/args.h"
#include "kernels/hulls/depth_grid.h"

#define TS_ROWS_ts_segment_args(ARG) \
	ARG(IN, f32, depths, depth_grid_depth) \
	ARG(OUT, u32, labels, segment_label) \
	ARG(VALUE, u32, grid, none) \
	ARG(VALUE, u32, sweep, none) /* 0 right, 1 down, 2 left, 3 up */ \
	ARG(VALUE, f32, step, none)  /* t */
TS_ARGS(ts_segment_args);

TS_FN bool ts_k_is_apart(f32 from, f32 to, f32 step)
{
	f32 room = step * (1.0f - from);
	return ts_abs(from - to) > room;
}

/* map over lines of blocks: one sweep along each (SSAGH algorithm 1). At first the label of a texel is its own place in
 * the block, 32 y + x. */
TS_FN void ts_k_segment_item(const ts_segment_args *args, u64 i)
{
	/* Choose the line of the block and the direction of the sweep (Propagate in SSAGH algorithm 1). */
	u32 block = (u32)(i / TS_BLOCK);
	u32 line = (u32)(i % TS_BLOCK);
	bool along_rows = (args->sweep & 1u) == 0u;
	f32 before = 0.0f;
	u32 label = 0u;
	for (u32 k = 0u; k < TS_BLOCK; k++) {
		/* Step to the next texel of the line. */
		u32 along = args->sweep < 2u ? k : TS_BLOCK - 1u - k;
		u32 x = along_rows ? along : line;
		u32 y = along_rows ? line : along;
		u64 at = ts_k_block_texel(args->grid, block, x, y);
		/* Carry the label on, or take the texel's own label beyond a step of depth (SwapLabel in SSAGH algorithm 1). */
		u32 own = args->sweep == 0u ? y * TS_BLOCK + x : args->labels[at];
		f32 depth = args->depths[at];
		label = k == 0u || ts_k_is_apart(before, depth, args->step) ? own : label;
		args->labels[at] = label;
		before = depth;
	}
}

/* map over texels: every block is one segment, the sky included */
TS_FN void ts_k_segment_none_item(const ts_segment_args *args, u64 i) { args->labels[i] = 0u; }

/* The root of a texel's segment. Labels are links to lesser places; the label of a root is its own place. */
TS_FN u32 ts_k_segment_root(const ts_segment_args *args, u32 block, u32 place)
{
	u32 label = args->labels[ts_k_block_texel(args->grid, block, place % TS_BLOCK, place / TS_BLOCK)];
	while (label < place) {
		place = label;
		label = args->labels[ts_k_block_texel(args->grid, block, place % TS_BLOCK, place / TS_BLOCK)];
	}
	return place;
}

/* Joins two neighbours if a sweep in either direction joins them. */
TS_FN void ts_k_segment_join(const ts_segment_args *args, u32 block, u32 p, u32 q)
{
	f32 a = args->depths[ts_k_block_texel(args->grid, block, p % TS_BLOCK, p / TS_BLOCK)];
	f32 b = args->depths[ts_k_block_texel(args->grid, block, q % TS_BLOCK, q / TS_BLOCK)];
	if (ts_k_is_apart(a, b, args->step) && ts_k_is_apart(b, a, args->step)) return;
	u32 x = ts_k_segment_root(args, block, p);
	u32 y = ts_k_segment_root(args, block, q);
	u32 less = x < y ? x : y;
	u32 more = x < y ? y : x;
	args->labels[ts_k_block_texel(args->grid, block, more % TS_BLOCK, more / TS_BLOCK)] = less;
}

/* map over blocks: the connected components, each labelled by its least place, with the union-find (He, Chao and Suzuki
 * 2008) that the paper leaves out, since threads contend for it */
TS_FN void ts_k_segment_components_item(const ts_segment_args *args, u64 i)
{
	u32 block = (u32)i;
	for (u32 p = 0u; p < TS_BLOCK_TEXELS; p++) {
		args->labels[ts_k_block_texel(args->grid, block, p % TS_BLOCK, p / TS_BLOCK)] = p;
		if (p % TS_BLOCK != 0u) ts_k_segment_join(args, block, p, p - 1u);
		if (p >= TS_BLOCK) ts_k_segment_join(args, block, p, p - TS_BLOCK);
	}
	for (u32 p = 0u; p < TS_BLOCK_TEXELS; p++) {
		u64 at = ts_k_block_texel(args->grid, block, p % TS_BLOCK, p / TS_BLOCK);
		args->labels[at] = ts_k_segment_root(args, block, p);
	}
}

#endif
