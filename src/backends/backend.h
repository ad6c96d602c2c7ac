/* Backends run a kernel over all its items. */
#ifndef TS_BACKENDS_BACKEND_H
#define TS_BACKENDS_BACKEND_H
#include "../kernels/draw.h"
#include "../kernels/image.h"
#include "../kernels/lookup.h"
#include "../kernels/margin.h"
#include "../kernels/mirror.h"
#include "../kernels/pixel.h"
#include "../kernels/resize.h"
#include "../kernels/cull.h"
#include "../kernels/splat.h"
#include "../kernels/vectors.h"

#define KERNEL(name, args) TS_KERNEL_##name,
typedef enum {
#include "kernels.def"
	TS_N_KERNELS
} ts_kernel;
#undef KERNEL

/* Runs items [0, n) on `threads` threads. args is the kernel's argument struct. The order of the items is not defined
 * and never changes a result. */
void ts_c_launch(ts_kernel kernel, const void *args, u64 n, u32 threads);

/* Fast paths: the same bits as launching the kernel (proved by tests/backends/<noun>_fast.c).
 * Splat: offset[n_pieces + 1] are the points before each piece. */
void ts_c_splat_fast(const ts_splat_args *args, const u32 *offset, u64 n_pieces, u32 threads);
/* Shade: of n entries; adaptive must be 0. */
void ts_c_shade_fast(const ts_lookup_args *args, u64 n, u32 threads);

/* Exclusive prefix sum in place: counts[0 .. n-1] become the sums before each, counts[n] the total, which is also
 * returned. The counts are 32-bit; a total that does not fit is returned all the same and must be refused. */
u64 ts_c_scan(u32 *counts, u64 n);

/* Fills n elements with all ones. */
void ts_c_empty(u64 *texels, u64 n, u32 threads);

#endif
