/* Margins of culling: the distance of each random number from its threshold (PORTING 7). This second pass changes no
 * decision of cull.h. */
#ifndef TS_KERNELS_POINTS_CULL_MARGIN_H
#define TS_KERNELS_POINTS_CULL_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/points/cull.h"

#define TS_ROWS_ts_cull_margin_args(ARG) \
	ARG(INNER, ts_cull_args, cull, none) \
	ARG(OUT, f32, margin, cull_margin)
TS_ARGS(ts_cull_margin_args);

/* map over pieces: the random number's distance from its threshold, both from 0 to 1; 1 where chance does not decide */
TS_FN void ts_k_cull_margin_item(const ts_cull_margin_args *args, u64 i)
{
	i32 threshold = ts_k_cull_threshold(ts_k_cull_pixels(&args->cull, i));
	i32 apart = ts_k_cull_chance(&args->cull, i) - threshold;
	bool chance = args->cull.enabled != 0u && threshold > 0;
	args->margin[i] = ts_put(chance ? (f32)(apart < 0 ? -apart : apart) * 0.000000059604644775390625f : 1.0f);
}

#endif
