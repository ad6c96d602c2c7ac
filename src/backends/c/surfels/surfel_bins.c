/* Bins of surfels, filled by all threads. */
#include "backends/c/surfels/surfel_bins.h"
#include <math.h>
#include <stdlib.h>
#include "kernels/surfels/surfel_setup.h"
#include "model/core.h"

enum { TILE = TS_SURFEL_TILE, MOST_TILES_A_SURFEL = 16, FEW_TILES = 4 };

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

static i64 box_pixels(const ts_disc *disc)
{
	i64 columns = (i64)disc->high[0] - disc->low[0] + 1, rows = (i64)disc->high[1] - disc->low[1] + 1;
	return columns > 0 && rows > 0 ? columns * rows : 0;
}

/* Columns first to last of a row of tiles, from the centre of a surfel: the middle and half the sides, in pixels. */
typedef struct {
	double x, y, half_x, half_y;
} box;

static box box_of(const ts_disc *disc, i32 first, i32 last, i32 row)
{
	box r = {.half_x = (last - first + 1) * (TILE / 2), .half_y = TILE / 2};
	r.x = first * TILE + r.half_x - disc->pixel[0] - (double)disc->fraction[0];
	r.y = row * TILE + r.half_y - disc->pixel[1] - (double)disc->fraction[1];
	return r;
}

/* A linear function of pixels. */
typedef struct {
	double at, by_x, by_y; /* at the middle of a box */
} linear;

static linear mix(double p, linear a, double q, linear b)
{
	return (linear){p * a.at + q * b.at, p * a.by_x + q * b.by_x, p * a.by_y + q * b.by_y};
}

static linear linear_in(const box *in, double constant, const f32 by[2])
{
	return (linear){constant + (double)by[0] * in->x + (double)by[1] * in->y, (double)by[0], (double)by[1]};
}

/* The greatest magnitude of any of its terms. */
static double greatest(const box *in, linear f)
{
	return fabs(f.by_x) * (fabs(in->x) + in->half_x) + fabs(f.by_y) * (fabs(in->y) + in->half_y);
}

/* Whether pixels of a box may be in the ellipse, of rays P = W (a, b) with |P| <= W where W = 1 + G.d. They cannot if
 * the component of P along its direction in the middle exceeds W in all of the box, by more than 64 times the rounding
 * error. */
static bool may_meet(const ts_disc *disc, const box *in)
{
	const double rounding = 0x1p-16, sane = 0x1p100;
	static const f32 level[2] = {0, 0};
	bool crosses = (disc->flags & TS_DISC_CROSSES) != 0, parallel = (disc->flags & TS_DISC_PARALLEL) != 0;
	double ca = crosses ? (double)disc->conic[0] : 0, cb = crosses ? (double)disc->conic[1] : 0;
	linear w = linear_in(in, 1, parallel ? level : disc->g);
	linear a = linear_in(in, 0, disc->a), b = linear_in(in, 0, disc->b);
	double terms = 1 + greatest(in, a) + greatest(in, b) + greatest(in, w);
	double error = rounding * terms * (1 + fabs(ca) + fabs(cb));
	a = mix(1, a, ca, w);
	b = mix(1, b, cb, w);
	double length = sqrt(a.at * a.at + b.at * b.at);
	if (!(length > 0) || !(error < sane)) return true;
	linear beyond = mix(1, mix(a.at / length, a, b.at / length, b), -1, w);
	return !(beyond.at - fabs(beyond.by_x) * in->half_x - fabs(beyond.by_y) * in->half_y > error);
}

static bool touches(const ts_surfel_bins *b, const ts_disc *disc, i32 first, i32 last, i32 row)
{
	box in = box_of(disc, first, last, row);
	bool near = fabs(in.x) - in.half_x <= b->reach && fabs(in.y) - in.half_y <= b->reach;
	return near || may_meet(disc, &in);
}

/* Counts a surfel in its tiles or, where there is room, lists it there. A surfel with many tiles is listed only in
 * those that it may touch: one that comes to the eye's plane has the image as its box, however little it covers. */
static void bin(const ts_surfel_bins *b, u64 *place, u32 surfel)
{
	const ts_disc *disc = &b->discs[surfel];
	ts_surfel_span s = b->spans[surfel];
	bool many = (s.last[0] - s.first[0] + 1) * (s.last[1] - s.first[1] + 1) > FEW_TILES;
	for (i32 y = s.first[1]; y <= s.last[1]; y++) {
		if (many && !touches(b, disc, s.first[0], s.last[0], y)) continue;
		for (i32 x = s.first[0]; x <= s.last[0]; x++) {
			if (many && !touches(b, disc, x, x, y)) continue;
			u64 at = place[(u32)y * b->n_columns + (u32)x]++;
			if (b->surfel != NULL) b->surfel[at] = surfel;
		}
	}
}

static void bin_lot(ts_surfel_bins *b, u32 lot, ts_stop *stop)
{
	u64 *place = b->place + (u64)lot * b->n_tiles;
	i64 pixels = 0;
	for (u64 i = b->n * lot / b->n_lots; i < b->n * (lot + 1) / b->n_lots && !ts_stopped(stop); i++) {
		if (b->surfel == NULL) {
			b->spans[i] = span_of(&b->discs[i]);
			pixels += box_pixels(&b->discs[i]);
		}
		bin(b, place, (u32)i);
	}
	ts_add_i64(&b->pixels, pixels);
}

/* Turns numbers into places; returns their sum. */
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
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(static, 1) num_threads(b->n_lots)
	for (i64 lot = 0; lot < (i64)b->n_lots; lot++) bin_lot(b, (u32)lot, stop);
}

void ts_surfel_bins_free(ts_surfel_bins *b)
{
	free(b->place);
	free(b->spans);
	free(b->surfel);
}

bool ts_surfel_bins_make(ts_surfel_bins *b, const ts_view *view, const ts_disc *discs, u64 n, double reach, u32 threads)
{
	*b = (ts_surfel_bins){.discs = discs, .n = n, .reach = reach, .n_lots = threads};
	b->n_columns = ((u32)view->width + TILE - 1) / TILE;
	b->n_tiles = b->n_columns * (((u32)view->height + TILE - 1) / TILE);
	b->place = calloc((size_t)b->n_lots * b->n_tiles, sizeof *b->place);
	b->spans = malloc((size_t)(n + 1) * sizeof *b->spans);
	if (b->place == NULL || b->spans == NULL) return false;
	bin_lots(b);
	u64 sum = scan_lots(b);
	if (sum <= n * MOST_TILES_A_SURFEL) b->surfel = malloc((size_t)(sum + TS_SURFELS_AHEAD) * sizeof *b->surfel);
	if (b->surfel == NULL) return false;
	memset(b->surfel + sum, 0, TS_SURFELS_AHEAD * sizeof *b->surfel);
	bin_lots(b);
	return true;
}

/* Where the last lot ends. */
u64 ts_surfel_bin_end(const ts_surfel_bins *b, u32 tile) { return b->place[(u64)(b->n_lots - 1) * b->n_tiles + tile]; }

u64 ts_surfel_bin_begin(const ts_surfel_bins *b, u32 tile) { return tile > 0 ? ts_surfel_bin_end(b, tile - 1) : 0; }

#include "backends/selftest.h"
