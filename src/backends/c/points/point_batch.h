/* Surfaces of points in vector lanes, with the bits of ts_k_flight_surface: vector loops compute the weights of samples
 * in the lattices of their pieces. */
#ifndef TS_BACKENDS_POINT_BATCH_H
#define TS_BACKENDS_POINT_BATCH_H
#include "../../../kernels/points/flight.h"
#include "../raster/surface_bins.h"

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

/* Adds a point. A full batch asks `bins` for the surfaces of its points. */
void ts_points_add(ts_point_batch *batch, ts_surface_bins *bins, const ts_points_args *from, const ts_flight *point,
                   ts_v3 viewer, u64 place);
/* Asks for the surfaces of the points that are left. */
void ts_points_flush(ts_point_batch *batch, ts_surface_bins *bins);

#endif
