/* Surfels in the eye's view, and the depth range behind the nearest within which others are blended. */
#include "kernels/surfels/surfel_setup.h"
#include "methods/surfels/surfel.h"
#include "scene/surfel.h"

static const ts_launch launch = TS_LAUNCH(surfel_setup, TS_ALL);

ts_filter ts_surfel_filter(const ts_run *run)
{
	const ts_params *params = &run->params;
	f32 sigma = TS_PARAM(params, ewa_screen_radius),
		wide = TS_PARAM(params, ewa_sigma_k) * TS_PARAM(params, ewa_sigma_k);
	f32 narrow =
		TS_PARAM(params, ewa_sigma_h) != 0.0f ? TS_PARAM(params, ewa_sigma_h) : sigma * TS_PARAM(params, ewa_sigma_k);
	bool screen = sigma > 0.0f && TS_PARAM(params, ewa_filter) != TS_FILTER_OBJECT;
	return (ts_filter){
		.filter = run->plan.surfels.exact ? TS_FILTER_EWA : TS_PARAM(params, ewa_filter),
		.botsch = TS_PARAM(params, surfel_setup_bounds) == TS_BOUNDS_BOTSCH,
		.opens = TS_PARAM(params, ewa_outline) == TS_OUTLINE_FILTER,
		.per_sigma2 = screen ? 1.0f / (sigma * sigma) : 0.0f,
		.reach = ts_max(screen ? sigma : 0.0f, TS_PARAM(params, surfel_setup_min_px) * 0.5f),
		.fall = 0.5f / wide,
		.object2 = wide,
		.screen2 = narrow * narrow,
	};
}

static ts_status set_epsilon(ts_run *run)
{
	enum { MEDIAN = 2 };
	f32 quantile[TS_SURFEL_QUANTILES];
	f32 *epsilon = ts_run_make(run, TS_B_surfel_setup_epsilon);
	const ts_surfel *surfels = ts_frame_data(&run->frame, TS_B_scene_surfel);
	u32 n = (u32)ts_frame_n(&run->frame, TS_B_scene_surfel);
	if (epsilon == NULL || ts_surfel_quantiles(quantile, surfels, n) != TS_OK) return TS_ERROR;
	*epsilon = ts_put(TS_PARAM(&run->params, surfel_depth_epsilon) > 0.0f ? TS_PARAM(&run->params, surfel_depth_epsilon)
	                                                                      : quantile[MEDIAN]);
	return TS_OK;
}

static ts_status surfel_setup(ts_run *run)
{
	static const char *const fates[] = {"surfels drawn", "surfels turned away", "surfels before the near plane",
	                                    "surfels beside the image"};
	ts_surfel_setup_args args = {.filter = ts_surfel_filter(run)};
	if (set_epsilon(run) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &launch, &args, ts_run_size(run, TS_DIM_surfels)) != TS_OK) return TS_ERROR;
	for (u32 fate = 0; fate < 4; fate++) ts_run_count(run, fates[fate], ts_frame_tally(&run->frame, fate));
	return TS_OK;
}

const ts_stage ts_stage_surfel_setup = {
	.name = "surfel_setup",
	.kind = "map",
	.paper = "NV40: Perspectively Correct Rendering",
	.doc = "surfels in the eye's view: the map from pixels to their planes, and their boxes",
	.run = surfel_setup,
	.launches = TS_LAUNCHES(&launch),
	.makes = TS_BUFFERS(TS_B_surfel_setup_epsilon),
};
