/* From painters to images and materials: see paint.h. */
#include "scene/builtin/paint.h"
#include <stdlib.h>
#include "model/core.h"

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

static u32 add_slot(ts_build *build, const ts_dab *dabs, u8 *rgba, u32 map, const ts_paint *paint)
{
#pragma omp parallel for num_threads((int)ts_threads_all())
	for (u32 y = 0; y < paint->size; y++) {
		for (u32 x = 0; x < paint->size; x++) put_map(rgba + 4 * (y * paint->size + x), dabs, map, paint, x, y);
	}
	bool srgb = map == 0 || map == TS_MAP_GLOW;
	ts_slot slot = {.image = ts_build_image(build, rgba, paint->size, paint->size, srgb)};
	slot.transform[0] = 1.0f / paint->tile[0];
	slot.transform[4] = 1.0f / paint->tile[1];
	return ts_build_slot(build, &slot);
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

static void add_slots(ts_build *build, ts_material *material, const ts_paint *paint, u32 seed)
{
	size_t n = (size_t)paint->size * paint->size;
	ts_dab *dabs = ts_alloc(n, sizeof *dabs, "the texture of a built-in scene");
	u8 *rgba = ts_alloc(n, 4, "the texture of a built-in scene");
	if (dabs == NULL || rgba == NULL) {
		ts_build_adopt(build);
	} else {
		paint_dabs(dabs, paint, seed);
		material->slot[TS_SLOT_BASE] = add_slot(build, dabs, rgba, 0, paint);
		if ((paint->maps & TS_MAP_NORMAL) != 0)
			material->slot[TS_SLOT_NORMAL] = add_slot(build, dabs, rgba, TS_MAP_NORMAL, paint);
		if ((paint->maps & TS_MAP_SURFACE) != 0) {
			material->slot[TS_SLOT_METALROUGH] = add_slot(build, dabs, rgba, TS_MAP_SURFACE, paint);
			material->slot[TS_SLOT_OCCLUSION] = material->slot[TS_SLOT_METALROUGH];
		}
		if ((paint->maps & TS_MAP_GLOW) != 0) {
			material->slot[TS_SLOT_EMISSIVE] = add_slot(build, dabs, rgba, TS_MAP_GLOW, paint);
			ts_store3(material->emissive, ts_v3_make(1.0f, 1.0f, 1.0f));
		}
	}
	free(dabs);
	free(rgba);
}

u32 ts_paint_add(ts_build *build, const ts_paint *paint, u32 seed)
{
	ts_material material = ts_material_default();
	ts_store3(material.base, paint->base);
	material.roughness = paint->roughness;
	material.metallic = paint->metallic;
	material.flags = paint->flags;
	if (paint->painter != NULL) add_slots(build, &material, paint, seed);
	return ts_build_material(build, &material);
}
