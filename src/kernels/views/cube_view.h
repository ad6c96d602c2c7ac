/* Views to all sides from the middles of the reflectors' cubes (MegaViews section 6, "reflections via cube maps";
 * METHODS 14), and their maps as mip chains, which MVR looks up. */
#ifndef TS_KERNELS_VIEWS_CUBE_VIEW_H
#define TS_KERNELS_VIEWS_CUBE_VIEW_H
#include "kernels/base/args.h"
#include "kernels/raster/cube.h"
#include "kernels/raster/texel_place.h"
#include "kernels/views/paraboloid.h"

#define TS_ROWS_ts_cube_view_args(ARG) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(OUT, ts_vpl, views, vpl_light)
TS_ARGS(ts_cube_view_args);

/* map over cubes */
TS_FN void ts_k_cube_view_item(const ts_cube_view_args *args, u64 i)
{
	TS_GLOBAL ts_vpl *view = &args->views[i];
	ts_v3 none = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_store3(view->position, ts_load3(args->cubes[i].centre));
	ts_store3(view->normal, none);
	ts_store3(view->flux, none);
	view->bounce = 0u;
	view->pad0 = 0u;
	view->pad1 = 0u;
}

#define TS_ROWS_ts_cube_view_mip_args(ARG) \
	ARG(INNER, ts_illuminate_args, to, none) /* without its depth_triangle */ \
	ARG(IN, f32, colours, view_map_colour) \
	ARG(VALUE, u32, n, none) /* texels per side of a view's map */
TS_ARGS(ts_cube_view_mip_args);

/* map over texels of the batch: each copies the texel of the view's map that shows the direction of its middle */
TS_FN void ts_k_cube_view_mip_item(const ts_cube_view_mip_args *args, u64 i)
{
	ts_texel_place place = ts_k_texel_place(&args->to, i);
	u32 n = args->to.cubes[place.cube].n;
	f32 s = ts_k_paraboloid_middle(place.x, n);
	f32 t = ts_k_paraboloid_middle(place.y, n);
	u32 texel = ts_k_paraboloid_texel(ts_k_cube_direction(place.face, s, t), args->n);
	u64 first = (u64)place.cube * (2u * args->n * args->n);
	u64 level0 = ts_k_mip_first(args->to.cubes, args->to.first_cube, place.cube);
	TS_GLOBAL f32 *out = args->to.mip + (level0 + place.inside) * 4u;
	ts_store3(out, ts_load3(args->colours + (first + texel) * 3u));
	out[3] = 1.0f;
}

#endif
