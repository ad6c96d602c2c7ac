/* MVR's depth maps: draws every triangle into the depths of each off-screen view (iVIR section 4). */
#ifndef TS_KERNELS_RASTER_DEPTH_MAP_H
#define TS_KERNELS_RASTER_DEPTH_MAP_H
#include "kernels/base/args.h"
#include "kernels/raster/draw.h"

#define TS_ROWS_ts_depth_map_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_offscreen, views, offscreen_view) \
	ARG(MIN, u32, depths, depth_map_depth) /* of the batch */ \
	ARG(VALUE, u32, first_view, none) \
	ARG(VALUE, u32, n_views, none) /* the batch */ \
	ARG(VALUE, u32, others, none)  /* other items that share the rows: band.h */
TS_ARGS(ts_depth_map_args);

/* scatter over triangles: into every view of the batch */
TS_FN void ts_k_depth_map_item(const ts_depth_map_args *args, u64 i)
{
	/* Drop a triangle without area (CONTRACT rule 35). */
	ts_band band = ts_k_band(i, args->others);
	u32 triangle = (u32)band.item;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (args->n_views == 0u || ts_k_is_degenerate(t.n)) return;
	u64 first_texel = args->views[args->first_view].offset;
	for (u32 v = args->first_view; v < args->first_view + args->n_views; v++) {
		/* Choose the views that may show the triangle. */
		TS_GLOBAL const ts_offscreen *offscreen = &args->views[v];
		if (!ts_k_offscreen_may_show(&args->scene, offscreen, triangle, &t)) continue;
		/* Draw the triangle's depths, without its index, into the view's texels (iVIR 4). */
		ts_camera_k view = ts_k_offscreen(offscreen);
		ts_target target;
		target.keys = NULL;
		target.depths = args->depths + (offscreen->offset - first_texel);
		ts_k_draw(&args->scene, &view, &t, triangle, &band, &target);
	}
}

#endif
