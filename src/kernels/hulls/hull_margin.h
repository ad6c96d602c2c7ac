/* Margins of hull_choice.h, for ports that round otherwise (PORTING 7): how near the choice of a pixel's box was to
 * another. This second pass takes boxes and depths as given and changes no decision. Whether a box contains a depth
 * involves no rounding, and among boxes of equal measure the first is right; rounding matters only in the slack and
 * between measures that differ. */
#ifndef TS_KERNELS_HULLS_HULL_MARGIN_H
#define TS_KERNELS_HULLS_HULL_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/hulls/hull_choice.h"
#include "kernels/hulls/segment_margin.h"
#include "kernels/raster/gpixel.h"

#define TS_ROWS_ts_hull_margin_args(ARG) \
	ARG(INNER, ts_choice_args, choice, none) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, u32, box, hull_box) \
	ARG(OUT, f32, margin, hull_margin) \
	ARG(VALUE, u32, width, none) \
	ARG(VALUE, u32, height, none)
TS_ARGS(ts_hull_margin_args);

/* Rank and measure of a box as if no other were offered, the margin of its gap against the slack, and its thickness. */
typedef struct {
	ts_choice as;
	f32 slack_margin, thickness;
} ts_offered;

TS_FN ts_offered ts_k_offered(const ts_choice_args *args, ts_grid_place at, u32 b)
{
	TS_GLOBAL const ts_segment *box = &args->boxes[b];
	f32 gap = ts_max(ts_max(box->nearest - at.depth, at.depth - box->farthest), 0.0f);
	f32 slack = args->step * (1.0f - at.depth);
	ts_offered r;
	r.as.box = TS_NONE; /* b, once it is offered */
	r.as.rank = 4u;
	r.as.measure = 0.0f;
	ts_k_choice_offer(args, at, b, &r.as);
	r.slack_margin = r.as.rank == 1u || r.as.rank == 2u ? ts_k_margin_between(gap, slack) : TS_MARGIN_FAR;
	r.thickness = box->farthest - box->nearest;
	return r;
}

TS_FN f32 ts_k_measure_margin(f32 measure, f32 best)
{
	return measure == best ? TS_MARGIN_FAR : ts_k_margin_between(measure, best);
}

/* How near a box is to being chosen instead of the best: as it is, or widened, if the widened box nearly contains the
 * depth. */
TS_FN f32 ts_k_rival_margin(const ts_choice_args *args, ts_grid_place at, u32 b, const ts_choice *best)
{
	ts_offered rival = ts_k_offered(args, at, b);
	f32 least = TS_MARGIN_FAR;
	if (rival.as.rank == best->rank) least = ts_k_measure_margin(rival.as.measure, best->measure);
	if (rival.as.rank != 2u || best->rank == 0u) return least;
	bool thinner = best->rank == 2u || rival.thickness <= best->measure;
	f32 apart = thinner ? 0.0f : ts_k_measure_margin(rival.thickness, best->measure);
	return ts_min(least, ts_max(rival.slack_margin, apart));
}

TS_FN f32 ts_k_block_margin(const ts_choice_args *args, ts_grid_place at, u32 block, const ts_choice *best)
{
	u64 first = (u64)block * TS_BLOCK_TEXELS;
	u32 end = args->offset[first + TS_BLOCK_TEXELS];
	f32 least = TS_MARGIN_FAR;
	for (u32 b = args->offset[first]; b < end; b++) {
		if (b != best->box) least = ts_min(least, ts_k_rival_margin(args, at, b, best));
	}
	return least;
}

/* Rivals are in blocks at the distance of the box's own block; nearer blocks have no boxes. */
TS_FN f32 ts_k_choice_margin(const ts_choice_args *args, ts_grid_place at, u32 box)
{
	/* Find the ring of blocks, about the pixel's own block, in which the box was chosen. */
	i32 side = (i32)(args->grid / TS_BLOCK);
	i32 x = (i32)(at.x / TS_BLOCK);
	i32 y = (i32)(at.y / TS_BLOCK);
	u32 block = args->boxes[box].label / TS_BLOCK_TEXELS;
	i32 across = (i32)(block % (u32)side) - x;
	i32 down = (i32)(block / (u32)side) - y;
	i32 ring = ts_max_i32(ts_max_i32(across, -across), ts_max_i32(down, -down));
	/* Start with the box's margin against the slack, if only the slack admitted it. */
	ts_offered best = ts_k_offered(args, at, box);
	f32 least = best.as.rank == 1u ? best.slack_margin : TS_MARGIN_FAR;
	/* Take the least margin of all rivals, up to that ring; nearer blocks have no boxes. */
	for (i32 j = ts_max_i32(y - ring, 0); j <= ts_min_i32(y + ring, side - 1); j++) {
		for (i32 i = ts_max_i32(x - ring, 0); i <= ts_min_i32(x + ring, side - 1); i++) {
			least = ts_min(least, ts_k_block_margin(args, at, (u32)(j * side + i), &best.as));
		}
	}
	return least;
}

/* map over pixels and their samples */
TS_FN void ts_k_hull_margin_item(const ts_hull_margin_args *args, u64 i)
{
	ts_grid_place at;
	at.x = ts_k_resample((u32)(i % args->width), args->width, args->choice.grid);
	at.y = ts_k_resample((u32)(i / args->width % args->height), args->height, args->choice.grid);
	at.depth = args->pixels[i].depth;
	bool none = args->box[i] == TS_NONE;
	args->margin[i] = none ? TS_MARGIN_FAR : ts_put(ts_k_choice_margin(&args->choice, at, args->box[i]));
}

#endif
