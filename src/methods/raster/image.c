/* The picture. */
#include "../../kernels/raster/image.h"
#include "../../kernels/raster/indirect.h"
#include "../stages.h"

static const ts_launch with_mirrors = TS_LAUNCH(image, TS_WITH(offset), TS_WITH(reflected));
static const ts_launch with_shadows = TS_LAUNCH(image, TS_IN(scene.lights, lamp_light), TS_WITH(lit), TS_WITH(lamps));
static const ts_launch of_indirect = TS_LAUNCH(image_indirect, TS_ALL);
static const ts_launch of_glossy = TS_LAUNCH(image_indirect, TS_WITH(specular));

static u64 n_pixels(const ts_run *run) { return (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height); }

static ts_status image(ts_run *run)
{
	ts_image_args args = {.scene = ts_run_scene(run), .exposure = TS_PARAM(&run->params, image_exposure)};
	return TS_RUN(run, &with_mirrors, &args, n_pixels(run));
}

/* In the light of the lamps, as far as it reaches. */
static ts_status image_shadow(ts_run *run)
{
	ts_image_args args = {.scene = ts_run_scene(run), .exposure = TS_PARAM(&run->params, image_exposure)};
	args.scene.n_lights = (u32)ts_run_size(run, TS_DIM_lamps);
	return TS_RUN(run, &with_shadows, &args, n_pixels(run));
}

f32 ts_image_gain(const ts_run *run) { return run->plan.lights.straight ? 1.0f : TS_BOUNCE_GAIN; }

/* In the light that was gathered alone. */
static ts_status image_indirect(ts_run *run)
{
	ts_indirect_args args = {.exposure = TS_PARAM(&run->params, image_exposure), .gain = ts_image_gain(run)};
	bool is_glossy = ts_run_made(run, TS_B_indirect_specular);
	return TS_RUN(run, is_glossy ? &of_glossy : &of_indirect, &args, n_pixels(run));
}

const ts_stage ts_stage_image = {
	.name = "image",
	.kind = "map",
	.paper = "EPR 4.1.2",
	.doc = "the picture",
	.run = image,
	.launches = TS_LAUNCHES(&with_mirrors),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_image_shadow = {
	.name = "image.shadow",
	.kind = "map",
	.paper = "iVIR 4",
	.doc = "the picture with its shadows",
	.run = image_shadow,
	.launches = TS_LAUNCHES(&with_shadows),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_image_indirect = {
	.name = "image.indirect",
	.kind = "map",
	.paper = "SSAGH 4, eq. 6",
	.doc = "the picture of indirect light",
	.run = image_indirect,
	.launches = TS_LAUNCHES(&of_indirect, &of_glossy),
};
