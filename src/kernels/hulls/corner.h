/* Light gathered at the corners of a box (SSAGH section 3; METHODS 11). Every triangle of light that faces the corner
 * gives w = M Omega, exitance times solid angle, a third of it from the direction of each of its three vertices. The
 * horizon of the corner's surface is not tested, since the normal is the pixel's, not the corner's. If rounding made a
 * triangle face a corner on its own surface, half the sphere would be light. So a triangle begins to count where the
 * corner is a sixteenth of the triangle's side above its plane, and counts in full from five sixteenths on
 * (corner.facing=ramp). Lamps hang in the air, so their triangles count in full wherever they face the corner, as all
 * triangles do by the paper. A light without extent is one direction: its weight is pi times the irradiance of a
 * surface that faces the light. Sums are in the order of the triangles, then of the lights. */
#ifndef TS_KERNELS_HULLS_CORNER_H
#define TS_KERNELS_HULLS_CORNER_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/hulls/depth_grid.h"
#include "kernels/hulls/form_factor.h"
#include "kernels/raster/gpixel.h"

#define TS_ROWS_ts_corner_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, ts_patch, patches, rsm_patch) \
	ARG(IN_OPT, ts_light, lamps, lamp_light) \
	ARG(IN_OPT, ts_lamp, shapes, lamp_shape) \
	ARG(IN, ts_segment, boxes, segment_box) \
	ARG(OUT, ts_moment, moments, corner_moment) \
	ARG(VALUE, u64, n_patches, none) \
	ARG(VALUE, u32, n_lamps, none) /* 0: patches are of surfaces */ \
	ARG(VALUE, u32, grid, none) \
	ARG(VALUE, u32, paper, none)     /* corner.facing=paper */ \
	ARG(VALUE, u32, rectangle, none) /* hull.corners=rectangle */
TS_ARGS(ts_corner_args);

/* The point at depth zn on a pixel's ray. */
TS_FN ts_v3 ts_k_pixel_point(const ts_camera_k *view, u32 x, u32 y, f32 depth)
{
	f32 z = view->near / (1.0f - depth);
	f32 right = (((f32)x + 0.5f) - (f32)view->width * 0.5f) / view->focal;
	f32 up = ((f32)view->height * 0.5f - ((f32)y + 0.5f)) / view->focal;
	ts_v3 way = ts_sub(ts_mad(ts_scale(view->right, right), view->up, up), view->back);
	return ts_mad(view->eye, way, z);
}

typedef struct {
	ts_v3 p;
	f32 depth;
} ts_box_corner;

/* The pixel at a corner: 0 to 3 are top left, top right, bottom left, bottom right. */
typedef struct {
	u32 x, y;
} ts_corner_pixel;

TS_FN ts_corner_pixel ts_k_corner_pixel(const ts_camera_k *view, TS_GLOBAL const ts_segment *box, u32 grid,
                                        u32 rectangle, u32 corner)
{
	u32 right = ts_k_box_end(box->high[0], grid, rectangle);
	u32 bottom = ts_k_box_end(box->high[1], grid, rectangle);
	ts_corner_pixel at;
	at.x = ts_k_resample((corner & 1u) != 0u ? right : box->low[0], grid, (u32)view->width);
	at.y = ts_k_resample((corner & 2u) != 0u ? bottom : box->low[1], grid, (u32)view->height);
	return at;
}

/* The point that the G-buffer shows at a corner; if its depth is out of the box, the point at the middle of the box's
 * depths on the same ray. Where a box ends at the sky, that middle may round to the sky, which has no point. */
TS_FN ts_box_corner ts_k_box_corner(const ts_camera_k *view, TS_GLOBAL const ts_segment *box,
                                    TS_GLOBAL const ts_gpixel *pixel, ts_corner_pixel at)
{
	ts_box_corner r;
	r.p = ts_load3(pixel->position);
	r.depth = pixel->depth;
	if (r.depth >= box->nearest && r.depth <= box->farthest) return r;
	r.depth = ts_min((box->nearest + box->farthest) * 0.5f, TS_DEEPEST);
	r.p = ts_k_pixel_point(view, at.x, at.y, r.depth);
	return r;
}

/* Moments of the gathered light: for each channel the sum of w, and the sum of w times direction (SSAGH eq. 4). */
typedef struct {
	ts_v3 w, red, green, blue;
} ts_gathered;

/* The share, from 0 to 1, of a triangle of light that counts at a corner `height` above its plane. It rises from 0 at a
 * sixteenth of the triangle's side to 1 at five sixteenths. */
TS_FN f32 ts_k_facing(f32 height, f32 side)
{
	f32 above = height - side * 0.0625f;
	if (!(above > 0.0f && side > 0.0f)) return 0.0f;
	return ts_min(above / (side * 0.25f), 1.0f);
}

TS_FN void ts_k_gather(ts_gathered *sum, TS_GLOBAL const ts_patch *patch, ts_v3 p, bool ramp)
{
	/* Load the triangle, and find how high above its plane the corner is. */
	ts_v3 a = ts_load3(patch->a);
	ts_v3 b = ts_load3(patch->b);
	ts_v3 c = ts_load3(patch->c);
	ts_v3 normal = ts_load3(patch->normal);
	f32 height = ts_flush(ts_dot(normal, ts_sub(p, a)));
	/* Find the share that counts: by the ramp, since rounding must not let a corner see its own surface as half a
	 * sphere of light, or by the paper's test of the side. */
	f32 in_front = ts_k_is_in_front(p, a, normal) ? 1.0f : 0.0f;
	f32 facing = ramp ? ts_k_facing(height, ts_length(ts_sub(b, a))) : in_front;
	if (facing == 0.0f) return;
	/* Weight the triangle by exitance times solid angle (SSAGH 3). */
	ts_v3 w = ts_scale(ts_load3(patch->exitance), ts_k_solid_angle(p, a, b, c) * facing);
	ts_v3 ways = ts_k_ways(p, a, b, c);
	/* Accumulate the sums of SSAGH eq. 4, a third of w from the direction of each vertex. */
	sum->w = ts_add(sum->w, w);
	sum->red = ts_mad(sum->red, ways, w.x / 3.0f);
	sum->green = ts_mad(sum->green, ways, w.y / 3.0f);
	sum->blue = ts_mad(sum->blue, ways, w.z / 3.0f);
}

TS_FN void ts_k_gather_point(ts_gathered *sum, TS_GLOBAL const ts_light *light, ts_v3 p)
{
	ts_v3 way;
	f32 arrives = ts_k_light(light, p, &way);
	ts_v3 w = ts_scale(ts_load3(light->intensity), arrives * TS_PI_F32);
	sum->w = ts_add(sum->w, w);
	sum->red = ts_mad(sum->red, way, w.x);
	sum->green = ts_mad(sum->green, way, w.y);
	sum->blue = ts_mad(sum->blue, way, w.z);
}

TS_FN void ts_k_gather_all(TS_GLOBAL ts_moment *out, const ts_corner_args *args, ts_box_corner corner)
{
	/* Start from no light. */
	ts_gathered sum;
	sum.w = ts_v3_make(0.0f, 0.0f, 0.0f);
	sum.red = sum.w;
	sum.green = sum.w;
	sum.blue = sum.w;
	/* Gather from every triangle in order (SSAGH 3). Lamps need no ramp: no corner lies on one. */
	bool ramp = args->paper == 0u && args->n_lamps == 0u;
	for (u64 k = 0u; k < args->n_patches; k++) ts_k_gather(&sum, &args->patches[k], corner.p, ramp);
	/* Add the lights without extent, which have no triangles. */
	for (u32 k = 0u; k < args->n_lamps; k++) {
		if (!(args->shapes[k].radius > 0.0f)) ts_k_gather_point(&sum, &args->lamps[k], corner.p);
	}
	/* Store the corner and its moments, the sums of SSAGH eq. 4. */
	ts_store3(out->position, corner.p);
	out->depth = ts_put(corner.depth);
	ts_store3(out->sum, sum.w);
	ts_store3(out->direction, sum.red);
	ts_store3(out->direction + 3, sum.green);
	ts_store3(out->direction + 6, sum.blue);
}

/* map over corners of boxes */
TS_FN void ts_k_corner_item(const ts_corner_args *args, u64 i)
{
	TS_GLOBAL const ts_segment *box = &args->boxes[i / 4u];
	ts_camera_k view = ts_k_view(args->view);
	ts_corner_pixel at = ts_k_corner_pixel(&view, box, args->grid, args->rectangle, (u32)(i % 4u));
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[(u64)at.y * (u64)view.width + at.x];
	ts_k_gather_all(&args->moments[i], args, ts_k_box_corner(&view, box, pixel, at));
}

#endif
