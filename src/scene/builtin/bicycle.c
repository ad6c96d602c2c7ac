/* A bicycle: rims, spokes, tubes and chain, the thin things that point rendering finds hard. */
#include "scene/builtin/parts.h"

#define REAR_X (-0.515625f)
#define FRONT_X 0.515625f
#define AXLE_Y 0.34375f

static void bar(ts_mesh *mesh, ts_v3 a, ts_v3 b, f32 radius)
{
	ts_mesh_rod(mesh, a, b, radius, ts_mesh_segments(mesh, 12.0f, 3));
}

static void add_wheel(ts_mesh *mesh, const ts_bicycle_materials *material, f32 x)
{
	static const f32 hub[][2] = {{0.0f, -0.046875f},      {0.0078125f, -0.046875f},   {0.0234375f, -0.03125f},
	                             {0.0234375f, -0.03125f}, {0.01171875f, -0.0234375f}, {0.01171875f, 0.0234375f},
	                             {0.0234375f, 0.03125f},  {0.0234375f, 0.03125f},     {0.0078125f, 0.046875f},
	                             {0.0f, 0.046875f}};
	ts_place stand = mesh->place;
	mesh->place = ts_place_in(&stand, ts_place_along(ts_v3_make(x, AXLE_Y, 0.0f), ts_v3_make(0.0f, 0.0f, 1.0f)));
	mesh->material = material->rubber;
	ts_part_ring(mesh, 0.328125f, 0.015625f, ts_mesh_segments(mesh, 10.0f, 3), ts_mesh_segments(mesh, 80.0f, 10));
	mesh->material = material->steel;
	ts_part_ring(mesh, 0.3125f, 0.0078125f, ts_mesh_segments(mesh, 8.0f, 3), ts_mesh_segments(mesh, 80.0f, 10));
	ts_mesh_lathe(mesh, hub, 10, ts_mesh_segments(mesh, 12.0f, 4), 1.0f);
	for (u32 i = 0; i < 32; i++) {
		f32 turn = (f32)i / 32.0f, lean = turn + (i & 2u ? 0.21875f : -0.21875f), side = i & 1u ? 0.03125f : -0.03125f;
		ts_v3 inner = {0.0234375f * ts_cos_turn(lean), side, 0.0234375f * ts_sin_turn(lean)};
		ts_v3 outer = {0.30859375f * ts_cos_turn(turn), 0.0f, 0.30859375f * ts_sin_turn(turn)};
		ts_mesh_rod(mesh, inner, outer, 0.001220703125f, ts_mesh_segments(mesh, 5.0f, 3));
	}
	mesh->place = stand;
}

static void add_frame(ts_mesh *mesh, const ts_bicycle_materials *material)
{
	const ts_v3 bracket = {-0.078125f, 0.28125f, 0.0f}, seat = {-0.25f, 0.796875f, 0.0f},
				head = {0.359375f, 0.828125f, 0.0f}, crown = {0.40625f, 0.671875f, 0.0f};
	mesh->material = material->paint;
	bar(mesh, bracket, seat, 0.015625f);
	bar(mesh, seat, ts_v3_make(head.x, head.y - 0.03125f, 0.0f), 0.013671875f);
	bar(mesh, bracket, ts_v3_make(crown.x, crown.y + 0.03125f, 0.0f), 0.017578125f);
	bar(mesh, crown, head, 0.01953125f);
	for (u32 i = 0; i < 2; i++) {
		f32 z = i ? 0.05078125f : -0.05078125f;
		ts_v3 rear = {REAR_X, AXLE_Y, z};
		ts_v3 fork[4] = {{crown.x, crown.y, z * 0.25f},
		                 {crown.x + 0.015625f, crown.y - 0.0625f, z},
		                 {crown.x + 0.0625f, AXLE_Y + 0.125f, z},
		                 {FRONT_X, AXLE_Y, z}};
		bar(mesh, ts_v3_make(seat.x, seat.y - 0.03125f, z * 0.25f), rear, 0.0078125f);
		bar(mesh, ts_v3_make(bracket.x, bracket.y, z * 0.375f), rear, 0.009765625f);
		ts_mesh_tube(mesh, fork, 4, 0.01171875f, ts_v3_make(0.0f, 0.0f, 1.0f), ts_mesh_segments(mesh, 10.0f, 3),
		             ts_mesh_segments(mesh, 10.0f, 3));
	}
	mesh->material = material->steel;
	bar(mesh, seat, ts_v3_make(-0.28125f, 0.921875f, 0.0f), 0.01171875f);
	bar(mesh, head, ts_v3_make(0.34375f, 0.890625f, 0.0f), 0.01171875f);
	bar(mesh, ts_v3_make(0.34375f, 0.890625f, 0.0f), ts_v3_make(0.4375f, 0.90625f, 0.0f), 0.01171875f);
	for (u32 i = 0; i < 2; i++) {
		f32 z = i ? 1.0f : -1.0f;
		const ts_v3 drop[7] = {{0.4375f, 0.90625f, 0.0f},           {0.4375f, 0.90625f, z * 0.15625f},
		                       {0.46875f, 0.90625f, z * 0.203125f}, {0.53125f, 0.890625f, z * 0.21875f},
		                       {0.53125f, 0.8125f, z * 0.21875f},   {0.46875f, 0.78125f, z * 0.21875f},
		                       {0.40625f, 0.78125f, z * 0.21875f}};
		ts_mesh_tube(mesh, drop, 7, 0.01171875f, ts_v3_make(0.25f, 1.0f, 0.1875f * z), ts_mesh_segments(mesh, 10.0f, 3),
		             ts_mesh_segments(mesh, 30.0f, 6));
	}
}

/* Where the chain is, a fraction t of its length: around the sprocket behind, along, around the ring in front, back. */
static ts_place chain_at(f32 t)
{
	const f32 front = 0.09375f, rear = 0.0390625f, bx = -0.078125f, by = 0.28125f;
	f32 part = t * 4.0f, f = part - ts_floor(part);
	u32 side = (u32)ts_floor_i32(part);
	f32 turn = side == 0 ? 0.25f + 0.5f * f : side == 2 ? 0.75f + 0.5f * f : side == 1 ? 0.75f : 0.25f;
	f32 mix = side == 0 ? 0.0f : side == 2 ? 1.0f : side == 1 ? f : 1.0f - f;
	f32 r = rear + (front - rear) * mix;
	ts_place p = {ts_v3_make(REAR_X + (bx - REAR_X) * mix + r * ts_cos_turn(turn),
	                         AXLE_Y + (by - AXLE_Y) * mix + r * ts_sin_turn(turn), 0.046875f),
	              ts_v3_make(-ts_sin_turn(turn), ts_cos_turn(turn), 0.0f),
	              ts_v3_make(-ts_cos_turn(turn), -ts_sin_turn(turn), 0.0f), ts_v3_make(0.0f, 0.0f, 1.0f)};
	return p;
}

static void add_drive(ts_mesh *mesh, const ts_bicycle_materials *material)
{
	ts_place stand = mesh->place;
	mesh->material = material->steel;
	u32 n = 4 * ts_mesh_segments(mesh, 28.0f, 5);
	for (u32 i = 0; i < n; i++) {
		ts_place link = chain_at((f32)i / (f32)n);
		mesh->place = ts_place_in(&stand, link);
		ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0f, 0.0f),
		              ts_v3_make(0.625f / (f32)n, 0.00390625f, i & 1u ? 0.00390625f : 0.001953125f), 0.0f, 0);
	}
	mesh->place =
		ts_place_in(&stand, ts_place_along(ts_v3_make(-0.078125f, 0.28125f, 0.046875f), ts_v3_make(0.0f, 0.0f, 1.0f)));
	ts_part_ring(mesh, 0.0859375f, 0.00390625f, ts_mesh_segments(mesh, 6.0f, 3), ts_mesh_segments(mesh, 48.0f, 8));
	mesh->place = stand;
	for (u32 i = 0; i < 5; i++) {
		f32 c = ts_cos_turn((f32)i * 0.2f), s = ts_sin_turn((f32)i * 0.2f);
		bar(mesh, ts_v3_make(-0.078125f, 0.28125f, 0.046875f),
		    ts_v3_make(-0.078125f + 0.0859375f * c, 0.28125f + 0.0859375f * s, 0.046875f), 0.00390625f);
	}
	for (u32 i = 0; i < 2; i++) {
		f32 side = i ? 1.0f : -1.0f;
		ts_v3 a = {-0.078125f, 0.28125f, side * 0.0703125f}, b = {a.x + side * 0.15625f, a.y - side * 0.0625f, a.z};
		bar(mesh, a, b, 0.0078125f);
		mesh->material = material->rubber;
		ts_mesh_block(mesh, ts_v3_make(b.x, b.y, b.z + side * 0.046875f), ts_v3_make(0.03125f, 0.0078125f, 0.0390625f),
		              0.00390625f, ts_mesh_segments(mesh, 1.0f, 0));
		mesh->material = material->steel;
	}
	bar(mesh, ts_v3_make(-0.078125f, 0.28125f, -0.0703125f), ts_v3_make(-0.078125f, 0.28125f, 0.0703125f), 0.01953125f);
}

void ts_part_bicycle(ts_mesh *mesh, const ts_bicycle_materials *material)
{
	add_wheel(mesh, material, REAR_X);
	add_wheel(mesh, material, FRONT_X);
	add_frame(mesh, material);
	add_drive(mesh, material);
	mesh->material = material->leather;
	ts_mesh_block(mesh, ts_v3_make(-0.296875f, 0.9453125f, 0.0f), ts_v3_make(0.0625f, 0.0234375f, 0.0703125f),
	              0.0234375f, ts_mesh_segments(mesh, 3.0f, 1));
	ts_mesh_block(mesh, ts_v3_make(-0.1953125f, 0.9453125f, 0.0f), ts_v3_make(0.0859375f, 0.0171875f, 0.0234375f),
	              0.015625f, ts_mesh_segments(mesh, 3.0f, 1));
}
