/* Small worlds for the tests of truth: a scene of plain arrays and a run whose frame holds its pose. */
#ifndef TS_TESTS_TRUTH_WORLD_H
#define TS_TESTS_TRUTH_WORLD_H
#include <assert.h>
#include <string.h>
#include "kernels/base/texture.h"
#include "truth/truth.h"

enum { WORLD_TRIANGLES = 8192, WORLD_OBJECTS = 4, WORLD_MATERIALS = 11 };
/* Materials: what their names say; CUT and UNCUT have an alpha below and above their cutoff. From WALL on: six colours
 * that need no light. */
enum { TWO_SIDED, ONE_SIDED, CUT, UNCUT, HALF_CUT, WALL };

typedef struct {
	ts_vertex vertices[WORLD_TRIANGLES * 3];
	ts_triangle triangles[WORLD_TRIANGLES];
	ts_material materials[WORLD_MATERIALS];
	ts_object objects[WORLD_OBJECTS]; /* 0 is static, the others are reflectors 0, 1, 2 */
	ts_slot slot;
	ts_image image;
	u64 texels[4];
	ts_scene scene;
	ts_run run;
} world;

static inline ts_material world_material(u32 flags, f32 alpha)
{
	return (ts_material){.base = {1, 1, 1, alpha},
	                     .roughness = 1,
	                     .normal_scale = 1,
	                     .occlusion = 1,
	                     .alpha_cutoff = 0.5f,
	                     .flags = flags,
	                     .slot = {TS_NONE, TS_NONE, TS_NONE, TS_NONE, TS_NONE}};
}

/* Two texels: alpha 0 on the left, 1 on the right, so 1/2 in the middle; the level above is half everywhere. */
static inline void world_texture(world *w)
{
	w->texels[0] = 0x0000ffffffffffffUL;
	w->texels[1] = 0xffffffffffffffffUL;
	w->texels[2] = 0x8000ffffffffffffUL;
	w->image = (ts_image){.width = 2, .height = 1, .n_levels = 2};
	w->slot = (ts_slot){.wrap = {TS_CLAMP, TS_CLAMP}, .transform = {1, 0, 0, 0, 1, 0}};
	w->materials[HALF_CUT].slot[TS_SLOT_BASE] = 0;
}

static inline void world_begin(world *w)
{
	memset(w, 0, sizeof(*w));
	w->materials[TWO_SIDED] = world_material(TS_DOUBLE_SIDED, 1);
	w->materials[ONE_SIDED] = world_material(0, 1);
	w->materials[CUT] = world_material(TS_DOUBLE_SIDED | TS_MASKED, 0.25f);
	w->materials[UNCUT] = world_material(TS_DOUBLE_SIDED | TS_MASKED, 0.75f);
	w->materials[HALF_CUT] = world_material(TS_DOUBLE_SIDED | TS_MASKED, 1);
	for (u32 i = 0; i < 6; i++) {
		w->materials[WALL + i] = world_material(TS_DOUBLE_SIDED | TS_UNLIT, 1);
		for (u32 k = 0; k < 3; k++) w->materials[WALL + i].base[k] = (f32)(i + 1 + k) * 0.125f;
	}
	world_texture(w);
	for (u32 i = 0; i < WORLD_OBJECTS; i++) w->objects[i].reflector = i - 1;
	w->scene = (ts_scene){.vertices = w->vertices,
	                      .triangles = w->triangles,
	                      .materials = w->materials,
	                      .n_materials = WORLD_MATERIALS,
	                      .slots = &w->slot,
	                      .n_slots = 1,
	                      .images = &w->image,
	                      .n_images = 1,
	                      .texels = w->texels,
	                      .n_texels = 3,
	                      .objects = w->objects,
	                      .n_objects = WORLD_OBJECTS,
	                      .info = {.n_reflectors = WORLD_OBJECTS - 1, .ambient = 1}};
}

/* Corners get uv (0,0), (1,0), (1,1) and the face's normal. */
static inline void world_triangle(world *w, ts_v3 a, ts_v3 b, ts_v3 c, u32 material, u32 object)
{
	ts_v3 corner[3] = {a, b, c};
	u32 first = w->scene.n_vertices;
	assert(w->scene.n_triangles < WORLD_TRIANGLES);
	for (u32 i = 0; i < 3; i++) {
		ts_vertex *v = &w->vertices[first + i];
		*v = (ts_vertex){.object = object, .uv = {i > 0, i > 1, 0, 0}, .colour = {1, 1, 1, 1}};
		ts_store3(v->position, corner[i]);
	}
	w->triangles[w->scene.n_triangles++] = (ts_triangle){{first, first + 1, first + 2}, material};
	w->scene.n_vertices += 3;
}

static inline void world_quad(world *w, ts_v3 a, ts_v3 b, ts_v3 c, ts_v3 d, u32 material, u32 object)
{
	world_triangle(w, a, b, c, material, object);
	world_triangle(w, a, c, d, material, object);
}

/* Corner i of the box: bit 0 is x, bit 1 is y, bit 2 is z. */
static inline ts_v3 world_corner(ts_v3 low, ts_v3 high, u32 i)
{
	return ts_v3_make(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
}

/* Twelve triangles, faces -x +x -y +y -z +z in pairs; their fronts look inwards. */
static inline void world_room(world *w, ts_v3 low, ts_v3 high, u32 material, u32 object)
{
	static const u8 face[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
	for (u32 f = 0; f < 6; f++)
		world_quad(w, world_corner(low, high, face[f][0]), world_corner(low, high, face[f][1]),
		           world_corner(low, high, face[f][2]), world_corner(low, high, face[f][3]), material, object);
}

/* Ends the building: hands the arrays to the run's frame. */
static inline void world_pose(world *w)
{
	ts_params params;
	ts_params_default(&params);
	ts_run_begin(&w->run, &w->scene, &params, 2);
	ts_frame_borrow(&w->run.frame, TS_B_pose_vertex, w->vertices, w->scene.n_vertices);
}

#endif
