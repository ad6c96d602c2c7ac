/* The limit of scattering: 64-bit minima at random texels. `touchstone bench backends` measures this kernel; no stage
 * runs it. */
#ifndef TS_KERNELS_BASE_BENCH_H
#define TS_KERNELS_BASE_BENCH_H
#include "kernels/base/args.h"
#include "kernels/base/num.h"

#define TS_ROWS_ts_bench_min_args(ARG) \
	ARG(OUT, u64, texels, cube_face_depth_triangle) /* all empty before the first launch */ \
	ARG(VALUE, u32, n_texels, none) \
	ARG(VALUE, u32, distance, none) /* of every key; falls with each launch, so that the keys win */
TS_ARGS(ts_bench_min_args);

/* scatter over offers; with as many offers as texels, in whatever order, four in five offers lower their texel */
TS_FN void ts_k_bench_min_item(const ts_bench_min_args *args, u64 i)
{
	u64 texel = ((u64)ts_pcg((u32)i) * args->n_texels) >> 32;
	u64 key = ((u64)args->distance << 32) | ts_pcg(~(u32)i);
	ts_min_u64(&args->texels[texel], key);
}

#endif
