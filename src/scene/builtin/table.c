/* The laid table of the built-in scene "dining": cloth, plates, cutlery, glasses, bottles, candles, chairs. */
#include "scene/builtin/dining.h"
#include "scene/builtin/parts.h"

static const f32 HALF_X = 1.875f, HALF_Z = 0.5625f, TABLE = 0.75f;

/* A cloth laid over the table: it hangs beyond the edge, in folds. */
static void tablecloth(ts_corner *c, const void *shape, f32 s, f32 t)
{
	const f32 hang = *(const f32 *)shape;
	f32 x = (2.0f * s - 1.0f) * (HALF_X + hang), z = (1.0f - 2.0f * t) * (HALF_Z + hang);
	f32 on_x = ts_clamp(x, -HALF_X, HALF_X), on_z = ts_clamp(z, -HALF_Z, HALF_Z);
	ts_v3 over = {x - on_x, 0.0f, z - on_z};
	f32 drop = ts_max(ts_abs(over.x), ts_abs(over.z));
	ts_v3 out = ts_normalize(over);
	f32 along = on_x * 2.5f + on_z * 2.5f + (out.x * 0.5f + out.z) * 0.5f;
	f32 fold = 0.0625f + 0.09375f * ts_sin_turn(along) + 0.03125f * ts_sin_turn(along * 2.25f);
	f32 away = ts_min(drop, 0.015625f) * 0.75f + drop * fold;
	c->p = ts_v3_make(on_x + out.x * away, TABLE + 0.0078125f - ts_max(drop - 0.0078125f, 0.0f), on_z + out.z * away);
	c->uv = ts_v2_make(x, z);
}

static void add_plate(ts_mesh *mesh, f32 radius)
{
	f32 r = radius;
	const f32 profile[][2] = {{r * 0.5625f, 0.0f},        {r * 0.625f, r * 0.03125f}, {r, r * 0.15625f},
	                          {r, r * 0.1875f},           {r, r * 0.1875f},           {r * 0.75f, r * 0.109375f},
	                          {r * 0.6875f, r * 0.0625f}, {0.0f, r * 0.046875f}};
	ts_mesh_lathe(mesh, profile, 8, ts_mesh_segments(mesh, 48.0f, 6), 2.5f);
}

/* Scaled from a wine glass half a foot high. */
static void add_glass(ts_mesh *mesh, f32 size)
{
	static const f32 glass[][2] = {{0.03125f, 0.0f},
	                               {0.03125f, 0.00390625f},
	                               {0.0078125f, 0.0078125f},
	                               {0.00390625f, 0.015625f},
	                               {0.00390625f, 0.078125f},
	                               {0.015625f, 0.0859375f},
	                               {0.03515625f, 0.109375f},
	                               {0.0390625f, 0.1328125f},
	                               {0.03125f, 0.1796875f},
	                               {0.03125f, 0.1796875f},
	                               {0.029296875f, 0.1796875f},
	                               {0.037109375f, 0.1328125f},
	                               {0.033203125f, 0.11328125f},
	                               {0.0f, 0.09375f}};
	ts_place stand = mesh->place;
	mesh->place.x = ts_scale(stand.x, size);
	mesh->place.y = ts_scale(stand.y, size);
	mesh->place.z = ts_scale(stand.z, size);
	ts_mesh_lathe(mesh, glass, 14, ts_mesh_segments(mesh, 28.0f, 5), 2.0f);
	mesh->place = stand;
}

static void add_cutlery(ts_mesh *mesh)
{
	u32 k = ts_mesh_segments(mesh, 2.0f, 0);
	ts_v3 handle = {0.005859375f, 0.001953125f, 0.0546875f};
	/* Knife and spoon to the right, fork to the left. */
	ts_mesh_block(mesh, ts_v3_make(0.171875f, 0.00390625f, 0.0546875f), handle, 0.0015625f, k);
	ts_mesh_block(mesh, ts_v3_make(0.171875f, 0.00390625f, -0.0546875f),
	              ts_v3_make(0.0078125f, 0.0009765625f, 0.0546875f), 0.0009765625f, k);
	ts_mesh_block(mesh, ts_v3_make(0.20703125f, 0.00390625f, 0.046875f), handle, 0.0015625f, k);
	ts_mesh_block(mesh, ts_v3_make(0.20703125f, 0.005859375f, -0.03515625f),
	              ts_v3_make(0.017578125f, 0.00390625f, 0.02734375f), 0.00390625f, ts_mesh_segments(mesh, 3.0f, 0));
	ts_mesh_block(mesh, ts_v3_make(-0.171875f, 0.00390625f, 0.046875f), handle, 0.0015625f, k);
	ts_mesh_block(mesh, ts_v3_make(-0.171875f, 0.00390625f, -0.0234375f),
	              ts_v3_make(0.01171875f, 0.0015625f, 0.015625f), 0.0009765625f, k);
	for (u32 i = 0; i < 4 && ts_mesh_shows(mesh, 0.25f); i++) {
		f32 x = -0.171875f + ((f32)i - 1.5f) * 0.00634765625f;
		ts_mesh_rod(mesh, ts_v3_make(x, 0.00390625f, -0.037109375f), ts_v3_make(x, 0.0078125f, -0.0859375f),
		            0.0013671875f, ts_mesh_segments(mesh, 6.0f, 3));
	}
}

/* One place at the table, the guest on the side of +z; the plate's middle at mesh->place. */
static void add_setting(ts_mesh *mesh, const u32 *material, u32 id)
{
	ts_place stand = mesh->place;
	mesh->material = material[D_PORCELAIN];
	add_plate(mesh, 0.140625f);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, 0.01171875f, 0.0f, 0.0f));
	add_plate(mesh, 0.1015625f);
	mesh->place = stand;
	mesh->material = material[D_SILVER];
	add_cutlery(mesh);
	mesh->material = material[D_GLASS];
	mesh->place = ts_place_in(&stand, ts_place_at(0.1640625f, 0.0f, -0.1640625f, 0.0f));
	add_glass(mesh, 1.0f);
	mesh->place = ts_place_in(&stand, ts_place_at(0.078125f, 0.0f, -0.203125f, 0.0f));
	add_glass(mesh, 0.8125f);
	mesh->place = ts_place_in(&stand, ts_place_at(-0.25f, 0.0f, 0.0f, 0.015625f * ts_mesh_random(mesh, id)));
	mesh->material = material[D_SEAT];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.0078125f, 0.0f), ts_v3_make(0.046875f, 0.0078125f, 0.0859375f), 0.00390625f,
	              ts_mesh_segments(mesh, 2.0f, 0));
	mesh->place = stand;
}

static void add_bottle(ts_mesh *mesh, const u32 *material)
{
	static const f32 bottle[][2] = {{0.03125f, 0.0f},           {0.03515625f, 0.00390625f}, {0.037109375f, 0.015625f},
	                                {0.037109375f, 0.1796875f}, {0.03125f, 0.203125f},      {0.015625f, 0.2265625f},
	                                {0.013671875f, 0.28125f},   {0.013671875f, 0.28125f},   {0.015625f, 0.283203125f},
	                                {0.015625f, 0.296875f},     {0.0f, 0.298828125f}};
	static const f32 label[][2] = {{0.037841796875f, 0.0546875f}, {0.037841796875f, 0.1328125f}};
	u32 na = ts_mesh_segments(mesh, 32.0f, 6);
	mesh->material = material[D_BOTTLE];
	ts_mesh_lathe(mesh, bottle, 11, na, 2.0f);
	mesh->material = material[D_LINEN];
	ts_mesh_lathe(mesh, label, 2, na, 1.0f);
}

void ts_dining_candle(ts_mesh *mesh, const u32 *material, f32 height)
{
	static const f32 wax[][2] = {{0.01171875f, 0.0f},
	                             {0.0107421875f, 0.171875f},
	                             {0.0107421875f, 0.171875f},
	                             {0.005859375f, 0.16796875f},
	                             {0.0f, 0.166015625f}};
	static const f32 flame[][2] = {
		{0.0f, 0.1796875f}, {0.005859375f, 0.189453125f}, {0.00390625f, 0.203125f}, {0.0f, 0.21875f}};
	f32 h = height;
	const f32 stick[][2] = {{0.0546875f, 0.0f},
	                        {0.05859375f, 0.0078125f},
	                        {0.0234375f, 0.0234375f},
	                        {0.009765625f, h * 0.25f},
	                        {0.01953125f, h * 0.5f},
	                        {0.0078125f, h * 0.625f},
	                        {0.0078125f, h * 0.875f},
	                        {0.0234375f, h * 0.9375f},
	                        {0.0234375f, h},
	                        {0.0234375f, h},
	                        {0.0f, h}};
	ts_place stand = mesh->place;
	u32 na = ts_mesh_segments(mesh, 18.0f, 4);
	mesh->material = material[D_BRASS];
	ts_mesh_lathe(mesh, stick, 11, na, 1.5f);
	mesh->place = ts_place_in(&stand, ts_place_at(0.0f, h - 0.00390625f, 0.0f, 0.0f));
	mesh->material = material[D_WAX];
	ts_mesh_lathe(mesh, wax, 5, na, 1.5f);
	mesh->material = material[D_SHADE];
	ts_mesh_lathe(mesh, flame, 4, ts_mesh_segments(mesh, 10.0f, 3), 2.0f);
	mesh->place = stand;
}

void ts_dining_fruit(ts_mesh *mesh, const u32 *material)
{
	static const f32 bowl[][2] = {{0.078125f, 0.0f},       {0.0703125f, 0.015625f},    {0.0390625f, 0.03125f},
	                              {0.0390625f, 0.046875f}, {0.140625f, 0.078125f},     {0.1875f, 0.125f},
	                              {0.1875f, 0.125f},       {0.18359375f, 0.12890625f}, {0.13671875f, 0.0859375f},
	                              {0.0f, 0.0625f}};
	static const f32 ball[][2] = {{0.0f, -0.0390625f},     {0.0234375f, -0.03515625f}, {0.0390625f, -0.0078125f},
	                              {0.0390625f, 0.015625f}, {0.0234375f, 0.037109375f}, {0.00390625f, 0.03125f},
	                              {0.0f, 0.029296875f}};
	ts_place stand = mesh->place;
	mesh->material = material[D_SILVER];
	ts_mesh_lathe(mesh, bowl, 10, ts_mesh_segments(mesh, 40.0f, 6), 2.0f);
	for (u32 i = 0; i < 9; i++) {
		f32 r = i < 6 ? 0.0859375f : 0.0390625f, turn = (f32)i / (i < 6 ? 6.0f : 3.0f);
		mesh->place = ts_place_in(
			&stand, ts_place_at(r * ts_cos_turn(turn), i < 6 ? 0.125f : 0.1796875f, r * ts_sin_turn(turn), turn));
		mesh->material = material[i % 3 ? D_APPLE : D_ORANGE];
		ts_mesh_lathe(mesh, ball, 7, ts_mesh_segments(mesh, 20.0f, 4), 2.5f);
	}
	mesh->place = stand;
}

void ts_dining_chair(ts_mesh *mesh, const u32 *material)
{
	u32 na = ts_mesh_segments(mesh, 10.0f, 3), nl = ts_mesh_segments(mesh, 8.0f, 1);
	mesh->material = material[D_SEAT];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.46875f, 0.0f), ts_v3_make(0.21875f, 0.03125f, 0.21875f), 0.0234375f,
	              ts_mesh_segments(mesh, 4.0f, 0));
	mesh->material = material[D_MAHOGANY];
	ts_mesh_block(mesh, ts_v3_make(0.0f, 0.421875f, 0.0f), ts_v3_make(0.2109375f, 0.0234375f, 0.2109375f), 0.0078125f,
	              ts_mesh_segments(mesh, 1.0f, 0));
	for (u32 i = 0; i < 2; i++) {
		f32 x = i ? 0.1875f : -0.1875f;
		const ts_v3 back[5] = {{x, 0.0f, 0.234375f},
		                       {x, 0.234375f, 0.203125f},
		                       {x, 0.453125f, 0.1953125f},
		                       {x, 0.75f, 0.2265625f},
		                       {x * 1.0625f, 1.0f, 0.28125f}};
		ts_mesh_rod(mesh, ts_v3_make(x, 0.40625f, -0.1875f), ts_v3_make(x, 0.0f, -0.1953125f), 0.01953125f, na);
		ts_mesh_tube(mesh, back, 5, 0.017578125f, ts_v3_make(1.0f, 0.0f, 0.0f), na, nl + 1);
		if (ts_mesh_shows(mesh, 0.1875f))
			ts_mesh_rod(mesh, ts_v3_make(x, 0.1875f, -0.1875f), ts_v3_make(x, 0.1875f, 0.203125f), 0.0107421875f, na);
	}
	const ts_v3 top[3] = {
		{-0.203125f, 0.984375f, 0.28125f}, {0.0f, 1.0f, 0.3046875f}, {0.203125f, 0.984375f, 0.28125f}};
	const ts_v3 low[3] = {{-0.1875f, 0.5625f, 0.203125f}, {0.0f, 0.5625f, 0.21875f}, {0.1875f, 0.5625f, 0.203125f}};
	ts_mesh_tube(mesh, top, 3, 0.0234375f, ts_v3_make(0.0f, 1.0f, 0.0f), na, nl);
	ts_mesh_tube(mesh, low, 3, 0.015625f, ts_v3_make(0.0f, 1.0f, 0.0f), na, nl);
	for (u32 i = 0; i < 6 && ts_mesh_shows(mesh, 0.125f); i++) {
		f32 x = ((f32)i - 2.5f) * 0.0546875f;
		const ts_v3 spindle[3] = {{x, 0.5625f, 0.2109375f}, {x, 0.78125f, 0.234375f}, {x, 0.984375f, 0.296875f}};
		ts_mesh_tube(mesh, spindle, 3, 0.0068359375f, ts_v3_make(1.0f, 0.0f, 0.0f), na, nl);
	}
}

static void add_legs(ts_mesh *mesh, const u32 *material)
{
	static const f32 leg[][2] = {{0.0234375f, 0.0f},    {0.03125f, 0.015625f}, {0.0234375f, 0.0625f},
	                             {0.03125f, 0.125f},    {0.046875f, 0.4375f},  {0.03125f, 0.5f},
	                             {0.0546875f, 0.5625f}, {0.046875f, 0.703125f}};
	ts_place stand = mesh->place;
	mesh->material = material[D_MAHOGANY];
	ts_mesh_block(mesh, ts_v3_make(0.0f, TABLE - 0.0234375f, 0.0f), ts_v3_make(HALF_X, 0.0234375f, HALF_Z), 0.0078125f,
	              ts_mesh_segments(mesh, 1.0f, 0));
	for (u32 i = 0; i < 4; i++) {
		mesh->place = ts_place_in(&stand, ts_place_at(i & 1u ? HALF_X - 0.125f : 0.125f - HALF_X, 0.0f,
		                                              i & 2u ? HALF_Z - 0.125f : 0.125f - HALF_Z, 0.0f));
		ts_mesh_lathe(mesh, leg, 8, ts_mesh_segments(mesh, 20.0f, 4), 2.0f);
	}
	mesh->place = stand;
}

void ts_dining_table(ts_mesh *mesh, const u32 *material)
{
	static const f32 hang = 0.25f;
	ts_place stand = mesh->place;
	add_legs(mesh, material);
	mesh->material = material[D_LINEN];
	ts_mesh_grid(mesh, ts_mesh_segments(mesh, 110.0f, 12), ts_mesh_segments(mesh, 48.0f, 10), 0, tablecloth, &hang);
	for (u32 i = 0; i < 8; i++) {
		f32 x = ((f32)(i / 2) - 1.5f) * 0.875f, side = i & 1u ? 1.0f : -1.0f;
		ts_place seat = ts_place_at(x, 0.0f, side * 0.75f,
		                            (i & 1u ? 0.0f : 0.5f) + 0.03125f * (ts_mesh_random(mesh, 700u + i) - 0.5f));
		mesh->place = ts_place_in(&stand, seat);
		ts_dining_chair(mesh, material);
		mesh->place = ts_place_in(&stand, ts_place_at(x, TABLE + 0.009765625f, side * 0.359375f, i & 1u ? 0.0f : 0.5f));
		add_setting(mesh, material, 720u + i);
	}
	for (u32 i = 0; i < 6; i++) {
		f32 x = ((f32)i - 2.5f) * 0.46875f;
		mesh->place = ts_place_in(&stand, ts_place_at(x, TABLE + 0.0078125f, i & 1u ? 0.03125f : -0.046875f, 0.0f));
		if (i == 2)
			ts_dining_fruit(mesh, material);
		else if (i == 1 || i == 4)
			ts_dining_candle(mesh, material, 0.25f);
		else if (i == 3)
			add_bottle(mesh, material);
	}
	mesh->place = stand;
}

void ts_dining_chandelier(ts_mesh *mesh, const u32 *material)
{
	static const f32 body[][2] = {{0.0f, -0.25f},         {0.03125f, -0.21875f}, {0.015625f, -0.171875f},
	                              {0.09375f, -0.078125f}, {0.078125f, 0.0f},     {0.03125f, 0.0625f},
	                              {0.015625f, 0.25f},     {0.0f, 0.265625f}};
	static const f32 drop[][2] = {{0.0f, -0.046875f}, {0.01171875f, -0.02734375f}, {0.0f, 0.0f}};
	ts_place stand = mesh->place;
	mesh->material = material[D_BRASS];
	ts_part_chain(mesh, ts_v3_make(0.0f, -0.015625f, 0.0f), ts_mesh_shows(mesh, 0.1875f) ? 12 : 0, 0.0546875f,
	              0.00585937500f);
	ts_place centre = ts_place_in(&stand, ts_place_at(0.0f, -0.90625f, 0.0f, 0.0f));
	mesh->place = centre;
	ts_mesh_lathe(mesh, body, 8, ts_mesh_segments(mesh, 28.0f, 6), 3.0f);
	for (u32 i = 0; i < 8; i++) {
		ts_place arm = ts_place_in(&centre, ts_place_at(0.0f, 0.0f, 0.0f, (f32)i * 0.125f));
		const ts_v3 curve[5] = {{0.0625f, -0.0625f, 0.0f},
		                        {0.21875f, -0.171875f, 0.0f},
		                        {0.40625f, -0.140625f, 0.0f},
		                        {0.5f, -0.03125f, 0.0f},
		                        {0.5f, 0.03125f, 0.0f}};
		mesh->place = arm;
		mesh->material = material[D_BRASS];
		ts_mesh_tube(mesh, curve, 5, 0.01171875f, ts_v3_make(0.0f, 0.0f, 1.0f), ts_mesh_segments(mesh, 10.0f, 3),
		             ts_mesh_segments(mesh, 24.0f, 3));
		mesh->place = ts_place_in(&arm, ts_place_at(0.5f, 0.015625f, 0.0f, 0.0f));
		ts_dining_candle(mesh, material, 0.0625f);
		mesh->material = material[D_GLASS];
		u32 drops = (u32)ts_min_i32((i32)ts_mesh_segments(mesh, 5.0f, 0), 12);
		for (u32 k = 0; k < drops; k++) {
			f32 at = 0.125f + 0.375f * ((f32)k + 0.5f) / (f32)drops;
			mesh->place = ts_place_in(&arm, ts_place_at(at, -0.1875f, 0.0f, 0.0f));
			ts_mesh_lathe(mesh, drop, 3, ts_mesh_segments(mesh, 8.0f, 3), 2.0f);
		}
	}
	mesh->place = stand;
}
