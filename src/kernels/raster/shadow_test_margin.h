/* Margins of the shadows of the eye's pixels, by shadow_map_margin.h: a second pass, which changes no decision. */
#ifndef TS_KERNELS_RASTER_SHADOW_TEST_MARGIN_H
#define TS_KERNELS_RASTER_SHADOW_TEST_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/raster/shadow_map_margin.h"
#include "kernels/raster/shadow_test.h"

/* Two minima per pixel and light, over the light's views, as f32 bits: the distance to a texel with another answer, in
 * steps along the axes; and the distance of z from map + bias, in units of the change of both depths per step. */
#define TS_ROWS_ts_shadow_test_margin_args(ARG) \
	ARG(INNER, ts_shadow_test_args, of, none) \
	ARG(MIN, u64, margin, shadow_test_margin) /* [2] per pixel and light */
TS_ARGS(ts_shadow_test_margin_args);

/* map over pixels and their samples, as ts_k_shadow_test_item */
TS_FN void ts_k_shadow_test_margin_item(const ts_shadow_test_margin_args *args, u64 i)
{
	/* Find the receiver, as ts_k_shadow_test_item does. */
	const ts_shadow_test_args *of = &args->of;
	ts_camera_k eye = ts_k_view(of->view);
	ts_receiver at = ts_k_receiver_at(of, i);
	if (!at.seen || of->n_views == 0u) return;
	f32 moves = ts_k_receiver_step(&eye, &at);
	/* Visit the views of the batch; of a cube the one face that the receiver falls into. */
	u64 first_texel = of->views[of->first_view].offset;
	u32 step = of->cubes != 0u ? 6u : 1u;
	for (u32 v = of->first_view; v < of->first_view + of->n_views; v += step) {
		TS_GLOBAL const ts_offscreen *view = ts_k_asked_view(of, v, &at);
		u64 light = i * of->n_lamps + view->light;
		ts_k_reach_margin(of, view, &at, moves, first_texel, args->margin + light * 2u);
	}
}

#endif
