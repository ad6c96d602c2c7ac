/* Fast path of reflective pixels, with the same bits: one glance at each, and none more by its neighbours. */
#include "../../../kernels/points/mirror_pixel.h"
#include <omp.h>
#include <stdlib.h>
#include "../../../model/core.h"
#include "../../fast.h"

enum { BAND = 32, RING = 3 };

typedef struct {
	ts_glance glance;
	u32 reflector; /* TS_NONE: none is seen */
} seen;

/* Rows of the picture of a sample that a thread works on; row y is in place y % RING. */
typedef struct {
	const ts_mirror_pixel_args *args;
	ts_eye_place at;
	seen *row[RING];
} band;

static void see_row(band *b, i32 y)
{
	const ts_mirror_pixel_args *args = b->args;
	seen *row = b->row[y % RING];
	u64 first = b->at.first + (u64)y * (u64)b->at.view.width;
	ts_eye_place at = b->at;
	at.y = y;
	for (at.x = 0; at.x < at.view.width; at.x++) {
		u64 i = first + (u64)at.x;
		row[at.x].reflector = TS_NONE;
		if (args->offset[i + 1] == args->offset[i]) continue;
		row[at.x].reflector = ts_k_seen_reflector(&args->scene, args->depth_triangle[i]);
		row[at.x].glance = ts_k_glance(args, &at, 0, 0, row[at.x].reflector);
	}
}

/* What is seen at (x, y), if that is the same reflector. */
static ts_glance glance_at(const band *b, i32 x, i32 y, u32 reflector)
{
	static const ts_glance unseen = {.seen = false};
	if (x < 0 || y < 0 || x >= b->at.view.width || y >= b->at.view.height) return unseen;
	const seen *at = &b->row[y % RING][x];
	return at->reflector == reflector ? at->glance : unseen;
}

static void write_row(band *b, i32 y)
{
	b->at.y = y;
	for (i32 x = 0; x < b->at.view.width; x++) {
		u32 r = b->row[y % RING][x].reflector;
		if (r == TS_NONE) continue;
		const ts_glance glance[TS_N_GLANCES] = {[TS_HERE] = glance_at(b, x, y, r),
		                                        [TS_LEFT] = glance_at(b, x - 1, y, r),
		                                        [TS_RIGHT] = glance_at(b, x + 1, y, r),
		                                        [TS_ABOVE] = glance_at(b, x, y - 1, r),
		                                        [TS_BELOW] = glance_at(b, x, y + 1, r)};
		b->at.x = x;
		u64 i = b->at.first + (u64)y * (u64)b->at.view.width + (u64)x;
		ts_k_mirror_pixel_write(b->args, i, &b->at, glance);
	}
}

/* Rows from `first` on, of the pictures of all samples, one below the other. */
static void write_band(const ts_mirror_pixel_args *args, seen *room, i64 first)
{
	i32 width = args->view->width, height = args->view->height;
	band b = {.args = args, .at = ts_k_eye_place(args->view, args->samples, (u64)first * (u64)width)};
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
	if (room == NULL) return false;
#pragma omp parallel for schedule(static, 1) num_threads(threads)
	for (i64 k = 0; k < n_bands; k++)
		write_band(args, room + omp_get_thread_num() * RING * width, k / bands * height + k % bands * BAND);
	free(room);
	return true;
}
