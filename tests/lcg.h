/* Numbers that a seed decides, by a linear congruential generator: its high bits are the random ones. */
#ifndef TS_TESTS_LCG_H
#define TS_TESTS_LCG_H
#include <stdint.h>

static inline uint32_t lcg_next(uint32_t *seed) { return *seed = *seed * 1664525u + 1013904223u; }

/* From 0 to n - 1. */
static inline uint32_t lcg_below(uint32_t *seed, uint32_t n)
{
	return (uint32_t)(((uint64_t)lcg_next(seed) * n) >> 32);
}

#endif
