/* Cube maps: the six faces of OpenGL's table as views from the inside, and the texel of a direction (CONTRACT
 * rule 36). */
#ifndef TS_KERNELS_RASTER_CUBE_H
#define TS_KERNELS_RASTER_CUBE_H
#include "kernels/raster/view.h"

/* Rows right, up, back of faces +X -X +Y -Y +Z -Z: (sc, -tc, -ma) of OpenGL's table. */
TS_CONSTANT f32 ts_cube_row[6][9] = {
	{0.0f, 0.0f, -1.0f, 0.0f, 1.0f, 0.0f, -1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f, 0.0f, 1.0f, 0.0f, 1.0f, 0.0f, 0.0f},
	{1.0f, 0.0f, 0.0f, 0.0f, 0.0f, -1.0f, 0.0f, -1.0f, 0.0f}, {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f, 0.0f},
	{1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, -1.0f},  {-1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f},
};

TS_FN ts_v3 ts_k_cube_row(u32 face, u32 row)
{
	return ts_v3_make(ts_cube_row[face][row * 3u], ts_cube_row[face][row * 3u + 1u], ts_cube_row[face][row * 3u + 2u]);
}

/* The view of a face from the cube's centre. */
TS_FN ts_camera_k ts_k_cube_view(TS_GLOBAL const ts_face *cube, u32 face)
{
	ts_camera_k r;
	/* Look along the face's axes (CONTRACT rule 36). */
	r.eye = ts_load3(cube->centre);
	r.right = ts_k_cube_row(face, 0u);
	r.up = ts_k_cube_row(face, 1u);
	r.back = ts_k_cube_row(face, 2u);
	/* See 90 degrees: at a focal length of n / 2 pixels n texels span them. */
	r.focal = (f32)cube->n * 0.5f;
	r.near = cube->near;
	r.width = (i32)cube->n;
	r.height = (i32)cube->n;
	r.side = 1.0f;
	/* Take texels at their centres, in perspective. */
	r.shift_x = 0;
	r.shift_y = 0;
	r.orthographic = 0u;
	return r;
}

/* A face's axis as a world axis and a sign. */
typedef struct {
	u32 axis;
	f32 sign;
} ts_row;

TS_FN ts_row ts_k_row(ts_v3 v)
{
	ts_row r;
	r.axis = v.x != 0.0f ? 0u : v.y != 0.0f ? 1u : 2u;
	r.sign = v.x != 0.0f ? v.x : v.y != 0.0f ? v.y : v.z;
	return r;
}

/* The coordinate of a point along an axis of the world. */
TS_FN f32 ts_k_along(ts_v3 p, u32 axis) { return axis == 0u ? p.x : axis == 1u ? p.y : p.z; }

/* A direction as face and (sc / ma, tc / ma) in [-1, 1]. */
typedef struct {
	u32 face;
	f32 s, t;
} ts_cube_place;

TS_FN ts_cube_place ts_k_cube_place(ts_v3 d)
{
	/* Choose the face of the greatest component; ties go to x, then y (CONTRACT rule 36). */
	f32 x = ts_abs(d.x);
	f32 y = ts_abs(d.y);
	f32 z = ts_abs(d.z);
	ts_cube_place r;
	f32 major;
	if (x >= y && x >= z) {
		r.face = d.x < 0.0f ? 1u : 0u;
		major = x;
	} else if (y >= z) {
		r.face = d.y < 0.0f ? 3u : 2u;
		major = y;
	} else {
		r.face = d.z < 0.0f ? 5u : 4u;
		major = z;
	}
	/* Divide by that component; 1 stands in for that of the zero direction. */
	major = major > 0.0f ? major : 1.0f;
	r.s = ts_dot(ts_k_cube_row(r.face, 0u), d) / major;
	r.t = -ts_dot(ts_k_cube_row(r.face, 1u), d) / major;
	return r;
}

/* The column of s, or the row of t: min(n - 1, floor((s + 1) / 2 * n)). */
TS_FN u32 ts_k_cube_texel(f32 s, u32 n)
{
	f32 unit = (s + 1.0f) * 0.5f;
	return (u32)ts_min_i32(ts_max_i32(ts_floor_i32(unit * (f32)n), 0), (i32)n - 1);
}

/* Texel of a direction, relative to the cube's first. */
TS_FN u64 ts_k_cube_index(ts_cube_place place, u32 n)
{
	u64 row = ts_k_cube_texel(place.t, n);
	u64 column = ts_k_cube_texel(place.s, n);
	return ((u64)place.face * n + row) * n + column;
}

/* The direction of a point of a face. */
TS_FN ts_v3 ts_k_cube_direction(u32 face, f32 s, f32 t)
{
	ts_v3 r = ts_scale(ts_k_cube_row(face, 0u), s);
	r = ts_mad(r, ts_k_cube_row(face, 1u), -t);
	return ts_sub(r, ts_k_cube_row(face, 2u));
}

#endif
