/* "plain": two mirrors and two stones on a rug, and a ground of 40 km: its numbers span a range like no room's. Near
 * planes cut edges of the ground whose ends are 2^25 times as far away. */
#include "scene/builtin/builtin.h"
#include "scene/sources.h"

enum { STONE, RUG, N_PAINTS };
#define HALF 20000.0f

static const ts_paint paints[N_PAINTS] = {
	[STONE] = {ts_paint_ashlar, 1, 256, {1.0f, 1.0f}, TS_MAP_NORMAL, 0, TS_WHITE, 1.0f, 0.0f},
	[RUG] = {ts_paint_carpet, 0, 512, {1.0f, 1.0f}, 0, TS_DOUBLE_SIDED, TS_WHITE, 1.0f, 0.0f},
};

static const f32 mirrors[][4] = {{0.0f, 1.0f, 0.0f, 0.5f}, {1.0f, 0.375f, 0.75f, 0.25f}};

static void shape_plain(ts_mesh *mesh, const u32 *material)
{
	mesh->material = material[STONE];
	ts_mesh_block(mesh, ts_v3_make(-1.25f, 0.5f, -0.75f), ts_v3_make(0.375f, 0.5f, 0.375f), 0.0f, 0);
	ts_mesh_block(mesh, ts_v3_make(1.5f, 0.25f, -1.0f), ts_v3_make(0.5f, 0.25f, 0.25f), 0.0f, 0);
	if (mesh->build != NULL) ts_builtin_camera(mesh->build, "visitor", ts_v3_make(0.25f, 1.25f, 2.5f), 0.1875f);
}

static void add_ground(ts_build *build)
{
	static const f32 sand[3] = {0.453125f, 0.40625f, 0.328125f};
	ts_material material = ts_material_default();
	memcpy(material.base, sand, sizeof sand);
	ts_build_object(build, NULL, false);
	ts_mesh mesh = {.build = build, .place = ts_place_world(), .material = ts_build_material(build, &material)};
	ts_mesh_plane(&mesh, ts_v3_make(-HALF, 0.0f, HALF), ts_v3_make(2.0f * HALF, 0.0f, 0.0f),
	              ts_v3_make(0.0f, 0.0f, -2.0f * HALF), 1, 1);
}

const ts_builtin ts_builtin_plain = {
	.info = {"plain", "two mirrors and two stones on a rug, on a ground of 40 km: numbers that are far apart"},
	.paints = paints,
	.n_paints = N_PAINTS,
	.shape = shape_plain,
	.rug = {RUG, 2.5f, 1.75f, 0.0f, 0.01171875f, 1.0f, {2.0f, 1.25f, 5.0f, 3.0f}},
	.mirrors = mirrors,
	.n_mirrors = sizeof mirrors / sizeof *mirrors,
	.beyond = add_ground,
	.camera = "visitor",
};
