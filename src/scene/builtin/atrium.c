/* "atrium": a court of two storeys, arcades along its sides and blind arcades at its ends, hung with cloth.
 * 30 by 18 by 11 m, the court's floor at y = 0, open to the sky between the upper cornices. */
#include "scene/builtin/builtin.h"
#include "scene/builtin/parts.h"

enum {
	ASHLAR,
	STONE,
	FLOOR,
	AISLE,
	PLASTER,
	COLUMN,
	MARBLE,
	RED,
	GREEN,
	BLUE,
	GOLD,
	POT,
	SOIL,
	STEM,
	LEAF,
	BLADE,
	BRONZE,
	GILT,
	WOOD,
	GLOW,
	RUG,
	N_PAINTS,
};

static const ts_paint paints[N_PAINTS] = {
	[ASHLAR] = {ts_paint_ashlar, 0, 512, {3.5f, 3.5f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.875f, 0.0f},
	[STONE] = {ts_paint_ashlar, 1, 256, {2.0f, 2.0f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.875f, 0.0f},
	[FLOOR] = {ts_paint_tiles, 1, 512, {3.0f, 3.0f}, TS_MAP_NORMAL | TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 1.0f},
	[AISLE] = {ts_paint_tiles, 0, 256, {2.0f, 2.0f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 1.0f},
	[PLASTER] = {ts_paint_plaster, 1, 256, {2.0f, 2.0f}, TS_MAP_NORMAL, 0, TS_WHITE, 1.0f, 0.0f},
	[COLUMN] = {ts_paint_plaster, 0, 256, {2.0f, 2.0f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED, TS_WHITE, 0.75f, 0.0f},
	[MARBLE] = {ts_paint_marble, 1, 256, {2.0f, 2.0f}, 0, 0, TS_WHITE, 0.25f, 0.0f},
	[RED] = {ts_paint_weave, 0, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED, TS_WHITE, 0.9375f, 0.0f},
	[GREEN] = {ts_paint_weave, 1, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED, TS_WHITE, 0.9375f, 0.0f},
	[BLUE] = {ts_paint_weave, 2, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED, TS_WHITE, 0.9375f, 0.0f},
	[GOLD] = {ts_paint_weave, 4, 256, {0.5f, 0.5f}, 0, TS_DOUBLE_SIDED, TS_WHITE, 0.875f, 0.0f},
	[POT] = {ts_paint_terracotta, 0, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.75f, 0.0f},
	[SOIL] = {ts_paint_soil, 0, 256, {0.5f, 0.5f}, 0, 0, TS_WHITE, 1.0f, 0.0f},
	[STEM] = {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {0.125f, 0.109375f, 0.046875f}, 0.875f, 0.0f},
	[LEAF] = {ts_paint_leaf, 0, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, TS_DOUBLE_SIDED | TS_MASKED, TS_WHITE, 0.625f, 0.0f},
	[BLADE] = {ts_paint_leaf, 1, 256, {1.0f, 1.0f}, 0, TS_DOUBLE_SIDED | TS_MASKED, TS_WHITE, 0.5f, 0.0f},
	[BRONZE] = {ts_paint_metal, 0, 256, {0.5f, 0.5f}, TS_MAP_SURFACE, 0, TS_WHITE, 1.0f, 0.5f},
	[GILT] = {NULL, 0, 0, {1.0f, 1.0f}, 0, 0, {0.875f, 0.609375f, 0.234375f}, 0.375f, 0.5f},
	[WOOD] = {ts_paint_wood, 1, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, 0, TS_WHITE, 0.625f, 0.0f},
	[GLOW] = {ts_paint_shade, 0, 256, {0.5f, 0.5f}, TS_MAP_GLOW, 0, TS_WHITE, 0.875f, 0.0f},
	[RUG] = {ts_paint_carpet, 0, 512, {1.0f, 1.0f}, 0, TS_DOUBLE_SIDED, TS_WHITE, 1.0f, 0.0f},
};

/* Court: half length, half width to the middle of the arcades, half width to the outer walls. Heights: of the slab
 * under the upper floor, of that floor, of the upper cornice, of the whole. */
static const f32 LENGTH = 15.0f, NAVE = 6.40625f, WIDTH = 9.0f, SLAB = 5.8125f, FLOOR_2 = 6.125f, CORNICE = 10.0f,
				 TOP = 11.0f;
static const f32 BAY = 3.296875f;

/* How one storey's arcade is built: from its floor up. */
typedef struct {
	f32 bay, radius, spring, top, depth, column;
} storey;
static const storey lower = {BAY, 1.25f, 4.25f, SLAB, 0.25f, 0.3125f};
static const storey upper = {BAY, 1.3125f, 2.4375f, CORNICE - FLOOR_2, 0.1875f, 0.21875f};

typedef struct {
	const storey *storey;
	f32 z;
} arch_shape;

/* The wall over an arch: t from the arch to the bay's outline, which has corners at s = 1/4 and 3/4. */
static void arch_panel(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const storey *k = ((const arch_shape *)shape)->storey;
	f32 h = k->bay * 0.5f, rise = k->top - k->spring;
	f32 ix = -ts_cos_turn(s * 0.5f) * k->radius, iy = ts_sin_turn(s * 0.5f) * k->radius;
	f32 ox = s < 0.25f ? -h : s > 0.75f ? h : (4.0f * s - 2.0f) * h;
	f32 oy = s < 0.25f ? 4.0f * s * rise : s > 0.75f ? 4.0f * (1.0f - s) * rise : rise;
	c->p = ts_v3_make(ix + (ox - ix) * t, k->spring + iy + (oy - iy) * t, k->depth);
	c->n = ts_v3_make(0.0f, 0.0f, 1.0f);
	c->uv = ts_v2_make(c->p.x, -c->p.y);
}

static void arch_soffit(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const storey *k = ((const arch_shape *)shape)->storey;
	f32 x = -ts_cos_turn(s * 0.5f), y = ts_sin_turn(s * 0.5f);
	c->p = ts_v3_make(x * k->radius, k->spring + y * k->radius, (2.0f * t - 1.0f) * k->depth);
	c->n = ts_v3_make(-x, -y, 0.0f);
	c->uv = ts_v2_make(s * k->radius * 3.140625f, c->p.z);
}

static void add_archivolt(ts_mesh *mesh, const storey *k, f32 offset, f32 radius)
{
	ts_v3 points[9];
	for (u32 i = 0; i < 9; i++) {
		f32 a = (f32)i * 0.0625f, r = k->radius + offset;
		points[i] = ts_v3_make(-ts_cos_turn(a) * r, k->spring + ts_sin_turn(a) * r, k->depth);
	}
	ts_mesh_tube(mesh, points, 9, radius, ts_v3_make(0.0f, 0.0f, 1.0f), ts_mesh_segments(mesh, 7.0f, 3),
	             4 * ts_mesh_segments(mesh, 6.0f, 1));
}

/* One arch, with both faces unless it is blind. */
static void add_arch(ts_mesh *mesh, const u32 *material, const storey *k, bool blind)
{
	arch_shape shape = {k, 0.0f};
	u32 ns = 4 * ts_mesh_segments(mesh, 7.0f, 1), nt = ts_mesh_segments(mesh, 4.0f, 1);
	ts_place stand = mesh->place;
	mesh->material = material[ASHLAR];
	ts_mesh_grid(mesh, ns, nt, 0, arch_panel, &shape);
	mesh->material = material[STONE];
	ts_mesh_grid(mesh, ns, ts_mesh_segments(mesh, 3.0f, 1), 0, arch_soffit, &shape);
	mesh->material = material[COLUMN];
	if (ts_mesh_shows(mesh, 0.25f)) add_archivolt(mesh, k, 0.0625f, 0.0625f);
	if (ts_mesh_shows(mesh, 0.375f)) add_archivolt(mesh, k, 0.25f, 0.03125f);
	ts_v3 key = {0.0f, k->spring + k->radius + 0.0625f, k->depth};
	if (ts_mesh_shows(mesh, 0.25f))
		ts_mesh_block(mesh, key, ts_v3_make(0.125f, 0.21875f, 0.109375f), 0.03125f, ts_mesh_segments(mesh, 1.5f, 0));
	if (!blind) {
		mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 0.0f, 0.0f, 0.5f));
		mesh->material = material[PLASTER];
		ts_mesh_grid(mesh, ns, nt, 0, arch_panel, &shape);
		mesh->material = material[COLUMN];
		if (ts_mesh_shows(mesh, 0.25f)) add_archivolt(mesh, k, 0.0625f, 0.0625f);
		mesh->place = stand;
	}
}

typedef struct {
	f32 radius, foot, head, flutes;
} shaft_shape;

/* Twenty flutes, and the swelling of a third up. */
static void shaft(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const shaft_shape *k = shape;
	f32 turn = s < 1.0f ? s : 0.0f;
	f32 r = k->radius * (1.0f - 0.15625f * t * t);
	r = r - k->flutes * (0.5f + 0.5f * ts_cos_turn(turn * 20.0f)) * ts_min(1.0f, ts_min(t, 1.0f - t) * 24.0f);
	c->p = ts_v3_make(r * ts_cos_turn(turn), k->foot + (k->head - k->foot) * t, -r * ts_sin_turn(turn));
	c->uv = ts_v2_make(s * k->radius * 6.28125f, -c->p.y);
}

typedef struct {
	f32 radius, y, height, turn, width;
} acanthus_shape;

/* A leaf that hugs the bell and curls over at its tip. */
static void acanthus(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const acanthus_shape *k = shape;
	f32 x = s * 2.0f - 1.0f;
	f32 lobes = 0.8125f + 0.1875f * ts_cos_turn(t * 4.0f);
	f32 turn = k->turn + x * k->width * ts_sin_turn(0.09375f + t * 0.375f) * lobes;
	f32 curl = t * t * t;
	f32 r = k->radius * (1.0625f + 0.1875f * t + 0.4375f * curl * t - 0.0625f * x * x);
	c->p = ts_v3_make(r * ts_cos_turn(turn), k->y + k->height * (t - 0.375f * curl * t), -r * ts_sin_turn(turn));
	c->uv = ts_v2_make(s * 0.25f, 1.0f - t);
}

static void add_capital(ts_mesh *mesh, f32 r, f32 y)
{
	const f32 bell[][2] = {{r * 0.84375f, y - r * 2.125f},
	                       {r * 0.96875f, y - r * 2.0625f},
	                       {r * 0.84375f, y - r * 2.0f},
	                       {r * 0.84375f, y - r * 2.0f},
	                       {r * 0.875f, y - r},
	                       {r * 1.25f, y - r * 0.3125f}};
	ts_mesh_lathe(mesh, bell, 6, ts_mesh_segments(mesh, 28.0f, 6), 3.0f);
	u32 n = ts_min_i32((i32)ts_mesh_segments(mesh, 9.0f, 0), 12) & ~1;
	for (u32 row = 0; row < 2; row++) {
		for (u32 i = 0; i < n; i++) {
			acanthus_shape a = {r * 0.875f, y - r * (row ? 1.5f : 2.0f), r * 1.125f,
			                    ((f32)i + 0.5f * (f32)row) / (f32)n, 0.4375f / (f32)n};
			ts_mesh_grid(mesh, ts_mesh_segments(mesh, 4.0f, 2), ts_mesh_segments(mesh, 7.0f, 3), 0, acanthus, &a);
		}
	}
	ts_mesh_block(mesh, ts_v3_make(0.0f, y - r * 0.15625f, 0.0f), ts_v3_make(r * 1.40625f, r * 0.15625f, r * 1.40625f),
	              0.015625f, ts_mesh_segments(mesh, 1.0f, 0));
}

static void add_column(ts_mesh *mesh, const u32 *material, f32 r, f32 height, u32 shaft_paint)
{
	const f32 base[][2] = {{r * 1.375f, r * 0.375f},   {r * 1.5f, r * 0.5f},        {r * 1.375f, r * 0.65625f},
	                       {r * 1.375f, r * 0.65625f}, {r * 1.125f, r * 0.75f},     {r * 1.125f, r * 0.84375f},
	                       {r * 1.125f, r * 0.84375f}, {r * 1.21875f, r * 0.9375f}, {r, r * 1.0625f}};
	u32 na = ts_mesh_segments(mesh, 88.0f, 6);
	if (na >= 60) na = na / 60 * 60;
	shaft_shape s = {r, ts_mesh_shows(mesh, 0.1875f) ? r : 0.0f, height - r * 2.0f, na >= 60 ? r * 0.078125f : 0.0f};
	mesh->material = material[STONE];
	if (ts_mesh_shows(mesh, 0.1875f))
		ts_mesh_block(mesh, ts_v3_make(0.0f, r * 0.1875f, 0.0f), ts_v3_make(r * 1.53125f, r * 0.1875f, r * 1.53125f),
		              0.015625f, ts_mesh_segments(mesh, 1.0f, 0));
	mesh->material = material[shaft_paint];
	ts_mesh_grid(mesh, na, ts_mesh_segments(mesh, 9.0f, 1), TS_GRID_WRAP_S, shaft, &s);
	mesh->material = material[COLUMN];
	if (ts_mesh_shows(mesh, 0.1875f)) ts_mesh_lathe(mesh, base, 9, ts_mesh_segments(mesh, 28.0f, 6), 1.5f);
	add_capital(mesh, r, height);
}

/* n bays along x, the middle at the mesh's place, facing +z. Columns also at both ends, unless blind. */
static void add_arcade(ts_mesh *mesh, const u32 *material, const storey *k, u32 n, bool blind, u32 shaft_paint)
{
	ts_place stand = mesh->place;
	for (u32 i = 0; i < n; i++) {
		mesh->place = ts_place_in(&stand, ts_place_at(((f32)i + 0.5f - 0.5f * (f32)n) * k->bay, 0.0f, 0.0f, 0.0f));
		add_arch(mesh, material, k, blind);
	}
	for (u32 i = blind ? 1 : 0; i < (blind ? n : n + 1); i++) {
		mesh->place = ts_place_in(&stand, ts_place_at(((f32)i - 0.5f * (f32)n) * k->bay, 0.0f, 0.0f, 0.0f));
		add_column(mesh, material, k->column, k->spring, shaft_paint);
	}
	mesh->place = stand;
}

static void add_balustrade(ts_mesh *mesh, const u32 *material)
{
	static const f32 baluster[][2] = {{0.0625f, 0.0f},        {0.0625f, 0.0625f}, {0.03125f, 0.109375f},
	                                  {0.0703125f, 0.28125f}, {0.03125f, 0.5f},   {0.05859375f, 0.625f},
	                                  {0.05859375f, 0.6875f}};
	f32 half = 4.0f * BAY;
	ts_place stand = mesh->place;
	mesh->material = material[COLUMN];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0625f, 0.0f), ts_v3_make(half, 0.0625f, 0.125f), 0.015625f,
	              ts_mesh_segments(mesh, 1.0f, 0));
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.875f, 0.0f), ts_v3_make(half, 0.0625f, 0.140625f), 0.03125f,
	              ts_mesh_segments(mesh, 2.0f, 0));
	u32 n = ts_mesh_shows(mesh, 0.1875f) ? 8 * (u32)ts_min_i32((i32)ts_mesh_segments(mesh, 12.0f, 2), 14) : 0;
	for (u32 i = 0; i < n; i++) {
		mesh->place =
			ts_place_in(&stand, ts_place_at((((f32)i + 0.5f) / (f32)n * 2.0f - 1.0f) * half, 0.125f, 0.0f, 0.0f));
		ts_mesh_lathe(mesh, baluster, 7, ts_mesh_segments(mesh, 9.0f, 3), 1.0f);
	}
	mesh->place = stand;
}

/* One long side, seen from the court: +z towards the court, the arcade's middle plane at z = 0. */
static void add_side(ts_mesh *mesh, const u32 *material)
{
	static const f32 cornice[][2] = {{0.25f, -0.125f},     {0.3125f, -0.09375f}, {0.375f, 0.0f}, {0.40625f, 0.1875f},
	                                 {0.46875f, 0.28125f}, {0.46875f, 0.3125f},  {0.0f, 0.3125f}};
	ts_place stand = mesh->place;
	f32 aisle = WIDTH - NAVE;
	add_arcade(mesh, material, &lower, 8, false, COLUMN);
	for (u32 end = 0; end < 2; end++) {
		f32 x = (end ? 1.0f : -1.0f) * (4.0f * BAY + 0.90625f);
		mesh->material = material[ASHLAR];
		ts_mesh_block(mesh, ts_v3_make(x, SLAB * 0.5f, 0.0f), ts_v3_make(0.90625f, SLAB * 0.5f, 0.25f), 0.0f, 0);
		ts_mesh_block(mesh, ts_v3_make(x, (FLOOR_2 + CORNICE) * 0.5f, 0.0f),
		              ts_v3_make(0.90625f, (CORNICE - FLOOR_2) * 0.5f, 0.1875f), 0.0f, 0);
	}
	mesh->material = material[PLASTER];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, SLAB, -aisle), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, aisle + 0.25f), ts_mesh_segments(mesh, 20.0f, 2),
	              ts_mesh_segments(mesh, 3.0f, 1));
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, CORNICE, -aisle), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, aisle + 0.1875f), ts_mesh_segments(mesh, 20.0f, 2),
	              ts_mesh_segments(mesh, 3.0f, 1));
	mesh->material = material[COLUMN];
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, SLAB, 0.0f, 0.0f));
	ts_part_moulding(mesh, LENGTH, cornice, 7, ts_mesh_segments(mesh, 60.0f, 2));
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, CORNICE, -0.0625f, 0.0f));
	ts_part_moulding(mesh, LENGTH, cornice, 7, ts_mesh_segments(mesh, 60.0f, 2));
	mesh->place = stand;
	mesh->material = material[AISLE];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, FLOOR_2, 0.0f), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, -aisle), 1, 1);
	mesh->material = material[ASHLAR];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, CORNICE + 0.3125f, 0.0f), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, TOP - CORNICE - 0.3125f, 0.0f), ts_mesh_segments(mesh, 20.0f, 1), 1);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, FLOOR_2, 0.0f, 0.0f));
	add_arcade(mesh, material, &upper, 8, false, MARBLE);
	add_balustrade(mesh, material);
	mesh->place = stand;
}

/* The wall behind an aisle, with doors, pilasters and a seat. +z towards the court, the wall at z = 0. */
static void add_back_wall(ts_mesh *mesh, const u32 *material)
{
	static const f32 casing[][2] = {{0.1875f, 0.0f},    {0.1875f, 0.0625f}, {0.125f, 0.09375f},
	                                {0.0625f, 0.0625f}, {0.0f, 0.078125f},  {0.0f, 0.0f}};
	ts_place stand = mesh->place;
	mesh->material = material[PLASTER];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, 0.0f, 0.0f), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, TOP, 0.0f), ts_mesh_segments(mesh, 24.0f, 2), ts_mesh_segments(mesh, 8.0f, 1));
	for (u32 i = 0; i < 9; i++) {
		f32 x = ((f32)i - 4.0f) * BAY;
		mesh->material = material[ASHLAR];
		ts_mesh_block(mesh, ts_v3_make(x, SLAB * 0.5f, 0.0625f), ts_v3_make(0.34375f, SLAB * 0.5f, 0.0625f), 0.0f, 0);
		ts_mesh_block(mesh, ts_v3_make(x, 0.25f, 0.125f), ts_v3_make(0.4375f, 0.25f, 0.125f), 0.03125f,
		              ts_mesh_segments(mesh, 1.0f, 0));
		if (i == 8 || i % 2 == 1) continue;
		mesh->place = ts_place_in(&stand, ts_place_at(x + BAY * 0.5f, 1.5625f, 0.0f, 0.0f));
		mesh->material = material[COLUMN];
		ts_mesh_frame(mesh, 0.75f, 1.375f, casing, 6, 0.015625f, ts_mesh_segments(mesh, 12.0f, 1));
		mesh->material = material[WOOD];
		ts_mesh_plane(mesh, ts_v3_make(-0.75f, -1.375f, 0.03125f), ts_v3_make(1.5f, 0.0f, 0.0f),
		              ts_v3_make(0.0f, 2.75f, 0.0f), 1, 1);
		for (u32 k = 0; k < 8 && ts_mesh_shows(mesh, 0.25f); k++) {
			ts_v3 at = {k & 1u ? 0.359375f : -0.359375f, (f32)(k / 2) * 0.65625f - 0.984375f, 0.046875f};
			ts_mesh_block(mesh, at, ts_v3_make(0.328125f, 0.3046875f, 0.03125f), 0.0234375f,
			              ts_mesh_segments(mesh, 1.5f, 0));
		}
		mesh->place = stand;
	}
	mesh->material = material[STONE];
	static const f32 plinth[][2] = {{0.0625f, 0.0f}, {0.0625f, 0.34375f}, {0.03125f, 0.40625f}, {0.0f, 0.421875f}};
	ts_part_moulding(mesh, LENGTH, plinth, 4, ts_mesh_segments(mesh, 16.0f, 1));
}

/* A panelled door or a blind window in its casing. */
static void add_opening(ts_mesh *mesh, const u32 *material, bool door)
{
	static const f32 casing[][2] = {{0.375f, 0.0f},   {0.375f, 0.125f}, {0.25f, 0.1875f},
	                                {0.125f, 0.125f}, {0.0f, 0.15625f}, {0.0f, 0.0f}};
	f32 w = door ? 0.8125f : 0.6875f, h = door ? 1.625f : 1.0f;
	mesh->material = material[door ? COLUMN : BRONZE];
	ts_mesh_frame(mesh, w, h, casing, 6, 0.03125f, ts_mesh_segments(mesh, 24.0f, 1));
	mesh->material = material[door ? WOOD : MARBLE];
	for (u32 i = 0; i < 10 && door && ts_mesh_shows(mesh, 0.25f); i++) {
		ts_v3 at = {i & 1u ? 0.390625f : -0.390625f, (f32)(i / 2) * 0.625f - 1.25f, 0.0625f};
		ts_v3 half = {0.359375f, 0.28125f, 0.046875f};
		ts_mesh_block(mesh, at, half, 0.03125f, ts_mesh_segments(mesh, 1.5f, 0));
	}
	ts_mesh_plane(mesh, ts_v3_make(-w, -h, 0.03125f), ts_v3_make(2.0f * w, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 2.0f * h, 0.0f), 1, 1);
}

/* One end of the court: +z towards the court, the wall at z = 0. */
static void add_end(ts_mesh *mesh, const u32 *material)
{
	static const f32 band[][2] = {{0.0f, -0.125f},    {0.25f, -0.0625f}, {0.34375f, 0.0625f},
	                              {0.375f, 0.21875f}, {0.375f, 0.3125f}, {0.0f, 0.3125f}};
	storey low = lower, high = upper;
	low.bay = high.bay = NAVE * 0.5f;
	low.depth = high.depth = 0.5f;
	ts_place stand = mesh->place;
	mesh->material = material[ASHLAR];
	ts_mesh_plane(mesh, ts_v3_make(-WIDTH, 0.0f, 0.0f), ts_v3_make(2.0f * WIDTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, TOP, 0.0f), ts_mesh_segments(mesh, 16.0f, 2), ts_mesh_segments(mesh, 8.0f, 1));
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 0.0f, 0.5f, 0.0f));
	add_arcade(mesh, material, &low, 4, true, MARBLE);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, FLOOR_2, 0.5f, 0.0f));
	add_arcade(mesh, material, &high, 4, true, MARBLE);
	mesh->material = material[COLUMN];
	for (u32 k = 0; k < 2; k++) {
		mesh->place = ts_place_in(&stand, ts_place_at(0.0f, k ? CORNICE : SLAB, 0.71875f, 0.0f));
		ts_part_moulding(mesh, NAVE, band, 6, ts_mesh_segments(mesh, 24.0f, 1));
	}
	for (u32 k = 0; k < 4; k++) {
		mesh->place = ts_place_in(&stand, ts_place_at(((f32)k - 1.5f) * low.bay, 2.0f, 0.0f, 0.0f));
		add_opening(mesh, material, k == 1 || k == 2);
	}
	mesh->place = stand;
}

typedef struct {
	f32 width, span, sag, wave;
} canopy_shape;

/* Cloth slung across the court, hanging in a parabola and rippling along its edges. Seen from below. */
static void canopy(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const canopy_shape *k = shape;
	f32 z = 2.0f * t - 1.0f, x = 2.0f * s - 1.0f;
	f32 hang = k->sag * (z * z - 1.0f) * (1.0f - 0.1875f * x * x);
	f32 ripple =
		0.0625f * ts_sin_turn(x * 1.5f + k->wave) * (1.0f - z * z) + 0.03125f * ts_sin_turn(z * 3.0f + x + k->wave);
	c->p = ts_v3_make(x * k->width * (0.8125f + 0.1875f * z * z), hang + ripple, z * k->span);
	c->uv = ts_v2_make(s * k->width * 2.0f, t * k->span * 2.0f);
}

static void add_canopies(ts_mesh *mesh, const u32 *material)
{
	static const u32 cloth[4] = {RED, GOLD, BLUE, RED};
	for (u32 i = 0; i < 4; i++) {
		f32 x = ((f32)i - 1.5f) * 2.0f * BAY;
		canopy_shape k = {1.125f, NAVE - 0.25f, 1.25f, ts_mesh_random(mesh, 50u + i)};
		mesh->place = ts_place_at(x, CORNICE - 0.125f, 0.0f, 0.0f);
		mesh->material = material[cloth[i]];
		ts_mesh_grid(mesh, ts_mesh_segments(mesh, 20.0f, 3), ts_mesh_segments(mesh, 64.0f, 8), 0, canopy, &k);
		mesh->material = material[STEM];
		for (u32 e = 0; e < 4; e++) {
			ts_v3 a = {e & 1u ? 1.125f : -1.125f, 0.0f, (e & 2u ? 1.0f : -1.0f) * (NAVE - 0.25f)};
			ts_v3 b = {a.x * 1.375f, 0.125f, a.z * 1.03125f};
			ts_mesh_rod(mesh, a, b, 0.015625f, ts_mesh_segments(mesh, 5.0f, 3));
		}
	}
}

/* Banners over the upper rail, curtains drawn to the columns below. Seen from the court, arcade at z = 0. */
static void add_cloth(ts_mesh *mesh, const u32 *material, u32 id)
{
	static const u32 cloth[4] = {GREEN, BLUE, BLUE, GREEN};
	ts_place stand = mesh->place;
	for (u32 i = 0; i < 4; i++) {
		f32 x = ((f32)(2 * i) - 3.0f) * BAY + (i < 2 ? 0.5f : -0.5f) * BAY;
		mesh->place = ts_place_in(&stand, ts_place_at(x, FLOOR_2 + 0.953125f, 0.578125f, 0.0f));
		mesh->material = material[cloth[i]];
		ts_part_curtain(mesh, 1.5f, 2.875f, 5.0f, 0.0625f, 0.9375f, id + i);
		mesh->material = material[GILT];
		ts_mesh_rod(mesh, ts_v3_make(-0.875f, 0.015625f, 0.0f), ts_v3_make(0.875f, 0.015625f, 0.0f), 0.0234375f,
		            ts_mesh_segments(mesh, 8.0f, 3));
	}
	for (u32 i = 0; i < 8; i++) {
		f32 post = (f32)(i / 2 * 2) - 3.0f, side = i & 1u ? -1.0f : 1.0f;
		mesh->place = ts_place_in(&stand, ts_place_at(post * BAY + side * 0.6875f, 4.6875f, 0.0f, 0.0f));
		mesh->material = material[RED];
		ts_part_curtain(mesh, 0.75f, 4.4375f, 6.0f, 0.078125f, 0.625f, id + 20u + i);
	}
	mesh->place = stand;
}

/* A pole leaning out from the upper rail, its pennant and its gilt ball. */
static void add_flag(ts_mesh *mesh, const u32 *material, u32 cloth, u32 id)
{
	static const f32 ball[][2] = {{0.0f, -0.0625f},       {0.046875f, -0.046875f}, {0.0625f, 0.0f},
	                              {0.046875f, 0.046875f}, {0.015625f, 0.0625f},    {0.0f, 0.15625f}};
	ts_v3 foot = {0.0f, 0.0f, 0.0f}, head = {0.0f, 1.625f, 1.75f};
	ts_place stand = mesh->place;
	mesh->material = material[WOOD];
	ts_mesh_rod(mesh, foot, head, 0.0234375f, ts_mesh_segments(mesh, 10.0f, 3));
	mesh->place = ts_place_in(&stand, ts_place_along(head, ts_sub(head, foot)));
	mesh->material = material[GILT];
	ts_mesh_lathe(mesh, ball, 6, ts_mesh_segments(mesh, 14.0f, 4), 2.0f);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 1.4375f, 1.0625f, 0.25f));
	mesh->material = material[cloth];
	ts_part_curtain(mesh, 0.9375f, 1.5f, 2.5f, 0.078125f, 0.6875f, id);
	mesh->place = stand;
	mesh->material = material[STEM];
	ts_part_rope(mesh, head, ts_v3_make(0.0f, 1.4375f, 0.5625f), 0.125f, 0.0078125f, 3,
	             ts_mesh_segments(mesh, 12.0f, 2));
}

/* A bronze lantern on a chain; its place is where the chain is fixed. */
static void add_lantern(ts_mesh *mesh, const u32 *material)
{
	static const f32 roof[][2] = {{0.203125f, 0.0f},  {0.21875f, 0.015625f}, {0.109375f, 0.09375f},
	                              {0.03125f, 0.125f}, {0.03125f, 0.171875f}, {0.0f, 0.1875f}};
	static const f32 glass[][2] = {
		{0.0f, -0.296875f}, {0.109375f, -0.28125f}, {0.15625f, -0.140625f}, {0.171875f, 0.0f}};
	static const f32 foot[][2] = {
		{0.0f, -0.40625f}, {0.03125f, -0.375f}, {0.015625f, -0.34375f}, {0.109375f, -0.3125f}, {0.125f, -0.28125f}};
	ts_place stand = mesh->place;
	u32 na = ts_mesh_segments(mesh, 16.0f, 5);
	mesh->material = material[BRONZE];
	if (ts_mesh_shows(mesh, 0.1875f))
		ts_part_chain(mesh, ts_v3_make(0.0f, -0.03125f, 0.0f), ts_min_i32((i32)ts_mesh_segments(mesh, 7.0f, 1), 7),
		              0.0625f, 0.0078125f);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, -0.65625f, 0.0f, 0.0f));
	ts_mesh_lathe(mesh, roof, 6, na, 2.0f);
	ts_mesh_lathe(mesh, foot, 5, na, 2.0f);
	for (u32 i = 0; i < 6 && ts_mesh_shows(mesh, 0.25f); i++) {
		f32 c = ts_cos_turn((f32)i / 6.0f), s = ts_sin_turn((f32)i / 6.0f);
		ts_mesh_rod(mesh, ts_v3_make(0.1171875f * c, -0.296875f, 0.1171875f * s),
		            ts_v3_make(0.1796875f * c, 0.015625f, 0.1796875f * s), 0.0078125f, ts_mesh_segments(mesh, 5.0f, 3));
	}
	mesh->material = material[GLOW];
	ts_mesh_lathe(mesh, glass, 4, na, 2.0f);
	mesh->place = stand;
}

static void furnish(ts_mesh *mesh, const u32 *material)
{
	const ts_plant_materials bush = {material[POT], material[SOIL], material[STEM], material[LEAF]};
	const ts_plant_materials palm = {material[POT], material[SOIL], material[STEM], material[BLADE]};
	for (u32 side = 0; side < 2; side++) {
		f32 z = side ? 1.0f : -1.0f;
		for (u32 i = 0; i < 4; i++) {
			f32 x = ((f32)(2 * i) - 3.0f) * BAY;
			mesh->place = ts_place_at(x, 0.0f, z * (NAVE - 0.9375f), 0.0f);
			ts_part_plant(mesh, i == 0 || i == 3 ? &palm : &bush, 0.375f, i == 0 || i == 3 ? 1.5f : 1.25f,
			              i == 0 || i == 3, 400u * (2 * i + side) + 90000u);
			mesh->place = ts_place_at(x + BAY * (i < 2 ? -0.5f : 0.5f), SLAB, z * (NAVE + 1.28125f), 0.0f);
			add_lantern(mesh, material);
		}
		for (u32 i = 0; i < 4; i++) {
			f32 x = ((f32)(2 * i) - 3.0f) * BAY;
			mesh->place = ts_place_at(x, FLOOR_2 + 0.875f, z * (NAVE - 0.15625f), side ? 0.5f : 0.0f);
			add_flag(mesh, material, i & 1u ? RED : GOLD, 300u + 2 * i + side);
		}
	}
}

static void shape_atrium(ts_mesh *mesh, const u32 *material)
{
	mesh->place = ts_place_world();
	mesh->material = material[FLOOR];
	ts_mesh_plane(mesh, ts_v3_make(-LENGTH, 0.0f, NAVE), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, -2.0f * NAVE), ts_mesh_segments(mesh, 30.0f, 2),
	              ts_mesh_segments(mesh, 12.0f, 1));
	for (u32 side = 0; side < 2; side++) {
		f32 z = side ? 1.0f : -1.0f, turn = side ? 0.5f : 0.0f;
		mesh->place = ts_place_at(0.0f, 0.0f, z * NAVE, turn);
		add_side(mesh, material);
		add_cloth(mesh, material, 200u + 40u * side);
		mesh->material = material[AISLE];
		ts_mesh_plane(mesh, ts_v3_make(-LENGTH, 0.0f, 0.0f), ts_v3_make(2.0f * LENGTH, 0.0f, 0.0f),
		              ts_v3_make(0.0f, 0.0f, NAVE - WIDTH), ts_mesh_segments(mesh, 30.0f, 2),
		              ts_mesh_segments(mesh, 3.0f, 1));
		mesh->place = ts_place_at(0.0f, 0.0f, z * WIDTH, turn);
		add_back_wall(mesh, material);
		mesh->place = ts_place_at((side ? 1.0f : -1.0f) * LENGTH, 0.0f, 0.0f, side ? -0.25f : 0.25f);
		add_end(mesh, material);
	}
	add_canopies(mesh, material);
	furnish(mesh, material);
}

const ts_builtin ts_builtin_atrium = {
	.info = {"atrium", "a colonnaded court of two storeys with hanging cloth, plants and flags; open to the sky"},
	.paints = paints,
	.n_paints = N_PAINTS,
	.shape = shape_atrium,
	.rug = {RUG, 8.0f, 1.375f, 0.0f, 0.015625f, 4.0f, {7.0f, 0.75f, 19.0f, 2.0f}},
};
