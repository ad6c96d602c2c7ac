/* Rounding to IEEE binary16, as frame buffers of 16-bit floats do: to nearest, ties to even, by integers (CONTRACT rule
 * 13). No 16-bit type is needed, since every binary16 is a binary32. */
#ifndef TS_KERNELS_BASE_HALF_H
#define TS_KERNELS_BASE_HALF_H
#include "kernels/base/compat.h"

#define TS_HALF_NORMAL 0x38800000u   /* 2^-14: below it steps are 2^-24, those of the binary32 from 0.5 on */
#define TS_HALF_OVERFLOW 0x47800000u /* 65536 */

/* The nearest binary16; infinite from 65520 on. */
TS_FN f32 ts_half(f32 x)
{
	u32 u = ts_f2u(x);
	u32 size = u & 0x7fffffffu;
	f32 small = ts_u2f(size) + 0.5f;
	small = small - 0.5f;
	u32 rounded = (size + 0xfffu + ((size >> 13) & 1u)) & 0xffffe000u;
	rounded = rounded >= TS_HALF_OVERFLOW ? 0x7f800000u : rounded;
	rounded = size < TS_HALF_NORMAL ? ts_f2u(small) : rounded;
	rounded = size > 0x7f800000u ? size : rounded;
	return ts_u2f(rounded | (u & 0x80000000u));
}

#endif
