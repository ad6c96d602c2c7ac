/* Each view, or band of one, by itself: blocks of triangles are transformed into it side by side, and those that it may
 * show enter its batch. */
#include "backends/c/raster/draw_views.h"
#include <omp.h>
#include <stdlib.h>
#include "backends/c/raster/draw_batch.h"
#include "backends/wide.h"
#include "model/core.h"

enum { TRIANGLES = TS_DRAW_TRIANGLES, LANES = TS_DRAW_LANES };

/* Triangles of a block that the view may show. */
typedef struct {
	u32 shown[TRIANGLES];
	ts_draw_corners corners; /* on the view's axes */
} sight;

/* What a thread works with. */
typedef struct {
	ts_draw_batch batch;
	ts_draw_block block;
	sight sight;
} worker;

/* Bits of the planes of ts_k_is_outside that a corner is behind. */
static inline u32 corner_behind(const ts_camera_k *view, const ts_corner *p)
{
	f32 z = view->orthographic != 0u ? 1.0f : p->z;
	f32 x = view->focal * p->x, y = view->focal * p->y;
	f32 across = ((f32)view->width * 0.5f) * z, up = ((f32)view->height * 0.5f) * z;
	u32 behind = ts_draw_is_below(p->z - view->near) | ts_draw_is_below(x + across) << 1;
	behind |= ts_draw_is_below(across - x) << 2 | ts_draw_is_below(y + up) << 3;
	return behind | ts_draw_is_below(up - y) << 4;
}

/* Like ts_k_offscreen_may_show and ts_k_is_outside. */
TS_WIDE(void, see_view, (sight *restrict to, const ts_draw_block *restrict b, ts_camera_k view, u32 object),
        (to, b, view, object))
{
	u32 n = (b->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		ts_v3 p = ts_draw_corner(&b->corners, 0, i), q = ts_draw_corner(&b->corners, 1, i);
		ts_v3 r = ts_draw_corner(&b->corners, 2, i);
		ts_v3 normal = ts_cross(ts_sub(q, p), ts_sub(r, p));
		f32 towards = ts_dot(normal, ts_sub(view.eye, p)), along = ts_dot(normal, view.back);
		u32 facing = ts_draw_is_above(view.orthographic != 0u ? along : towards);
		u32 shown = (facing | b->two_sided[i]) & (b->object[i] != object ? 1u : 0u);
		shown &= ts_draw_is_above(ts_dot(normal, normal));
		ts_corner a = ts_k_to_view(&view, p), c = ts_k_to_view(&view, q), e = ts_k_to_view(&view, r);
		u32 behind = corner_behind(&view, &a) & corner_behind(&view, &c) & corner_behind(&view, &e);
		to->shown[i] = shown & (behind == 0u ? 1u : 0u);
		ts_draw_set_corner(&to->corners, 0, i, a.x, a.y, a.z);
		ts_draw_set_corner(&to->corners, 1, i, c.x, c.y, c.z);
		ts_draw_set_corner(&to->corners, 2, i, e.x, e.y, e.z);
	}
}

/* Rows of a view that one thread owns. */
static void draw_band(worker *w, const ts_arrays *scene, const ts_draw_view *of, u32 band, u32 n_bands, ts_stop *stop)
{
	static const ts_row row[3] = {{0, 1.0f}, {1, 1.0f}, {2, 1.0f}};
	ts_draw_batch *b = &w->batch;
	b->scene = scene;
	b->view = of->view;
	b->target = of->target;
	b->owned = ts_k_view_box(&of->view);
	b->owned.y0 = (i32)((u64)of->view.height * band / n_bands);
	b->owned.y1 = (i32)((u64)of->view.height * (band + 1) / n_bands) - 1;
	b->n = 0;
	for (u32 first = 0; first < scene->n_triangles && !ts_stopped(stop); first += TRIANGLES) {
		u32 left = scene->n_triangles - first;
		ts_draw_block_read(&w->block, scene, first, left < TRIANGLES ? left : TRIANGLES);
		see_view(&w->sight, &w->block, of->view, of->object);
		for (u32 k = 0; k < w->block.n; k++) {
			if (w->sight.shown[k] != 0) ts_draw_add(b, &w->block, k, &w->sight.corners, row);
		}
	}
	ts_draw_flush(b);
}

ts_draw_view ts_draw_view_offscreen(const ts_offscreen *offscreen, ts_target target)
{
	return (ts_draw_view){.view = ts_k_offscreen(offscreen), .target = target, .object = offscreen->object};
}

bool ts_draw_views(const ts_arrays *scene, const ts_draw_view *views, u32 n, u32 threads)
{
	u32 n_bands = threads > 1 && n != 0 ? (2 * threads + n - 1) / n : 1;
	worker *w = malloc(threads * sizeof *w);
	if (w == NULL) return false;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
	for (i64 i = 0; i < (i64)n * n_bands; i++) {
		u32 view = (u32)(i / n_bands), band = (u32)(i % n_bands);
		if (views[view].view.width != 0) {
			draw_band(&w[omp_get_thread_num()], scene, &views[view], band, n_bands, stop);
		}
	}
	free(w);
	return true;
}

#include "backends/selftest.h"
