/* Painters of stone, wood, earth and metal. */
#include "scene/builtin/paint.h"

/* Grain in all sizes; the contrast that keeps a plain surface from looking like plastic. */
static f32 grain(f32 u, f32 v, u32 seed) { return ts_paint_fbm(u, v, 8, 5, seed) - 0.5f; }

/* Squared stone in courses of equal height, half a stone displaced: 4 by 8 stones per image. */
void ts_paint_ashlar(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 y = v * 8.0f;
	i32 row = ts_floor_i32(y);
	f32 x = u * 4.0f + (row & 1 ? 0.5f : 0.0f);
	i32 column = ts_floor_i32(x) & 3;
	f32 fx = ts_paint_fract(x), fy = y - (f32)row;
	f32 wobble = (ts_paint_noise(u * 32.0f, v * 32.0f, 32, 32, seed) - 0.5f) * 0.03125f;
	f32 edge = ts_min(ts_min(fx, 1.0f - fx) * 2.0f, ts_min(fy, 1.0f - fy)) + wobble;
	f32 stone = ts_paint_ramp(0.015625f, 0.078125f, edge);
	f32 tone = ts_paint_hash(column, row, seed + 40u);
	f32 g = grain(u, v, seed);
	f32 dirt = ts_paint_fbm(u, v, 3, 4, seed + 9u);
	ts_v3 light = kind == 0 ? ts_v3_make(0.84f, 0.76f, 0.63f) : ts_v3_make(0.70f, 0.66f, 0.62f);
	ts_v3 dark = kind == 0 ? ts_v3_make(0.72f, 0.60f, 0.46f) : ts_v3_make(0.58f, 0.53f, 0.49f);
	ts_v3 c = ts_paint_mix(dark, light, tone * 0.5f + dirt * 0.5f);
	c = ts_scale(c, 0.96f + g * 0.5f);
	dab->colour = ts_paint_mix(ts_v3_make(0.50f, 0.44f, 0.37f), c, stone);
	dab->height = stone * 0.0078125f + g * 0.0078125f;
	dab->roughness = 0.9375f - stone * 0.125f;
	dab->metallic = 0.0f;
	dab->occlusion = 0.5f + 0.5f * stone;
}

static f32 veins(f32 u, f32 v, u32 seed)
{
	f32 warp = ts_paint_fbm(u, v, 4, 5, seed);
	f32 ridge = ts_abs(ts_sin_turn(u + v + warp * 1.5f));
	f32 fine = ts_abs(ts_paint_fbm(u, v, 8, 4, seed + 20u) - 0.5f) * 8.0f;
	return ts_min(1.0f, ts_sqrt(ridge) * 0.75f + ts_min(fine, 1.0f) * 0.25f);
}

static ts_v3 marble_colour(f32 u, f32 v, u32 kind, u32 seed)
{
	static const ts_v3 body[5] = {{0.90f, 0.88f, 0.84f},
	                              {0.36f, 0.19f, 0.16f},
	                              {0.24f, 0.30f, 0.26f},
	                              {0.20f, 0.20f, 0.21f},
	                              {0.80f, 0.70f, 0.54f}};
	static const ts_v3 vein[5] = {{0.58f, 0.57f, 0.58f},
	                              {0.70f, 0.54f, 0.46f},
	                              {0.58f, 0.66f, 0.58f},
	                              {0.66f, 0.62f, 0.56f},
	                              {0.58f, 0.44f, 0.30f}};
	f32 cloud = ts_paint_fbm(u, v, 4, 5, seed + 60u);
	ts_v3 c = ts_scale(body[kind], 0.875f + cloud * 0.25f);
	return ts_paint_mix(vein[kind], c, ts_paint_ramp(0.0f, 0.5f, veins(u, v, seed)));
}

/* kind: white, red, green, black, yellow. */
void ts_paint_marble(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	dab->colour = marble_colour(u, v, kind, seed + kind * 100u);
	dab->roughness = 0.25f + 0.125f * grain(u, v, seed);
	dab->metallic = 0.0f;
}

/* A floor of two marbles, 4 by 4 squares per image, with small dark squares on the corners. kind 1: set diagonally. */
void ts_paint_tiles(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 x = kind == 0 ? u * 4.0f : (u + v) * 4.0f;
	f32 y = kind == 0 ? v * 4.0f : (u - v) * 4.0f + 4.0f;
	i32 i = ts_floor_i32(x), j = ts_floor_i32(y);
	f32 fx = x - (f32)i, fy = y - (f32)j;
	f32 ex = ts_min(fx, 1.0f - fx), ey = ts_min(fy, 1.0f - fy);
	f32 joint = ts_paint_ramp(0.0078125f, 0.0234375f, ts_min(ex, ey));
	bool inlay = ex + ey < 0.1875f;
	f32 rim = ts_paint_ramp(0.0078125f, 0.0234375f, ts_abs(ex + ey - 0.1875f));
	u32 stone = inlay ? 3u : (((i + j) & 1) != 0 ? 4u : 0u);
	f32 shift = ts_paint_hash(i & 7, j & 7, seed + 80u);
	ts_v3 c = marble_colour(ts_paint_fract(u + shift), ts_paint_fract(v + shift * 0.5f), stone, seed + stone);
	c = ts_scale(c, 0.84375f + 0.15625f * shift);
	f32 flat = ts_min(joint, rim);
	f32 wear = ts_paint_fbm(u, v, 4, 4, seed + 90u);
	dab->colour = ts_paint_mix(ts_v3_make(0.30f, 0.27f, 0.24f), c, flat);
	dab->height = flat * 0.001953125f;
	dab->roughness = 0.25f + 0.25f * wear + (1.0f - flat) * 0.375f;
	dab->metallic = 0.0f;
	dab->occlusion = 0.75f + 0.25f * flat;
}

/* kind: warm white, ochre, cool grey, deep red, sage. */
void ts_paint_plaster(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	static const ts_v3 tint[5] = {{0.90f, 0.87f, 0.80f},
	                              {0.83f, 0.67f, 0.42f},
	                              {0.76f, 0.77f, 0.78f},
	                              {0.48f, 0.17f, 0.16f},
	                              {0.55f, 0.60f, 0.50f}};
	f32 g = grain(u, v, seed);
	f32 patch = ts_paint_fbm(u, v, 3, 4, seed + 7u) - 0.5f;
	f32 trowel = ts_paint_noise(u * 16.0f, v * 64.0f, 16, 64, seed + 8u) - 0.5f;
	dab->colour = ts_scale(tint[kind], 1.0f + g * 0.125f + patch * (kind == 0 ? 0.0625f : 0.1875f) + trowel * 0.03125f);
	dab->height = g * 0.015625f + trowel * 0.00048828125f;
	dab->roughness = 0.875f;
	dab->metallic = 0.0f;
}

void ts_paint_terracotta(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 g = grain(u, v, seed);
	f32 rings = ts_paint_noise(u * 4.0f, v * 64.0f, 4, 64, seed + 3u) - 0.5f;
	ts_v3 c = kind == 0 ? ts_v3_make(0.72f, 0.40f, 0.26f) : ts_v3_make(0.30f, 0.42f, 0.52f);
	f32 bloom = ts_paint_ramp(0.55f, 0.75f, ts_paint_fbm(u, v, 3, 4, seed + 5u));
	c = ts_scale(c, 1.0f + g * 0.375f + rings * 0.125f);
	dab->colour = ts_paint_mix(c, ts_v3_make(0.80f, 0.72f, 0.64f), bloom * 0.375f);
	dab->height = rings * 0.00048828125f + g * 0.001953125f;
	dab->roughness = 0.75f;
	dab->metallic = 0.0f;
}

/* Along v; `tone` moves the ring pattern. */
static f32 wood_rings(f32 u, f32 v, f32 tone, u32 seed)
{
	f32 warp = ts_paint_noise(u * 8.0f, v * 2.0f, 8, 2, seed);
	f32 rings = ts_paint_fract((u + warp * 0.1875f + tone) * 12.0f);
	f32 fibre = ts_paint_noise(u * 128.0f, v * 8.0f, 128, 8, seed + 2u);
	return rings * 0.625f + fibre * 0.375f;
}

/* kind: oak, walnut, mahogany, pale. */
static ts_v3 wood_colour(f32 rings, f32 tone, u32 kind)
{
	static const ts_v3 light[4] = {
		{0.76f, 0.57f, 0.36f}, {0.46f, 0.30f, 0.19f}, {0.48f, 0.22f, 0.13f}, {0.85f, 0.74f, 0.57f}};
	static const ts_v3 dark[4] = {
		{0.56f, 0.37f, 0.20f}, {0.27f, 0.16f, 0.10f}, {0.26f, 0.09f, 0.06f}, {0.70f, 0.56f, 0.38f}};
	return ts_scale(ts_paint_mix(light[kind], dark[kind], rings), 0.875f + 0.25f * tone);
}

void ts_paint_wood(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 rings = wood_rings(u, v, 0.0f, seed + kind * 10u);
	dab->colour = wood_colour(rings, ts_paint_fbm(u, v, 2, 3, seed + 50u), kind);
	dab->height = -rings * 0.000244140625f;
	dab->roughness = 0.375f + rings * 0.1875f;
	dab->metallic = 0.0f;
}

/* Straight boards with broken joints: 8 boards across, 2 long. */
void ts_paint_parquet(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 x = u * 8.0f;
	i32 board = ts_floor_i32(x);
	f32 y = v * 2.0f + ts_paint_hash(board, 0, seed + 11u);
	i32 piece = ts_floor_i32(y) & 1;
	f32 fx = x - (f32)board, fy = ts_paint_fract(y);
	f32 gap = ts_min(ts_paint_ramp(0.0f, 0.03125f, ts_min(fx, 1.0f - fx)),
	                 ts_paint_ramp(0.0f, 0.00390625f, ts_min(fy, 1.0f - fy)));
	f32 tone = ts_paint_hash(board, piece + 2, seed + 12u);
	f32 rings = wood_rings(u, v, tone, seed + (u32)(board * 2 + piece) * 5u);
	dab->colour = ts_scale(wood_colour(rings, tone, kind), 0.375f + 0.625f * gap);
	dab->height = gap * 0.0009765625f;
	dab->roughness = 0.3125f + rings * 0.1875f + (1.0f - gap) * 0.25f;
	dab->metallic = 0.0f;
	dab->occlusion = 0.5f + 0.5f * gap;
}

void ts_paint_soil(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 g = ts_paint_fbm(u, v, 16, 4, seed + kind);
	dab->colour = ts_scale(ts_v3_make(0.30f, 0.22f, 0.16f), 0.5f + g);
	dab->height = g * 0.015625f;
	dab->roughness = 1.0f;
	dab->metallic = 0.0f;
}

/* kind: bronze with green in its hollows, brushed steel, brass, gilding worn to the ground. */
void ts_paint_metal(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	static const ts_v3 body[4] = {
		{0.55f, 0.42f, 0.28f}, {0.76f, 0.77f, 0.78f}, {0.86f, 0.70f, 0.38f}, {0.89f, 0.71f, 0.36f}};
	static const ts_v3 worn[4] = {
		{0.34f, 0.48f, 0.42f}, {0.62f, 0.62f, 0.63f}, {0.58f, 0.42f, 0.22f}, {0.42f, 0.18f, 0.11f}};
	f32 brush = ts_paint_noise(u * 4.0f, v * 128.0f, 4, 128, seed);
	f32 patch = ts_paint_ramp(0.5f, 0.6875f, ts_paint_fbm(u, v, 6, 5, seed + 4u)) * (kind == 1 ? 0.25f : 0.75f);
	dab->colour = ts_scale(ts_paint_mix(body[kind], worn[kind], patch), 0.9375f + 0.125f * brush);
	dab->roughness = 0.25f + 0.125f * brush + 0.4375f * patch;
	dab->metallic = 1.0f - patch * 0.75f;
	dab->occlusion = 1.0f - 0.25f * patch;
}
