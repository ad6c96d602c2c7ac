/* Textures side by side: where each sample reads two levels, their texels, and the mean of those. */
#include "backends/c/raster/surface_batch.h"
#include "backends/wide.h"

enum { N = TS_ABREAST, LEVELS = 2, TEXELS = 4, MOST_LEVELS = 17 /* of 65,536 texels a side */ };

#define ALL 0xffffffffu

/* Of one level, for each sample: its four texels, and the weights of those to the right and of those below. */
typedef struct {
	u32 level[N], at[TEXELS][N], fx[N], fy[N];
	u32 red_green[TEXELS][N], blue_alpha[TEXELS][N];
} read;

typedef struct {
	read of[LEVELS];
	u32 between[N]; /* the weight of the second level, in 1/256; 0: that is the first again */
} reads;

/* What all samples share. */
typedef struct {
	f32 m[6];
	u32 width, height, last;
	u32 repeat_x, repeat_y, clamp_x, clamp_y; /* all bits set, or none; neither: mirrored */
} texture;

static texture texture_of(const ts_arrays *scene, const ts_slot *slot)
{
	const ts_image *image = &scene->images[slot->image];
	texture t = {.width = image->width, .height = image->height, .last = (image->n_levels - 1) * 256};
	for (u32 k = 0; k < 6; k++) t.m[k] = slot->transform[k];
	t.repeat_x = slot->wrap[0] == TS_REPEAT ? ALL : 0;
	t.repeat_y = slot->wrap[1] == TS_REPEAT ? ALL : 0;
	t.clamp_x = slot->wrap[0] == TS_CLAMP ? ALL : 0;
	t.clamp_y = slot->wrap[1] == TS_CLAMP ? ALL : 0;
	return t;
}

/* a where all bits of `which` are set, b where none is. */
static inline u32 choose(u32 which, u32 a, u32 b) { return b ^ ((a ^ b) & which); }
static inline f32 choose_number(u32 which, f32 a, f32 b) { return ts_u2f(choose(which, ts_f2u(a), ts_f2u(b))); }

/* ts_k_texture_wrap */
static inline f32 wrapped(f32 u, u32 repeat, u32 clamp)
{
	f32 turns = u - ts_floor(u);
	f32 pairs = ts_floor(u * 0.5f) * 2.0f;
	f32 mirror = u - pairs;
	mirror = mirror > 1.0f ? 2.0f - mirror : mirror;
	return choose_number(clamp, ts_clamp(u, 0.0f, 1.0f), choose_number(repeat, turns, mirror));
}

/* ts_k_texture_neighbour */
static inline u32 neighbour(i32 i, i32 n, u32 repeat)
{
	i32 high = i >= n ? i - n : i, around = i < 0 ? n - 1 : high;
	return choose(repeat, (u32)around, (u32)ts_min_i32(ts_max_i32(i, 0), n - 1));
}

static inline u32 side_of(u32 side, u32 level)
{
	u32 r = side >> level;
	return r != 0u ? r : 1u;
}

/* ts_k_texture_around */
static inline void read_level(read *restrict r, const texture *t, u32 i, ts_v2 uv, u32 level)
{
	u32 width = side_of(t->width, level), height = side_of(t->height, level);
	i32 x = ts_fix(uv.x * (f32)width, 8, 30) - 128, y = ts_fix(uv.y * (f32)height, 8, 30) - 128;
	u32 x0 = neighbour(x >> 8, (i32)width, t->repeat_x), x1 = neighbour((x >> 8) + 1, (i32)width, t->repeat_x);
	u32 y0 = neighbour(y >> 8, (i32)height, t->repeat_y), y1 = neighbour((y >> 8) + 1, (i32)height, t->repeat_y);
	r->level[i] = level;
	r->at[0][i] = y0 * width + x0;
	r->at[1][i] = y0 * width + x1;
	r->at[2][i] = y1 * width + x0;
	r->at[3][i] = y1 * width + x1;
	r->fx[i] = (u32)x & 255u;
	r->fy[i] = (u32)y & 255u;
}

TS_WIDE(void, find_reads,
        (reads *restrict to, const ts_surface_batch *restrict of, const ts_uv_batch *restrict uv,
         const f32 *restrict area, texture t, u32 n),
        (to, of, uv, area, t, n))
{
	for (u32 i = 0; i < n; i++) {
		ts_v2 a = ts_uv_lane(t.m, uv, 0, i);
		ts_v2 b = ts_uv_lane(t.m, uv, 1, i);
		ts_v2 c = ts_uv_lane(t.m, uv, 2, i);
		f32 uv_area = ts_abs(ts_diff_of_products(b.x - a.x, c.y - a.y, b.y - a.y, c.x - a.x));
		u32 lod = ts_k_texture_lod(t.width, t.height, of->footprint[i], uv_area, area[i]);
		lod = lod > t.last ? t.last : lod;
		ts_v3 w = ts_lane3(&of->w, i);
		ts_v2 at = ts_v2_make(wrapped(ts_blend1(w, a.x, b.x, c.x), t.repeat_x, t.clamp_x),
		                      wrapped(ts_blend1(w, a.y, b.y, c.y), t.repeat_y, t.clamp_y));
		u32 level = lod >> 8, between = lod & 255u;
		to->between[i] = between;
		read_level(&to->of[0], &t, i, at, level);
		read_level(&to->of[1], &t, i, at, between != 0u ? level + 1u : level);
	}
}

static inline void fetch(read *r, u32 i, const u64 *const *levels)
{
	const u64 *level = levels[r->level[i]];
	for (u32 k = 0; k < TEXELS; k++) {
		u64 texel = level[r->at[k][i]];
		r->red_green[k][i] = (u32)texel;
		r->blue_alpha[k][i] = (u32)(texel >> 32);
	}
}

static void fetch_all(reads *to, u32 n, const ts_arrays *scene, const ts_image *image)
{
	const u64 *levels[MOST_LEVELS];
	ts_texture_level level = ts_k_texture_finest(scene, image);
	for (u32 l = 0; l < image->n_levels && l < MOST_LEVELS; l++, level = ts_k_texture_coarser(level))
		levels[l] = level.texels;
	for (u32 i = 0; i < n; i++) {
		fetch(&to->of[0], i, levels);
		fetch(&to->of[1], i, levels);
	}
}

static inline u32 low_of(const u32 (*texel)[N], const read *r, u32 i)
{
	return ts_k_texture_mix4(texel[0][i] & 0xffffu, texel[1][i] & 0xffffu, texel[2][i] & 0xffffu, texel[3][i] & 0xffffu,
	                         r->fx[i], r->fy[i]);
}

static inline u32 high_of(const u32 (*texel)[N], const read *r, u32 i)
{
	return ts_k_texture_mix4(texel[0][i] >> 16, texel[1][i] >> 16, texel[2][i] >> 16, texel[3][i] >> 16, r->fx[i],
	                         r->fy[i]);
}

TS_WIDE(void, mix_reads, (ts_lanes3 *restrict to, const reads *restrict from, u32 n), (to, from, n))
{
	const read *p = &from->of[0], *q = &from->of[1];
	for (u32 i = 0; i < n; i++) {
		u32 f = from->between[i];
		u32 red = ts_k_texture_mix2(low_of(p->red_green, p, i), low_of(q->red_green, q, i), f);
		u32 green = ts_k_texture_mix2(high_of(p->red_green, p, i), high_of(q->red_green, q, i), f);
		u32 blue = ts_k_texture_mix2(low_of(p->blue_alpha, p, i), low_of(q->blue_alpha, q, i), f);
		to->x[i] = ts_k_texture_unit(red);
		to->y[i] = ts_k_texture_unit(green);
		to->z[i] = ts_k_texture_unit(blue);
	}
}

void ts_texture_batch(ts_lanes3 *to, const ts_arrays *scene, const ts_slot *slot, const ts_surface_batch *of,
                      const ts_uv_batch *uv, const f32 *area)
{
	reads r;
	const u32 n = ts_whole_lanes(of->n);
	find_reads(&r, of, uv, area, texture_of(scene, slot), n);
	fetch_all(&r, n, scene, &scene->images[slot->image]);
	mix_reads(to, &r, n);
}

#include "backends/selftest.h"
