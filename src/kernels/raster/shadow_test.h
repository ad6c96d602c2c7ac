/* The light samples that reach the pixels of the eye, by the rule of shadow_map.h. */
#ifndef TS_KERNELS_RASTER_SHADOW_TEST_H
#define TS_KERNELS_RASTER_SHADOW_TEST_H
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"
#include "kernels/raster/shadow_map.h"

TS_FN ts_receiver ts_k_receiver(const ts_arrays *scene, const ts_camera_k *eye, u64 key, i32 x, i32 y)
{
	ts_receiver r;
	r.seen = key != TS_EMPTY;
	r.p = ts_v3_make(0.0f, 0.0f, 0.0f);
	r.n = r.p;
	if (!r.seen) return r;
	ts_corners t = ts_k_corners(scene, (u32)key);
	ts_fragment f = ts_k_fragment_at(eye, &t, x, y);
	r.p = ts_blend(f.w, t.a, t.b, t.c);
	r.n = ts_normalize(t.n);
	return r;
}

/* The receiver of element i of the eye's buffers. */
TS_FN ts_receiver ts_k_receiver_at(const ts_shadow_test_args *args, u64 i)
{
	ts_eye_place at = ts_k_eye_place(args->view, args->samples, i);
	return ts_k_receiver(&args->scene, &at.view, args->depth_triangle[i], at.x, at.y);
}

/* map over pixels and their samples: adds the light samples of the batch that reach them */
TS_FN void ts_k_shadow_test_item(const ts_shadow_test_args *args, u64 i)
{
	ts_receiver at = ts_k_receiver_at(args, i);
	if (!at.seen || args->n_views == 0u) return;
	u64 first_texel = args->views[args->first_view].offset;
	u32 step = args->cubes != 0u ? 6u : 1u;
	for (u32 v = args->first_view; v < args->first_view + args->n_views; v += step) {
		TS_GLOBAL const ts_offscreen *view = ts_k_asked_view(args, v, &at);
		args->lit[i * args->n_lamps + view->light] += ts_k_reaches(args, view, &at, first_texel) ? 1u : 0u;
	}
}

#endif
