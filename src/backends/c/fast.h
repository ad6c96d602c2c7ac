/* The fast paths of the reference. */
#ifndef TS_BACKENDS_C_FAST_H
#define TS_BACKENDS_C_FAST_H
#include "../backend.h"
#include "../kernels.h"

/* Runs a kernel's fast path. False if it has none, or none for these arguments: then nothing was done. */
bool ts_c_fast(ts_kernel kernel, const void *args, u64 n, u32 threads);

/* The same bits as launching the kernel (tests/backends, tests/methods/run.c).
 * Splat: args->offset must be there, and nothing to mark. */
void ts_c_splat_fast(const ts_splat_args *args, u32 threads);
/* Scatter: of n stored points or n pieces, into depth maps; n_views must not be 0. False if there is no memory, or
 * there are more than 2048 views: then nothing was done. */
bool ts_c_scatter_fast(const ts_scatter_args *args, u64 n, bool stored, u32 threads);
/* Shade: of n entries; adaptive must be 0. */
void ts_c_shade_fast(const ts_lookup_args *args, u64 n, u32 threads);
/* Split_count: of n triangles, by the point closest to each of perspective views. False if there is no memory: then
 * nothing was done. */
bool ts_c_density_fast(const ts_density_args *args, u64 n, u32 threads);
/* Hull: of n pixels; by eqs 15 to 18 in their stable forms, of interpolated parameters. */
void ts_c_hull_fast(const ts_hull_args *args, u64 n, u32 threads);
/* Surfels: of n surfels or, from surfel_mean on, n pixels. False if there is no memory, surfels are as large as the
 * image, or the filter is exact EWA: then nothing was done (tests/backends/surfel_fast.c). */
bool ts_c_surfel_setup_fast(const ts_surfel_setup_args *args, u64 n, u32 threads);
bool ts_c_surfel_depth_fast(const ts_surfel_depth_args *args, u64 n, u32 threads);
bool ts_c_blend_fast(const ts_blend_args *args, u64 n, u32 threads);
void ts_c_surfel_mean_fast(const ts_surfel_mean_args *args, u64 n, u32 threads);
void ts_c_deferred_fast(const ts_deferred_args *args, u64 n, u32 threads);

#endif
