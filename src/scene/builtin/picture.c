/* Painted pictures for the walls: land and sea, still life, a portrait, squares, waves, a town, dots. */
#include "scene/builtin/paint.h"

static ts_v3 rgb(f32 r, f32 g, f32 b) { return ts_v3_make(r, g, b); }

/* Ridges one behind the other under an evening sky. */
static ts_v3 hills(f32 u, f32 v, u32 seed)
{
	ts_v3 c = ts_paint_mix(rgb(0.36f, 0.48f, 0.66f), rgb(0.95f, 0.76f, 0.52f), ts_min(v * 1.75f, 1.0f));
	f32 cloud = ts_paint_ramp(0.5f, 0.75f, ts_paint_fbm(u, v * 2.0f - ts_floor(v * 2.0f), 4, 5, seed));
	c = ts_paint_mix(c, rgb(0.96f, 0.90f, 0.84f), cloud * (1.0f - v) * 0.75f);
	for (u32 k = 0; k < 5; k++) {
		f32 ridge = 0.40f + 0.11f * (f32)k - 0.16f * ts_paint_fbm(u, 0.25f, 3 + k, 5, seed + 10u * k + 3u);
		if (v < ridge) continue;
		f32 near = (f32)k * 0.25f;
		ts_v3 far_green = rgb(0.46f, 0.55f, 0.62f), near_green = rgb(0.20f, 0.27f, 0.10f);
		f32 field = ts_paint_fbm(u, v, 24, 3, seed + k);
		c = ts_scale(ts_paint_mix(far_green, near_green, near), 0.6875f + 0.625f * field);
	}
	return c;
}

static ts_v3 sea(f32 u, f32 v, u32 seed)
{
	f32 horizon = 0.4375f;
	f32 cloud = ts_paint_fbm(u, v, 3, 6, seed);
	if (v < horizon)
		return ts_paint_mix(rgb(0.34f, 0.46f, 0.60f), rgb(0.93f, 0.90f, 0.84f),
		                    ts_paint_ramp(0.35f, 0.75f, cloud + v * 0.5f));
	f32 depth = (v - horizon) * 2.0f;
	f32 wave = ts_paint_noise(u * 10.0f / (0.25f + depth), v * 48.0f, 64, 48, seed + 5u);
	ts_v3 c = ts_paint_mix(rgb(0.42f, 0.58f, 0.62f), rgb(0.05f, 0.20f, 0.28f), ts_min(depth, 1.0f));
	f32 sail = ts_max(ts_abs(u - 0.625f) * 4.0f - (v - 0.33f), 0.56f - v - 0.25f);
	c = ts_paint_mix(c, rgb(0.90f, 0.93f, 0.92f), ts_paint_ramp(0.6875f, 0.875f, wave));
	return sail < 0.0f && v < 0.46f ? rgb(0.94f, 0.90f, 0.80f) : c;
}

static f32 disc(f32 u, f32 v, f32 x, f32 y, f32 rx, f32 ry)
{
	f32 dx = (u - x) / rx, dy = (v - y) / ry;
	return ts_sqrt(dx * dx + dy * dy);
}

static ts_v3 ball(ts_v3 under, ts_v3 colour, f32 u, f32 v, f32 x, f32 y, f32 rx, f32 ry)
{
	f32 d = disc(u, v, x, y, rx, ry);
	f32 light = ts_clamp(1.25f - disc(u, v, x - rx * 0.375f, y - ry * 0.375f, rx * 1.5f, ry * 1.5f), 0.1875f, 1.0f);
	return ts_paint_mix(ts_scale(colour, light), under, ts_paint_ramp(0.96875f, 1.0f, d));
}

static ts_v3 still_life(f32 u, f32 v, u32 seed)
{
	f32 dark = ts_paint_fbm(u, v, 4, 5, seed);
	ts_v3 c = ts_scale(rgb(0.26f, 0.20f, 0.14f), 0.5f + dark * 0.75f + (1.0f - u) * 0.5f);
	if (v > 0.6875f) c = ts_scale(rgb(0.62f, 0.56f, 0.46f), 0.5f + 0.5f * ts_paint_fbm(u, v, 8, 4, seed + 2u));
	c = ball(c, rgb(0.30f, 0.42f, 0.46f), u, v, 0.34f, 0.48f, 0.13f, 0.25f);
	c = ball(c, rgb(0.32f, 0.44f, 0.48f), u, v, 0.34f, 0.25f, 0.05f, 0.10f);
	c = ball(c, rgb(0.86f, 0.50f, 0.12f), u, v, 0.58f, 0.67f, 0.09f, 0.09f);
	c = ball(c, rgb(0.74f, 0.16f, 0.10f), u, v, 0.72f, 0.70f, 0.08f, 0.08f);
	c = ball(c, rgb(0.72f, 0.68f, 0.20f), u, v, 0.48f, 0.74f, 0.07f, 0.08f);
	for (u32 k = 0; k < 9; k++) {
		f32 x = 0.78f + 0.10f * ts_paint_hash((i32)k, 5, seed), y = 0.70f + 0.10f * ts_paint_hash((i32)k, 6, seed);
		c = ball(c, rgb(0.24f, 0.12f, 0.28f), u, v, x, y, 0.03f, 0.035f);
	}
	return c;
}

static ts_v3 portrait(f32 u, f32 v, u32 seed)
{
	f32 g = ts_paint_fbm(u, v, 6, 5, seed);
	ts_v3 c = ts_scale(rgb(0.28f, 0.24f, 0.17f), 0.5f + g);
	c = ball(c, rgb(0.30f, 0.10f, 0.10f), u, v, 0.5f, 1.05f, 0.40f, 0.42f);
	c = ball(c, rgb(0.22f, 0.14f, 0.09f), u, v, 0.5f, 0.36f, 0.19f, 0.25f);
	c = ball(c, rgb(0.80f, 0.62f, 0.48f), u, v, 0.5f, 0.62f, 0.07f, 0.12f);
	c = ball(c, rgb(0.90f, 0.72f, 0.57f), u, v, 0.5f, 0.40f, 0.135f, 0.20f);
	c = ball(c, rgb(0.22f, 0.14f, 0.09f), u, v, 0.5f, 0.22f, 0.16f, 0.10f);
	c = ball(c, rgb(0.16f, 0.12f, 0.10f), u, v, 0.45f, 0.38f, 0.018f, 0.010f);
	c = ball(c, rgb(0.16f, 0.12f, 0.10f), u, v, 0.55f, 0.38f, 0.018f, 0.010f);
	c = ball(c, rgb(0.80f, 0.56f, 0.44f), u, v, 0.5f, 0.44f, 0.018f, 0.035f);
	c = ball(c, rgb(0.66f, 0.28f, 0.24f), u, v, 0.5f, 0.51f, 0.040f, 0.012f);
	return ball(c, rgb(0.92f, 0.90f, 0.86f), u, v, 0.5f, 0.74f, 0.15f, 0.05f);
}

/* Rectangles cut again and again at random places, black lines between. */
static ts_v3 squares(f32 u, f32 v, u32 seed)
{
	static const ts_v3 paint[6] = {{0.93f, 0.91f, 0.86f}, {0.93f, 0.91f, 0.86f}, {0.80f, 0.13f, 0.10f},
	                               {0.93f, 0.91f, 0.86f}, {0.12f, 0.22f, 0.52f}, {0.93f, 0.77f, 0.17f}};
	f32 lo[2] = {0.0f, 0.0f}, hi[2] = {1.0f, 1.0f};
	const f32 at[2] = {u, v};
	u32 id = 1;
	f32 edge = 1.0f;
	for (u32 k = 0; k < 6; k++) {
		u32 axis = k & 1u;
		f32 cut = lo[axis] + (hi[axis] - lo[axis]) * (0.25f + 0.5f * ts_uniform(ts_random(id, 5u, seed)));
		bool above = at[axis] >= cut;
		edge = ts_min(edge, ts_abs(at[axis] - cut));
		if (above)
			lo[axis] = cut;
		else
			hi[axis] = cut;
		id = id * 2 + (above ? 1 : 0);
	}
	return edge < 0.01f ? rgb(0.08f, 0.08f, 0.08f) : paint[ts_random(id, 5u, seed + 1u) % 6u];
}

static ts_v3 waves(f32 u, f32 v, u32 seed)
{
	f32 a = ts_paint_fbm(u, v, 3, 4, seed), b = ts_paint_fbm(v, u, 3, 4, seed + 9u);
	f32 band = ts_sin_turn(a * 3.0f + v * 1.5f) * 0.5f + 0.5f;
	ts_v3 c = ts_paint_mix(rgb(0.10f, 0.20f, 0.36f), rgb(0.90f, 0.46f, 0.20f), band);
	return ts_paint_mix(c, rgb(0.95f, 0.87f, 0.66f), ts_paint_ramp(0.5f, 0.75f, b));
}

/* Gables along a canal, windows lit, and their reflection. */
static ts_v3 town(f32 u, f32 v, u32 seed)
{
	bool water = v > 0.6875f;
	f32 y = water ? 1.375f - v + 0.01f * ts_sin_turn(v * 40.0f + u) : v;
	f32 x = u * 7.0f;
	i32 house = ts_floor_i32(x);
	f32 fx = x - (f32)house;
	f32 roof = 0.25f + 0.1875f * ts_paint_hash(house, 0, seed) + ts_abs(fx - 0.5f) * 0.25f;
	ts_v3 c = ts_paint_mix(rgb(0.20f, 0.28f, 0.46f), rgb(0.90f, 0.66f, 0.48f), ts_min(y * 1.5f, 1.0f));
	if (y > roof) {
		f32 tone = ts_paint_hash(house, 1, seed);
		c = ts_paint_mix(rgb(0.50f, 0.22f, 0.15f), rgb(0.66f, 0.56f, 0.42f), tone);
		f32 wx = ts_abs(ts_paint_fract(fx * 3.0f) - 0.5f), wy = ts_abs(ts_paint_fract(y * 12.0f) - 0.5f);
		bool lit = ts_paint_hash(house * 3 + ts_floor_i32(fx * 3.0f), ts_floor_i32(y * 12.0f) + 4, seed) > 0.5f;
		if (wx < 0.25f && wy < 0.3125f && y > roof + 0.06f)
			c = lit ? rgb(0.98f, 0.84f, 0.46f) : rgb(0.16f, 0.18f, 0.24f);
		if (y < roof + 0.015625f) c = rgb(0.90f, 0.86f, 0.78f);
	}
	return water ? ts_paint_mix(ts_scale(c, 0.625f), rgb(0.14f, 0.22f, 0.30f), 0.375f) : c;
}

/* A field of dots, larger and warmer towards the middle. */
static ts_v3 dots(f32 u, f32 v, u32 seed)
{
	f32 x = u * 16.0f, y = v * 16.0f;
	i32 i = ts_floor_i32(x), j = ts_floor_i32(y);
	f32 middle = disc((f32)i / 15.0f, (f32)j / 15.0f, 0.5f, 0.5f, 0.7f, 0.7f);
	f32 r = 0.5f - 0.3125f * ts_min(middle, 1.0f) + 0.0625f * ts_paint_hash(i, j, seed);
	f32 d = disc(x - (f32)i, y - (f32)j, 0.5f, 0.5f, r, r);
	ts_v3 warm = rgb(0.94f, 0.40f, 0.16f), cold = rgb(0.10f, 0.36f, 0.52f);
	ts_v3 c = ts_paint_mix(warm, cold, ts_clamp(middle + ts_paint_hash(i, j, seed + 1u) * 0.5f - 0.25f, 0.0f, 1.0f));
	return ts_paint_mix(c, rgb(0.92f, 0.90f, 0.84f), ts_paint_ramp(0.9375f, 1.0f, d));
}

void ts_paint_picture(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed)
{
	static ts_v3 (*const subject[TS_N_PICTURES])(f32, f32, u32) = {hills,      portrait, sea,  squares,
	                                                               still_life, waves,    town, dots};
	f32 canvas = ts_paint_noise(u * 128.0f, v * 128.0f, 128, 128, seed);
	f32 stroke = ts_paint_noise(u * 24.0f + v * 40.0f, v * 64.0f, 64, 64, seed + 1u) - 0.5f;
	f32 wobble = stroke * 0.0078125f;
	dab->colour = ts_scale(subject[kind](u + wobble, v + wobble, seed + kind * 200u),
	                       0.9375f + 0.0625f * canvas + 0.125f * stroke);
	dab->height = canvas * 0.00048828125f + stroke * 0.001953125f;
	dab->roughness = 0.5f + 0.25f * canvas;
	dab->metallic = 0.0f;
}
