/* Bands: on devices that stop long loops, n items share the rows of one loop. Item i is band i % n of item i / n, and
 * takes the rows band, band + n, ... */
#ifndef TS_KERNELS_BASE_BAND_H
#define TS_KERNELS_BASE_BAND_H
#include "kernels/base/compat.h"

typedef struct {
	u64 item;
	i32 first, step; /* rows */
} ts_band;

TS_FN ts_band ts_k_band(u64 i, u32 others)
{
	u64 n = (u64)others + 1u;
	ts_band r;
	r.item = i / n;
	r.first = (i32)(i % n);
	r.step = (i32)n;
	return r;
}

#endif
