/* A texel of a reflective shadow map as a triangle of light (SSAGH section 5; METHODS 11): its area, its corners, and
 * what it reflects. rsm.h has the formulas. */
#ifndef TS_KERNELS_RASTER_PATCH_H
#define TS_KERNELS_RASTER_PATCH_H
#include "kernels/base/surface.h"
#include "kernels/raster/view.h"

#define TS_LEAST_LIT 0.015625f /* 2^-6: bounds the area of a surface that light grazes */

/* Area of a surface at p that a texel sees; cosine: between the surface's normal and the way to the light. */
TS_FN f32 ts_k_texel_area(const ts_camera_k *view, ts_v3 p, f32 cosine)
{
	ts_corner at = ts_k_to_view(view, p);
	f32 d = ts_length(ts_v3_make(at.x, at.y, at.z));
	f32 width = view->orthographic != 0u ? 1.0f / view->focal : at.z / view->focal;
	f32 across = width * width;
	f32 facing = view->orthographic != 0u || !(d > 0.0f) ? 1.0f : at.z / d;
	return (across * facing) / ts_max(cosine, TS_LEAST_LIT);
}

/* A unit axis at right angles to n and to the y axis; to n and to the x axis if n is near the y axis. */
TS_FN ts_v3 ts_k_across(ts_v3 n)
{
	ts_v3 pole = ts_abs(n.y) < 0.75f ? ts_v3_make(0.0f, 1.0f, 0.0f) : ts_v3_make(1.0f, 0.0f, 0.0f);
	return ts_normalize(ts_cross(pole, n));
}

/* The corners of an equilateral triangle of this area about p, counter-clockwise about n: circumradius sqrt(4 A / (3
 * sqrt 3)). */
TS_FN void ts_k_patch_corners(TS_GLOBAL ts_patch *patch, ts_v3 p, ts_v3 n, f32 area)
{
	f32 radius = ts_sqrt(ts_flush(area * 0.769800364971160888671875f));
	ts_v3 u = ts_k_across(n);
	ts_v3 v = ts_cross(n, u);
	f32 back = radius * -0.5f;
	f32 aside = radius * TS_HALF_ROOT_3;
	ts_v3 behind = ts_mad(p, u, back);
	ts_store3(patch->a, ts_mad(p, u, radius));
	ts_store3(patch->b, ts_mad(behind, v, aside));
	ts_store3(patch->c, ts_mad(behind, v, -aside));
	ts_store3(patch->normal, n);
}

TS_FN void ts_k_patch_clear(TS_GLOBAL ts_patch *patch)
{
	ts_v3 zero = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_store3(patch->a, zero);
	ts_store3(patch->b, zero);
	ts_store3(patch->c, zero);
	ts_store3(patch->normal, zero);
	ts_store3(patch->exitance, zero);
	patch->pad = 0u;
}

/* Diffuse albedo; unlit materials reflect nothing. */
TS_FN ts_v3 ts_k_albedo(const ts_surface *s)
{
	return ts_scale(s->base, (s->flags & TS_UNLIT) != 0u ? 0.0f : 1.0f - s->metallic);
}

#endif
