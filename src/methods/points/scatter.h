/* Code of the stages that put points, stored or made from pieces, into the off-screen views of the batch. */
#ifndef TS_METHODS_POINTS_SCATTER_H
#define TS_METHODS_POINTS_SCATTER_H
#include "kernels/points/scatter.h"
#include "methods/points/points.h"

/* Launches over points that are stored, and over pieces. */
typedef struct {
	ts_launch stored, pieces;
} ts_scatters;

ts_scatter_args ts_scatter_values(const ts_run *run);
/* Fills the buffers of `args`, runs the launch for the points, and counts. Does nothing if there are no views. */
ts_status ts_scatter_run(ts_run *run, const ts_scatters *own, void *args, size_t bytes, u32 n_views);

#endif
