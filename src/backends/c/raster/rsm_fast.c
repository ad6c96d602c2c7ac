/* Fast path of reflective shadow maps, with the same bits. */
#include <stdlib.h>
#include "backends/c/raster/draw_views.h"
#include "backends/fast.h"
#include "kernels/raster/rsm.h"

bool ts_c_fast_rsm(const void *of, u64 n, u32 threads)
{
	const ts_rsm_args *args = of;
	ts_draw_view *drawn = malloc(args->n_views * sizeof *drawn);
	(void)n;
	if (drawn == NULL) return false;
	for (u32 v = 0; v < args->n_views; v++) {
		ts_target target = ts_k_keys(args->depth_triangle + args->views[v].offset);
		drawn[v] = ts_draw_view_offscreen(&args->views[v], target);
	}
	bool done = ts_draw_views(&args->scene, drawn, args->n_views, threads);
	free(drawn);
	return done;
}

#include "backends/selftest.h"
