/* Mip chains of cubes: places of the levels, from six faces of n x n texels down to six texels (METHODS 3). */
#ifndef TS_KERNELS_RASTER_MIP_H
#define TS_KERNELS_RASTER_MIP_H
#include "kernels/base/num.h"
#include "kernels/base/records.h"

/* Number of texels in the levels of one cube that are finer than `level`; with TS_NONE, in all levels. */
TS_FN u64 ts_k_mip_texels(u32 n, u32 level)
{
	u64 sum = 0u;
	for (u32 l = 0u; l < level && n != 0u; l++) {
		sum += (u64)6u * n * n;
		if (n == 1u) break;
		n = n >> 1;
	}
	return sum;
}

TS_FN u32 ts_k_mip_size(u32 n, u32 level)
{
	u32 size = n >> level;
	return size != 0u ? size : 1u;
}

TS_FN u32 ts_k_mip_levels(u32 n)
{
	u32 levels = 1u;
	for (; n > 1u; n = n >> 1) levels++;
	return levels;
}

/* First texel of a cube's mip chain in the batch. */
TS_FN u64 ts_k_mip_first(TS_GLOBAL const ts_face *cubes, u32 first_cube, u32 cube)
{
	u64 sum = 0u;
	for (u32 r = first_cube; r < cube; r++) sum += ts_k_mip_texels(cubes[r].n, TS_NONE);
	return sum;
}

#endif
