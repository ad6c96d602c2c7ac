/* "dining": a dining room, 14 by 11 by 4.25 m, with a laid table, blinds in its windows, a fireplace between shelves of
 * books, a sideboard, a chandelier. The table stands to one side, so the middle is free. */
#include "scene/builtin/dining.h"
#include "scene/builtin/builtin.h"
#include "scene/builtin/parts.h"

/* clang-format off */
#define PLAIN(r, g, b, rough, metal) {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {r, g, b}, rough, metal}
/* clang-format on */

static const ts_paint paints[D_N_PAINTS] = {
	[D_PARQUET] = {ts_paint_parquet, 1, 512, {1.25f, 1.25f}, TS_MAP_NORMAL | TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 1.0f},
	[D_PAPER] = {ts_paint_wallpaper, 0, 512, {1.25f, 1.25f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.75f, 0.0f},
	[D_CEILING] = {ts_paint_plaster, 0, 256, {3.0f, 3.0f}, 0, 0, TS_WHITE, 1.0f, 0.0f},
	[D_TRIM] = PLAIN(0.71875f, 0.6875f, 0.609375f, 0.5f, 0.0f),
	[D_WALNUT] = {ts_paint_wood, 1, 256, {0.75f, 0.75f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.4375f, 0.0f},
	[D_MAHOGANY] = {ts_paint_wood, 2, 256, {0.75f, 0.75f}, 0, 0, TS_WHITE, 0.375f, 0.0f},
	[D_OAK] = {ts_paint_wood, 0, 256, {0.75f, 0.75f}, 0, 0, TS_WHITE, 0.5f, 0.0f},
	[D_LINEN] = {ts_paint_weave, 3, 256, {0.25f, 0.25f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED, TS_WHITE, 0.9375f, 0.0f},
	[D_SEAT] = {ts_paint_weave, 1, 256, {0.5f, 0.5f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.9375f, 0.0f},
	[D_CURTAIN] = {ts_paint_weave, 0, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED, TS_WHITE, 0.875f, 0.0f},
	[D_BLIND] = {ts_paint_wood, 3, 256, {1.0f, 1.0f}, 0, 0, TS_WHITE, 0.5f, 0.0f},
	[D_PORCELAIN] = PLAIN(0.84375f, 0.84375f, 0.8125f, 0.125f, 0.0f),
	[D_GLASS] = PLAIN(0.5625f, 0.640625f, 0.640625f, 0.0625f, 0.0f),
	[D_BOTTLE] = PLAIN(0.03125f, 0.09375f, 0.046875f, 0.0625f, 0.0f),
	[D_SILVER] = PLAIN(0.75f, 0.734375f, 0.703125f, 0.25f, 0.75f),
	[D_BRASS] = {ts_paint_metal, 2, 256, {0.5f, 0.5f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 0.5625f},
	[D_SHADE] = {ts_paint_shade, 0, 256, {0.5f, 0.5f}, TS_MAP_GLOW, TS_DOUBLE_SIDED, TS_WHITE, 0.875f, 0.0f},
	[D_WAX] = PLAIN(0.84375f, 0.796875f, 0.671875f, 0.625f, 0.0f),
	[D_APPLE] = PLAIN(0.453125f, 0.0625f, 0.03125f, 0.25f, 0.0f),
	[D_ORANGE] = PLAIN(0.78125f, 0.28125f, 0.03125f, 0.4375f, 0.0f),
	[D_POT] = {ts_paint_terracotta, 1, 256, {0.5f, 0.5f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.375f, 0.0f},
	[D_SOIL] = {ts_paint_soil, 0, 256, {0.5f, 0.5f}, 0, 0, TS_WHITE, 1.0f, 0.0f},
	[D_STEM] = PLAIN(0.09375f, 0.140625f, 0.03125f, 0.75f, 0.0f),
	[D_LEAF] =
		{ts_paint_leaf, 1, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED | TS_MASKED, TS_WHITE, 0.5625f, 0.0f},
	[D_GILT] = {ts_paint_metal, 3, 256, {0.5f, 0.5f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 0.5f},
	[D_MARBLE] = {ts_paint_marble, 0, 256, {1.5f, 1.5f}, 0, 0, TS_WHITE, 0.3125f, 0.0f},
	[D_SOOT] = {ts_paint_ashlar, 1, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, 0, {0.25f, 0.234375f, 0.21875f}, 1.0f, 0.0f},
	[D_BOOK] = {ts_paint_book, 0, 256, {1.0f, 1.0f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 1.0f},
	[D_RUG] = {ts_paint_carpet, 0, 512, {1.0f, 1.0f}, 0, TS_DOUBLE_SIDED, TS_WHITE, 1.0f, 0.0f},
	[D_VASE] = {ts_paint_marble, 1, 256, {0.5f, 0.5f}, 0, 0, TS_WHITE, 0.25f, 0.0f},
	[D_PICTURE] = {ts_paint_picture, 0, 256, {1.0f, 1.0f}, 0, 0, TS_WHITE, 0.625f, 0.0f},
	[D_PICTURE_2] = {ts_paint_picture, 4, 256, {1.0f, 1.0f}, 0, 0, TS_WHITE, 0.625f, 0.0f},
	[D_PICTURE_3] = {ts_paint_picture, 6, 256, {1.0f, 1.0f}, 0, 0, TS_WHITE, 0.625f, 0.0f},
};

static const f32 LENGTH = 7.0f, WIDTH = 5.5f, TOP = 4.25f, SILL = 0.875f, LINTEL = 3.25f, PANE = 0.8125f,
				 REVEAL = 0.25f;

static const f32 cornice[][2] = {{0.0f, -0.375f},       {0.046875f, -0.359375f}, {0.046875f, -0.28125f},
                                 {0.09375f, -0.21875f}, {0.1875f, -0.125f},      {0.28125f, -0.046875f},
                                 {0.28125f, 0.0f}};
static const f32 dado[][2] = {
	{0.015625f, 0.0f}, {0.046875f, 0.015625f}, {0.0625f, 0.046875f}, {0.046875f, 0.078125f}, {0.0f, 0.09375f}};
static const f32 base[][2] = {{0.03125f, 0.0f}, {0.03125f, 0.140625f}, {0.015625f, 0.1875f}, {0.0f, 0.1953125f}};

/* Slats hung in a window: each a thin board, a little tilted, on three cords. Top at mesh->place. */
static void add_blind(ts_mesh *mesh, const u32 *material, f32 half, f32 height, f32 tilt)
{
	ts_place stand = mesh->place;
	u32 n = ts_mesh_shows(mesh, 0.25f) ? 60 : ts_mesh_shows(mesh, 0.125f) ? 30 : 15;
	mesh->material = material[D_BLIND];
	ts_mesh_block(mesh, ts_v3_make(0.0f, -0.03125f, 0.0f), ts_v3_make(half, 0.03125f, 0.03125f), 0.0078125f,
	              ts_mesh_segments(mesh, 1.0f, 0));
	for (u32 i = 0; i < n; i++) {
		f32 y = -0.09375f - (height - 0.125f) * (f32)i / (f32)n;
		mesh->place = ts_place_in(
			&stand, ts_place_along(ts_v3_make(0.0f, y, 0.0f), ts_v3_make(0.0f, ts_cos_turn(tilt), ts_sin_turn(tilt))));
		ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0f, 0.0f), ts_v3_make(half - 0.015625f, 0.0009765625f, 0.021484375f),
		              0.0009765625f, ts_mesh_segments(mesh, 0.5f + 0.03125f * (f32)(i * 37u % 60u), 0));
	}
	mesh->place = stand;
	mesh->material = material[D_LINEN];
	for (u32 i = 0; i < 3; i++) {
		f32 x = ((f32)i - 1.0f) * half * 0.75f;
		ts_mesh_rod(mesh, ts_v3_make(x, -0.0625f, 0.0234375f), ts_v3_make(x, -height, 0.0234375f), 0.0015625f,
		            ts_mesh_segments(mesh, 4.0f, 3));
	}
}

/* The sash bars of a window whose opening is centred at x = 0 in the wall z = 0. */
static void add_sash(ts_mesh *mesh, const u32 *material)
{
	f32 middle = (SILL + LINTEL) * 0.5f, half = (LINTEL - SILL) * 0.5f;
	u32 k = ts_mesh_segments(mesh, 1.0f, 0);
	mesh->material = material[D_TRIM];
	for (u32 i = 0; i < 4; i++) {
		f32 x = (i / 2 ? 1.0f : -1.0f) * (i % 2 ? 0.03125f : PANE - 0.03125f);
		ts_mesh_block(mesh, ts_v3_make(x, middle, -REVEAL + 0.0625f), ts_v3_make(0.03125f, half, 0.03125f), 0.0078125f,
		              k);
	}
	for (u32 i = 0; i < 5; i++) {
		f32 y = SILL + 0.03125f + (2.0f * half - 0.0625f) * (f32)i * 0.25f;
		bool rim = i == 0 || i == 4;
		ts_mesh_block(mesh, ts_v3_make(0.0f, y, -REVEAL + 0.0625f),
		              ts_v3_make(PANE, rim ? 0.03125f : 0.01171875f, rim ? 0.03125f : 0.015625f), 0.00390625f, k);
	}
	for (u32 i = 0; i < 2; i++) {
		ts_mesh_block(mesh, ts_v3_make(i ? PANE * 0.5f : -PANE * 0.5f, middle, -REVEAL + 0.0625f),
		              ts_v3_make(0.01171875f, half, 0.015625f), 0.00390625f, k);
	}
	ts_mesh_block(mesh, ts_v3_make(0.0f, SILL - 0.015625f, 0.03125f), ts_v3_make(PANE + 0.125f, 0.015625f, 0.09375f),
	              0.0078125f, k);
}

/* The casing around the opening and the four faces of its depth. */
static void add_reveal(ts_mesh *mesh, const u32 *material)
{
	static const f32 casing[][2] = {{0.15625f, 0.0f},      {0.15625f, 0.03125f}, {0.109375f, 0.046875f},
	                                {0.046875f, 0.03125f}, {0.0f, 0.0234375f},   {0.0f, 0.0f}};
	f32 h = LINTEL - SILL;
	ts_place stand = mesh->place;
	mesh->material = material[D_TRIM];
	ts_mesh_plane(mesh, ts_v3_make(-PANE, SILL, -REVEAL), ts_v3_make(0.0f, 0.0f, REVEAL), ts_v3_make(0.0f, h, 0.0f), 1,
	              1);
	ts_mesh_plane(mesh, ts_v3_make(PANE, SILL, 0.0f), ts_v3_make(0.0f, 0.0f, -REVEAL), ts_v3_make(0.0f, h, 0.0f), 1, 1);
	ts_mesh_plane(mesh, ts_v3_make(-PANE, SILL, 0.0f), ts_v3_make(2.0f * PANE, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, -REVEAL), 1, 1);
	ts_mesh_plane(mesh, ts_v3_make(-PANE, LINTEL, -REVEAL), ts_v3_make(2.0f * PANE, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, REVEAL), 1, 1);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, (SILL + LINTEL) * 0.5f, 0.0f, 0.0f));
	ts_mesh_frame(mesh, PANE, h * 0.5f, casing, 6, 0.0078125f, ts_mesh_segments(mesh, 16.0f, 1));
	mesh->place = stand;
}

static void add_window(ts_mesh *mesh, const u32 *material, u32 id)
{
	ts_place stand = mesh->place;
	f32 drop = LINTEL - SILL - 0.046875f;
	add_reveal(mesh, material);
	add_sash(mesh, material);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, LINTEL - 0.015625f, -0.09375f, 0.0f));
	add_blind(mesh, material, PANE - 0.03125f, drop * (0.5f + 0.5f * ts_mesh_random(mesh, id)), 0.09375f);
	for (u32 i = 0; i < 2; i++) {
		mesh->place =
			ts_place_in(&stand, ts_place_at(i ? PANE + 0.25f : -PANE - 0.25f, LINTEL + 0.21875f, 0.140625f, 0.0f));
		mesh->material = material[D_CURTAIN];
		ts_part_curtain(mesh, 0.75f, LINTEL + 0.140625f, 7.0f, 0.0546875f, 0.6875f, id + 1u + i);
	}
	mesh->place = stand;
	mesh->material = material[D_BRASS];
	ts_mesh_rod(mesh, ts_v3_make(-PANE - 0.71875f, LINTEL + 0.25f, 0.140625f),
	            ts_v3_make(PANE + 0.71875f, LINTEL + 0.25f, 0.140625f), 0.015625f, ts_mesh_segments(mesh, 10.0f, 3));
	for (u32 i = 0; i < 24 && ts_mesh_shows(mesh, 0.3125f); i++) {
		f32 x = (i / 12 ? 1.0f : -1.0f) * (PANE - 0.09375f + 0.0625f * (f32)(i % 12));
		ts_place up = {ts_v3_make(x, LINTEL + 0.2421875f, 0.140625f), ts_v3_make(0.0f, 1.0f, 0.0f),
		               ts_v3_make(-1.0f, 0.0f, 0.0f), ts_v3_make(0.0f, 0.0f, 1.0f)};
		mesh->place = ts_place_in(&stand, up);
		ts_part_ring(mesh, 0.0234375f, 0.00390625f, ts_mesh_segments(mesh, 5.0f, 3), ts_mesh_segments(mesh, 12.0f, 4));
	}
	mesh->place = stand;
}

/* Raised panels below the dado from -half to half, left out where a hole reaches the floor. */
static void add_panels(ts_mesh *mesh, const u32 *material, f32 half, u32 n)
{
	static const f32 raised[][2] = {
		{0.03125f, 0.0f}, {0.03125f, 0.0234375f}, {0.0f, 0.0078125f}, {-0.0625f, 0.015625f}};
	ts_place stand = mesh->place;
	f32 pitch = 2.0f * half / (f32)n;
	mesh->material = material[D_TRIM];
	for (u32 i = 0; i < n && ts_mesh_shows(mesh, 0.1875f); i++) {
		mesh->place = ts_place_in(&stand, ts_place_at(((f32)i + 0.5f) * pitch - half, 0.46875f, 0.0f, 0.0f));
		ts_mesh_frame(mesh, pitch * 0.5f - 0.109375f, 0.1875f, raised, 4, 0.0f, 1);
	}
	mesh->place = stand;
	ts_part_moulding(mesh, half, base, 4, ts_mesh_segments(mesh, half * 2.0f, 1));
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 0.75f, 0.0f, 0.0f));
	ts_part_moulding(mesh, half, dado, 5, ts_mesh_segments(mesh, half * 2.0f, 1));
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, TOP, 0.0f, 0.0f));
	ts_part_moulding(mesh, half, cornice, 7, ts_mesh_segments(mesh, half * 4.0f, 1));
	mesh->place = stand;
}

/* A wall of half length `half` with n windows, evenly spaced `pitch` apart. */
static void add_wall(ts_mesh *mesh, const u32 *material, f32 half, u32 n, f32 pitch, u32 id)
{
	ts_hole holes[3] = {0};
	ts_place stand = mesh->place;
	for (u32 i = 0; i < n; i++) {
		f32 x = ((f32)i - 0.5f * (f32)(n - 1)) * pitch;
		holes[i] = (ts_hole){{half + x - PANE, SILL}, {half + x + PANE, LINTEL}};
		mesh->place = ts_place_in(&stand, ts_place_at(x, 0.0f, 0.0f, 0.0f));
		add_window(mesh, material, id + 10u * i);
	}
	mesh->place = stand;
	mesh->material = material[D_PAPER];
	ts_mesh_wall(mesh, ts_v3_make(-half, 0.0f, 0.0f), ts_v3_make(2.0f * half, 0.0f, 0.0f), ts_v3_make(0.0f, TOP, 0.0f),
	             0.625f, holes, n);
	add_panels(mesh, material, half, (u32)ts_floor_i32(half * 2.0f));
}

/* Boards and books, 1.75 m wide; +z away from the wall. */
static void add_shelves(ts_mesh *mesh, const u32 *material, u32 id)
{
	u32 k = ts_mesh_segments(mesh, 1.0f, 0);
	mesh->material = material[D_WALNUT];
	for (u32 i = 0; i < 2; i++)
		ts_mesh_block(mesh, ts_v3_make(i ? 0.859375f : -0.859375f, 1.375f, 0.171875f),
		              ts_v3_make(0.015625f, 1.375f, 0.171875f), 0.00390625f, k);
	for (u32 i = 0; i < 8; i++)
		ts_mesh_block(mesh, ts_v3_make(0.0f, 0.09375f + 0.375f * (f32)i, 0.171875f),
		              ts_v3_make(0.84375f, 0.0125f, 0.171875f), 0.00390625f, k);
	ts_mesh_plane(mesh, ts_v3_make(-0.84375f, 0.0f, 0.0234375f), ts_v3_make(1.6875f, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 2.75f, 0.0f), 1, 1);
	mesh->material = material[D_BOOK];
	u32 books = ts_mesh_shows(mesh, 0.25f) ? 40 : ts_mesh_shows(mesh, 0.125f) ? 20 : 0;
	ts_place stand = mesh->place;
	for (u32 i = 0; i < 7 * books; i++) {
		f32 thick = 0.8125f / (f32)books, x = ((f32)(i % books) + 0.5f) * 2.0f * thick - 0.8125f;
		f32 r = ts_mesh_random(mesh, id + i), tall = 0.1015625f + 0.046875f * r;
		if (ts_mesh_random(mesh, id + 5000u + i) > 0.9375f) continue;
		f32 y = 0.109375f + 0.375f * (f32)(i / books) + tall,
			z = 0.171875f + 0.03125f * ts_mesh_random(mesh, id + 9000u + i);
		mesh->place = ts_place_in(&stand, ts_place_at(x, y, z, 0.0f));
		mesh->shift = ts_v2_make((f32)(ts_random(id + i, 5u, mesh->seed) & 15u) * 0.0625f, r);
		ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0f, 0.0f), ts_v3_make(thick * (0.75f + 0.1875f * r), tall, 0.109375f),
		              0.0046875f, ts_mesh_segments(mesh, 0.5f + 2.0f * r, 0));
	}
	mesh->shift = ts_v2_make(0.0f, 0.0f);
	mesh->place = stand;
}

static void add_fireplace(ts_mesh *mesh, const u32 *material)
{
	static const f32 hood[][2] = {{0.0f, -0.1875f}, {0.3125f, -0.15625f},   {0.34375f, -0.0625f},
	                              {0.40625f, 0.0f}, {0.421875f, 0.046875f}, {0.421875f, 0.078125f},
	                              {0.0f, 0.078125f}};
	ts_place stand = mesh->place;
	u32 k = ts_mesh_segments(mesh, 2.0f, 0);
	mesh->material = material[D_MARBLE];
	for (u32 i = 0; i < 2; i++) {
		f32 x = i ? 0.8125f : -0.8125f;
		ts_mesh_block(mesh, ts_v3_make(x, 0.53125f, 0.15625f), ts_v3_make(0.1875f, 0.53125f, 0.15625f), 0.015625f, k);
		ts_mesh_block(mesh, ts_v3_make(x, 0.53125f, 0.3125f), ts_v3_make(0.109375f, 0.375f, 0.015625f), 0.0078125f, k);
	}
	ts_mesh_block(mesh, ts_v3_make(0.0f, 1.0625f, 0.15625f), ts_v3_make(1.0f, 0.125f, 0.15625f), 0.015625f, k);
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.03125f, 0.46875f), ts_v3_make(1.125f, 0.03125f, 0.46875f), 0.015625f, k);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 1.1875f, 0.0f, 0.0f));
	ts_part_moulding(mesh, 1.125f, hood, 7, ts_mesh_segments(mesh, 16.0f, 1));
	mesh->place = stand;
	mesh->material = material[D_SOOT];
	ts_mesh_plane(mesh, ts_v3_make(-0.625f, 0.0625f, 0.078125f), ts_v3_make(1.25f, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.875f, 0.0f), ts_mesh_segments(mesh, 8.0f, 1), ts_mesh_segments(mesh, 6.0f, 1));
	mesh->material = material[D_OAK];
	for (u32 i = 0; i < 5; i++) {
		f32 x = ((f32)i - 2.0f) * 0.125f, z = 0.140625f + 0.0625f * (f32)(i & 1u);
		ts_mesh_rod(mesh, ts_v3_make(x - 0.25f, 0.125f + 0.046875f * (f32)(i & 1u), z),
		            ts_v3_make(x + 0.1875f, 0.15625f + 0.0625f * (f32)(i / 2), z + 0.0625f), 0.0390625f,
		            ts_mesh_segments(mesh, 12.0f, 4));
	}
	for (u32 i = 0; i < 2; i++) {
		mesh->place = ts_place_in(&stand, ts_place_at(i ? 0.875f : -0.875f, 1.265625f, 0.21875f, 0.0f));
		ts_dining_candle(mesh, material, 0.28125f);
	}
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 2.3125f, 0.015625f, 0.0f));
	ts_part_picture(mesh, material[D_GILT], material[D_PICTURE], 0.84375f, 0.625f, 0.15625f);
	mesh->place = stand;
}

/* A lamp with a shade of cloth, on a turned foot. */
static void add_lamp(ts_mesh *mesh, const u32 *material)
{
	static const f32 foot[][2] = {{0.09375f, 0.0f},       {0.09375f, 0.015625f}, {0.03125f, 0.046875f},
	                              {0.0859375f, 0.15625f}, {0.0625f, 0.234375f},  {0.015625f, 0.28125f},
	                              {0.0078125f, 0.40625f}};
	static const f32 shade[][2] = {{0.15625f, 0.28125f}, {0.09375f, 0.46875f}};
	u32 na = ts_mesh_segments(mesh, 36.0f, 6);
	mesh->material = material[D_VASE];
	ts_mesh_lathe(mesh, foot, 7, na, 3.0f);
	mesh->material = material[D_SHADE];
	ts_mesh_lathe(mesh, shade, 2, na, 4.0f);
}

static void add_sideboard(ts_mesh *mesh, const u32 *material)
{
	static const f32 knob[][2] = {{0.0078125f, 0.0f},
	                              {0.0078125f, 0.015625f},
	                              {0.01953125f, 0.0234375f},
	                              {0.015625f, 0.03515625f},
	                              {0.0f, 0.0390625f}};
	static const f32 vase[][2] = {{0.0625f, 0.0f},        {0.078125f, 0.03125f},  {0.140625f, 0.1875f},
	                              {0.109375f, 0.328125f}, {0.046875f, 0.40625f},  {0.0703125f, 0.46875f},
	                              {0.0625f, 0.4609375f},  {0.0390625f, 0.390625f}};
	ts_place stand = mesh->place;
	u32 k = ts_mesh_segments(mesh, 2.0f, 0);
	mesh->material = material[D_MAHOGANY];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.515625f, 0.25f), ts_v3_make(1.125f, 0.359375f, 0.21875f), 0.0078125f, k);
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.890625f, 0.25f), ts_v3_make(1.1875f, 0.015625f, 0.25f), 0.0078125f, k);
	for (u32 i = 0; i < 4; i++) {
		f32 x = ((f32)i - 1.5f) * 0.546875f;
		mesh->place = stand;
		mesh->material = material[D_WALNUT];
		ts_mesh_block(mesh, ts_v3_make(x, 0.4375f, 0.46875f), ts_v3_make(0.25f, 0.234375f, 0.015625f), 0.0125f, k);
		ts_mesh_block(mesh, ts_v3_make(x, 0.7734375f, 0.46875f), ts_v3_make(0.25f, 0.078125f, 0.015625f), 0.0125f, k);
		ts_mesh_block(mesh, ts_v3_make(x * 1.28125f, 0.078125f, 0.25f + (i & 1u ? 0.15625f : -0.15625f)),
		              ts_v3_make(0.03125f, 0.078125f, 0.03125f), 0.0078125f, k);
		mesh->material = material[D_BRASS];
		for (u32 row = 0; row < 2; row++) {
			mesh->place = ts_place_in(&stand, ts_place_along(ts_v3_make(x, row ? 0.7734375f : 0.59375f, 0.484375f),
			                                                 ts_v3_make(0.0f, 0.0f, 1.0f)));
			ts_mesh_lathe(mesh, knob, 5, ts_mesh_segments(mesh, 14.0f, 3), 2.0f);
		}
	}
	mesh->place = ts_place_in(&stand, ts_place_at(-0.875f, 0.90625f, 0.1875f, 0.0f));
	add_lamp(mesh, material);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 0.90625f, 0.25f, 0.0f));
	ts_dining_fruit(mesh, material);
	mesh->place = ts_place_in(&stand, ts_place_at(0.84375f, 0.90625f, 0.21875f, 0.0f));
	mesh->material = material[D_VASE];
	ts_mesh_lathe(mesh, vase, 8, ts_mesh_segments(mesh, 40.0f, 6), 4.0f);
	mesh->place = stand;
}

/* Over the table: a cord and a shade of cloth. */
static void add_pendant(ts_mesh *mesh, const u32 *material, f32 length)
{
	static const f32 shade[][2] = {
		{0.28125f, -0.28125f}, {0.265625f, -0.15625f}, {0.15625f, -0.03125f}, {0.03125f, 0.0f}};
	static const f32 bulb[][2] = {
		{0.0f, -0.21875f}, {0.0390625f, -0.1875f}, {0.046875f, -0.140625f}, {0.015625f, -0.0625f}};
	ts_place stand = mesh->place;
	mesh->material = material[D_STEM];
	ts_mesh_rod(mesh, ts_v3_make(0.0f, 0.0f, 0.0f), ts_v3_make(0.0f, -length, 0.0f), 0.00390625f,
	            ts_mesh_segments(mesh, 6.0f, 3));
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, -length, 0.0f, 0.0f));
	mesh->material = material[D_SHADE];
	ts_mesh_lathe(mesh, shade, 4, ts_mesh_segments(mesh, 40.0f, 6), 4.0f);
	mesh->material = material[D_WAX];
	ts_mesh_lathe(mesh, bulb, 4, ts_mesh_segments(mesh, 20.0f, 4), 3.0f);
	mesh->place = stand;
}

static void add_ceiling(ts_mesh *mesh, const u32 *material)
{
	static const f32 rosette[][2] = {{0.0f, -0.09375f},  {0.125f, -0.078125f},   {0.1875f, -0.03125f},
	                                 {0.375f, -0.0625f}, {0.46875f, -0.015625f}, {0.625f, -0.046875f},
	                                 {0.6875f, 0.0f}};
	mesh->place = ts_place_world();
	mesh->material = material[D_CEILING];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, TOP, -WIDTH), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, 2.0f * WIDTH), ts_mesh_segments(mesh, 14.0f, 1),
	              ts_mesh_segments(mesh, 11.0f, 1));
	for (u32 i = 0; i < 6; i++) {
		f32 x = ((f32)i - 2.5f) * 2.25f;
		mesh->material = material[D_TRIM];
		ts_mesh_block(mesh, ts_v3_make(x, TOP - 0.078125f, 0.0f), ts_v3_make(0.09375f, 0.078125f, WIDTH), 0.015625f,
		              ts_mesh_segments(mesh, 1.0f, 0));
	}
	mesh->place = ts_place_at(0.0f, TOP - 0.001953125f, 0.0f, 0.0f);
	ts_mesh_lathe(mesh, rosette, 7, ts_mesh_segments(mesh, 64.0f, 8), 3.0f);
	ts_dining_chandelier(mesh, material);
}

static void furnish(ts_mesh *mesh, const u32 *material)
{
	const ts_plant_materials plant = {material[D_POT], material[D_SOIL], material[D_STEM], material[D_LEAF]};
	mesh->place = ts_place_at(0.0f, 0.0f, 3.875f, 0.0f);
	ts_dining_table(mesh, material);
	for (u32 i = 0; i < 3; i++) {
		mesh->place = ts_place_at(((f32)i - 1.0f) * 1.25f, TOP, 3.875f, 0.0f);
		add_pendant(mesh, material, 1.875f);
	}
	for (u32 i = 0; i < 3; i++) {
		static const u32 picture[3] = {D_PICTURE_3, D_PICTURE_2, D_PICTURE};
		mesh->place = ts_place_at(((f32)i - 1.0f) * 3.5f, 2.1875f, WIDTH - 0.015625f, 0.5f);
		ts_part_picture(mesh, material[i == 1 ? D_GILT : D_WALNUT], material[picture[i]], i == 1 ? 0.9375f : 0.5625f,
		                i == 1 ? 0.625f : 0.6875f, 0.125f);
	}
	mesh->place = ts_place_at(0.0f, 0.0f, -WIDTH, 0.0f);
	add_sideboard(mesh, material);
	mesh->place = ts_place_at(LENGTH, 0.0f, 0.0f, -0.25f);
	add_fireplace(mesh, material);
	for (u32 i = 0; i < 2; i++) {
		f32 s = i ? 1.0f : -1.0f;
		mesh->place = ts_place_at(LENGTH - 0.0625f, 0.0f, s * 2.5f, -0.25f);
		add_shelves(mesh, material, 20000u + 20000u * i);
		mesh->place = ts_place_at(-LENGTH + 0.75f, 0.0f, s * (WIDTH - 0.75f), 0.0f);
		ts_part_plant(mesh, &plant, 0.28125f, 0.8125f, 1, 60000u + 3000u * i);
		mesh->place = ts_place_at(s * 2.1875f, 0.0f, -WIDTH + 0.5f, 0.53125f);
		ts_dining_chair(mesh, material);
	}
}

static void shape_dining(ts_mesh *mesh, const u32 *material)
{
	mesh->place = ts_place_world();
	mesh->material = material[D_PARQUET];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, 0.0f, WIDTH), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, -2.0f * WIDTH), ts_mesh_segments(mesh, 28.0f, 2),
	              ts_mesh_segments(mesh, 22.0f, 2));
	mesh->place = ts_place_at(0.0f, 0.0f, -WIDTH, 0.0f);
	add_wall(mesh, material, LENGTH, 2, 7.5f, 100u);
	mesh->place = ts_place_at(0.0f, 0.0f, WIDTH, 0.5f);
	add_wall(mesh, material, LENGTH, 0, 0.0f, 200u);
	mesh->place = ts_place_at(-LENGTH, 0.0f, 0.0f, 0.25f);
	add_wall(mesh, material, WIDTH, 3, 3.125f, 300u);
	mesh->place = ts_place_at(LENGTH, 0.0f, 0.0f, -0.25f);
	add_wall(mesh, material, WIDTH, 0, 0.0f, 400u);
	add_ceiling(mesh, material);
	furnish(mesh, material);
}

const ts_builtin ts_builtin_dining = {
	.info = {"dining", "a dining room: laid table, chairs, blinds, shelves of books, fireplace, chandelier"},
	.paints = paints,
	.n_paints = D_N_PAINTS,
	.shape = shape_dining,
	.rug = {D_RUG, 3.75f, 2.5f, -0.75f, 0.01171875f, 1.0f, {2.0f, 1.25f, 5.0f, 3.0f}},
};
