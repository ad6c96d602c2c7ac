/* Primitives of points: stochastic culling (cull.h). */
#ifndef TS_KERNELS_POINTS_VECTORS_H
#define TS_KERNELS_POINTS_VECTORS_H
#include "kernels/points/cull.h"
#include "kernels/vectors/vectors_args.h"

TS_VECTOR_WORD(cull_threshold, ts_k_cull_threshold(TS_A))

#define TS_LIST_points_vectors(VECTOR) VECTOR(cull_threshold)
/* map over rows */
TS_VECTORS(points_vectors)

#endif
