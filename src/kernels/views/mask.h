/* The masks of an octree's levels: one bit per voxel in Morton order, 1 where the voxel is not empty, all levels in one
 * array from the root on. Level l has 8^l bits; levels 0 and 1 take one word each. The number of set bits before a bit
 * is the id of its node. */
#ifndef TS_KERNELS_VIEWS_MASK_H
#define TS_KERNELS_VIEWS_MASK_H
#include "kernels/base/args.h"
#include "kernels/base/morton.h"

/* The first word of level l: l for l < 2, otherwise 2 + the sum of 8^(k - 2) over the levels k from 2 to l - 1. */
TS_FN u64 ts_k_mask_first(u32 level)
{
	return level < 2u ? (u64)level : 2u + (((u64)1u << (3u * level - 6u)) - 1u) / 7u;
}

TS_FN u64 ts_k_mask_word(u32 level, u64 code) { return ts_k_mask_first(level) + (code >> 6); }
TS_FN u64 ts_k_mask_bit(u64 code) { return (u64)1u << (code & 63u); }

/* The id of the node of a voxel that is not empty. */
TS_FN u32 ts_k_mask_id(TS_GLOBAL const u64 *mask, TS_GLOBAL const u32 *before, u32 level, u64 code)
{
	u64 word = ts_k_mask_word(level, code);
	return before[word] + ts_k_count_bits(mask[word] & (ts_k_mask_bit(code) - 1u));
}

#define TS_ROWS_ts_mask_args(ARG) \
	ARG(OUT, u64, mask, voxel_mask) \
	ARG(OUT, u32, before, voxel_before) /* counts, then their prefix sums */ \
	ARG(VALUE, u32, level, none)        /* that is made from the level below it */
TS_ARGS(ts_mask_args);

/* One bit for each of the eight bytes: 1 if the byte is not 0. */
TS_FN u64 ts_k_mask_used(u64 bytes)
{
	u64 r = 0u;
	for (u32 k = 0u; k < 8u; k++) r |= (u64)(((bytes >> (8u * k)) & 255u) != 0u ? 1u : 0u) << k;
	return r;
}

/* map over words of a level */
TS_FN void ts_k_mask_up_item(const ts_mask_args *args, u64 i)
{
	u64 below = ts_k_mask_first(args->level + 1u) + 8u * i;
	u64 r = 0u;
	for (u32 k = 0u; k < (args->level < 2u ? 1u : 8u); k++) r |= ts_k_mask_used(args->mask[below + k]) << (8u * k);
	args->mask[ts_k_mask_first(args->level) + i] = r;
}

/* map over words */
TS_FN void ts_k_mask_count_item(const ts_mask_args *args, u64 i) { args->before[i] = ts_k_count_bits(args->mask[i]); }

#endif
