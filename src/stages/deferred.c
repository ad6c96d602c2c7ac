/* Deferred shading of a G-buffer, with the shadows of its lights. */
#include "stages.h"

bool ts_shader_has_shadows(const ts_params *params)
{
	return params->shader == TS_SHADER_PHONG_SHADOW || params->shader == TS_SHADER_NPR_SHADOW;
}

ts_deferred_lit_args ts_deferred_lit_arguments(const ts_run *run)
{
	return (ts_deferred_lit_args){
		.of = {
			.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
			.depths = ts_frame_handle(&run->frame, TS_B_scatter_depth),
			.n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view),
			.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_shape),
			.bias = run->params.bias,
			.slope = run->params.bias_slope,
		},
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.lights = ts_frame_handle(&run->frame, TS_B_lamp_light),
	};
}

ts_status ts_stage_deferred_lit(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_gbuffer_pixel);
	ts_deferred_lit_args args = ts_deferred_lit_arguments(run);
	args.of.lit = ts_resolve_output(run);
	return args.of.lit != NULL ? ts_run_launch(run, TS_KERNEL_deferred_lit, &args, n) : TS_ERROR;
}

ts_deferred_args ts_deferred_arguments(const ts_run *run)
{
	u32 shader = run->params.shader;
	return (ts_deferred_args){
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.lights = ts_frame_handle(&run->frame, TS_B_lamp_light),
		.lamps = ts_frame_handle(&run->frame, TS_B_lamp_shape),
		.lit = ts_shader_has_shadows(&run->params) ? ts_frame_handle(&run->frame, TS_B_resolve_lit) : NULL,
		.n_lights = (u32)ts_frame_n(&run->frame, TS_B_lamp_light),
		.shader = shader == TS_SHADER_NPR || shader == TS_SHADER_NPR_SHADOW ? TS_SHADER_IS_NPR : TS_SHADER_IS_PHONG,
		.ambient = ts_run_info(run)->ambient,
		.exposure = run->params.exposure,
	};
}

ts_status ts_stage_deferred(ts_run *run)
{
	ts_deferred_args args = ts_deferred_arguments(run);
	args.radiance = ts_frame_make3(&run->frame, TS_B_image_radiance, run->params.height, run->params.width, 3);
	args.srgb = ts_frame_make3(&run->frame, TS_B_image_srgb, run->params.height, run->params.width, 3);
	if (args.radiance == NULL || args.srgb == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_deferred, &args, ts_frame_n(&run->frame, TS_B_gbuffer_pixel));
}
