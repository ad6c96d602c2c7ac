/* Margins of surfel_shade.h, for ports that round otherwise (PORTING 7): how near the shading of surfels was to another
 * answer. This second pass changes no colour. A step is 8 ulps of the cosine; for phong it also has the change that a
 * step of the ray cast makes in the normal. */
#ifndef TS_KERNELS_SURFELS_SURFEL_SHADE_MARGIN_H
#define TS_KERNELS_SURFELS_SURFEL_SHADE_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/surfels/deferred_margin.h"
#include "kernels/surfels/surfel_margin.h"
#include "kernels/surfels/surfel_shade.h"

#define TS_ROWS_ts_surfel_shade_margin_args(ARG) \
	ARG(INNER, ts_surfel_shade_args, of, none) \
	ARG(INNER, ts_surfel_margin_args, by, none)
TS_ARGS(ts_surfel_shade_margin_args);

/* The least margin of all lights at a place. */
TS_FN f32 ts_k_shading_margin(const ts_surfel_shade_args *args, const ts_shading_place *at, f32 step)
{
	f32 least = TS_MARGIN_NOWHERE;
	for (u32 k = 0u; k < args->n_lights; k++) {
		least = ts_min(least, ts_k_cosine_margin(&args->lights[k], 1.0f, args->npr, at->p, at->n, step));
	}
	return least;
}

/* The margin of a surfel that is shaded once per fragment. */
TS_FN f32 ts_k_fragment_shading_margin(const ts_surfel_shade_margin_args *args, const ts_camera_k *view,
                                       const ts_nearly *surfel, u64 i, i32 x, i32 y)
{
	const ts_surfel_shade_args *of = &args->of;
	TS_GLOBAL const f32 *slopes = of->slopes + i * TS_FIELD_SLOPES;
	ts_nearly_there there = ts_k_nearly_there(&args->by, view, surfel, x, y);
	f32 moved = ts_length(ts_load3(slopes)) * there.a_step + ts_length(ts_load3(slopes + 3)) * there.b_step;
	f32 step = TS_MARGIN_ROUNDING + (there.hit.inside ? moved : 0.0f);
	ts_shading_place at = ts_k_fragment_place(&of->of.surfels[i], &surfel->disc, slopes, view->near, x, y);
	return ts_k_shading_margin(of, &at, step);
}

/* scatter over surfels */
TS_FN void ts_k_surfel_shade_margin_item(const ts_surfel_shade_margin_args *args, u64 i)
{
	/* Leave out surfels that are not drawn. */
	ts_camera_k view = ts_k_view(args->by.view);
	ts_nearly surfel = ts_k_nearly(&args->by, &view, (u32)i);
	if (!surfel.drawn) return;
	/* Find the margin of the colour at the centre. */
	ts_shading_place centre = ts_k_centre_place(&args->of.of.surfels[i], &surfel.disc);
	bool phong = args->of.shading == TS_SHADING_PHONG;
	f32 margin = ts_k_shading_margin(&args->of, &centre, TS_MARGIN_ROUNDING);
	for (i32 y = surfel.disc.low[1]; y <= surfel.disc.high[1]; y++) {
		for (i32 x = surfel.disc.low[0]; x <= surfel.disc.high[0]; x++) {
			/* Take the fragments that are blended. */
			u64 pixel = (u64)y * (u64)view.width + (u64)x;
			u64 key = args->by.keys[pixel];
			ts_surfel_fragment f = ts_k_surfel_fragment(&surfel.disc, &args->by.filter, view.near, x, y);
			if (!f.covers || !ts_k_is_visible(&args->by.filter, key, f.z)) continue;
			if (!ts_k_shows(args->of.shading, key, (u32)i)) continue;
			/* Find the margin of the fragment's own colour, and lower that of the pixel. */
			if (phong) margin = ts_k_fragment_shading_margin(args, &view, &surfel, i, x, y);
			ts_k_least_step(&args->by.margin[pixel * 2u], margin);
		}
	}
}

#endif
