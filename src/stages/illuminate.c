/* Level 0 of the batch's cubes, by shading every texel (MVR) or from points (iVIR); then their mip chains. */
#include "stages.h"

static ts_status make_levels(ts_run *run, ts_illuminate_args args)
{
	for (u32 r = run->first_unit; r < run->first_unit + run->n_units; r++) {
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

/* iVIR: colours of points into level 0, and the levels above. */
ts_status ts_stage_copy(ts_run *run)
{
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_resize_face);
	u64 n_mip = ts_k_mip_first(cubes, run->first_unit, run->first_unit + run->n_units);
	ts_copy_args args = {
		.to = {.cubes = cubes, .mip = ts_frame_make2(&run->frame, TS_B_face_mip, n_mip, 4),
		       .first_cube = run->first_unit, .n_cubes = run->n_units},
		.colours = ts_frame_handle(&run->frame, TS_B_scatter_colour),
		.exposure = run->params.exposure,
	};
	if (args.to.mip == NULL) return TS_ERROR;
	u64 n_texels = ts_run_n_texels(run, run->first_unit, run->n_units);
	if (ts_run_launch(run, TS_KERNEL_copy, &args, n_texels) != TS_OK) return TS_ERROR;
	return make_levels(run, args.to);
}

ts_status ts_stage_illuminate(ts_run *run)
{
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_resize_face);
	u64 n_mip = ts_k_mip_first(cubes, run->first_unit, run->first_unit + run->n_units);
	ts_illuminate_args args = {
		.scene = ts_run_arrays(run),
		.cubes = cubes,
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_face_depth_triangle),
		.mip = ts_frame_make2(&run->frame, TS_B_face_mip, n_mip, 4),
		.first_cube = run->first_unit,
		.n_cubes = run->n_units,
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
