/* "gallery": a hall under a skylight with a cabinet behind a doorway in each corner, hung with pictures.
 * 24 by 18 by 5.25 m; a bicycle, a knot of bronze, vases and benches stand in it. */
#include "scene/builtin/builtin.h"
#include "scene/builtin/parts.h"

enum {
	PARQUET,
	RED,
	SAGE,
	CEILING,
	TRIM,
	OAK,
	LEATHER,
	TAN,
	GILT,
	BLACK,
	BRONZE,
	STEEL,
	BRASS,
	PAINT,
	RUBBER,
	VASE,
	WHITE_MARBLE,
	DARK_MARBLE,
	ROPE,
	RUG,
	LAMP,
	PICTURE,
	N_PAINTS = PICTURE + TS_N_PICTURES,
};

#define PAINTED(k, n) \
	[PICTURE + (k)] = {ts_paint_picture, k, n, {1.0f, 1.0f}, (k) == 0 ? TS_MAP_NORMAL : 0, 0, TS_WHITE, 0.625f, 0.0f}

static const ts_paint paints[N_PAINTS] = {
	[PARQUET] = {ts_paint_parquet, 0, 512, {1.5f, 1.5f}, TS_MAP_NORMAL | TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 1.0f},
	[RED] = {ts_paint_plaster, 3, 512, {4.0f, 4.0f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.875f, 0.0f},
	[SAGE] = {ts_paint_plaster, 4, 256, {2.0f, 2.0f}, 0, 0, TS_WHITE, 0.875f, 0.0f},
	[CEILING] = {ts_paint_plaster, 0, 256, {3.0f, 3.0f}, 0, 0, TS_WHITE, 1.0f, 0.0f},
	[TRIM] = {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {0.75f, 0.71875f, 0.640625f}, 0.5f, 0.0f},
	[OAK] = {ts_paint_wood, 0, 256, {0.75f, 0.75f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.5f, 0.0f},
	[LEATHER] = {ts_paint_leather, 0, 256, {0.5f, 0.5f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.5f, 0.0f},
	[TAN] = {ts_paint_leather, 1, 256, {0.5f, 0.5f}, 0, 0, TS_WHITE, 0.5f, 0.0f},
	[GILT] = {ts_paint_metal, 3, 256, {0.5f, 0.5f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 0.5f},
	[BLACK] = {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {0.03125f, 0.02734375f, 0.0234375f}, 0.375f, 0.0f},
	[BRONZE] = {ts_paint_metal, 0, 256, {0.5f, 0.5f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 0.625f},
	[STEEL] = {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {0.5625f, 0.5703125f, 0.578125f}, 0.25f, 0.625f},
	[BRASS] = {ts_paint_metal, 2, 256, {0.5f, 0.5f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 0.5625f},
	[PAINT] = {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {0.03125f, 0.234375f, 0.25f}, 0.1875f, 0.0f},
	[RUBBER] = {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {0.0234375f, 0.0234375f, 0.0234375f}, 0.9375f, 0.0f},
	[VASE] = {ts_paint_terracotta, 1, 256, {0.5f, 0.5f}, 0, 0, TS_WHITE, 0.25f, 0.0f},
	[WHITE_MARBLE] = {ts_paint_marble, 0, 256, {1.0f, 1.0f}, 0, 0, TS_WHITE, 0.3125f, 0.0f},
	[DARK_MARBLE] = {ts_paint_marble, 2, 256, {1.0f, 1.0f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 0.0f},
	[ROPE] = {ts_paint_weave, 0, 256, {0.0625f, 0.0625f}, 0, 0, TS_WHITE, 0.9375f, 0.0f},
	[RUG] = {ts_paint_carpet, 1, 512, {1.0f, 1.0f}, 0, TS_DOUBLE_SIDED, TS_WHITE, 1.0f, 0.0f},
	[LAMP] = {ts_paint_shade, 1, 256, {0.25f, 0.25f}, TS_MAP_GLOW, 0, TS_WHITE, 0.875f, 0.0f},
	PAINTED(0, 512),
	PAINTED(1, 256),
	PAINTED(2, 512),
	PAINTED(3, 256),
	PAINTED(4, 512),
	PAINTED(5, 256),
	PAINTED(6, 256),
	PAINTED(7, 256),
};

/* Half the hall, and where the cabinets in its corners begin. The eye's circle passes between. */
static const f32 LENGTH = 12.0f, WIDTH = 9.0f, TOP = 5.25f, CABINET_X = 8.5f, CABINET_Z = 6.375f;

static const f32 crown[][2] = {{0.0f, -0.5f},      {0.0625f, -0.46875f}, {0.0625f, -0.375f}, {0.125f, -0.28125f},
                               {0.25f, -0.15625f}, {0.375f, -0.0625f},   {0.375f, 0.0f}};
static const f32 rail[][2] = {{0.0f, 0.0f}, {0.046875f, 0.015625f}, {0.046875f, 0.046875f}, {0.0f, 0.078125f}};
static const f32 skirting[][2] = {{0.03125f, 0.0f}, {0.03125f, 0.1875f}, {0.015625f, 0.21875f}, {0.0f, 0.25f}};

static void add_trim(ts_mesh *mesh, const u32 *material, f32 half)
{
	ts_place stand = mesh->place;
	mesh->material = material[TRIM];
	ts_part_moulding(mesh, half, skirting, 4, ts_mesh_segments(mesh, half * 2.0f, 1));
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 3.75f, 0.0f, 0.0f));
	ts_part_moulding(mesh, half, rail, 4, ts_mesh_segments(mesh, half * 2.0f, 1));
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, TOP, 0.0f, 0.0f));
	ts_part_moulding(mesh, half, crown, 7, ts_mesh_segments(mesh, half * 2.0f, 1));
	mesh->place = stand;
}

/* A picture, hung by two wires from the rail; facing +z from the wall z = 0. */
static void hang(ts_mesh *mesh, const u32 *material, f32 x, f32 hx, f32 hy, u32 id)
{
	static const u32 wood[3] = {GILT, BLACK, GILT};
	ts_place stand = mesh->place;
	mesh->place = ts_place_in(&stand, ts_place_at(x, 1.9375f, 0.015625f, 0.0f));
	u32 k = ts_random(id, 5u, mesh->seed);
	ts_part_picture(mesh, material[wood[id % 3u]], material[PICTURE + (id + (k & 1u) * 4u) % TS_N_PICTURES], hx, hy,
	                0.125f + 0.0625f * (f32)(id & 1u));
	mesh->material = material[STEEL];
	for (u32 side = 0; side < 2 && ts_mesh_shows(mesh, 0.1875f); side++) {
		f32 at = side ? hx * 0.75f : -hx * 0.75f;
		ts_mesh_rod(mesh, ts_v3_make(at, hy, 0.0078125f), ts_v3_make(at * 0.9375f, 1.84375f, 0.03125f), 0.001953125f,
		            3);
	}
	mesh->place = stand;
}

/* An outer wall with its trim and pictures: those of the hall between +-inner, one in each cabinet. */
static void add_outer_wall(ts_mesh *mesh, const u32 *material, f32 half, f32 inner, u32 n_pictures, u32 id)
{
	mesh->material = material[RED];
	ts_mesh_plane(mesh, ts_v3_make(-half, 0.0f, 0.0f), ts_v3_make(2.0f * half, 0.0f, 0.0f), ts_v3_make(0.0f, TOP, 0.0f),
	              ts_mesh_segments(mesh, half * 2.0f, 2), ts_mesh_segments(mesh, 6.0f, 1));
	add_trim(mesh, material, half);
	f32 pitch = 2.0f * inner / (f32)n_pictures;
	for (u32 i = 0; i < n_pictures; i++) {
		bool wide = (i + id) % 2 == 0;
		hang(mesh, material, ((f32)i + 0.5f) * pitch - inner, wide ? pitch * 0.375f : pitch * 0.25f,
		     wide ? 0.75f : 0.84375f, id + i);
	}
	for (u32 i = 0; i < 2; i++)
		hang(mesh, material, (i ? 0.5f : -0.5f) * (half + inner + 0.125f), 0.53125f, 0.65625f, id + n_pictures + i);
}

/* A wall between hall and cabinet, with or without a doorway; the hall on the side of +z. */
static void add_partition(ts_mesh *mesh, const u32 *material, f32 half, bool doorway)
{
	const f32 thick = 0.125f, w = 0.703125f, h = 2.625f;
	const ts_hole hole = {{half - w, 0.0f}, {half + w, h}};
	ts_place stand = mesh->place;
	for (u32 side = 0; side < 2; side++) {
		mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 0.0f, side ? -thick : thick, side ? 0.5f : 0.0f));
		mesh->material = material[side ? SAGE : RED];
		ts_mesh_wall(mesh, ts_v3_make(-half, 0.0f, 0.0f), ts_v3_make(2.0f * half, 0.0f, 0.0f),
		             ts_v3_make(0.0f, TOP, 0.0f), 1.0f, &hole, doorway ? 1 : 0);
		mesh->material = material[TRIM];
		mesh->place = ts_place_in(&stand, ts_place_at(0.0f, TOP, side ? -thick : thick, side ? 0.5f : 0.0f));
		ts_part_moulding(mesh, half, crown, 7, ts_mesh_segments(mesh, half * 2.0f, 1));
	}
	mesh->place = stand;
	if (!doorway) return;
	mesh->material = material[OAK];
	for (u32 side = 0; side < 2; side++) {
		f32 x = side ? w : -w;
		ts_mesh_block(mesh, ts_v3_make(x * 1.0625f, h * 0.5f, 0.0f), ts_v3_make(0.078125f, h * 0.5f, thick + 0.046875f),
		              0.015625f, ts_mesh_segments(mesh, 2.0f, 0));
	}
	ts_mesh_block(mesh, ts_v3_make(0.0f, h + 0.0625f, 0.0f), ts_v3_make(w + 0.1875f, 0.09375f, thick + 0.078125f),
	              0.03125f, ts_mesh_segments(mesh, 3.0f, 0));
}

static void add_cabinets(ts_mesh *mesh, const u32 *material)
{
	f32 half_x = (LENGTH - CABINET_X) * 0.5f, half_z = (WIDTH - CABINET_Z) * 0.5f;
	for (u32 corner = 0; corner < 4; corner++) {
		f32 sx = corner & 1u ? 1.0f : -1.0f, sz = corner & 2u ? 1.0f : -1.0f;
		mesh->place = ts_place_at(sx * (CABINET_X + half_x), 0.0f, sz * CABINET_Z, sz > 0.0f ? 0.5f : 0.0f);
		add_partition(mesh, material, half_x, true);
		mesh->place = ts_place_at(sx * CABINET_X, 0.0f, sz * (CABINET_Z + half_z), sx > 0.0f ? -0.25f : 0.25f);
		add_partition(mesh, material, half_z, false);
		mesh->place =
			ts_place_at(sx * (CABINET_X - 0.125f), 0.0f, sz * (CABINET_Z + half_z), sx > 0.0f ? -0.25f : 0.25f);
		hang(mesh, material, 0.0f, 0.75f, 0.8125f, 60u + corner);
		mesh->place = ts_place_at(sx * CABINET_X, 0.0f, sz * CABINET_Z, 0.0f);
		mesh->material = material[TRIM];
		ts_mesh_block(mesh, ts_v3_make(0.0f, TOP * 0.5f, 0.0f), ts_v3_make(0.1875f, TOP * 0.5f, 0.1875f), 0.03125f,
		              ts_mesh_segments(mesh, 2.0f, 0));
	}
}

/* The ceiling seen from below, its opening, and the bars of the skylight. */
static void add_ceiling(ts_mesh *mesh, const u32 *material)
{
	const f32 hx = 6.0f, hz = 3.5f, rise = 0.625f;
	const ts_hole hole = {{LENGTH - hx, WIDTH - hz}, {LENGTH + hx, WIDTH + hz}};
	mesh->place = ts_place_world();
	mesh->material = material[CEILING];
	ts_mesh_wall(mesh, ts_v3_make(-LENGTH, TOP, -WIDTH), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	             ts_v3_make(0.0f, 0.0f, 2.0f * WIDTH), 1.5f, &hole, 1);
	for (u32 side = 0; side < 4; side++) {
		f32 half = side & 1u ? hz : hx, away = side & 1u ? hx : hz;
		ts_place turned = ts_place_at(0.0f, TOP, 0.0f, (f32)side * 0.25f);
		mesh->place = ts_place_in(&turned, ts_place_at(0.0f, 0.0f, -away, 0.0f));
		mesh->material = material[CEILING];
		ts_mesh_plane(mesh, ts_v3_make(-half, 0.0f, 0.0f), ts_v3_make(2.0f * half, 0.0f, 0.0f),
		              ts_v3_make(0.0f, rise, 0.0f), ts_mesh_segments(mesh, 8.0f, 1), 1);
		mesh->material = material[TRIM];
		mesh->place = ts_place_in(&turned, ts_place_at(0.0f, -0.0625f, -away - 0.125f, 0.0f));
		ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0f, 0.0f), ts_v3_make(half + 0.25f, 0.0625f, 0.109375f), 0.03125f,
		              ts_mesh_segments(mesh, 2.0f, 0));
	}
	mesh->place = ts_place_at(0.0f, TOP + rise - 0.09375f, 0.0f, 0.0f);
	for (u32 i = 1; i < 16; i++) {
		f32 x = hx * ((f32)i * 0.125f - 1.0f);
		ts_mesh_block(mesh, ts_v3_make(x, 0.0f, 0.0f),
		              ts_v3_make(i % 4 ? 0.0234375f : 0.0625f, i % 4 ? 0.03125f : 0.09375f, hz), 0.0f, 0);
	}
	for (u32 i = 1; i < 8; i++) {
		f32 z = hz * ((f32)i * 0.25f - 1.0f);
		ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0078125f, z), ts_v3_make(hx, 0.0234375f, 0.01953125f), 0.0f, 0);
	}
}

static void add_bench(ts_mesh *mesh, const u32 *material)
{
	u32 k = ts_mesh_segments(mesh, 5.0f, 1);
	mesh->material = material[LEATHER];
	for (u32 i = 0; i < 3; i++) {
		ts_mesh_block(mesh, ts_v3_make(((f32)i - 1.0f) * 0.59375f, 0.4375f, 0.0f),
		              ts_v3_make(0.2890625f, 0.0625f, 0.28125f), 0.046875f, k);
	}
	mesh->material = material[OAK];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.34375f, 0.0f), ts_v3_make(0.875f, 0.03125f, 0.265625f), 0.015625f,
	              ts_mesh_segments(mesh, 2.0f, 0));
	mesh->material = material[STEEL];
	for (u32 i = 0; i < 4; i++) {
		f32 x = i & 1u ? 0.75f : -0.75f, z = i & 2u ? 0.203125f : -0.203125f;
		ts_mesh_rod(mesh, ts_v3_make(x, 0.0f, z), ts_v3_make(x, 0.3125f, z), 0.0234375f,
		            ts_mesh_segments(mesh, 12.0f, 4));
	}
}

static void add_pedestal(ts_mesh *mesh, const u32 *material, u32 id)
{
	static const f32 vase[2][11][2] = {{{0.0f, 0.0f},
	                                    {0.109375f, 0.0f},
	                                    {0.109375f, 0.0f},
	                                    {0.125f, 0.03125f},
	                                    {0.21875f, 0.25f},
	                                    {0.1875f, 0.40625f},
	                                    {0.0703125f, 0.484375f},
	                                    {0.0859375f, 0.5625f},
	                                    {0.0859375f, 0.5625f},
	                                    {0.0625f, 0.546875f},
	                                    {0.046875f, 0.453125f}},
	                                   {{0.0f, 0.0f},
	                                    {0.125f, 0.0f},
	                                    {0.125f, 0.0f},
	                                    {0.0625f, 0.0625f},
	                                    {0.046875f, 0.125f},
	                                    {0.203125f, 0.3125f},
	                                    {0.234375f, 0.46875f},
	                                    {0.25f, 0.484375f},
	                                    {0.25f, 0.484375f},
	                                    {0.21875f, 0.4765625f},
	                                    {0.078125f, 0.25f}}};
	ts_place stand = mesh->place;
	u32 k = ts_mesh_segments(mesh, 2.0f, 0);
	mesh->material = material[WHITE_MARBLE];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.5f, 0.0f), ts_v3_make(0.21875f, 0.4375f, 0.21875f), 0.0078125f, k);
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.03125f, 0.0f), ts_v3_make(0.28125f, 0.03125f, 0.28125f), 0.015625f, k);
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.96875f, 0.0f), ts_v3_make(0.265625f, 0.03125f, 0.265625f), 0.015625f, k);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 1.0f, 0.0f, 0.0f));
	mesh->material = material[id & 1u ? BRONZE : VASE];
	ts_mesh_lathe(mesh, vase[id & 1u], 11, ts_mesh_segments(mesh, 56.0f, 8), 5.0f);
	mesh->place = stand;
}

/* A trefoil knot on a drum of dark marble. */
static void add_knot(ts_mesh *mesh, const u32 *material)
{
	static const f32 drum[][2] = {{0.65625f, 0.0f},    {0.65625f, 0.0625f}, {0.65625f, 0.0625f}, {0.59375f, 0.09375f},
	                              {0.59375f, 0.375f},  {0.59375f, 0.375f},  {0.625f, 0.40625f},  {0.625f, 0.453125f},
	                              {0.625f, 0.453125f}, {0.0f, 0.453125f}};
	ts_place stand = mesh->place;
	ts_v3 points[49];
	mesh->material = material[DARK_MARBLE];
	ts_mesh_lathe(mesh, drum, 10, ts_mesh_segments(mesh, 48.0f, 8), 1.5f);
	for (u32 i = 0; i < 49; i++) {
		f32 t = (f32)(i % 48) / 48.0f;
		points[i] = ts_v3_make(ts_sin_turn(t) + 2.0f * ts_sin_turn(2.0f * t),
		                       ts_cos_turn(t) - 2.0f * ts_cos_turn(2.0f * t), -ts_sin_turn(3.0f * t));
		points[i] = ts_scale(points[i], 0.1484375f);
	}
	mesh->material = material[BRONZE];
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 0.953125f, 0.0f, 0.0f));
	ts_mesh_tube(mesh, points, 49, 0.078125f, ts_v3_make(0.0f, 0.0f, 1.0f), ts_mesh_segments(mesh, 28.0f, 5),
	             24 * ts_mesh_segments(mesh, 10.0f, 1));
	mesh->place = stand;
}

/* n posts along x, a metre and a half apart, ropes between. */
static void add_barrier(ts_mesh *mesh, const u32 *material, u32 n)
{
	static const f32 post[][2] = {{0.15625f, 0.0f},      {0.15625f, 0.015625f},    {0.15625f, 0.015625f},
	                              {0.03125f, 0.046875f}, {0.01953125f, 0.078125f}, {0.01953125f, 0.8125f},
	                              {0.03125f, 0.828125f}, {0.01953125f, 0.84375f},  {0.0390625f, 0.890625f},
	                              {0.0f, 0.9375f}};
	ts_place stand = mesh->place;
	for (u32 i = 0; i < n; i++) {
		f32 x = ((f32)i - 0.5f * (f32)(n - 1)) * 1.5f;
		mesh->place = ts_place_in(&stand, ts_place_at(x, 0.0f, 0.0f, 0.0f));
		mesh->material = material[BRASS];
		ts_mesh_lathe(mesh, post, 10, ts_mesh_segments(mesh, 18.0f, 4), 1.5f);
		if (i + 1 == n) continue;
		mesh->material = material[ROPE];
		ts_part_rope(mesh, ts_v3_make(0.015625f, 0.8125f, 0.0f), ts_v3_make(1.484375f, 0.8125f, 0.0f), 0.25f,
		             0.0171875f, ts_mesh_segments(mesh, 10.0f, 3), ts_mesh_segments(mesh, 36.0f, 4));
	}
	mesh->place = stand;
}

/* Spotlights on a track under the ceiling, turned to the wall on the side of -z. */
static void add_track(ts_mesh *mesh, const u32 *material, f32 half, u32 n)
{
	static const f32 can[][2] = {{0.0f, -0.09375f},      {0.0390625f, -0.09375f}, {0.0390625f, -0.09375f},
	                             {0.046875f, -0.0625f},  {0.046875f, 0.09375f},   {0.046875f, 0.09375f},
	                             {0.0390625f, 0.09375f}, {0.0390625f, 0.09375f},  {0.0390625f, 0.078125f}};
	static const f32 lens[][2] = {{0.0390625f, 0.078125f}, {0.0f, 0.0859375f}};
	ts_place stand = mesh->place;
	mesh->material = material[BLACK];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0f, 0.0f), ts_v3_make(half, 0.015625f, 0.01953125f), 0.0f, 0);
	for (u32 i = 0; i < 4; i++) {
		f32 x = ((f32)i - 1.5f) * half * 0.625f;
		ts_mesh_rod(mesh, ts_v3_make(x, 0.015625f, 0.0f), ts_v3_make(x, 0.6875f, 0.0f), 0.00390625f, 3);
	}
	for (u32 i = 0; i < n; i++) {
		f32 x = (((f32)i + 0.5f) / (f32)n * 2.0f - 1.0f) * half;
		mesh->place =
			ts_place_in(&stand, ts_place_along(ts_v3_make(x, -0.15625f, 0.0f), ts_v3_make(0.0f, -1.0f, -0.75f)));
		mesh->material = material[BLACK];
		ts_mesh_lathe(mesh, can, 9, ts_mesh_segments(mesh, 20.0f, 5), 1.5f);
		mesh->material = material[LAMP];
		ts_mesh_lathe(mesh, lens, 2, ts_mesh_segments(mesh, 20.0f, 5), 2.0f);
		mesh->place = stand;
		mesh->material = material[BLACK];
		ts_mesh_rod(mesh, ts_v3_make(x, -0.140625f, 0.0f), ts_v3_make(x, 0.0f, 0.0f), 0.00390625f, 3);
	}
}

static void furnish(ts_mesh *mesh, const u32 *material)
{
	const ts_bicycle_materials bicycle = {material[RUBBER], material[STEEL], material[PAINT], material[TAN]};
	for (u32 i = 0; i < 4; i++) {
		f32 sx = i & 1u ? 1.0f : -1.0f, sz = i & 2u ? 1.0f : -1.0f;
		mesh->place = ts_place_at(sx * 4.25f, 0.0f, sz * 4.8125f, 0.0f);
		add_bench(mesh, material);
		mesh->place = ts_place_at(sx * 7.0f, 0.0f, sz * 5.0f, 0.0f);
		add_pedestal(mesh, material, i);
		mesh->place = ts_place_at(sx * 10.25f, 0.0f, sz * 7.6875f, 0.125f * sx);
		add_pedestal(mesh, material, i + 1);
	}
	for (u32 i = 0; i < 2; i++) {
		f32 s = i ? 1.0f : -1.0f;
		mesh->place = ts_place_at(0.0f, 0.0f, s * 7.9375f, 0.0f);
		add_barrier(mesh, material, 8);
		mesh->place = ts_place_at(0.0f, 4.5625f, s * 6.75f, i ? 0.5f : 0.0f);
		add_track(mesh, material, 7.5f, 12);
		mesh->place = ts_place_at(s * 9.75f, 4.5625f, 0.0f, i ? -0.25f : 0.25f);
		add_track(mesh, material, 5.0f, 8);
	}
	mesh->place = ts_place_at(0.0f, 0.0f, 6.1875f, 0.0f);
	add_knot(mesh, material);
	mesh->place = ts_place_at(0.0f, 0.0f, -6.1875f, 0.03125f);
	mesh->material = material[WHITE_MARBLE];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.09375f, 0.0f), ts_v3_make(1.125f, 0.09375f, 0.46875f), 0.015625f,
	              ts_mesh_segments(mesh, 2.0f, 0));
	mesh->place.o.y = 0.1875f;
	ts_part_bicycle(mesh, &bicycle);
}

static void shape_gallery(ts_mesh *mesh, const u32 *material)
{
	mesh->place = ts_place_world();
	mesh->material = material[PARQUET];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, 0.0f, WIDTH), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, -2.0f * WIDTH), ts_mesh_segments(mesh, 32.0f, 2),
	              ts_mesh_segments(mesh, 24.0f, 2));
	for (u32 i = 0; i < 2; i++) {
		mesh->place = ts_place_at(0.0f, 0.0f, i ? WIDTH : -WIDTH, i ? 0.5f : 0.0f);
		add_outer_wall(mesh, material, LENGTH, CABINET_X - 0.125f, 7, 10u * i);
		mesh->place = ts_place_at(i ? LENGTH : -LENGTH, 0.0f, 0.0f, i ? -0.25f : 0.25f);
		add_outer_wall(mesh, material, WIDTH, CABINET_Z - 0.125f, 5, 20u + 10u * i);
	}
	add_cabinets(mesh, material);
	add_ceiling(mesh, material);
	furnish(mesh, material);
}

const ts_builtin ts_builtin_gallery = {
	.info = {"gallery", "a hall of pictures under a skylight, cabinets behind doorways, benches, a bicycle"},
	.paints = paints,
	.n_paints = N_PAINTS,
	.shape = shape_gallery,
	.rug = {RUG, 4.5f, 3.0f, 0.0f, 0.01171875f, 1.0f, {3.0f, 1.25f, 7.0f, 3.0f}},
};
