/* From painters to images and materials: see paint.h. */
#include "scene/builtin/paint.h"
#include <stdlib.h>
#include "model/core.h"
#include "scene/sources.h"

f32 ts_paint_hash(i32 x, i32 y, u32 seed) { return ts_uniform(ts_random((u32)x + 65537u * (u32)y, 5u, seed)); }

f32 ts_paint_fract(f32 x) { return x - ts_floor(x); }

f32 ts_paint_ramp(f32 lo, f32 hi, f32 x)
{
	f32 t = ts_clamp((x - lo) / (hi - lo), 0.0f, 1.0f);
	return t * t * (3.0f - 2.0f * t);
}

ts_v3 ts_paint_mix(ts_v3 a, ts_v3 b, f32 t) { return ts_mad(a, ts_sub(b, a), t); }

/* i modulo n; most are below n already, and division takes longer than all the rest of the noise. */
static u32 wrap(i32 i, u32 n)
{
	i32 p = (i32)n;
	return (u32)i < n ? (u32)i : (u32)((i % p + p) % p);
}

/* A cell of a lattice and the values at its corners, by row and column. */
typedef struct {
	i32 i, j;
	u32 period_x, period_y, seed; /* period 0: no cell */
	f32 corner[2][2];
} cell;

static void set_corners(cell *c)
{
	u32 stream = ts_pcg(5u ^ ts_pcg(c->seed));
	for (i32 row = 0; row < 2; row++) {
		for (i32 column = 0; column < 2; column++) {
			u32 place = wrap(c->i + column, c->period_x) + 65537u * wrap(c->j + row, c->period_y);
			c->corner[row][column] = ts_uniform(ts_pcg(place ^ stream));
		}
	}
}

/* Neighbouring texels ask for the same cell, so each thread keeps the last ones. */
static const cell *cell_at(i32 i, i32 j, u32 period_x, u32 period_y, u32 seed)
{
	static _Thread_local cell kept[16];
	cell *c = &kept[seed % 16];
	if (c->i != i || c->j != j || c->period_x != period_x || c->period_y != period_y || c->seed != seed) {
		*c = (cell){.i = i, .j = j, .period_x = period_x, .period_y = period_y, .seed = seed};
		set_corners(c);
	}
	return c;
}

/* ts_floor_i32 for |x| below 2^31, without saturation, which would take a quarter of the noise. */
static i32 floor_of(f32 x)
{
	i32 i = (i32)x;
	return (f32)i > x ? i - 1 : i;
}

f32 ts_paint_noise(f32 x, f32 y, u32 period_x, u32 period_y, u32 seed)
{
	i32 i = floor_of(x), j = floor_of(y);
	const cell *c = cell_at(i, j, period_x, period_y, seed);
	f32 fx = x - (f32)i, fy = y - (f32)j;
	fx = fx * fx * (3.0f - 2.0f * fx);
	fy = fy * fy * (3.0f - 2.0f * fy);
	f32 low = c->corner[0][0] + (c->corner[0][1] - c->corner[0][0]) * fx;
	f32 high = c->corner[1][0] + (c->corner[1][1] - c->corner[1][0]) * fx;
	return low + (high - low) * fy;
}

f32 ts_paint_fbm(f32 u, f32 v, u32 period, u32 octaves, u32 seed)
{
	f32 sum = 0.0f, weight = 0.5f, total = 0.0f;
	for (u32 k = 0; k < octaves; k++) {
		f32 n = ts_paint_noise(u * (f32)period, v * (f32)period, period, period, seed + k);
		sum = sum + n * weight;
		total = total + weight;
		weight = weight * 0.5f;
		period *= 2;
	}
	return sum / total;
}

static u8 byte(f32 x) { return (u8)ts_rint(ts_clamp(x, 0.0f, 1.0f) * 255.0f); }

static void put(u8 *rgba, f32 r, f32 g, f32 b, f32 a)
{
	rgba[0] = byte(r);
	rgba[1] = byte(g);
	rgba[2] = byte(b);
	rgba[3] = byte(a);
}

/* The unit normal of the heights at a texel, green upwards, as a colour. */
static void put_normal(u8 *rgba, const ts_dab *dabs, u32 size, u32 x, u32 y, const f32 *tile)
{
	u32 mask = size - 1;
	f32 dx = dabs[y * size + ((x + 1) & mask)].height - dabs[y * size + ((x - 1) & mask)].height;
	f32 dy = dabs[((y + 1) & mask) * size + x].height - dabs[((y - 1) & mask) * size + x].height;
	f32 texels = (f32)size * 0.5f;
	ts_v3 n = ts_normalize(ts_v3_make(-dx * texels / tile[0], dy * texels / tile[1], 1.0f));
	put(rgba, n.x * 0.5f + 0.5f, n.y * 0.5f + 0.5f, n.z * 0.5f + 0.5f, 1.0f);
}

static void put_map(u8 *rgba, const ts_dab *dabs, u32 map, const ts_paint *paint, u32 x, u32 y)
{
	const ts_dab *d = &dabs[y * paint->size + x];
	if (map == TS_MAP_NORMAL)
		put_normal(rgba, dabs, paint->size, x, y, paint->tile);
	else if (map == TS_MAP_SURFACE)
		put(rgba, d->occlusion, d->roughness, d->metallic, 1.0f);
	else if (map == TS_MAP_GLOW)
		put(rgba, d->colour.x * d->glow, d->colour.y * d->glow, d->colour.z * d->glow, 1.0f);
	else
		put(rgba, d->colour.x, d->colour.y, d->colour.z, d->alpha);
}

static void draw_map(u8 *rgba, const ts_dab *dabs, u32 map, const ts_paint *paint)
{
#pragma omp parallel for num_threads((int)ts_threads_all())
	for (u32 y = 0; y < paint->size; y++) {
		for (u32 x = 0; x < paint->size; x++) put_map(rgba + 4 * (y * paint->size + x), dabs, map, paint, x, y);
	}
}

static void paint_dabs(ts_dab *dabs, const ts_paint *paint, u32 seed)
{
	i32 size = (i32)paint->size;
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(dynamic, 8)
	for (i32 y = 0; y < size; y++) {
		for (i32 x = 0; x < size; x++) {
			ts_dab *d = &dabs[y * size + x];
			*d = (ts_dab){
				.colour = {1.0f, 1.0f, 1.0f}, .alpha = 1.0f, .roughness = 1.0f, .metallic = 1.0f, .occlusion = 1.0f};
			paint->painter(d, ((f32)x + 0.5f) / (f32)size, ((f32)y + 0.5f) / (f32)size, paint->kind, seed);
		}
	}
}

/* Maps in the order of their bits, after that of the base colour. */
enum { N_MAPS = 4 };

static bool has_map(const ts_paint *paint, u32 i) { return i == 0 || (paint->maps & 1u << (i - 1)) != 0; }
static u32 map_of(u32 i) { return i == 0 ? 0 : 1u << (i - 1); }

typedef struct painting {
	ts_paint of;
	u32 seed;
	u8 *rgba[N_MAPS]; /* NULL: not among the maps */
	struct painting *before;
} painting;

static bool keeps;
static painting *kept;

void ts_builtin_keep(void) { keeps = true; }

static void destroy(painting *p)
{
	for (u32 i = 0; i < N_MAPS; i++) free(p->rgba[i]);
	free(p);
}

static painting *find_kept(const ts_paint *paint, u32 seed)
{
	for (painting *p = kept; p != NULL; p = p->before) {
		const ts_paint *of = &p->of;
		bool same = of->painter == paint->painter && of->kind == paint->kind && of->size == paint->size;
		same = same && of->maps == paint->maps && memcmp(of->tile, paint->tile, sizeof of->tile) == 0;
		if (same && p->seed == seed) return p;
	}
	return NULL;
}

/* NULL: no memory. */
static painting *paint_maps(const ts_paint *paint, u32 seed)
{
	size_t n = (size_t)paint->size * paint->size;
	ts_dab *dabs = ts_alloc(n, sizeof *dabs, "the texture of a built-in scene");
	painting *p = dabs != NULL ? ts_alloc_zero(1, sizeof *p, "the texture of a built-in scene") : NULL;
	bool made = p != NULL;
	if (made) paint_dabs(dabs, paint, seed);
	for (u32 i = 0; made && i < N_MAPS; i++) {
		if (!has_map(paint, i)) continue;
		p->rgba[i] = ts_alloc(n, 4, "the texture of a built-in scene");
		made = p->rgba[i] != NULL;
		if (made) draw_map(p->rgba[i], dabs, map_of(i), paint);
	}
	free(dabs);
	if (made || p == NULL) return p;
	destroy(p);
	return NULL;
}

static u32 add_slot(ts_build *build, const ts_paint *paint, const painting *from, u32 i)
{
	bool srgb = i == 0 || map_of(i) == TS_MAP_GLOW;
	if (!has_map(paint, i)) return TS_NONE;
	ts_slot slot = {.image = ts_build_image(build, from->rgba[i], paint->size, paint->size, srgb)};
	slot.transform[0] = 1.0f / paint->tile[0];
	slot.transform[4] = 1.0f / paint->tile[1];
	return ts_build_slot(build, &slot);
}

static void add_slots(ts_build *build, ts_material *material, const ts_paint *paint, const painting *from)
{
	static const u32 slots[N_MAPS] = {TS_SLOT_BASE, TS_SLOT_NORMAL, TS_SLOT_METALROUGH, TS_SLOT_EMISSIVE};
	for (u32 i = 0; i < N_MAPS; i++) material->slot[slots[i]] = add_slot(build, paint, from, i);
	material->slot[TS_SLOT_OCCLUSION] = material->slot[TS_SLOT_METALROUGH];
	if ((paint->maps & TS_MAP_GLOW) != 0) ts_store3(material->emissive, ts_v3_make(1.0f, 1.0f, 1.0f));
}

static void take_painting(ts_build *build, ts_material *material, const ts_paint *paint, u32 seed)
{
	painting *old = find_kept(paint, seed), *p = old != NULL ? old : paint_maps(paint, seed);
	if (p == NULL) {
		ts_build_adopt(build);
		return;
	}
	add_slots(build, material, paint, p);
	if (old != NULL) return;
	if (!keeps) {
		destroy(p);
		return;
	}
	p->of = *paint;
	p->seed = seed;
	p->before = kept;
	kept = p;
}

u32 ts_paint_add(ts_build *build, const ts_paint *paint, u32 seed)
{
	ts_material material = ts_material_default();
	ts_store3(material.base, paint->base);
	material.roughness = paint->roughness;
	material.metallic = paint->metallic;
	material.flags = paint->flags;
	if (paint->painter != NULL) take_painting(build, &material, paint, seed);
	return ts_build_material(build, &material);
}
