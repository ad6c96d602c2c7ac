/* Shading of surfels before they are blended, and its picture. */
#include "methods/surfels/surfel.h"

static const ts_launch launch = TS_LAUNCH(surfel_shade_image, TS_ALL);

ts_surfel_shade_args ts_surfel_shading(const ts_run *run)
{
	return (ts_surfel_shade_args){
		.of = {.filter = ts_surfel_filter(run)},
		.n_lights = (u32)ts_run_size(run, TS_DIM_lamps),
		.shading = run->plan.surfels.shading,
		.npr = ts_shader_is_npr(&run->params),
		.ambient = ts_run_info(run)->ambient,
		.exposure = TS_PARAM(&run->params, image_exposure),
	};
}

static ts_status image(ts_run *run)
{
	ts_surfel_shade_image_args args = {.exposure = TS_PARAM(&run->params, image_exposure)};
	return TS_RUN(run, &launch, &args, (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height));
}

const ts_stage ts_stage_surfel_shade_image = {
	.name = "surfel_shade.image",
	.kind = "map",
	.paper = "NV40: 3-Pass Shading",
	.doc = "the picture of colours that were shaded before they were blended",
	.run = image,
	.launches = TS_LAUNCHES(&launch),
};
