/* Visibility bits: the faces of cubes that may see a triangle (EPR section 3.1; METHODS 2). Face f of cube r has bit 6
 * r + f. The tangent of half a face's field of view is 1. */
#ifndef TS_KERNELS_RASTER_VISIBILITY_H
#define TS_KERNELS_RASTER_VISIBILITY_H
#include "kernels/base/args.h"
#include "kernels/base/scene.h"
#include "kernels/raster/cube.h"

#define TS_ROWS_ts_visibility_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(OUT, u64, bits, visibility_bits) /* n_triangles * n_words */ \
	ARG(VALUE, u32, n_cubes, none) \
	ARG(VALUE, u32, n_words, none) \
	ARG(VALUE, u32, vertex_mode, none)
TS_ARGS(ts_visibility_args);

/* A corner relative to a cube's centre, on the axes of a face. */
TS_FN ts_v3 ts_k_face_axes(u32 face, ts_v3 d)
{
	ts_v3 back = ts_k_cube_row(face, 2u);
	return ts_v3_make(ts_dot(ts_k_cube_row(face, 0u), d), ts_dot(ts_k_cube_row(face, 1u), d), -ts_dot(back, d));
}

/* A frustum: how far it reaches to the sides and up, one unit ahead or, in an orthographic view, everywhere; and
 * near. */
typedef struct {
	f32 x, y, near;
	u32 orthographic;
} ts_frustum;

TS_FN f32 ts_k_reach(const ts_frustum *frustum, f32 side, f32 z)
{
	return frustum->orthographic != 0u ? side : side * z;
}

/* Whether all corners lie outside one plane of the frustum. A corner on a plane is not outside. */
TS_FN bool ts_k_outside_plane(const ts_frustum *f, ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Find how far the frustum reaches at the depth of each corner. */
	f32 ax = ts_k_reach(f, f->x, a.z), bx = ts_k_reach(f, f->x, b.z), cx = ts_k_reach(f, f->x, c.z);
	f32 ay = ts_k_reach(f, f->y, a.z), by = ts_k_reach(f, f->y, b.z), cy = ts_k_reach(f, f->y, c.z);
	/* Test right, left, top, bottom and near: strictly, so that a corner on a plane is inside. */
	if (a.x > ax && b.x > bx && c.x > cx) return true;
	if (-a.x > ax && -b.x > bx && -c.x > cx) return true;
	if (a.y > ay && b.y > by && c.y > cy) return true;
	if (-a.y > ay && -b.y > by && -c.y > cy) return true;
	return a.z < f->near && b.z < f->near && c.z < f->near;
}

/* Whether p lies in the frustum made wider and higher by a fifth (EPR 3.1). */
TS_FN bool ts_k_inside_enlarged(const ts_frustum *f, ts_v3 p)
{
	f32 fifth_more = 1.2000000476837158203125f;
	return p.z > 0.0f && ts_abs(p.x) <= fifth_more * ts_k_reach(f, f->x, p.z) &&
	       ts_abs(p.y) <= fifth_more * ts_k_reach(f, f->y, p.z);
}

/* Whether a view may see the triangle; a, b and c are on the axes of the view. */
TS_FN bool ts_k_may_see(const ts_frustum *f, ts_v3 a, ts_v3 b, ts_v3 c, u32 vertex_mode)
{
	if (vertex_mode == 0u) return !ts_k_outside_plane(f, a, b, c);
	return ts_k_inside_enlarged(f, a) || ts_k_inside_enlarged(f, b) || ts_k_inside_enlarged(f, c);
}

/* The faces of a cube that may see the triangle, a bit each. */
TS_FN u32 ts_k_visible_faces(const ts_corners *t, TS_GLOBAL const ts_face *cube, u32 vertex_mode)
{
	/* Move the corners to the cube's centre. */
	ts_v3 centre = ts_load3(cube->centre);
	ts_v3 da = ts_sub(t->a, centre);
	ts_v3 db = ts_sub(t->b, centre);
	ts_v3 dc = ts_sub(t->c, centre);
	ts_frustum frustum;
	/* Take the frustum of a face: 45 degrees to each side. */
	frustum.x = 1.0f;
	frustum.y = 1.0f;
	frustum.near = cube->near;
	frustum.orthographic = 0u;
	/* Test each face on its own axes (EPR 3.1). */
	u32 faces = 0u;
	for (u32 face = 0u; face < 6u; face++) {
		ts_v3 a = ts_k_face_axes(face, da);
		ts_v3 b = ts_k_face_axes(face, db);
		ts_v3 c = ts_k_face_axes(face, dc);
		faces |= ts_k_may_see(&frustum, a, b, c, vertex_mode) ? 1u << face : 0u;
	}
	return faces;
}

/* The six bits of one triangle in one cube: 0 if the cube is its own reflector's, or it turns its back. */
TS_FN u32 ts_k_visibility(const ts_visibility_args *args, u32 triangle, const ts_corners *t, u32 r)
{
	TS_GLOBAL const ts_face *cube = &args->cubes[r];
	return ts_k_may_show(&args->scene, cube, triangle, t) ? ts_k_visible_faces(t, cube, args->vertex_mode) : 0u;
}

/* The six bits of cube r of a triangle's words. */
TS_FN u32 ts_k_cube_bits(TS_GLOBAL const u64 *words, u32 r)
{
	u32 first = r * 6u;
	u32 shift = first & 63u;
	u64 low = words[first >> 6] >> shift;
	u64 high = shift > 58u ? words[(first >> 6) + 1u] << (64u - shift) : 0u;
	return (u32)(low | high) & 63u;
}

/* map over triangles */
TS_FN void ts_k_visibility_item(const ts_visibility_args *args, u64 i)
{
	/* Clear the words; a triangle without area sets no bit. */
	TS_GLOBAL u64 *words = args->bits + i * args->n_words;
	for (u32 w = 0u; w < args->n_words; w++) words[w] = 0u;
	u32 triangle = (u32)i;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (ts_k_is_degenerate(t.n)) return;
	for (u32 r = 0u; r < args->n_cubes; r++) {
		/* Find the faces of the cube that may see the triangle (EPR 3.1). */
		u64 faces = ts_k_visibility(args, triangle, &t, r);
		/* Set their six bits; above a shift of 58 they run over into the next word. */
		u32 first = r * 6u;
		u32 shift = first & 63u;
		words[first >> 6] |= faces << shift;
		if (shift > 58u) words[(first >> 6) + 1u] |= faces >> (64u - shift);
	}
}

#endif
