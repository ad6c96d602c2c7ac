/* Morton codes of voxels: the bits of x, y and z in turn, x lowest, up to 11 bits each; and a count of set bits. */
#ifndef TS_KERNELS_BASE_MORTON_H
#define TS_KERNELS_BASE_MORTON_H
#include "kernels/base/compat.h"

typedef struct {
	i32 x, y, z;
} ts_i3;

TS_FN ts_i3 ts_i3_make(i32 x, i32 y, i32 z)
{
	ts_i3 r;
	r.x = x;
	r.y = y;
	r.z = z;
	return r;
}

/* Bit b moves to 3 b. */
TS_FN u64 ts_k_spread(u32 x)
{
	u64 r = x & 0x7ffu;
	r = (r | (r << 16)) & 0xff0000ffu;
	r = (r | (r << 8)) & 0x0f00f00fu;
	r = (r | (r << 4)) & 0xc30c30c3u;
	return (r | (r << 2)) & 0x49249249u;
}

/* Bit 3 b moves to b; the other bits are dropped. */
TS_FN i32 ts_k_gather_bits(u64 x)
{
	u64 r = x & 0x49249249u;
	r = (r | (r >> 2)) & 0xc30c30c3u;
	r = (r | (r >> 4)) & 0x0f00f00fu;
	r = (r | (r >> 8)) & 0xff0000ffu;
	r = (r | (r >> 16)) & 0x7ffu;
	return (i32)r;
}

TS_FN u64 ts_k_morton(ts_i3 p)
{
	return ts_k_spread((u32)p.x) | (ts_k_spread((u32)p.y) << 1) | (ts_k_spread((u32)p.z) << 2);
}

TS_FN ts_i3 ts_k_unmorton(u64 code)
{
	return ts_i3_make(ts_k_gather_bits(code), ts_k_gather_bits(code >> 1), ts_k_gather_bits(code >> 2));
}

/* Adds neighbouring counts of 1, 2 and 4 bits, then all bytes (Warren, Hacker's Delight, chapter 5). */
TS_FN u32 ts_k_count_bits(u64 x)
{
	x = x - ((x >> 1) & 0x5555555555555555UL);
	x = (x & 0x3333333333333333UL) + ((x >> 2) & 0x3333333333333333UL);
	x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fUL;
	return (u32)((x * 0x0101010101010101UL) >> 56);
}

#endif
