/* Off-screen views: cube faces and the depth maps of lights, and which of them may see a triangle (iVIR section 3.1;
 * METHODS 9). */
#ifndef TS_KERNELS_RASTER_OFFSCREEN_H
#define TS_KERNELS_RASTER_OFFSCREEN_H
#include "kernels/base/args.h"
#include "kernels/raster/cube.h"
#include "kernels/raster/visibility.h"

TS_FN ts_camera_k ts_k_offscreen(TS_GLOBAL const ts_offscreen *view)
{
	ts_camera_k r;
	/* Copy the place, the axes, the lens and the size. */
	r.eye = ts_load3(view->eye);
	r.right = ts_load3(view->right);
	r.up = ts_load3(view->up);
	r.back = ts_load3(view->back);
	r.focal = view->focal;
	r.near = view->near;
	r.width = (i32)view->width;
	r.height = (i32)view->height;
	/* Take texels whole and at their centres. */
	r.side = 1.0f;
	r.shift_x = 0;
	r.shift_y = 0;
	r.orthographic = view->orthographic;
	return r;
}

/* Whether a view may show the triangle: the view is in sight, the triangle is not of the object that the view leaves
 * out, and does not turn its back. */
TS_FN bool ts_k_offscreen_may_show(const ts_arrays *scene, TS_GLOBAL const ts_offscreen *view, u32 triangle,
                                   const ts_corners *t)
{
	if (view->width == 0u || view->object == ts_k_object_of(scene, triangle)) return false;
	if (view->orthographic == 0u) return ts_k_is_facing(scene, triangle, t, ts_load3(view->eye));
	return ts_k_is_two_sided(scene, triangle) || ts_flush(ts_dot(t->n, ts_load3(view->back))) > 0.0f;
}

#define TS_ROWS_ts_offscreen_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_offscreen, views, offscreen_view) \
	ARG(OUT, u64, bits, visibility_bits) /* n_triangles * n_words */ \
	ARG(VALUE, u32, n_views, none) \
	ARG(VALUE, u32, n_words, none) \
	ARG(VALUE, u32, vertex_mode, none)
TS_ARGS(ts_offscreen_args);

/* Whether a view may show and may see the triangle (iVIR 3.1). */
TS_FN bool ts_k_offscreen_sees(const ts_offscreen_args *args, TS_GLOBAL const ts_offscreen *view, u32 triangle,
                               const ts_corners *t)
{
	/* Drop what the view never shows, by its side and its reflector. */
	if (!ts_k_offscreen_may_show(&args->scene, view, triangle, t)) return false;
	/* Test the corners against the planes of the view's frustum. */
	ts_frustum frustum;
	frustum.x = view->reach[0];
	frustum.y = view->reach[1];
	frustum.near = view->near;
	frustum.orthographic = view->orthographic;
	ts_camera_k camera = ts_k_offscreen(view);
	ts_corner a = ts_k_to_view(&camera, t->a);
	ts_corner b = ts_k_to_view(&camera, t->b);
	ts_corner c = ts_k_to_view(&camera, t->c);
	return ts_k_may_see(&frustum, ts_v3_make(a.x, a.y, a.z), ts_v3_make(b.x, b.y, b.z), ts_v3_make(c.x, c.y, c.z),
	                    args->vertex_mode);
}

/* map over triangles */
TS_FN void ts_k_offscreen_visibility_item(const ts_offscreen_args *args, u64 i)
{
	TS_GLOBAL u64 *words = args->bits + i * args->n_words;
	for (u32 w = 0u; w < args->n_words; w++) words[w] = 0u;
	ts_corners t = ts_k_corners(&args->scene, (u32)i);
	if (ts_k_is_degenerate(t.n)) return;
	for (u32 v = 0u; v < args->n_views; v++) {
		u64 sees = ts_k_offscreen_sees(args, &args->views[v], (u32)i, &t) ? 1u : 0u;
		words[v >> 6] |= sees << (v & 63u);
	}
}

/* Bit v of a triangle's words. */
TS_FN bool ts_k_offscreen_bit(TS_GLOBAL const u64 *words, u32 v) { return ((words[v >> 6] >> (v & 63u)) & 1u) != 0u; }

#endif
