/* How near another answer counts, and where the least margin is kept (margin.h). */
#ifndef TS_KERNELS_RASTER_MARGIN_BOUNDS_H
#define TS_KERNELS_RASTER_MARGIN_BOUNDS_H
#include "kernels/base/num.h"

#define TS_MARGIN_REACH 4.0f                       /* edges farther outside do not matter, in 1/256 pixel */
#define TS_MARGIN_NEAR 0.015625f                   /* nor do depths farther behind than 4 steps + this share of depth */
#define TS_MARGIN_ROUNDING 0.00000095367431640625f /* share of a depth that rounding may change: 8 ulps */
#define TS_MARGIN_ALPHA 0.00390625f                /* an alpha this near its cutoff is undecided */
#define TS_MARGIN_NOWHERE 1048576.0f               /* where nothing is compared, or the comparison is exact */

TS_FN void ts_k_least_bits(TS_GLOBAL u32 *least, f32 margin)
{
	if (margin <= TS_MARGIN_REACH) ts_min_u32(least, ts_f2u(ts_put(margin)));
}

#endif
