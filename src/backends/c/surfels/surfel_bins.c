/* Bins of surfels, filled by all threads. */
#include "surfel_bins.h"
#include <stdlib.h>

enum { TILE = 64, MOST_TILES_A_SURFEL = 16 };

static ts_surfel_span span_of(const ts_disc *disc)
{
	ts_surfel_span r = {{0, 0}, {-1, -1}};
	if (disc->low[0] > disc->high[0] || disc->low[1] > disc->high[1]) return r;
	for (u32 axis = 0; axis < 2; axis++) {
		r.first[axis] = (int16_t)(disc->low[axis] / TILE);
		r.last[axis] = (int16_t)(disc->high[axis] / TILE);
	}
	return r;
}

/* Counts the surfels of a lot or, where there is room for them, puts them there. */
static void bin_lot(ts_surfel_bins *b, u32 lot)
{
	u64 *place = b->place + (u64)lot * b->n_tiles;
	for (u64 i = b->n * lot / b->n_lots; i < b->n * (lot + 1) / b->n_lots; i++) {
		if (b->surfel == NULL) b->spans[i] = span_of(&b->discs[i]);
		ts_surfel_span s = b->spans[i];
		for (i32 y = s.first[1]; y <= s.last[1]; y++) {
			for (i32 x = s.first[0]; x <= s.last[0]; x++) {
				u64 at = place[(u32)y * b->n_columns + (u32)x]++;
				if (b->surfel != NULL) b->surfel[at] = (u32)i;
			}
		}
	}
}

/* From numbers to places; returns their sum. */
static u64 scan_lots(ts_surfel_bins *b)
{
	u64 sum = 0;
	for (u32 tile = 0; tile < b->n_tiles; tile++) {
		for (u32 lot = 0; lot < b->n_lots; lot++) {
			u64 *place = &b->place[(u64)lot * b->n_tiles + tile], n = *place;
			*place = sum;
			sum += n;
		}
	}
	return sum;
}

static void bin_lots(ts_surfel_bins *b)
{
#pragma omp parallel for schedule(static, 1) num_threads(b->n_lots)
	for (i64 lot = 0; lot < (i64)b->n_lots; lot++) bin_lot(b, (u32)lot);
}

void ts_surfel_bins_free(ts_surfel_bins *b)
{
	free(b->place);
	free(b->spans);
	free(b->surfel);
}

bool ts_surfel_bins_make(ts_surfel_bins *b, const ts_view *view, const ts_disc *discs, u64 n, u32 threads)
{
	*b = (ts_surfel_bins){.discs = discs, .n = n, .n_lots = threads, .n_columns = ((u32)view->width + TILE - 1) / TILE};
	b->n_tiles = b->n_columns * (((u32)view->height + TILE - 1) / TILE);
	b->place = calloc((size_t)b->n_lots * b->n_tiles, sizeof *b->place);
	b->spans = malloc((size_t)(n + 1) * sizeof *b->spans);
	if (b->place == NULL || b->spans == NULL) return false;
	bin_lots(b);
	u64 sum = scan_lots(b);
	if (sum <= n * MOST_TILES_A_SURFEL) b->surfel = malloc((size_t)(sum + 1) * sizeof *b->surfel);
	if (b->surfel != NULL) bin_lots(b);
	return b->surfel != NULL;
}

/* Where the last lot ends. */
u64 ts_surfel_bin_end(const ts_surfel_bins *b, u32 tile) { return b->place[(u64)(b->n_lots - 1) * b->n_tiles + tile]; }

u64 ts_surfel_bin_begin(const ts_surfel_bins *b, u32 tile) { return tile > 0 ? ts_surfel_bin_end(b, tile - 1) : 0; }

ts_disc ts_surfel_bins_disc(const ts_surfel_bins *b, u32 tile, u32 surfel)
{
	ts_disc disc = b->discs[surfel];
	i32 corner[2] = {(i32)(tile % b->n_columns * TILE), (i32)(tile / b->n_columns * TILE)};
	for (u32 axis = 0; axis < 2; axis++) {
		disc.low[axis] = ts_max_i32(disc.low[axis], corner[axis]);
		disc.high[axis] = ts_min_i32(disc.high[axis], corner[axis] + TILE - 1);
	}
	return disc;
}
