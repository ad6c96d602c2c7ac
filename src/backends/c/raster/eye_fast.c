/* Fast path of the eye's view, with the same bits. */
#include "backends/c/raster/draw_views.h"
#include "backends/fast.h"
#include "kernels/raster/eye.h"

bool ts_c_fast_eye(const void *of, u64 n, u32 threads)
{
	const ts_eye_args *args = of;
	ts_draw_view views[TS_N_EYE_SAMPLES];
	u32 n_views = args->samples == TS_N_EYE_SAMPLES ? TS_N_EYE_SAMPLES : 1;
	u64 pixels = (u64)args->view->width * args->view->height;
	(void)n;
	for (u32 s = 0; s < n_views; s++) {
		views[s] = (ts_draw_view){.view = ts_k_eye_view(args->view, args->samples, s),
		                          .target = ts_k_keys(args->texels + s * pixels),
		                          .object = TS_NONE};
	}
	return ts_draw_views(&args->scene, views, n_views, threads);
}

#include "backends/selftest.h"
