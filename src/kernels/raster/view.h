/* Views: a camera in registers, and points in view space. */
#ifndef TS_KERNELS_RASTER_VIEW_H
#define TS_KERNELS_RASTER_VIEW_H
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

/* Snapped coordinates and shifts are in sub-pixels, 1/256 of a pixel (CONTRACT rule 15). Pixel i has its centre at
 * i * TS_SUB_PIXELS + TS_SUB_CENTRE. Of the pixels with centres from a to b the first is ceil((a - 128) / 256) =
 * (a + TS_SUB_FIRST) >> 8, since >> rounds down; the last is (b - TS_SUB_CENTRE) >> 8. */
#define TS_SUB_PIXELS 256
#define TS_SUB_CENTRE 128
#define TS_SUB_FIRST 127

#define TS_MAX_CORNERS 8 /* of a triangle that five planes cut */

/* A corner in view space (X, Y, z axial) with its weights on the source triangle. */
typedef struct {
	f32 x, y, z;
	ts_v3 w;
} ts_corner;

/* A view in registers. An orthographic view has `focal` pixels per world unit. The image is moved by `shift`, in 1/256
 * pixel; `side` is the side, in pixels, of the square that a sample's colour stands for: see eye_sample.h. */
typedef struct {
	ts_v3 eye, right, up, back;
	f32 focal, near, side;
	i32 width, height, shift_x, shift_y;
	u32 orthographic;
} ts_camera_k;

TS_FN ts_camera_k ts_k_view(TS_GLOBAL const ts_view *view)
{
	ts_camera_k r;
	/* Copy the place, the axes and the lens. */
	r.eye = ts_load3(view->eye);
	r.right = ts_load3(view->right);
	r.up = ts_load3(view->up);
	r.back = ts_load3(view->back);
	r.focal = view->focal;
	r.near = view->near;
	/* Let a sample stand for a whole pixel, at its centre; eye_sample.h changes both. */
	r.side = 1.0f;
	r.width = (i32)view->width;
	r.height = (i32)view->height;
	r.shift_x = 0;
	r.shift_y = 0;
	r.orthographic = 0u;
	return r;
}

/* A point of the world in the view, without weights. */
TS_FN ts_corner ts_k_to_view(const ts_camera_k *view, ts_v3 p)
{
	ts_v3 d = ts_sub(p, view->eye);
	ts_corner r;
	r.x = ts_dot(view->right, d);
	r.y = ts_dot(view->up, d);
	r.z = -ts_dot(view->back, d);
	r.w = ts_v3_make(0.0f, 0.0f, 0.0f);
	return r;
}

/* The place in the image, in pixels from the upper left corner (CONTRACT rule 15). */
TS_FN ts_v2 ts_k_project(const ts_camera_k *view, const ts_corner *p)
{
	f32 z = view->orthographic != 0u ? 1.0f : p->z;
	f32 x = (view->focal * p->x) / z;
	f32 y = (view->focal * p->y) / z;
	return ts_v2_make((f32)view->width * 0.5f + x, (f32)view->height * 0.5f - y);
}

#endif
