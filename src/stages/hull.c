/* Light at the corners of the segments' boxes, as lobes, at every pixel; or gathered by every pixel itself. */
#include "stages.h"

ts_status ts_stage_gather(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_box_record);
	ts_gather_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.patches = ts_frame_handle(&run->frame, TS_B_rsm_patch),
		.boxes = ts_frame_handle(&run->frame, TS_B_box_record),
		.moments = ts_frame_make2(&run->frame, TS_B_gather_moment, n, 4),
		.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch),
		.grid = run->params.grid_px,
	};
	if (args.moments == NULL) return TS_ERROR;
	ts_run_count(run, "gathers", (i64)(4 * n * args.n_patches));
	return ts_run_launch(run, TS_KERNEL_gather, &args, 4 * n);
}

ts_status ts_stage_fit(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_gather_moment);
	ts_fit_args args = {
		.moments = ts_frame_handle(&run->frame, TS_B_gather_moment),
		.lobes = ts_frame_make2(&run->frame, TS_B_fit_lobes, n / 4, 4),
		.vmf = run->params.sharpness == TS_SHARPNESS_VMF,
	};
	if (args.lobes == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_fit, &args, n);
}

ts_choice_args ts_choice_arguments(const ts_run *run)
{
	return (ts_choice_args){
		.offset = ts_frame_handle(&run->frame, TS_B_box_offset),
		.boxes = ts_frame_handle(&run->frame, TS_B_box_record),
		.grid = run->params.grid_px,
		.robust = run->params.surface == TS_SURFACE_ROBUST,
		.step = run->params.segment_step,
	};
}

ts_status ts_stage_hull(ts_run *run)
{
	u64 width = run->params.width, height = run->params.height;
	ts_hull_args args = {
		.choice = ts_choice_arguments(run),
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.moments = ts_frame_handle(&run->frame, TS_B_gather_moment),
		.lobes = ts_frame_handle(&run->frame, TS_B_fit_lobes),
		.box = ts_frame_make2(&run->frame, TS_B_hull_box, height, width),
		.irradiance = ts_frame_make3(&run->frame, TS_B_indirect_irradiance, height, width, 3),
		.n_unlit = ts_frame_tallies(&run->frame),
		.width = (u32)width,
		.height = (u32)height,
		.cosine = run->params.cosine,
		.by_moments = run->params.interpolation == TS_INTERPOLATION_MOMENTS,
		.vmf = run->params.sharpness == TS_SHARPNESS_VMF,
		.printed = run->params.integrals == TS_INTEGRALS_PRINTED,
	};
	if (args.box == NULL || args.irradiance == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_hull, &args, width * height) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pixels without a segment", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

ts_status ts_stage_direct(ts_run *run)
{
	u64 width = run->params.width, height = run->params.height;
	ts_direct_args args = {
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.patches = ts_frame_handle(&run->frame, TS_B_rsm_patch),
		.irradiance = ts_frame_make3(&run->frame, TS_B_indirect_irradiance, height, width, 3),
		.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch),
	};
	if (args.irradiance == NULL) return TS_ERROR;
	ts_run_count(run, "gathers", (i64)(width * height * args.n_patches));
	return ts_run_launch(run, TS_KERNEL_direct, &args, width * height);
}
