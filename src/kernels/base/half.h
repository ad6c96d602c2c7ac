/* Rounding to IEEE binary16, as frame buffers of 16-bit floats do: to nearest, ties to even, by integers (CONTRACT rule
 * 13). No 16-bit type is needed, since every binary16 is a binary32. */
#ifndef TS_KERNELS_BASE_HALF_H
#define TS_KERNELS_BASE_HALF_H
#include "kernels/base/num.h"

#define TS_HALF_NORMAL 0x38800000u   /* 2^-14: below it steps are 2^-24, those of the binary32 from 0.5 on */
#define TS_HALF_OVERFLOW 0x47800000u /* 65536 */

/* The nearest binary16; infinite from 65520 on. */
TS_FN f32 ts_half(f32 x)
{
	u32 u = ts_f2u(x);
	u32 size = u & 0x7fffffffu;
	/* Round subnormals by a sum whose step is 2^-24, others by adding half a step less one and the last bit that
	 * stays: both to nearest, ties to even. */
	f32 small = ts_u2f(size) + 0.5f;
	small = small - 0.5f;
	u32 rounded = (size + 0xfffu + ((size >> 13) & 1u)) & 0xffffe000u;
	/* Overflow to infinity, choose, and keep NaN. */
	rounded = rounded >= TS_HALF_OVERFLOW ? TS_INFINITE_BITS : rounded;
	rounded = size < TS_HALF_NORMAL ? ts_f2u(small) : rounded;
	rounded = size > TS_INFINITE_BITS ? size : rounded;
	return ts_u2f(rounded | (u & 0x80000000u));
}

#endif
