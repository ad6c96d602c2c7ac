/* Reflective shadow maps (Dachsbacher and Stamminger 2005): the triangles that a light sees, and each texel as a
 * triangle of light, as in SSAGH section 5 (METHODS 11).
 *
 * A texel shows the surface at x_p, which has axial depth z and distance d from the light; theta is the angle between
 * the surface's normal and the way to the light. The texel sees an area A = (z / f)^2 (z / d) / cos theta of the
 * surface, or A = (1 / f)^2 / cos theta in an orthographic view; here cos theta counts as at least 2^-6. The texel
 * becomes an equilateral triangle of this area about x_p, in the plane of the face, so that a flat wall does not light
 * itself. The triangle's exitance is M = rho E: E is the irradiance at x_p, rho base colour times 1 - metallic. */
#ifndef TS_KERNELS_RASTER_RSM_H
#define TS_KERNELS_RASTER_RSM_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/patch.h"

#define TS_ROWS_ts_rsm_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_offscreen, views, offscreen_view) \
	ARG(IN_OPT, ts_light, lamps, lamp_light) \
	ARG(MIN, u64, depth_triangle, rsm_depth_triangle) \
	ARG(OUT_OPT, ts_patch, patches, rsm_patch) \
	ARG(VALUE, u32, n_views, none) \
	ARG(VALUE, u32, others, none) /* other items that share the rows: band.h */
TS_ARGS(ts_rsm_args);

/* scatter over triangles: into every view */
TS_FN void ts_k_rsm_item(const ts_rsm_args *args, u64 i)
{
	/* Drop a triangle without area (CONTRACT rule 35). */
	ts_band band = ts_k_band(i, args->others);
	u32 triangle = (u32)band.item;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (ts_k_is_degenerate(t.n)) return;
	for (u32 v = 0u; v < args->n_views; v++) {
		/* Choose the light's views that may show the triangle. */
		TS_GLOBAL const ts_offscreen *offscreen = &args->views[v];
		if (!ts_k_offscreen_may_show(&args->scene, offscreen, triangle, &t)) continue;
		/* Draw the triangle into the view's texels. */
		ts_camera_k view = ts_k_offscreen(offscreen);
		ts_target target = ts_k_keys(args->depth_triangle + offscreen->offset);
		ts_k_draw(&args->scene, &view, &t, triangle, &band, &target);
	}
}

/* The view of a texel: the last whose first texel is not after it. */
TS_FN u32 ts_k_view_of_texel(TS_GLOBAL const ts_offscreen *views, u32 n, u64 texel)
{
	u32 v = 0u;
	for (u32 k = 1u; k < n; k++) v = views[k].offset <= texel ? k : v;
	return v;
}

/* map over texels */
TS_FN void ts_k_rsm_patch_item(const ts_rsm_args *args, u64 i)
{
	/* Clear the record, which stays so where the light sees nothing. */
	TS_GLOBAL ts_patch *patch = &args->patches[i];
	u64 key = args->depth_triangle[i];
	ts_k_patch_clear(patch);
	if (key == TS_EMPTY) return;
	/* Find the surface that the light sees through the texel. */
	TS_GLOBAL const ts_offscreen *offscreen = &args->views[ts_k_view_of_texel(args->views, args->n_views, i)];
	ts_camera_k view = ts_k_offscreen(offscreen);
	u64 texel = i - offscreen->offset;
	i32 x = (i32)(texel % (u64)view.width);
	i32 y = (i32)(texel / (u64)view.width);
	ts_surface s = ts_k_surface_seen(&args->scene, &view, (u32)key, x, y);
	/* Find the light that arrives on the side that faces the light. */
	TS_GLOBAL const ts_light *light = &args->lamps[offscreen->light];
	ts_v3 l;
	f32 arrives = ts_k_light(light, s.p, &l);
	ts_v3 n = ts_dot(s.face, l) < 0.0f ? ts_neg(s.face) : s.face;
	f32 cosine = ts_flush(ts_dot(n, l));
	if (!(arrives > 0.0f) || !(cosine > 0.0f)) return;
	/* Make a triangle of the area that the texel sees, with the exitance M = rho E (SSAGH 5). */
	ts_v3 irradiance = ts_scale(ts_load3(light->intensity), ts_flush(arrives * cosine));
	ts_k_patch_corners(patch, s.p, n, ts_k_texel_area(&view, s.p, cosine));
	ts_store3(patch->exitance, ts_mul(ts_k_albedo(&s), irradiance));
}

#endif
