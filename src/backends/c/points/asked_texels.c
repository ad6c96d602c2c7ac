/* Marks of the texels that are read, and of their blocks. */
#include "backends/c/points/asked_texels.h"
#include <stdlib.h>
#include "backends/c/points/sample_texels.h"
#include "model/core.h"

static u32 levels_of(u32 n) { return 32 - (u32)__builtin_clz(n | 1); }

static u64 blocks_of(u32 n)
{
	u64 sum = 0;
	for (u32 level = 1; n > 0 && level <= levels_of(n); level++) {
		sum += (u64)ts_asked_blocks(n, level) * ts_asked_blocks(n, level);
	}
	return sum;
}

static void mark(u8 *texel, const ts_splat_args *args, u32 threads)
{
	const ts_sample_offsets o = ts_sample_offsets_of(TS_N_SAMPLES);
	ts_v3 eye = ts_load3(args->view->eye);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, 512) num_threads(threads)
	for (i64 i = 0; i < (i64)args->n_pixels; i++) {
		if (ts_stopped(stop)) continue;
		u32 at[TS_SAMPLE_ROOM];
		const ts_face *cube = &args->cubes[args->pixels[i].reflector];
		if (cube->n == 0) continue;
		ts_sample_texels(at, &o, &args->pixels[i], eye, cube->n);
		for (u32 k = 0; k < TS_N_SAMPLES; k++) ts_mark_u8(&texel[cube->offset + at[k]]);
	}
}

/* Makes the next level's blocks: each of four, or fewer at the ends. */
static void join(u8 *to, const u8 *from, u32 n)
{
	u32 half = (n + 1) / 2;
	for (u32 y = 0; y < n; y++) {
		for (u32 x = 0; x < n; x++) to[y / 2 * half + x / 2] |= from[y * n + x];
	}
}

/* Each block receives what those to its right and below had before. */
static void widen(u8 *block, u32 n)
{
	for (u32 y = 0; y < n; y++) {
		u8 *row = block + (u64)y * n, *below = y + 1 < n ? row + n : row;
		for (u32 x = 0; x < n; x++) {
			u32 right = x + 1 < n ? x + 1 : x;
			row[x] = row[x] | row[right] | below[x] | below[right];
		}
	}
}

static void find_blocks(u8 *block, const u8 *texel, u32 n)
{
	const u8 *from = texel;
	u8 *to = block;
	for (u32 level = 1; level <= levels_of(n); level++) {
		u32 wide = ts_asked_blocks(n, level - 1), half = ts_asked_blocks(n, level);
		join(to, from, wide);
		from = to;
		to += (u64)half * half;
	}
	for (u32 level = 1; level <= levels_of(n); level++) {
		u32 half = ts_asked_blocks(n, level);
		widen(block, half);
		block += (u64)half * half;
	}
}

bool ts_asked_make(ts_asked *asked, const ts_splat_args *args, u32 threads)
{
	u64 n_blocks = 0;
	asked->first = ts_alloc(args->n_cubes, sizeof *asked->first, "blocks of texels");
	for (u32 r = 0; asked->first != NULL && r < args->n_cubes; r++) {
		u64 n = args->cubes[r].n, end = args->cubes[r].offset + 6 * n * n;
		asked->first[r] = n_blocks;
		asked->n = end > asked->n ? end : asked->n;
		n_blocks += 6 * blocks_of((u32)n);
	}
	asked->texel = ts_alloc_zero(asked->n, 1, "texels that are read");
	asked->blocks = ts_alloc_zero(n_blocks, 1, "blocks of texels");
	if (asked->first == NULL || asked->texel == NULL || asked->blocks == NULL) return false;
	mark(asked->texel, args, threads);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 i = 0; i < (i64)args->n_cubes * 6; i++) {
		if (ts_stopped(stop)) continue;
		const ts_face *cube = &args->cubes[i / 6];
		u64 n = cube->n, side = (u64)i % 6;
		u8 *block = asked->blocks + asked->first[i / 6] + side * blocks_of(cube->n);
		if (n > 0) find_blocks(block, asked->texel + cube->offset + side * n * n, cube->n);
	}
	return true;
}

void ts_asked_clear(ts_asked *asked)
{
	free(asked->texel);
	free(asked->blocks);
	free(asked->first);
}

ts_asked_face ts_asked_face_of(const ts_asked *asked, const ts_face *cubes, u32 cube, u32 side)
{
	ts_asked_face f = {.n = 0};
	if (asked->texel == NULL) return f;
	u32 n = f.n = cubes[cube].n;
	const u8 *block = asked->blocks + asked->first[cube] + side * blocks_of(n);
	for (u32 level = 1; level <= levels_of(n); level++) {
		f.level[level] = block;
		block += (u64)ts_asked_blocks(n, level) * ts_asked_blocks(n, level);
	}
	return f;
}

void ts_asked_close(const ts_asked *asked, u64 *texels, u32 threads)
{
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < (i64)asked->n; i++) texels[i] &= (u64)0 - asked->texel[i];
}

void ts_asked_open(const ts_asked *asked, u64 *texels, u32 threads)
{
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < (i64)asked->n; i++) texels[i] |= (u64)asked->texel[i] - 1;
}

#include "backends/selftest.h"
