/* The planes of 32 views side by side. A point at R to the right and A ahead is W/2 + f R / A pixels from the left of
 * an image that is W wide: inside where f R + W/2 A >= 0 and W/2 A - f R >= 0, as A is at least near; the same
 * upward. */
#include "backends/c/points/view_planes.h"
#include <math.h>
#include "backends/wide.h"

static const f32 ROUNDING = 0x1p-16f; /* some 20 operations of 2^-24 each, with a factor of two */

/* f axis + half ahead; in an orthographic view f axis + half. */
static void set_side(ts_view_planes *p, u32 plane, u32 at, const ts_camera_k *view, f32 f, ts_v3 axis, f32 half)
{
	bool parallel = view->orthographic != 0;
	ts_v3 n = ts_mad(ts_scale(axis, f), view->back, parallel ? 0.0f : -half);
	p->normal[plane][0][at] = n.x;
	p->normal[plane][1][at] = n.y;
	p->normal[plane][2][at] = n.z;
	p->least[plane][at] = parallel ? half : 0.0f;
	p->error[plane][at] = ROUNDING * (ts_abs(f) + half);
	p->level[plane][at] = view->near > 0.0f ? ROUNDING * half : INFINITY;
}

static f32 greatest(ts_v3 a) { return ts_max(ts_max(ts_abs(a.x), ts_abs(a.y)), ts_abs(a.z)); }

void ts_view_planes_set(ts_view_planes *p, u32 at, const ts_camera_k *view)
{
	f32 across = (f32)view->width * 0.5f, down = (f32)view->height * 0.5f;
	f32 scale = greatest(view->right) + greatest(view->up) + greatest(view->back);
	p->views |= 1u << at;
	p->eye[0][at] = view->eye.x;
	p->eye[1][at] = view->eye.y;
	p->eye[2][at] = view->eye.z;
	set_side(p, 0, at, view, view->focal, view->right, across);
	set_side(p, 1, at, view, -view->focal, view->right, across);
	set_side(p, 2, at, view, view->focal, view->up, down);
	set_side(p, 3, at, view, -view->focal, view->up, down);
	p->normal[4][0][at] = -view->back.x;
	p->normal[4][1][at] = -view->back.y;
	p->normal[4][2][at] = -view->back.z;
	p->least[4][at] = -view->near;
	p->error[4][at] = ROUNDING;
	p->level[4][at] = ROUNDING * ts_abs(view->near);
	for (u32 k = 0; k < TS_PLANES; k++) p->error[k][at] *= scale;
}

TS_WIDE(void, part_views, (u32 *restrict out, const ts_view_planes *restrict p, ts_bounds box), (out, p, box))
{
	for (u32 k = 0; k < TS_PLANES; k++) {
		const f32 *nx = p->normal[k][0], *ny = p->normal[k][1], *nz = p->normal[k][2];
		const f32 *least = p->least[k], *error = p->error[k], *level = p->level[k];
		for (u32 v = 0; v < TS_GROUP; v++) {
			f32 x = box.middle[0] - p->eye[0][v], y = box.middle[1] - p->eye[1][v], z = box.middle[2] - p->eye[2][v];
			f32 far = (ts_abs(x) + ts_abs(y) + ts_abs(z)) + (box.half[0] + box.half[1] + box.half[2]);
			f32 middle = nx[v] * x + ny[v] * y + nz[v] * z;
			f32 most = ts_abs(nx[v]) * box.half[0] + ts_abs(ny[v]) * box.half[1] + ts_abs(nz[v]) * box.half[2];
			f32 inside = (middle + most + least[v]) + (error[v] * far + level[v]);
			out[v] |= inside < 0.0f ? 1u : 0u;
		}
	}
}

u32 ts_view_planes_meet(const ts_view_planes *p, const ts_bounds *box)
{
	u32 out[TS_GROUP] = {0}, bits = 0;
	part_views(out, p, *box);
	for (u32 v = 0; v < TS_GROUP; v++) bits |= (out[v] ^ 1u) << v;
	return bits;
}

#include "backends/selftest.h"
