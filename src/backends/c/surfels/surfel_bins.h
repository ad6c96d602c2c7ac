/* The surfels of each tile of an image, so that a thread can own a tile. */
#ifndef TS_BACKENDS_C_SURFELS_SURFEL_BINS_H
#define TS_BACKENDS_C_SURFELS_SURFEL_BINS_H
#include "backends/backend.h"
#include "kernels/base/num.h"

enum { TS_SURFEL_TILE = 64, TS_SURFELS_AHEAD = 8 };

/* Tiles that a surfel may touch; none if the last is before the first. */
typedef struct {
	int16_t first[2], last[2];
} ts_surfel_span;

/* Each tile lists the surfels of the first group, then of the next. A group is a range of indices, so surfels are in
 * order. */
typedef struct {
	const ts_disc *discs;
	u64 n;
	double reach;
	i64 pixels; /* of all boxes */
	u32 n_columns, n_tiles, n_lots;
	u64 *place;            /* [group][tile]: number of surfels, then the place of the next, then their end */
	u32 *surfel;           /* and TS_SURFELS_AHEAD more, of no tile */
	ts_surfel_span *spans; /* of all surfels */
} ts_surfel_bins;

/* Bins n discs of a view: a disc is in the tiles of its ellipse and of the square of half side `reach` pixels about its
 * centre. False: no memory, or discs touch 16 tiles on average. Release by ts_surfel_bins_free in either case. */
bool ts_surfel_bins_make(ts_surfel_bins *bins, const ts_view *view, const ts_disc *discs, u64 n, double reach,
                         u32 threads);
void ts_surfel_bins_free(ts_surfel_bins *bins);
/* The range in `surfel` of a tile's surfels. */
u64 ts_surfel_bin_begin(const ts_surfel_bins *bins, u32 tile);
u64 ts_surfel_bin_end(const ts_surfel_bins *bins, u32 tile);
/* A surfel, with its box cut to the tile. Prefetches a later surfel. */
static inline ts_disc ts_surfel_bins_disc(const ts_surfel_bins *b, u32 tile, u64 place)
{
	const ts_disc *later = &b->discs[b->surfel[place + TS_SURFELS_AHEAD]];
	__builtin_prefetch(later);
	__builtin_prefetch(&later->pad);
	ts_disc disc = b->discs[b->surfel[place]];
	i32 corner[2] = {(i32)(tile % b->n_columns * TS_SURFEL_TILE), (i32)(tile / b->n_columns * TS_SURFEL_TILE)};
	for (u32 axis = 0; axis < 2; axis++) {
		disc.low[axis] = ts_max_i32(disc.low[axis], corner[axis]);
		disc.high[axis] = ts_min_i32(disc.high[axis], corner[axis] + TS_SURFEL_TILE - 1);
	}
	return disc;
}

#endif
