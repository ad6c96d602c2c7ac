/* The plane n.p = d of a surface on the axes of a view, and its axial depth at a place of the image. The ray (x, y,
 * focal) meets the plane at z = d focal / (n.(x, y, focal)), x and y in pixels from the middle; an orthographic ray
 * begins at (x / focal, y / focal) and points straight ahead. */
#ifndef TS_KERNELS_POINTS_PLANE_H
#define TS_KERNELS_POINTS_PLANE_H
#include "kernels/raster/view.h"

typedef struct {
	ts_v3 n;
	f32 d;
} ts_image_plane;

/* The plane through p with the normal n, both in world coordinates. */
TS_FN ts_image_plane ts_k_image_plane(const ts_camera_k *view, ts_v3 p, ts_v3 n)
{
	ts_corner at = ts_k_to_view(view, p);
	ts_image_plane r;
	r.n = ts_v3_make(ts_dot(view->right, n), ts_dot(view->up, n), -ts_dot(view->back, n));
	r.d = ts_dot(r.n, ts_v3_make(at.x, at.y, at.z));
	return r;
}

/* The plane's depth at (x, y) in pixels; `otherwise` where the plane is not met ahead. */
TS_FN f32 ts_k_plane_depth(const ts_camera_k *view, const ts_image_plane *plane, f32 x, f32 y, f32 otherwise)
{
	/* Intersect with the ray: z = d f / (n.(x, y, f)), or in parallel z = (d f - n.(x, y, 0)) / (n_z f). */
	bool parallel = view->orthographic != 0u;
	f32 right = plane->n.x * (x - (f32)view->width * 0.5f);
	f32 up = plane->n.y * ((f32)view->height * 0.5f - y);
	f32 across = right + up;
	f32 ahead = plane->n.z * view->focal;
	f32 reach = plane->d * view->focal;
	f32 top = parallel ? reach - across : reach;
	f32 bottom = ts_flush(parallel ? ahead : across + ahead);
	/* Fall back where the ray runs along the plane or meets it behind the view. */
	if (bottom == 0.0f) return otherwise;
	f32 z = ts_flush(top / bottom);
	return parallel || z > 0.0f ? z : otherwise;
}

#endif
