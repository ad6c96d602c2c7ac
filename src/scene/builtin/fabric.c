/* Painters of cloth, leather, paper and leaves. */
#include "scene/builtin/paint.h"

/* Over-and-under threads, n per image: height in [0,1]; *warp: whether the warp is on top. */
static f32 threads(bool *warp, f32 u, f32 v, f32 n)
{
	f32 x = u * n, y = v * n;
	i32 i = ts_floor_i32(x), j = ts_floor_i32(y);
	*warp = ((i + j) & 1) == 0;
	f32 across = *warp ? x - (f32)i : y - (f32)j;
	f32 along = *warp ? y - (f32)j : x - (f32)i;
	return (1.0f - ts_cos_turn(across)) * (1.0f - ts_cos_turn(along)) * 0.25f;
}

/* kind: crimson, deep green, blue, linen (plain), gold, grey; the first three with a woven border of stripes. */
void ts_paint_weave(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	static const ts_v3 body[6] = {{0.62f, 0.10f, 0.11f}, {0.11f, 0.36f, 0.20f}, {0.13f, 0.23f, 0.50f},
	                              {0.90f, 0.88f, 0.82f}, {0.75f, 0.56f, 0.24f}, {0.50f, 0.49f, 0.47f}};
	static const ts_v3 trim[6] = {{0.85f, 0.68f, 0.34f}, {0.80f, 0.72f, 0.44f}, {0.82f, 0.78f, 0.66f},
	                              {0.82f, 0.79f, 0.72f}, {0.62f, 0.40f, 0.14f}, {0.42f, 0.41f, 0.40f}};
	bool warp;
	f32 h = threads(&warp, u, v, 64.0f);
	f32 slub = ts_paint_noise(u * 64.0f, v * 4.0f, 64, 4, seed) * 0.5f +
	           ts_paint_noise(u * 4.0f, v * 64.0f, 4, 64, seed + 1u) * 0.5f;
	f32 stripe = ts_abs(ts_paint_fract(u * 2.0f) - 0.5f);
	f32 on = 0.0f;
	if (kind < 3) {
		f32 twist = ts_sin_turn(v * 8.0f) * 0.015625f;
		f32 line = ts_paint_ramp(0.02f, 0.01f, ts_abs(stripe - 0.375f + twist));
		f32 band = ts_paint_ramp(0.46f, 0.47f, stripe);
		f32 diamond = ts_paint_ramp(0.27f, 0.25f,
		                            ts_abs(ts_paint_fract(u * 8.0f) - 0.5f) + ts_abs(ts_paint_fract(v * 8.0f) - 0.5f));
		on = ts_max(line, ts_max(band, diamond * 0.5f));
	}
	ts_v3 c = ts_paint_mix(body[kind], trim[kind], kind < 3 ? on : (warp ? 0.25f : 0.0f));
	dab->colour = ts_scale(c, 0.75f + 0.1875f * h + 0.1875f * slub);
	dab->height = h * 0.001953125f;
	dab->roughness = 0.9375f - 0.1875f * on;
	dab->metallic = 0.0f;
	dab->occlusion = 0.75f + 0.25f * h;
}

/* One oriental carpet, border and all, that does not repeat: the surface covers (u, v) in [0,1) once. */
void ts_paint_carpet(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	static const ts_v3 field[2] = {{0.46f, 0.10f, 0.11f}, {0.16f, 0.22f, 0.36f}};
	static const ts_v3 border[2] = {{0.13f, 0.17f, 0.30f}, {0.44f, 0.13f, 0.12f}};
	const ts_v3 cream = {0.84f, 0.76f, 0.60f}, gold = {0.76f, 0.54f, 0.25f};
	f32 x = ts_abs(u - 0.5f) * 1.5f, y = ts_abs(v - 0.5f);
	f32 rim = ts_min(0.75f - x, 0.5f - y);
	f32 r = ts_sqrt(x * x + y * y * 1.5f);
	f32 petals = x > 0.0f || y > 0.0f ? ts_abs(x - y) / (x + y + 0.0078125f) : 0.0f;
	ts_v3 c = field[kind];
	f32 lattice =
		ts_abs(ts_paint_fract(x * 12.0f + y * 12.0f) - 0.5f) + ts_abs(ts_paint_fract(x * 12.0f - y * 12.0f) - 0.5f);
	if (lattice > 0.875f) c = gold;
	if (lattice < 0.1875f) c = cream;
	f32 star = r + 0.0625f * ts_cos_turn(petals * 2.0f);
	if (star < 0.34f) c = border[kind];
	if (ts_abs(star - 0.34f) < 0.0125f || ts_abs(star - 0.15f) < 0.009375f) c = cream;
	if (star < 0.27f && ts_sin_turn(x * 10.0f) * ts_sin_turn(y * 10.0f + 0.25f) > 0.5f) c = gold;
	if (star < 0.15f) c = lattice > 0.5f ? field[kind] : gold;
	if (rim < 0.125f) {
		f32 run = rim < 0.5f - y ? v : u * 1.5f;
		f32 wave = ts_sin_turn(run * 10.0f) * 0.02f;
		c = border[kind];
		if (ts_abs(rim - 0.0703125f - wave) < 0.0078125f) c = gold;
		if (ts_abs(ts_abs(ts_paint_fract(run * 20.0f) - 0.5f) * 0.05f) + ts_abs(rim - 0.0703125f) < 0.014f) c = cream;
		if (ts_abs(rim - 0.1171875f) < 0.0078125f || ts_abs(rim - 0.0234375f) < 0.005859375f) c = cream;
	}
	f32 pile = ts_paint_noise(u * 256.0f, v * 256.0f, 256, 256, seed);
	f32 fade = ts_paint_fbm(u, v, 4, 3, seed + 2u);
	dab->colour = ts_scale(c, 0.5625f + 0.3125f * pile + 0.3125f * fade);
	dab->height = pile * 0.00390625f;
	dab->roughness = 1.0f;
	dab->metallic = 0.0f;
}

/* Damask: mirrored scrolls in two tones. kind: green, blue-grey. */
void ts_paint_wallpaper(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	static const ts_v3 ground[2] = {{0.55f, 0.60f, 0.49f}, {0.44f, 0.51f, 0.58f}};
	static const ts_v3 figure[2] = {{0.68f, 0.71f, 0.58f}, {0.60f, 0.66f, 0.70f}};
	f32 x = ts_abs(ts_paint_fract(u * 2.0f) - 0.5f);
	f32 y = ts_paint_fract(v * 2.0f + (ts_paint_fract(u) < 0.5f ? 0.0f : 0.5f));
	f32 stem = ts_abs(x - 0.1875f - 0.125f * ts_sin_turn(y));
	f32 cx = x, cy = y - 0.5f;
	f32 r = ts_sqrt(cx * cx + cy * cy);
	f32 lobe = 0.1875f + 0.0625f * ts_cos_turn((cx - ts_abs(cy)) * 5.0f);
	f32 f = ts_max(ts_paint_ramp(0.03125f, 0.0234375f, stem), ts_paint_ramp(lobe, lobe - 0.015625f, r));
	f = ts_min(f, ts_paint_ramp(0.01f, 0.02f, ts_abs(r - lobe * 0.5f)));
	f32 g = ts_paint_fbm(u, v, 16, 4, seed) - 0.5f;
	dab->colour = ts_scale(ts_paint_mix(ground[kind], figure[kind], f), 1.0f + g * 0.125f);
	dab->height = f * 0.00048828125f;
	dab->roughness = 0.875f - 0.25f * f;
	dab->metallic = 0.0f;
}

/* kind: black, tan. */
void ts_paint_leather(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 a = ts_paint_noise(u * 64.0f, v * 64.0f, 64, 64, seed);
	f32 b = ts_paint_noise(u * 128.0f, v * 128.0f, 128, 128, seed + 1u);
	f32 crease = ts_abs(a - 0.5f) + ts_abs(b - 0.5f) * 0.5f;
	f32 worn = ts_paint_fbm(u, v, 3, 4, seed + 2u);
	ts_v3 c = kind == 0 ? ts_v3_make(0.15f, 0.13f, 0.12f) : ts_v3_make(0.50f, 0.30f, 0.17f);
	dab->colour = ts_scale(c, 0.625f + crease * 0.5f + worn * 0.5f);
	dab->height = crease * 0.001953125f;
	dab->roughness = 0.4375f + 0.25f * worn;
	dab->metallic = 0.0f;
}

/* One leaf, stalk at the bottom, with a transparent surround. kind: broad, narrow. */
void ts_paint_leaf(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	f32 y = 1.0f - v, x = ts_abs(u - 0.5f) * 2.0f;
	f32 belly = kind == 0 ? 0.9375f : 0.4375f;
	f32 width = belly * ts_sin_turn(ts_sqrt(y) * 0.5f) * (1.0f - 0.25f * y);
	f32 teeth = 0.03125f * ts_abs(ts_paint_fract(y * 12.0f) - 0.5f);
	f32 inside = ts_paint_ramp(0.0f, 0.03125f, width - teeth - x);
	f32 stalk = ts_paint_ramp(0.046875f, 0.015625f, x);
	f32 vein =
		ts_max(stalk, ts_paint_ramp(0.09375f, 0.0f, ts_abs(ts_paint_fract(y * 8.0f - x * 2.5f) - 0.5f)) * 0.625f);
	f32 g = ts_paint_fbm(u, v, 8, 4, seed);
	ts_v3 c = ts_paint_mix(ts_v3_make(0.14f, 0.33f, 0.11f), ts_v3_make(0.36f, 0.53f, 0.17f), g * 0.75f + x * 0.25f);
	dab->colour = ts_paint_mix(c, ts_v3_make(0.58f, 0.68f, 0.34f), vein * 0.5f);
	dab->alpha = ts_max(inside, stalk * ts_paint_ramp(1.0f, 0.96875f, y));
	dab->height = vein * 0.0009765625f;
	dab->roughness = 0.5f + 0.25f * g;
	dab->metallic = 0.0f;
}

/* A lamp's cloth that glows, brightest near its middle. */
void ts_paint_shade(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	bool warp;
	f32 h = threads(&warp, u, v, 64.0f);
	f32 slub = ts_paint_noise(u * 4.0f, v * 64.0f, 4, 64, seed + kind);
	dab->colour = ts_scale(ts_v3_make(0.98f, 0.86f, 0.62f), 0.8125f + 0.09375f * h + 0.09375f * slub);
	dab->glow = 0.75f + 0.1875f * ts_sin_turn(v * 0.5f);
	dab->roughness = 0.875f;
	dab->metallic = 0.0f;
}

/* Backs of books: 16 colours along u, gilt bands along v. */
void ts_paint_book(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	static const ts_v3 cloth[5] = {{0.42f, 0.12f, 0.10f},
	                               {0.13f, 0.24f, 0.19f},
	                               {0.14f, 0.18f, 0.33f},
	                               {0.46f, 0.32f, 0.18f},
	                               {0.70f, 0.63f, 0.50f}};
	i32 book = ts_floor_i32(u * 16.0f);
	u32 which = ts_random((u32)book, 5u, seed + 77u + kind) % 5u;
	f32 band = ts_abs(ts_paint_fract(v * 5.0f + ts_paint_hash(book, 1, seed) * 0.25f) - 0.5f);
	f32 gilt = ts_paint_ramp(0.0625f, 0.03125f, band);
	f32 g = ts_paint_fbm(u, v, 16, 3, seed);
	ts_v3 c = ts_scale(cloth[which], 0.625f + ts_paint_hash(book, 2, seed) * 0.375f + g * 0.25f);
	dab->colour = ts_paint_mix(c, ts_v3_make(0.82f, 0.65f, 0.32f), gilt * 0.75f);
	dab->roughness = 0.75f - 0.375f * gilt;
	dab->metallic = gilt * 0.5f;
}
