/* Visibility bits of every triangle. */
#include "stages.h"

ts_status ts_stage_visibility(ts_run *run)
{
	u32 n_words = ts_run_n_words(run);
	u64 n = run->scene->n_triangles;
	ts_visibility_args args = {
		.scene = ts_run_arrays(run),
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.bits = ts_frame_make2(&run->frame, TS_B_visibility_bits, n, n_words),
		.n_cubes = ts_run_n_cubes(run),
		.n_words = n_words,
		.vertex_mode = run->params.visibility == TS_VISIBILITY_VERTEX,
	};
	if (args.bits == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_visibility, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	ts_run_count(run, "triangles processed", (i64)n);
	return TS_OK;
}
