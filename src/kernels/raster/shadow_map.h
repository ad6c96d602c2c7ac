/* Shadows by depth maps: the number of samples of each light that reach a pixel of the eye, by one rule for all methods
 * (METHODS 10). A sample reaches p if z <= map + bias in the texel that p falls into, and also if that texel is empty
 * or p is outside the map. bias = b w + b_s slope: w is the width of a texel at p; slope is the change of the surface's
 * depth from texel to texel, z^2 |n_xy| / (f |n.(eye - p)|), since 1/z is linear in the image. In orthographic views w
 * is 1/f and slope |n_xy| / (f |n_z|). */
#ifndef TS_KERNELS_RASTER_SHADOW_MAP_H
#define TS_KERNELS_RASTER_SHADOW_MAP_H
#include "kernels/base/args.h"
#include "kernels/raster/offscreen.h"

#define TS_ROWS_ts_shadow_test_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(IN, ts_offscreen, views, offscreen_view) \
	ARG(IN, u32, depths, depth_map_depth) /* of the batch */ \
	ARG(SUM, u32, lit, shadow_test_lit) \
	ARG(VALUE, u32, first_view, none) \
	ARG(VALUE, u32, n_views, none) /* the batch */ \
	ARG(VALUE, u32, n_lamps, none) \
	ARG(VALUE, u32, cubes, none) /* not 0: views are faces of cubes; the face that p falls into counts */ \
	ARG(VALUE, f32, bias, none) \
	ARG(VALUE, f32, slope, none) \
	ARG(VALUE, u32, samples, none) /* of a pixel */
TS_ARGS(ts_shadow_test_args);

/* The receiver at a pixel of the eye: its position and its unit face normal. */
typedef struct {
	ts_v3 p, n;
	bool seen;
} ts_receiver;

#define TS_LEAST_FACING 0.015625f /* limits the slope, and so the bias */

TS_FN f32 ts_k_shadow_bias(const ts_shadow_test_args *args, const ts_camera_k *view, const ts_receiver *at, f32 z)
{
	f32 x = ts_dot(view->right, at->n);
	f32 y = ts_dot(view->up, at->n);
	f32 across = ts_sqrt(ts_flush(x * x + y * y));
	ts_v3 way = ts_sub(view->eye, at->p);
	bool parallel = view->orthographic != 0u;
	f32 facing = parallel ? ts_abs(ts_dot(view->back, at->n)) : ts_abs(ts_dot(way, at->n)) / ts_max(ts_length(way), z);
	facing = ts_max(facing, TS_LEAST_FACING);
	f32 width = parallel ? 1.0f / view->focal : z / view->focal;
	f32 deeper = parallel ? across / facing : (z / ts_max(ts_length(way), z)) * (across / facing);
	return width * (args->bias + args->slope * deeper);
}

TS_FN i32 ts_k_into(i32 i, i32 n) { return ts_max_i32(ts_min_i32(i, n - 1), 0); }

/* The depth bits of a texel of a view's map; TS_NONE outside the map. Places beside a cube's face take a texel of its
 * border. */
TS_FN u32 ts_k_map_texel(const ts_shadow_test_args *args, TS_GLOBAL const ts_offscreen *offscreen, u64 first_texel,
                         i32 i, i32 j)
{
	i32 width = (i32)offscreen->width;
	i32 height = (i32)offscreen->height;
	if (args->cubes != 0u) {
		i = ts_k_into(i, width);
		j = ts_k_into(j, height);
	}
	if (i < 0 || j < 0 || i >= width || j >= height) return TS_NONE;
	return args->depths[(offscreen->offset - first_texel) + (u64)j * (u64)width + (u64)i];
}

/* Whether the light sample of a view reaches the point. */
TS_FN bool ts_k_reaches(const ts_shadow_test_args *args, TS_GLOBAL const ts_offscreen *offscreen, const ts_receiver *at,
                        u64 first_texel)
{
	ts_camera_k view = ts_k_offscreen(offscreen);
	ts_corner p = ts_k_to_view(&view, at->p);
	if (!(p.z >= view.near)) return true;
	ts_v2 place = ts_k_project(&view, &p);
	u32 depth = ts_k_map_texel(args, offscreen, first_texel, ts_floor_i32(place.x), ts_floor_i32(place.y));
	return depth == TS_NONE || p.z <= ts_u2f(depth) + ts_k_shadow_bias(args, &view, at, p.z);
}

/* The view whose map decides about the sample of view v: v itself, or of a cube the face that the point falls into. */
TS_FN TS_GLOBAL const ts_offscreen *ts_k_asked_view(const ts_shadow_test_args *args, u32 v, const ts_receiver *at)
{
	u32 face = args->cubes != 0u ? ts_k_cube_place(ts_sub(at->p, ts_load3(args->views[v].eye))).face : 0u;
	return &args->views[v + face];
}

#endif
