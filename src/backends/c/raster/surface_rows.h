/* Threads that find the surfaces of rows of pixels. */
#ifndef TS_BACKENDS_C_RASTER_SURFACE_ROWS_H
#define TS_BACKENDS_C_RASTER_SURFACE_ROWS_H
#include "backends/c/raster/fragment_batch.h"

/* The state of a thread. */
typedef struct {
	const void *user;
	ts_surface_bins bins;
	ts_fragment_batch fragments;
} ts_row_worker;

/* Asks for the surfaces of pixels [first, first + n), and leaves no fragments in the batch. */
typedef void ts_see_row(ts_row_worker *worker, u64 first, u64 n);

typedef struct {
	const ts_arrays *scene;
	const void *user; /* of the workers, and what `done` receives */
	ts_see_row *see;
	ts_surface_done *done;
	u64 n, width; /* pixels; those of a row */
} ts_surface_rows;

/* False: no memory, and nothing was done. */
bool ts_see_rows(const ts_surface_rows *rows, u32 threads);

#endif
