/* The eye's view: draws every triangle that faces the eye into the keys depth << 32 | triangle (EPR section 4.1.3). */
#ifndef TS_KERNELS_RASTER_EYE_H
#define TS_KERNELS_RASTER_EYE_H
#include "kernels/base/args.h"
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"

#define TS_ROWS_ts_eye_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(MIN, u64, texels, eye_depth_triangle) \
	ARG(VALUE, u32, samples, none) /* of a pixel */ \
	ARG(VALUE, u32, others, none)  /* other items that share the rows: band.h */
TS_ARGS(ts_eye_args);

/* scatter over triangles, for each sample of the pixels */
TS_FN void ts_k_eye_item(const ts_eye_args *args, u64 i)
{
	ts_band band = ts_k_band(i, args->others);
	u32 triangle = (u32)(band.item % args->scene.n_triangles);
	u32 sample = (u32)(band.item / args->scene.n_triangles);
	ts_camera_k view = ts_k_eye_view(args->view, args->samples, sample);
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (ts_k_is_degenerate(t.n) || !ts_k_is_facing(&args->scene, triangle, &t, view.eye)) return;
	ts_target target = ts_k_keys(args->texels + (u64)sample * (u64)args->view->width * (u64)args->view->height);
	ts_k_draw(&args->scene, &view, &t, triangle, &band, &target);
}

#endif
