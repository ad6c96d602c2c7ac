/* Limits of memory: scattered minima and streams. */
#include "study/speed_limits.h"
#include <stdlib.h>
#include "backends/wide.h"

enum { BLOCK = 64, OFFERS = 1 << 24, STREAM_WORDS = 1 << 24, PASSES = 4 };

/* Texels for a block of offers, and the offers' keys, from a hash of their numbers. */
static void choose(u32 *at, u64 *key, u32 first, u32 n_texels)
{
	for (u32 i = 0; i < BLOCK; i++) {
		u32 hash = (first + i) * 747796405u + 2891336453u;
		hash = (hash ^ hash >> 15) * 277803737u;
		hash ^= hash >> 13;
		at[i] = (u32)((u64)hash * n_texels >> 32);
		key[i] = (u64)(hash * 2246822519u) << 32 | i;
	}
}

/* The next block's texels are prefetched while this one's are lowered. */
TS_WIDE(void, offer, (u64 * texels, u32 n_texels, u32 first, u32 n), (texels, n_texels, first, n))
{
	u32 at[2][BLOCK];
	u64 key[2][BLOCK];
	choose(at[0], key[0], first, n_texels);
	for (u32 i = 0; i < n; i += BLOCK) {
		const u32 *here = at[i / BLOCK % 2], *next = at[(i / BLOCK + 1) % 2];
		const u64 *offered = key[i / BLOCK % 2];
		choose(at[(i / BLOCK + 1) % 2], key[(i / BLOCK + 1) % 2], first + i + BLOCK, n_texels);
		for (u32 k = 0; k < BLOCK; k++) __builtin_prefetch(&texels[next[k]], 1);
		for (u32 k = 0; k < BLOCK; k++) {
			u64 has = texels[here[k]];
			texels[here[k]] = offered[k] < has ? offered[k] : has;
		}
	}
}

ts_status ts_limit_minima(double *a_second, u64 bytes, u32 threads)
{
	u32 n = (u32)(bytes / sizeof(u64));
	u64 *texels = ts_alloc(n, threads * sizeof *texels, "texels to scatter to");
	if (texels == NULL) return TS_ERROR;
	double seconds = 0;
#pragma omp parallel for num_threads((int)threads) schedule(static, 1) reduction(max : seconds)
	for (u32 t = 0; t < threads; t++) {
		u64 *own = texels + (size_t)t * n;
		memset(own, 0xff, n * sizeof *own);
		offer(own, n, 0, OFFERS / 8);
		double begin = ts_seconds();
		offer(own, n, OFFERS, OFFERS);
		seconds = ts_seconds() - begin;
	}
	*a_second = OFFERS / seconds;
	free(texels);
	return TS_OK;
}

TS_WIDE(void, stream, (u64 *restrict to, const u64 *restrict from, u32 n), (to, from, n))
{
	for (u32 i = 0; i < n; i++) to[i] = from[i] + 1;
}

ts_status ts_limit_stream(double *a_second, u32 threads)
{
	u64 *from = ts_alloc_zero(STREAM_WORDS, sizeof *from, "an array to read");
	u64 *to = ts_alloc_zero(STREAM_WORDS, sizeof *to, "an array to write");
	ts_status status = from != NULL && to != NULL ? TS_OK : TS_ERROR;
	u32 each = STREAM_WORDS / threads;
	double begin = 0;
	for (u32 pass = 0; status == TS_OK && pass <= PASSES; pass++) {
		if (pass == 1) begin = ts_seconds();
#pragma omp parallel for num_threads((int)threads) schedule(static, 1)
		for (u32 t = 0; t < threads; t++) stream(to + (size_t)t * each, from + (size_t)t * each, each);
	}
	if (status == TS_OK) *a_second = 2.0 * PASSES * (double)each * threads * sizeof *to / (ts_seconds() - begin);
	free(from);
	free(to);
	return status;
}
