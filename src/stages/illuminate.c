/* MVR: every texel of the batch's faces shaded, then their mip chains. */
#include "stages.h"

static ts_status make_levels(ts_run *run, ts_illuminate_args args)
{
	for (u32 r = run->first_reflector; r < run->first_reflector + run->n_reflectors; r++) {
		u32 n = args.cubes[r].n;
		args.first_cube = r;
		for (args.level = 1; n != 0 && args.level < ts_k_mip_levels(n); args.level++) {
			u64 size = ts_k_mip_size(n, args.level);
			if (ts_run_launch(run, TS_KERNEL_mip, &args, 6 * size * size) != TS_OK) return TS_ERROR;
		}
		args.mip += ts_k_mip_texels(n, TS_NONE) * 4;
	}
	return TS_OK;
}

ts_status ts_stage_illuminate(ts_run *run)
{
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_resize_face);
	u64 n_mip = ts_k_mip_first(cubes, run->first_reflector, run->first_reflector + run->n_reflectors);
	ts_illuminate_args args = {
		.scene = ts_run_arrays(run),
		.cubes = cubes,
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_face_depth_triangle),
		.mip = ts_frame_make2(&run->frame, TS_B_face_mip, n_mip, 4),
		.first_cube = run->first_reflector,
		.n_cubes = run->n_reflectors,
	};
	if (args.mip == NULL) return TS_ERROR;
	u64 n_texels = ts_frame_n(&run->frame, TS_B_face_depth_triangle);
	if (ts_run_launch(run, TS_KERNEL_illuminate, &args, n_texels) != TS_OK) return TS_ERROR;
	if (make_levels(run, args) != TS_OK) return TS_ERROR;
	const u64 *depth_triangle = ts_frame_data(&run->frame, TS_B_face_depth_triangle);
	i64 shaded = 0;
	for (u64 i = 0; i < n_texels; i++) shaded += depth_triangle[i] != TS_EMPTY;
	ts_run_count(run, "shading operations", shaded);
	return TS_OK;
}
