/* Surfaces of points in vector lanes, with the bits of ts_k_flight_surface: vector loops compute the weights of samples
 * in the lattices of their pieces. */
#ifndef TS_BACKENDS_C_POINTS_POINT_BATCH_H
#define TS_BACKENDS_C_POINTS_POINT_BATCH_H
#include "backends/c/raster/surface_bins.h"
#include "kernels/raster/lattice.h"

typedef struct {
	u32 n;
	u32 triangle[TS_ABREAST];
	i32 x[TS_ABREAST], y[TS_ABREAST];
	ts_lanes3 corner[3];    /* corners of the triangle */
	ts_lanes3 origin, u, v; /* of the lattice */
	f32 scale[TS_ABREAST];
	ts_lanes3 centre, viewer;
	f32 length[TS_ABREAST];
	u64 place[TS_ABREAST]; /* the caller's */
} ts_point_batch;

/* A point of a triangle: sample (x, y) of a lattice. */
typedef struct {
	const ts_align *frame;
	u32 triangle;
	i32 x, y;
	ts_v3 centre, viewer;
	f32 length;
	u64 place;
} ts_point_ask;

/* Adds a point. A full batch asks `bins` for the surfaces of its points. */
void ts_points_add(ts_point_batch *batch, ts_surface_bins *bins, const ts_arrays *scene, const ts_point_ask *ask);
/* Asks for the surfaces of the points that are left. */
void ts_points_flush(ts_point_batch *batch, ts_surface_bins *bins);

#endif
