/* Fragments of neighbouring pixels, with the bits of ts_k_fragment_at: vector loops transform their triangles into the
 * view. */
#ifndef TS_BACKENDS_C_RASTER_FRAGMENT_BATCH_H
#define TS_BACKENDS_C_RASTER_FRAGMENT_BATCH_H
#include "backends/c/raster/surface_bins.h"
#include "kernels/raster/draw.h"

typedef struct {
	u32 n;
	u32 triangle[TS_ABREAST];
	i32 x[TS_ABREAST], y[TS_ABREAST]; /* pixels */
	u64 place[TS_ABREAST];            /* the caller's */
	/* Results: */
	ts_lanes3 w, normal, p; /* corners' weights, (b - a) x (c - a), the place seen */
	f32 z[TS_ABREAST], footprint[TS_ABREAST];
} ts_fragment_batch;

static inline void ts_fragment_add(ts_fragment_batch *batch, u32 triangle, i32 x, i32 y, u64 place)
{
	u32 i = batch->n++;
	batch->triangle[i] = triangle;
	batch->x[i] = x;
	batch->y[i] = y;
	batch->place[i] = place;
}

/* Finds all fragments, asks `bins` for their surfaces, towards the view's eye, and empties the batch. The view is not
 * orthographic. lit: that of each place, as in ts_surface_batch; or NULL. */
void ts_fragments_ask(ts_fragment_batch *batch, ts_surface_bins *bins, const ts_camera_k *view, const u32 *lit);
/* Finds all fragments. */
void ts_fragments_find(ts_fragment_batch *batch, const ts_arrays *scene, const ts_camera_k *view);

#endif
