/* Triangles as polygons in view space, clipped against planes (CONTRACT rule 16). */
#ifndef TS_KERNELS_RASTER_CLIP_H
#define TS_KERNELS_RASTER_CLIP_H
#include "kernels/raster/view.h"

typedef struct {
	ts_corner corner[TS_MAX_CORNERS];
	u32 n;
} ts_polygon;

/* A triangle of the world in the view; each corner has the whole of its own weight. */
TS_FN ts_polygon ts_k_polygon(const ts_camera_k *view, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_polygon r;
	r.n = 3u;
	r.corner[0] = ts_k_to_view(view, a);
	r.corner[1] = ts_k_to_view(view, b);
	r.corner[2] = ts_k_to_view(view, c);
	r.corner[0].w.x = 1.0f;
	r.corner[1].w.y = 1.0f;
	r.corner[2].w.z = 1.0f;
	return r;
}

/* The half space x X + y Y + z Z + d >= 0. */
typedef struct {
	f32 x, y, z, d;
} ts_plane;

TS_FN ts_plane ts_plane_make(f32 x, f32 y, f32 z, f32 d)
{
	ts_plane r;
	r.x = x;
	r.y = y;
	r.z = z;
	r.d = d;
	return r;
}

TS_FN f32 ts_k_plane_side(const ts_plane *plane, const ts_corner *p)
{
	f32 x = plane->x * p->x;
	f32 y = plane->y * p->y;
	f32 z = plane->z * p->z;
	f32 s = x + y;
	f32 t = s + z;
	return ts_flush(t + plane->d);
}

/* Cuts from the inside to the outside corner, so that both triangles of an edge get the same bits (rule 16). On a long
 * edge z may round to less than `near`, even to 0, which is no depth; so it is raised to `near`. */
TS_FN ts_corner ts_k_cut(const ts_corner *in, f32 d_in, const ts_corner *out, f32 d_out, f32 near)
{
	f32 t = d_in / (d_in - d_out);
	ts_corner r;
	r.x = in->x + (out->x - in->x) * t;
	r.y = in->y + (out->y - in->y) * t;
	r.z = ts_max(in->z + (out->z - in->z) * t, near);
	r.w = ts_mad(in->w, ts_sub(out->w, in->w), t);
	return r;
}

/* Adds a corner. Rounding can make the edges of a polygon in the plane change sides at every corner; corners that no
 * longer fit lie in the plane, and are dropped. */
TS_FN void ts_k_push(ts_polygon *polygon, ts_corner corner)
{
	if (polygon->n < TS_MAX_CORNERS) polygon->corner[polygon->n++] = corner;
}

/* Clips against one plane (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974); no cut is before `near`. */
TS_FN void ts_k_clip(ts_polygon *polygon, ts_plane plane, f32 near)
{
	ts_polygon r;
	r.n = 0u;
	for (u32 i = 0u; i < polygon->n; i++) {
		/* Take an edge and the sides of its corners; a corner in the plane is inside. */
		const ts_corner *p = &polygon->corner[i];
		const ts_corner *q = &polygon->corner[i + 1u < polygon->n ? i + 1u : 0u];
		f32 dp = ts_k_plane_side(&plane, p);
		f32 dq = ts_k_plane_side(&plane, q);
		/* Keep an inner corner, then the cut, always made from inside to outside (CONTRACT rule 16). */
		if (dp >= 0.0f) ts_k_push(&r, *p);
		if (dp >= 0.0f && dq < 0.0f) ts_k_push(&r, ts_k_cut(p, dp, q, dq, near));
		if (dp < 0.0f && dq >= 0.0f) ts_k_push(&r, ts_k_cut(q, dq, p, dp, near));
	}
	*polygon = r;
}

TS_FN bool ts_k_all_behind(const ts_polygon *polygon, ts_plane plane)
{
	for (u32 i = 0u; i < polygon->n; i++) {
		if (ts_k_plane_side(&plane, &polygon->corner[i]) >= 0.0f) return false;
	}
	return true;
}

TS_FN bool ts_k_any_behind(const ts_polygon *polygon, ts_plane plane)
{
	for (u32 i = 0u; i < polygon->n; i++) {
		if (ts_k_plane_side(&plane, &polygon->corner[i]) < 0.0f) return true;
	}
	return false;
}

TS_FN ts_plane ts_k_near_plane(const ts_camera_k *view) { return ts_plane_make(0.0f, 0.0f, 1.0f, -view->near); }

/* Side plane `side` (-x +x -y +y) of the frustum, `pixels` from the image's middle. */
TS_FN ts_plane ts_k_side_plane(const ts_camera_k *view, u32 side, f32 pixels)
{
	f32 sign = (side & 1u) == 0u ? view->focal : -view->focal;
	f32 z = view->orthographic != 0u ? 0.0f : pixels;
	f32 d = view->orthographic != 0u ? pixels : 0.0f;
	return side < 2u ? ts_plane_make(sign, 0.0f, z, d) : ts_plane_make(0.0f, sign, z, d);
}

/* Whether no part of the polygon can reach the image. */
TS_FN bool ts_k_is_outside(const ts_camera_k *view, const ts_polygon *polygon)
{
	if (ts_k_all_behind(polygon, ts_k_near_plane(view))) return true;
	for (u32 side = 0u; side < 4u; side++) {
		f32 pixels = (f32)(side < 2u ? view->width : view->height) * 0.5f;
		if (ts_k_all_behind(polygon, ts_k_side_plane(view, side, pixels))) return true;
	}
	return false;
}

TS_FN void ts_k_clip_behind(const ts_camera_k *view, ts_polygon *polygon, ts_plane plane)
{
	if (ts_k_any_behind(polygon, plane)) ts_k_clip(polygon, plane, view->near);
}

/* Clips against the near plane, then the sides at x and y pixels from the image's middle. */
TS_FN void ts_k_clip_to_sides(const ts_camera_k *view, ts_polygon *polygon, f32 x, f32 y)
{
	ts_k_clip_behind(view, polygon, ts_k_near_plane(view));
	for (u32 side = 0u; side < 4u; side++) {
		ts_k_clip_behind(view, polygon, ts_k_side_plane(view, side, side < 2u ? x : y));
	}
}

/* The sides are at the end of the snapping range (CONTRACT rule 16). */
TS_FN void ts_k_clip_to_range(const ts_camera_k *view, ts_polygon *polygon)
{
	f32 x = 32767.0f - (f32)view->width * 0.5f;
	f32 y = 32767.0f - (f32)view->height * 0.5f;
	ts_k_clip_to_sides(view, polygon, x, y);
}

#endif
