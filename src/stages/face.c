/* MVR: every triangle into the faces of the batch's cubes. */
#include "stages.h"

ts_status ts_stage_face(ts_run *run)
{
	u64 n_texels = ts_run_n_texels(run, run->first_unit, run->n_units);
	ts_face_args args = {
		.scene = ts_run_arrays(run),
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.texels = ts_frame_make1(&run->frame, TS_B_face_depth_triangle, n_texels),
		.first_cube = run->first_unit,
		.n_cubes = run->n_units,
	};
	if (args.texels == NULL || ts_run_fill(run, TS_B_face_depth_triangle, 0xff) != TS_OK) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_face, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", run->n_units);
	ts_run_count(run, "triangles processed", (i64)args.scene.n_triangles * run->n_units);
	return TS_OK;
}
