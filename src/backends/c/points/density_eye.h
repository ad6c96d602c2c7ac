/* The other half of the fast path of split_count: densities by the eye. */
#ifndef TS_BACKENDS_C_POINTS_DENSITY_EYE_H
#define TS_BACKENDS_C_POINTS_DENSITY_EYE_H
#include "kernels/points/split.h"

/* As a fast path; see src/backends/fast.h. */
bool ts_c_eye_density(const ts_density_args *args, u32 n, u32 threads);

#endif
