/* The picture. */
#include "stages.h"

static ts_status image(ts_run *run, ts_image_args args)
{
	u64 width = run->params.width;
	u64 height = run->params.height;
	args.view = ts_frame_handle(&run->frame, TS_B_eye_view);
	args.depth_triangle = ts_frame_handle(&run->frame, TS_B_eye_depth_triangle);
	args.radiance = ts_frame_make3(&run->frame, TS_B_image_radiance, height, width, 3);
	args.srgb = ts_frame_make3(&run->frame, TS_B_image_srgb, height, width, 3);
	args.exposure = run->params.exposure;
	if (args.radiance == NULL || args.srgb == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_image, &args, width * height);
}

ts_status ts_stage_image(ts_run *run)
{
	ts_image_args args = {
		.scene = ts_run_arrays(run),
		.offset = ts_frame_handle(&run->frame, TS_B_pixel_offset),
		.reflected = ts_frame_handle(&run->frame, TS_B_shade_radiance),
	};
	return image(run, args);
}

/* In the light of the lamps, as far as it reaches. */
ts_status ts_stage_shadow_image(ts_run *run)
{
	ts_image_args args = {
		.scene = ts_run_arrays(run),
		.lit = ts_frame_handle(&run->frame, TS_B_resolve_lit),
		.lamps = ts_frame_handle(&run->frame, TS_B_lamp_shape),
	};
	args.scene.lights = ts_frame_handle(&run->frame, TS_B_lamp_light);
	args.scene.n_lights = (u32)ts_frame_n(&run->frame, TS_B_lamp_light);
	return image(run, args);
}

/* In indirect light alone. */
ts_status ts_stage_indirect_image(ts_run *run)
{
	u64 width = run->params.width;
	u64 height = run->params.height;
	ts_indirect_args args = {
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.irradiance = ts_frame_handle(&run->frame, TS_B_indirect_irradiance),
		.radiance = ts_frame_make3(&run->frame, TS_B_image_radiance, height, width, 3),
		.srgb = ts_frame_make3(&run->frame, TS_B_image_srgb, height, width, 3),
		.exposure = run->params.exposure,
	};
	if (args.radiance == NULL || args.srgb == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_indirect_image, &args, width * height);
}
