/* Surfaces that a thread asks for one by one are collected in bins by material; the surfaces of a full bin are found at
 * once. */
#ifndef TS_BACKENDS_C_RASTER_SURFACE_BINS_H
#define TS_BACKENDS_C_RASTER_SURFACE_BINS_H
#include "backends/c/raster/surface_batch.h"

enum { TS_SURFACE_BINS = 32 };

/* Receives the surfaces of a bin. */
typedef void ts_surface_done(const void *user, const ts_surface_batch *of, const ts_surfaces *found);

typedef struct {
	ts_arrays scene;
	ts_surface_done *done;
	const void *user;
	ts_surface_batch bin[TS_SURFACE_BINS];
} ts_surface_bins;

/* One sample: see ts_surface_batch. */
typedef struct {
	u32 triangle;
	ts_v3 w, normal, p, viewer;
	f32 footprint;
	const u32 *lit;
	u64 place;
} ts_surface_ask;

void ts_surface_bins_begin(ts_surface_bins *bins, const ts_arrays *scene, ts_surface_done *done, const void *user);
void ts_surface_bins_add(ts_surface_bins *bins, const ts_surface_ask *ask);
/* Finds the surfaces that are left in the bins. */
void ts_surface_bins_flush(ts_surface_bins *bins);

#endif
