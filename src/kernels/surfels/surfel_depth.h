/* Visibility of surfels (NV40: 3-Pass Deferred Shading; METHODS 16): every surfel that faces the view, inside its
 * ellipse, at the depth at which the ray meets its plane plus epsilon along the ray, by integer minimum. So the least
 * depth belongs to the nearest surfel, and the surfels that blend with it lie before this depth. Depth maps of lights
 * are made the same way. */
#ifndef TS_KERNELS_SURFELS_SURFEL_DEPTH_H
#define TS_KERNELS_SURFELS_SURFEL_DEPTH_H
#include "kernels/base/args.h"
#include "kernels/raster/offscreen.h"
#include "kernels/raster/target.h"
#include "kernels/surfels/fragment.h"

TS_FN void ts_k_disc_draw(const ts_disc *disc, const ts_camera_k *view, f32 epsilon, u32 surfel,
                          const ts_target *target)
{
	for (i32 y = disc->low[1]; y <= disc->high[1]; y++) {
		for (i32 x = disc->low[0]; x <= disc->high[0]; x++) {
			ts_v2 d = ts_k_disc_offset(disc, x, y);
			ts_disc_hit hit = ts_k_disc_hit(disc, view->near, d.x, d.y);
			if (!hit.inside) continue;
			f32 z = ts_put(hit.z + ts_k_pixel_shift(view, epsilon, x, y));
			ts_k_draw_texel(target, (u64)y * (u64)view->width + (u64)x, z, surfel);
		}
	}
}

#define TS_ROWS_ts_surfel_depth_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_disc, discs, surfel_setup_disc) \
	ARG(IN, f32, epsilon, surfel_setup_epsilon) \
	ARG(MIN, u64, keys, surfel_depth_surfel)
TS_ARGS(ts_surfel_depth_args);

/* scatter over surfels */
TS_FN void ts_k_surfel_depth_item(const ts_surfel_depth_args *args, u64 i)
{
	ts_camera_k view = ts_k_view(args->view);
	ts_disc disc = args->discs[i];
	ts_target target = ts_k_keys(args->keys);
	ts_k_disc_draw(&disc, &view, args->epsilon[0], (u32)i, &target);
}

#define TS_ROWS_ts_surfel_depth_shadow_args(ARG) \
	ARG(IN, ts_surfel, surfels, scene_surfel) \
	ARG(IN, ts_offscreen, views, offscreen_view) /* one per light */ \
	ARG(IN, f32, epsilon, surfel_setup_epsilon) \
	ARG(MIN, u32, depths, depth_map_depth) \
	ARG(VALUE, ts_filter, filter, none) \
	ARG(VALUE, u32, n_views, none)
TS_ARGS(ts_surfel_depth_shadow_args);

/* scatter over surfels: into the depth map of every light */
TS_FN void ts_k_surfel_depth_shadow_item(const ts_surfel_depth_shadow_args *args, u64 i)
{
	for (u32 v = 0u; v < args->n_views; v++) {
		ts_disc disc;
		ts_camera_k view = ts_k_offscreen(&args->views[v]);
		if (ts_k_disc(&disc, &view, &args->filter, &args->surfels[i]) != TS_DISC_DRAWN) continue;
		ts_target target;
		target.keys = NULL;
		target.depths = args->depths + args->views[v].offset;
		ts_k_disc_draw(&disc, &view, args->epsilon[0], (u32)i, &target);
	}
}

#endif
