/* Plants, cloth, ropes, chains, pictures, rugs: see parts.h. */
#include "scene/builtin/parts.h"

typedef struct {
	ts_v3 up, out, side;
	f32 length, width, droop, curl;
} leaf_shape;

/* Grows along `up`, bends over to `out`; u across, v from the tip (0) to the stalk (1). */
static void leaf(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const leaf_shape *l = shape;
	f32 angle = 0.0625f + l->droop * t;
	f32 x = s * 2.0f - 1.0f;
	ts_v3 rise = ts_scale(l->up, t * ts_cos_turn(angle) * l->length);
	ts_v3 reach = ts_scale(l->out, t * ts_sin_turn(angle) * l->length);
	c->p = ts_mad(ts_add(rise, reach), l->side, x * l->width);
	c->p = ts_mad(c->p, l->up, x * x * l->curl * l->width);
	c->uv = ts_v2_make(s, 1.0f - t);
}

static void add_leaf(ts_mesh *mesh, f32 y, f32 length, f32 width, f32 droop, u32 id)
{
	f32 turn = (f32)(id & 255u) * 0.38196563720703125f + ts_mesh_random(mesh, id + 1u) * 0.125f;
	ts_place stand = mesh->place;
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, y, 0.0f, turn));
	leaf_shape l = {
		.up = ts_v3_make(0.0f, 1.0f, 0.0f), .out = ts_v3_make(0.0f, 0.0f, 1.0f), .side = ts_v3_make(-1.0f, 0.0f, 0.0f)};
	l.length = length * (0.75f + 0.5f * ts_mesh_random(mesh, id + 2u));
	l.width = width * (0.75f + 0.5f * ts_mesh_random(mesh, id + 3u));
	l.droop = droop * (0.5f + 0.75f * ts_mesh_random(mesh, id + 4u));
	l.curl = 0.3125f;
	ts_mesh_grid(mesh, ts_mesh_segments(mesh, 2.0f, 1), ts_mesh_segments(mesh, 5.0f, 2), 0, leaf, &l);
	mesh->place = stand;
}

void ts_part_plant(ts_mesh *mesh, const ts_plant_materials *material, f32 radius, f32 height, u32 kind, u32 id)
{
	f32 r = radius;
	const f32 pot[][2] = {{r * 0.625f, 0.0f},        {r * 0.6875f, r * 0.125f}, {r * 0.875f, r},
	                      {r * 0.9375f, r * 1.375f}, {r * 0.9375f, r * 1.375f}, {r * 1.0625f, r * 1.40625f},
	                      {r * 1.09375f, r * 1.5f},  {r * 1.0625f, r * 1.625f}, {r * 1.0625f, r * 1.625f},
	                      {r * 0.9375f, r * 1.625f}, {r * 0.9375f, r * 1.625f}, {r * 0.90625f, r * 1.4375f}};
	const f32 soil[][2] = {{r * 0.90625f, r * 1.4375f}, {0.0f, r * 1.5f}};
	mesh->material = material->pot;
	ts_mesh_lathe(mesh, pot, 12, ts_mesh_segments(mesh, 32.0f, 6), 2.0f);
	mesh->material = material->soil;
	ts_mesh_lathe(mesh, soil, 2, ts_mesh_segments(mesh, 16.0f, 5), 3.0f);
	mesh->material = material->stem;
	ts_v3 up = {0.0f, r * 1.4375f, 0.0f};
	u32 stems = kind == 0 && ts_mesh_shows(mesh, 0.25f) ? 4 : 1;
	f32 crown = kind == 0 ? height : height * 0.25f;
	for (u32 k = 0; k < stems; k++) {
		f32 turn = (f32)k * 0.25f + ts_mesh_random(mesh, id + k), lean = r * 0.5f * (kind == 0 ? 1.0f : 0.0f);
		ts_v3 tip = {lean * ts_cos_turn(turn), up.y + crown * 0.75f, lean * ts_sin_turn(turn)};
		ts_v3 points[3] = {up, {tip.x * 0.25f, (up.y + tip.y) * 0.5f, tip.z * 0.25f}, tip};
		ts_mesh_tube(mesh, points, 3, r * 0.03125f, ts_v3_make(-ts_sin_turn(turn), 0.0f, ts_cos_turn(turn)),
		             ts_mesh_segments(mesh, 6.0f, 3), ts_mesh_segments(mesh, 8.0f, 2));
	}
	mesh->material = material->leaf;
	u32 n = kind == 0 ? ts_mesh_segments(mesh, 260.0f, 24) : ts_mesh_segments(mesh, 100.0f, 16);
	for (u32 k = 0; k < n; k++) {
		f32 y = ts_mesh_random(mesh, id + 7919u * k);
		if (kind == 0)
			add_leaf(mesh, up.y + crown * (0.125f + y * 0.625f), radius * (1.375f - 0.625f * y), radius * 0.40625f,
			         0.3125f, id + 16u * k + k);
		else
			add_leaf(mesh, up.y + crown * 0.5f * y, height, radius * 0.1875f, 0.171875f, id + 16u * k + k);
	}
}

typedef struct {
	f32 width, height, folds, depth, gather, phase;
} curtain_shape;

static void curtain(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const curtain_shape *k = shape;
	f32 down = 1.0f - t;
	f32 width = k->width * (1.0f + (k->gather - 1.0f) * down * (2.0f - down));
	f32 wave = s * k->folds + 0.125f * ts_sin_turn(s * 3.0f + k->phase) + 0.0625f * ts_sin_turn(down * 0.75f + s);
	f32 z = ts_sin_turn(wave + k->phase) * k->depth * (0.5f + 0.5f * down);
	z = z + ts_sin_turn(wave * 2.0f + down + k->phase) * k->depth * 0.125f * down;
	f32 hem = down * down * k->height * 0.015625f * ts_sin_turn(wave * 0.5f);
	c->p = ts_v3_make((s - 0.5f) * width, -down * k->height - hem, z);
	c->uv = ts_v2_make(s * k->width, down * k->height);
}

void ts_part_curtain(ts_mesh *mesh, f32 width, f32 height, f32 folds, f32 depth, f32 gather, u32 id)
{
	curtain_shape c = {width, height, folds, depth, gather, ts_mesh_random(mesh, id)};
	ts_mesh_grid(mesh, ts_mesh_segments(mesh, 14.0f * folds, 6), ts_mesh_segments(mesh, height * 8.0f, 3), 0, curtain,
	             &c);
}

void ts_part_rope(ts_mesh *mesh, ts_v3 a, ts_v3 b, f32 sag, f32 radius, u32 na, u32 nl)
{
	ts_v3 points[5];
	for (u32 k = 0; k < 5; k++) {
		f32 t = (f32)k * 0.25f;
		points[k] = ts_mad(a, ts_sub(b, a), t);
		points[k].y = points[k].y - 4.0f * t * (1.0f - t) * sag;
	}
	ts_v3 flat = ts_v3_make(a.z - b.z, 0.0f, b.x - a.x);
	ts_mesh_tube(mesh, points, 5, radius, flat, na, nl);
}

typedef struct {
	f32 ring, tube, stretch;
} ring_shape;

static void ring(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const ring_shape *r = shape;
	f32 turn = t < 1.0f ? t : 0.0f, around = s < 1.0f ? -s : 0.0f;
	f32 out = ts_cos_turn(around);
	f32 d = r->ring + r->tube * out;
	c->n = ts_v3_make(out * ts_cos_turn(turn), ts_sin_turn(around), -out * ts_sin_turn(turn));
	c->p = ts_v3_make(d * ts_cos_turn(turn) * r->stretch, r->tube * c->n.y, -d * ts_sin_turn(turn));
	c->uv = ts_v2_make(s * r->tube * 6.28125f, t * r->ring * 6.28125f);
}

void ts_part_ring(ts_mesh *mesh, f32 ring_radius, f32 tube, u32 na, u32 nl)
{
	ring_shape r = {ring_radius, tube, 1.0f};
	ts_mesh_grid(mesh, na, nl, 0, ring, &r);
}

void ts_part_chain(ts_mesh *mesh, ts_v3 a, u32 n, f32 link, f32 radius)
{
	ts_place stand = mesh->place;
	ring_shape r = {link * 0.3125f, radius, 2.0f};
	for (u32 k = 0; k < n; k++) {
		ts_place at = ts_place_at(a.x, a.y - link * (f32)k, a.z, (f32)(k & 1u) * 0.25f);
		ts_v3 x = at.x;
		at.x = at.y;
		at.y = ts_neg(x);
		mesh->place = ts_place_in(&stand, at);
		ts_mesh_grid(mesh, ts_mesh_segments(mesh, 5.0f, 3), ts_mesh_segments(mesh, 12.0f, 4), 0, ring, &r);
	}
	mesh->place = stand;
}

typedef struct {
	f32 hx, hy, z;
} canvas_shape;

static void canvas(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const canvas_shape *k = shape;
	c->p = ts_v3_make((2.0f * s - 1.0f) * k->hx, (2.0f * t - 1.0f) * k->hy, k->z);
	c->uv = ts_v2_make(s, 1.0f - t);
}

void ts_part_picture(ts_mesh *mesh, u32 frame, u32 picture, f32 hx, f32 hy, f32 width)
{
	f32 w = width;
	const f32 profile[][2] = {
		{w, 0.0f},         {w, w * 0.375f}, {w * 0.875f, w * 0.5f}, {w * 0.5f, w * 0.3125f}, {w * 0.25f, w * 0.4375f},
		{0.0f, w * 0.125f}};
	mesh->material = frame;
	ts_mesh_frame(mesh, hx, hy, profile, 6, w * 0.125f, ts_mesh_segments(mesh, 40.0f, 1));
	mesh->material = picture;
	canvas_shape c = {hx, hy, w * 0.1875f};
	ts_mesh_grid(mesh, 2, 2, 0, canvas, &c);
}

typedef struct {
	f32 half;
	const f32 (*profile)[2];
	u32 n;
} moulding_shape;

static void moulding(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const moulding_shape *m = shape;
	u32 i = (u32)ts_floor_i32(t * (f32)(m->n - 1) + 0.5f);
	c->p = ts_v3_make((2.0f * s - 1.0f) * m->half, m->profile[i][1], m->profile[i][0]);
	c->uv = ts_v2_make((s - 0.5f) * 2.0f * m->half, -(m->profile[i][1] + m->profile[i][0]));
}

void ts_part_moulding(ts_mesh *mesh, f32 half, const f32 (*profile)[2], u32 n_points, u32 n_along)
{
	moulding_shape m = {half, profile, n_points};
	ts_mesh_grid(mesh, n_along, n_points - 1, TS_GRID_FLAT, moulding, &m);
}

static void rug_surface(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const ts_rug *r = shape;
	f32 x = 2.0f * s - 1.0f, z = 1.0f - 2.0f * t;
	f32 swell = ts_sin_turn(x * r->waves[0] + z * r->waves[1]);
	swell = swell + ts_sin_turn(x * r->waves[2] - z * r->waves[3]) * 0.5f + 1.5f;
	c->p = ts_v3_make(x * r->half_x, r->height + swell * 0.00390625f, z * r->half_z + r->z);
	c->uv = ts_v2_make(s * r->repeats, t);
}

void ts_part_rug(ts_mesh *mesh, const ts_rug *rug, u32 n)
{
	ts_mesh_fill(mesh, n, rug->half_x / rug->half_z, rug_surface, rug);
}
