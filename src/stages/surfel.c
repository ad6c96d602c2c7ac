/* Surfels: three passes, and shadows the same way. */
#include "../scene/surfel.h"
#include "stages.h"

/* As arguments of kernels have it. */
static ts_filter filter_of(const ts_run *run)
{
	const ts_params *params = &run->params;
	f32 sigma = params->sigma, wide = params->sigma_k * params->sigma_k;
	f32 narrow = params->sigma_h != 0.0f ? params->sigma_h : sigma * params->sigma_k;
	bool screen = sigma > 0.0f && params->filter != TS_FILTER_OBJECT;
	return (ts_filter){
		.filter = run->exact_ewa ? TS_FILTER_IS_EWA : params->filter,
		.botsch = params->bounds == TS_BOUNDS_BOTSCH,
		.per_sigma2 = screen ? 1.0f / (sigma * sigma) : 0.0f,
		.reach = ts_max(screen ? sigma : 0.0f, params->min_px * 0.5f),
		.fall = 0.5f / wide,
		.object2 = wide,
		.screen2 = narrow * narrow,
	};
}

static u64 n_surfels(const ts_run *run) { return ts_frame_n(&run->frame, TS_B_scene_surfel); }

static u64 n_pixels(const ts_run *run) { return (u64)run->params.width * run->params.height; }

static ts_status set_epsilon(ts_run *run)
{
	enum { MEDIAN = 2 };
	f32 quantile[TS_SURFEL_QUANTILES];
	f32 *epsilon = ts_frame_make1(&run->frame, TS_B_surfel_setup_epsilon, 1);
	const ts_surfel *surfels = ts_frame_data(&run->frame, TS_B_scene_surfel);
	if (epsilon == NULL || ts_surfel_quantiles(quantile, surfels, (u32)n_surfels(run)) != TS_OK) return TS_ERROR;
	*epsilon = ts_put(run->params.eps > 0.0f ? run->params.eps : quantile[MEDIAN]);
	return TS_OK;
}

ts_status ts_stage_surfel_setup(ts_run *run)
{
	static const char *const fates[] = {"surfels drawn", "surfels turned away", "surfels before the near plane",
	                                    "surfels beside the image"};
	if (set_epsilon(run) != TS_OK) return TS_ERROR;
	ts_surfel_setup_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.surfels = ts_frame_handle(&run->frame, TS_B_scene_surfel),
		.discs = ts_frame_make1(&run->frame, TS_B_surfel_setup_disc, n_surfels(run)),
		.tally = ts_frame_tallies(&run->frame),
		.filter = filter_of(run),
	};
	if (args.discs == NULL || args.tally == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_surfel_setup, &args, n_surfels(run)) != TS_OK) return TS_ERROR;
	for (u32 fate = 0; fate < 4; fate++) ts_run_count(run, fates[fate], ts_frame_tally(&run->frame, fate));
	return TS_OK;
}

ts_status ts_stage_surfel_depth(ts_run *run)
{
	ts_surfel_depth_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.epsilon = ts_frame_handle(&run->frame, TS_B_surfel_setup_epsilon),
		.keys = ts_frame_make2(&run->frame, TS_B_surfel_depth_surfel, run->params.height, run->params.width),
	};
	if (args.keys == NULL || ts_run_fill(run, TS_B_surfel_depth_surfel, 0xff) != TS_OK) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_surfel_depth, &args, ts_frame_n(&run->frame, TS_B_surfel_setup_disc));
}

static ts_status clear_sums(ts_run *run)
{
	bool good = ts_frame_make3(&run->frame, TS_B_blend_sum, run->params.height, run->params.width, TS_BLEND_SUMS) != NULL &&
	            ts_frame_make2(&run->frame, TS_B_blend_heaviest, run->params.height, run->params.width) != NULL &&
	            ts_run_fill(run, TS_B_blend_sum, 0) == TS_OK && ts_run_fill(run, TS_B_blend_heaviest, 0xff) == TS_OK;
	return good ? TS_OK : TS_ERROR;
}

ts_status ts_stage_blend(ts_run *run)
{
	if (clear_sums(run) != TS_OK) return TS_ERROR;
	ts_blend_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.surfels = ts_frame_handle(&run->frame, TS_B_scene_surfel),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.keys = ts_frame_handle(&run->frame, TS_B_surfel_depth_surfel),
		.sums = ts_frame_handle(&run->frame, TS_B_blend_sum),
		.heaviest = ts_frame_handle(&run->frame, TS_B_blend_heaviest),
		.tally = ts_frame_tallies(&run->frame),
		.filter = filter_of(run),
	};
	if (args.tally == NULL || ts_run_launch(run, TS_KERNEL_blend, &args, n_surfels(run)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "fragments", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "pixels of boxes", ts_frame_tally(&run->frame, 1));
	return TS_OK;
}

ts_status ts_stage_surfel_mean(ts_run *run)
{
	ts_surfel_mean_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.discs = ts_frame_handle(&run->frame, TS_B_surfel_setup_disc),
		.epsilon = ts_frame_handle(&run->frame, TS_B_surfel_setup_epsilon),
		.keys = ts_frame_handle(&run->frame, TS_B_surfel_depth_surfel),
		.sums = ts_frame_handle(&run->frame, TS_B_blend_sum),
		.heaviest = ts_frame_handle(&run->frame, TS_B_blend_heaviest),
		.pixels = ts_frame_make2(&run->frame, TS_B_gbuffer_pixel, run->params.height, run->params.width),
		.tally = ts_frame_tallies(&run->frame),
	};
	if (args.pixels == NULL || args.tally == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_surfel_mean, &args, n_pixels(run)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "shading operations", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

ts_status ts_stage_surfel_shadow(ts_run *run)
{
	u32 n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view);
	if (ts_frame_make1(&run->frame, TS_B_scatter_depth, ts_run_n_texels(run, 0, n_views)) == NULL) return TS_ERROR;
	if (ts_run_fill(run, TS_B_scatter_depth, 0xff) != TS_OK) return TS_ERROR;
	ts_surfel_shadow_args args = {
		.surfels = ts_frame_handle(&run->frame, TS_B_scene_surfel),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.epsilon = ts_frame_handle(&run->frame, TS_B_surfel_setup_epsilon),
		.depths = ts_frame_handle(&run->frame, TS_B_scatter_depth),
		.filter = filter_of(run),
		.n_views = n_views,
	};
	return ts_run_launch(run, TS_KERNEL_surfel_shadow, &args, n_surfels(run));
}

ts_status ts_stage_deferred_lit(ts_run *run)
{
	ts_deferred_lit_args args = {
		.of = {
			.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
			.depths = ts_frame_handle(&run->frame, TS_B_scatter_depth),
			.lit = ts_resolve_output(run),
			.n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view),
			.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_shape),
			.bias = run->params.bias,
			.slope = run->params.bias_slope,
		},
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
	};
	return args.of.lit != NULL ? ts_run_launch(run, TS_KERNEL_deferred_lit, &args, n_pixels(run)) : TS_ERROR;
}

ts_status ts_stage_deferred(ts_run *run)
{
	u32 shader = run->params.shader;
	ts_deferred_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.pixels = ts_frame_handle(&run->frame, TS_B_gbuffer_pixel),
		.lights = ts_frame_handle(&run->frame, TS_B_lamp_light),
		.lamps = ts_frame_handle(&run->frame, TS_B_lamp_shape),
		.lit = ts_shader_has_shadows(&run->params) ? ts_frame_handle(&run->frame, TS_B_resolve_lit) : NULL,
		.radiance = ts_frame_make3(&run->frame, TS_B_image_radiance, run->params.height, run->params.width, 3),
		.srgb = ts_frame_make3(&run->frame, TS_B_image_srgb, run->params.height, run->params.width, 3),
		.n_lights = (u32)ts_frame_n(&run->frame, TS_B_lamp_light),
		.shader = shader == TS_SHADER_NPR || shader == TS_SHADER_NPR_SHADOW ? TS_SHADER_IS_NPR : TS_SHADER_IS_PHONG,
		.ambient = ts_run_info(run)->ambient,
		.exposure = run->params.exposure,
	};
	if (args.radiance == NULL || args.srgb == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_deferred, &args, n_pixels(run));
}

bool ts_shader_has_shadows(const ts_params *params)
{
	return params->shader == TS_SHADER_PHONG_SHADOW || params->shader == TS_SHADER_NPR_SHADOW;
}
