/* Fast path of MVR's depth maps, with the same bits. */
#include <stdlib.h>
#include "backends/c/raster/draw_views.h"
#include "backends/fast.h"
#include "kernels/raster/depth_map.h"

bool ts_c_fast_depth_map(const void *of, u64 n, u32 threads)
{
	const ts_depth_map_args *args = of;
	const ts_offscreen *views = args->views + args->first_view;
	ts_draw_view *drawn = malloc(args->n_views * sizeof *drawn);
	(void)n;
	if (drawn == NULL) return false;
	for (u32 v = 0; v < args->n_views; v++) {
		ts_target target = {.depths = args->depths + (views[v].offset - views[0].offset)};
		drawn[v] = ts_draw_view_offscreen(&views[v], target);
	}
	bool done = ts_draw_views(&args->scene, drawn, args->n_views, threads);
	free(drawn);
	return done;
}

#include "backends/selftest.h"
