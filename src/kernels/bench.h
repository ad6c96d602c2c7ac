/* What bounds scattering: 64-bit minima at random texels. `touchstone bench backends` measures it; no stage runs it. */
#ifndef TS_KERNELS_BENCH_H
#define TS_KERNELS_BENCH_H
#include "num.h"

typedef struct {
	TS_GLOBAL u64 *texels; /* all empty before the first launch */
	u32 n_texels;
	u32 distance;          /* of every key; less in each launch, which so finds the texels as good as empty */
} ts_bench_min_args;

/* scatter over offers; of as many as there are texels, four in five lower their texel, in any order */
TS_FN void ts_k_bench_min_item(const ts_bench_min_args *args, u64 i)
{
	u64 texel = ((u64)ts_pcg((u32)i) * args->n_texels) >> 32;
	u64 key = ((u64)args->distance << 32) | ts_pcg(~(u32)i);
	ts_min_u64(&args->texels[texel], key);
}

#endif
