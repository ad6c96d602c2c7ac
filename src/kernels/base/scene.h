/* The arrays of the scene that shading kernels read. */
#ifndef TS_KERNELS_BASE_SCENE_H
#define TS_KERNELS_BASE_SCENE_H
#include "kernels/base/args.h"
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

#define TS_ROWS_ts_arrays(ARG) \
	ARG(IN, ts_vertex, vertices, pose_vertex) /* world space, this frame */ \
	ARG(IN, ts_triangle, triangles, scene_triangle) \
	ARG(IN, ts_material, materials, scene_material) \
	ARG(IN, ts_slot, slots, scene_slot) \
	ARG(IN, ts_image, images, scene_image) \
	ARG(IN, u64, texels, scene_texel) \
	ARG(IN, ts_light, lights, scene_light) \
	ARG(IN, ts_object, objects, scene_object) \
	ARG(VALUE, u32, n_triangles, none) \
	ARG(VALUE, u32, n_lights, none) \
	ARG(VALUE, f32, ambient, none)
TS_ARGS(ts_arrays);

#define TS_DOUBLE_SIDED 1u
#define TS_MASKED 2u
#define TS_UNLIT 4u

/* The three corners of a triangle and its normal (b - a) x (c - a), not normalized. */
typedef struct {
	ts_v3 a, b, c, n;
} ts_corners;

TS_FN ts_corners ts_k_corners(const ts_arrays *scene, u32 triangle)
{
	TS_GLOBAL const ts_triangle *t = &scene->triangles[triangle];
	ts_corners r;
	r.a = ts_load3(scene->vertices[t->vertex[0]].position);
	r.b = ts_load3(scene->vertices[t->vertex[1]].position);
	r.c = ts_load3(scene->vertices[t->vertex[2]].position);
	r.n = ts_cross(ts_sub(r.b, r.a), ts_sub(r.c, r.a));
	return r;
}

/* Whether a triangle with the normal n has no area; every stage drops such triangles (CONTRACT rule 35). */
TS_FN bool ts_k_is_degenerate(ts_v3 n) { return !(ts_flush(ts_dot(n, n)) > 0.0f); }

TS_FN bool ts_k_is_two_sided(const ts_arrays *scene, u32 triangle)
{
	return (scene->materials[scene->triangles[triangle].material].flags & TS_DOUBLE_SIDED) != 0u;
}

/* Whether the triangle turns its front to the eye, or is two-sided. The winding on the screen never decides this
 * (CONTRACT rule 35). */
TS_FN bool ts_k_is_facing(const ts_arrays *scene, u32 triangle, const ts_corners *t, ts_v3 eye)
{
	if (ts_k_is_two_sided(scene, triangle)) return true;
	return ts_flush(ts_dot(t->n, ts_sub(eye, t->a))) > 0.0f;
}

TS_FN u32 ts_k_object_of(const ts_arrays *scene, u32 triangle)
{
	return scene->vertices[scene->triangles[triangle].vertex[0]].object;
}

/* The reflector that a triangle belongs to, or TS_NONE. */
TS_FN u32 ts_k_reflector_of(const ts_arrays *scene, u32 triangle)
{
	return scene->objects[ts_k_object_of(scene, triangle)].reflector;
}

/* Whether a cube may show the triangle: it is not of the cube's own reflector, and does not turn its back. */
TS_FN bool ts_k_may_show(const ts_arrays *scene, TS_GLOBAL const ts_face *cube, u32 triangle, const ts_corners *t)
{
	if (cube->n == 0u || cube->object == ts_k_object_of(scene, triangle)) return false;
	return ts_k_is_facing(scene, triangle, t, ts_load3(cube->centre));
}

#endif
