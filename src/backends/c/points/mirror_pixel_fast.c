/* Fast path of reflective pixels, with the same bits: each is glanced at once, and its neighbours reuse that; pixels of
 * one material are glanced at together. */
#include <omp.h>
#include <stdlib.h>
#include "backends/c/raster/fragment_batch.h"
#include "backends/fast.h"
#include "kernels/points/mirror_pixel.h"
#include "model/core.h"

enum { BAND = 32, RING = 3 };

typedef struct {
	ts_glance glance;
	ts_v3 tint;
	u32 reflector; /* TS_NONE: no reflector is seen */
} seen;

/* What a thread works with. */
typedef struct {
	ts_surface_bins bins;
	ts_fragment_batch fragments;
} worker;

/* Rows of the picture of a sample that a thread works on; row y is in place y % RING. */
typedef struct {
	const ts_mirror_pixel_args *args;
	worker *worker;
	ts_eye_place at;
	seen *row[RING];
} band;

/* Where a row of glances goes. */
typedef struct {
	seen *row;
} sink;

/* Like ts_k_glance. */
static void keep(const void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const sink *to = user;
	for (u32 i = 0; i < of->n; i++) {
		ts_surface s = ts_surface_lane(of, found, i);
		seen *at = &to->row[of->place[i]];
		at->glance.seen = true;
		at->glance.p = s.p;
		at->glance.n = ts_k_facing_normal(&s, ts_sub(ts_lane3(&of->viewer, i), s.p));
		at->tint = s.base;
	}
}

static void see_row(band *b, i32 y)
{
	const ts_mirror_pixel_args *args = b->args;
	worker *w = b->worker;
	sink to = {b->row[y % RING]};
	u64 first = b->at.first + (u64)y * (u64)b->at.view.width;
	ts_surface_bins_begin(&w->bins, &args->scene, keep, &to);
	for (i32 x = 0; x < b->at.view.width; x++) {
		u64 i = first + (u64)x;
		to.row[x].reflector = TS_NONE;
		if (args->offset[i + 1] == args->offset[i]) continue;
		to.row[x].reflector = ts_k_seen_reflector(&args->scene, args->depth_triangle[i]);
		ts_fragment_add(&w->fragments, (u32)args->depth_triangle[i], x, y, (u64)x);
		if (w->fragments.n == TS_ABREAST) ts_fragments_ask(&w->fragments, &w->bins, &b->at.view, NULL);
	}
	ts_fragments_ask(&w->fragments, &w->bins, &b->at.view, NULL);
	ts_surface_bins_flush(&w->bins);
}

/* The glance at (x, y), if the reflector there is the same. */
static ts_glance glance_at(const band *b, i32 x, i32 y, u32 reflector)
{
	static const ts_glance unseen = {.seen = false};
	if (x < 0 || y < 0 || x >= b->at.view.width || y >= b->at.view.height) return unseen;
	const seen *at = &b->row[y % RING][x];
	return at->reflector == reflector ? at->glance : unseen;
}

static void write_row(const band *b, i32 y)
{
	for (i32 x = 0; x < b->at.view.width; x++) {
		const seen *here = &b->row[y % RING][x];
		u32 r = here->reflector;
		if (r == TS_NONE) continue;
		const ts_glance glance[TS_N_GLANCES] = {[TS_HERE] = here->glance,
		                                        [TS_LEFT] = glance_at(b, x - 1, y, r),
		                                        [TS_RIGHT] = glance_at(b, x + 1, y, r),
		                                        [TS_ABOVE] = glance_at(b, x, y - 1, r),
		                                        [TS_BELOW] = glance_at(b, x, y + 1, r)};
		u64 i = b->at.first + (u64)y * (u64)b->at.view.width + (u64)x;
		ts_k_mirror_pixel_write(b->args, i, glance, here->tint, b->at.view.side);
	}
}

/* Writes rows from `first` on, of the pictures of all samples, one below the other. */
static void write_band(const ts_mirror_pixel_args *args, worker *w, seen *room, i64 first)
{
	i32 width = args->view->width, height = args->view->height;
	band b = {.args = args, .worker = w, .at = ts_k_eye_place(args->view, args->samples, (u64)first * (u64)width)};
	i32 begin = b.at.y, end = begin + BAND < height ? begin + BAND : height;
	for (i32 k = 0; k < RING; k++) b.row[k] = room + (i64)k * width;
	for (i32 y = begin > 0 ? begin - 1 : 0; y < end; y++) {
		if (y < begin || y == 0) see_row(&b, y);
		if (y + 1 < height) see_row(&b, y + 1);
		if (y >= begin) write_row(&b, y);
	}
}

bool ts_c_fast_mirror_pixel(const void *of, u64 n, u32 threads)
{
	const ts_mirror_pixel_args *args = of;
	i64 width = args->view->width, height = args->view->height, bands = (height + BAND - 1) / BAND;
	i64 n_bands = n > 0 ? (i64)n / (width * height) * bands : 0;
	seen *room = ts_alloc((size_t)threads * RING * (size_t)width, sizeof *room, "rows of reflective pixels");
	worker *workers = ts_alloc(threads, sizeof *workers, "surfaces of reflective pixels");
	bool enough = room != NULL && workers != NULL;
	for (u32 t = 0; enough && t < threads; t++) workers[t].fragments.n = 0;
	if (!enough) n_bands = 0;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(static, 1) num_threads(threads)
	for (i64 k = 0; k < n_bands; k++) {
		if (ts_stopped(stop)) continue;
		i32 t = omp_get_thread_num();
		write_band(args, &workers[t], room + t * RING * width, k / bands * height + k % bands * BAND);
	}
	free(workers);
	free(room);
	return enough;
}

#include "backends/selftest.h"
