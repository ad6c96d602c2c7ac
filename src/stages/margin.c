/* How near the decisions of the stages before were. */
#include "stages.h"

static ts_status margin_of_pixels(ts_run *run, ts_margin_args *args, ts_buffer_id margin, u32 n_dims, const u64 *shape,
                                  ts_kernel kernel)
{
	args->scene = ts_run_arrays(run);
	args->margin = ts_frame_make(&run->frame, margin, n_dims, shape);
	if (args->margin == NULL || ts_run_fill(run, margin, 0xff) != TS_OK) return TS_ERROR;
	if (ts_run_launch(run, kernel, args, args->scene.n_triangles) != TS_OK) return TS_ERROR;
	return TS_OK;
}

ts_status ts_stage_eye_margin(ts_run *run)
{
	const u64 shape[] = {run->params.height, run->params.width, 2};
	ts_margin_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_eye_depth_triangle),
	};
	return margin_of_pixels(run, &args, TS_B_eye_margin, 3, shape, TS_KERNEL_eye_margin);
}

ts_status ts_stage_face_margin(ts_run *run)
{
	const u64 shape[] = {ts_frame_n(&run->frame, TS_B_face_depth_triangle), 2};
	ts_margin_args args = {
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_face_depth_triangle),
		.first_unit = run->first_unit,
		.n_units = run->n_units,
	};
	return margin_of_pixels(run, &args, TS_B_face_margin, 2, shape, TS_KERNEL_face_margin);
}

ts_status ts_stage_depth_margin(ts_run *run)
{
	const u64 shape[] = {ts_frame_n(&run->frame, TS_B_scatter_depth), 2};
	ts_margin_args args = {
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.depths = ts_frame_handle(&run->frame, TS_B_scatter_depth),
	};
	ts_run_views(run, &args.first_unit, &args.n_units);
	return margin_of_pixels(run, &args, TS_B_depth_margin, 2, shape, TS_KERNEL_depth_margin);
}

/* One buffer for all batches, as resolve.lit. */
static ts_status make_resolve_margin(ts_run *run)
{
	const u64 shape[] = {run->params.height, run->params.width, ts_frame_n(&run->frame, TS_B_lamp_shape), 2};
	if (run->first_unit != 0) return TS_OK;
	if (ts_frame_make(&run->frame, TS_B_resolve_margin, 4, shape) == NULL) return TS_ERROR;
	return ts_run_fill(run, TS_B_resolve_margin, 0xff);
}

ts_status ts_stage_resolve_margin(ts_run *run)
{
	if (make_resolve_margin(run) != TS_OK) return TS_ERROR;
	ts_resolve_margin_args args = {
		.of = ts_resolve_arguments(run),
		.margin = ts_frame_handle(&run->frame, TS_B_resolve_margin),
	};
	return ts_run_launch(run, TS_KERNEL_resolve_margin, &args, ts_frame_n(&run->frame, TS_B_eye_depth_triangle));
}

ts_status ts_stage_cull_margin(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_split_triangle);
	ts_cull_margin_args args = {.cull = ts_cull_arguments(run), .margin = ts_frame_make1(&run->frame, TS_B_cull_margin, n)};
	if (args.margin == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_cull_margin, &args, n);
}

ts_status ts_stage_segment_margin(ts_run *run)
{
	u32 grid = run->params.grid_px;
	ts_segment_margin_args args = {
		.depths = ts_frame_handle(&run->frame, TS_B_nearest_depth),
		.margin = ts_frame_make2(&run->frame, TS_B_segment_margin, grid, grid),
		.grid = grid,
		.step = run->params.segment_step,
	};
	if (args.margin == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_segment_margin, &args, (u64)grid * grid / TS_BLOCK_TEXELS);
}

ts_status ts_stage_hull_margin(ts_run *run)
{
	u64 width = run->params.width, height = run->params.height;
	ts_hull_margin_args args = {
		.choice = ts_choice_arguments(run),
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.box = ts_frame_handle(&run->frame, TS_B_hull_box),
		.margin = ts_frame_make2(&run->frame, TS_B_hull_margin, height, width),
		.width = (u32)width,
		.height = (u32)height,
	};
	if (args.margin == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_hull_margin, &args, width * height);
}
