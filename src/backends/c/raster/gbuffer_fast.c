/* Fast path of the G-buffer, with the same bits: neighbouring pixels are transformed into the view together, and the
 * surfaces of one material are found together. */
#include "backends/c/raster/surface_rows.h"
#include "backends/fast.h"
#include "kernels/raster/gbuffer.h"

/* Like ts_k_gpixel. */
static void store(const void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const ts_gbuffer_args *args = user;
	for (u32 i = 0; i < of->n; i++) {
		u64 at = of->place[i];
		ts_surface s = ts_surface_lane(of, found, i);
		s.flags = args->scene.materials[of->material].flags;
		ts_v3 n = ts_k_facing_normal(&s, ts_sub(ts_lane3(&of->viewer, i), s.p));
		f32 depth = ts_k_screen_depth(args->view->near, ts_u2f((u32)(args->depth_triangle[at] >> 32)));
		ts_k_gpixel_store(&args->pixels[at], s.p, depth, n, ts_k_albedo(&s));
	}
}

static void store_row(ts_row_worker *w, u64 first, u64 n)
{
	const ts_gbuffer_args *args = w->user;
	ts_eye_place at = ts_k_eye_place(args->view, args->samples, first);
	for (u64 x = 0; x < n; x++) {
		u64 key = args->depth_triangle[first + x];
		if (key == TS_EMPTY) {
			ts_k_gbuffer_item(args, first + x);
			continue;
		}
		ts_fragment_add(&w->fragments, (u32)key, (i32)x, at.y, first + x);
		if (w->fragments.n == TS_ABREAST) ts_fragments_ask(&w->fragments, &w->bins, &at.view, NULL);
	}
	ts_fragments_ask(&w->fragments, &w->bins, &at.view, NULL);
}

bool ts_c_fast_gbuffer(const void *of, u64 n, u32 threads)
{
	const ts_gbuffer_args *args = of;
	ts_surface_rows rows = {&args->scene, args, store_row, store, n, (u64)args->view->width};
	return ts_see_rows(&rows, threads);
}

#include "backends/selftest.h"
