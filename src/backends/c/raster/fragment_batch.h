/* Fragments of pixels beside each other, with the bits of ts_k_fragment_at: loops for vectors bring their triangles
 * into the view. */
#ifndef TS_BACKENDS_FRAGMENT_BATCH_H
#define TS_BACKENDS_FRAGMENT_BATCH_H
#include "../../../kernels/raster/draw.h"
#include "surface_bins.h"

typedef struct {
	u32 n;
	u32 triangle[TS_ABREAST];
	i32 x[TS_ABREAST], y[TS_ABREAST]; /* pixels */
	u64 place[TS_ABREAST];            /* the caller's */
	/* Found: */
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

/* The view is not orthographic. */
void ts_fragments_find(ts_fragment_batch *batch, const ts_arrays *scene, const ts_camera_k *view);

/* The surface of fragment i. */
static inline ts_surface_ask ts_fragment_ask(const ts_fragment_batch *batch, u32 i, ts_v3 viewer)
{
	return (ts_surface_ask){.triangle = batch->triangle[i],
	                        .w = ts_lane3(&batch->w, i),
	                        .normal = ts_lane3(&batch->normal, i),
	                        .p = ts_lane3(&batch->p, i),
	                        .viewer = viewer,
	                        .footprint = batch->footprint[i],
	                        .place = batch->place[i]};
}

#endif
