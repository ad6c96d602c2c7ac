/* The picture. */
#include "kernels/raster/image.h"
#include "kernels/raster/indirect.h"
#include "methods/raster/raster.h"

/* For a picture without multisampling, and for samples that are resolved. */
typedef struct {
	ts_launch whole, samples;
} launches;

#define MIRRORS TS_WITH(offset), TS_WITH(reflected)
#define SHADOWS TS_IN(scene.lights, lamp_light), TS_WITH(lit), TS_WITH(lamps)
#define SHOWN TS_WITH(srgb)
#define SAMPLED TS_OUT(radiance, image_sample_radiance)
static const launches with_mirrors = {TS_LAUNCH(image, MIRRORS, SHOWN), TS_LAUNCH(image, MIRRORS, SAMPLED)};
static const launches with_shadows = {TS_LAUNCH(image, SHADOWS, SHOWN), TS_LAUNCH(image, SHADOWS, SAMPLED)};
static const launches of_indirect = {TS_LAUNCH(image_indirect, SHOWN), TS_LAUNCH(image_indirect, SAMPLED)};
static const launches of_glossy = {TS_LAUNCH(image_indirect, TS_WITH(specular), SHOWN),
                                   TS_LAUNCH(image_indirect, TS_WITH(specular), SAMPLED)};
static const ts_launch resolved = TS_LAUNCH(image_resolve, TS_ALL);

/* Display values, except the sky's, are multiplied by `gain`. */
static ts_status make(ts_run *run, const launches *own, void *args, size_t bytes, f32 gain)
{
	bool several = ts_eye_samples(&run->params) > 1;
	ts_status status = ts_launch_run(run, several ? &own->samples : &own->whole, args, bytes, ts_eye_size(run));
	if (status != TS_OK || !several) return status;
	u64 n_pixels = (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height);
	ts_resolve_args mean = {.n_pixels = n_pixels, .exposure = TS_PARAM(&run->params, image_exposure), .gain = gain};
	return TS_RUN(run, &resolved, &mean, n_pixels);
}

static ts_image_args values(const ts_run *run)
{
	return (ts_image_args){.scene = ts_run_scene(run),
	                       .exposure = TS_PARAM(&run->params, image_exposure),
	                       .samples = ts_eye_samples(&run->params)};
}

static ts_status image(ts_run *run)
{
	ts_image_args args = values(run);
	return make(run, &with_mirrors, &args, sizeof args, 1.0f);
}

/* Lit by the lamps, with shadows. */
static ts_status image_shadow(ts_run *run)
{
	ts_image_args args = values(run);
	args.scene.n_lights = (u32)ts_run_size(run, TS_DIM_lamps);
	return make(run, &with_shadows, &args, sizeof args, 1.0f);
}

f32 ts_image_gain(const ts_run *run) { return run->plan.lights.straight ? 1.0f : TS_BOUNCE_GAIN; }

/* Lit by gathered light alone. */
static ts_status image_indirect(ts_run *run)
{
	ts_indirect_args args = {.exposure = TS_PARAM(&run->params, image_exposure), .gain = ts_image_gain(run)};
	bool is_glossy = ts_run_made(run, TS_B_indirect_specular);
	return make(run, is_glossy ? &of_glossy : &of_indirect, &args, sizeof args, args.gain);
}

const ts_stage ts_stage_image = {
	.name = "image",
	.kind = "map",
	.paper = "EPR 4.1.2",
	.doc = "the picture",
	.run = image,
	.launches = TS_LAUNCHES(&with_mirrors.whole, &with_mirrors.samples, &resolved),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_image_shadow = {
	.name = "image.shadow",
	.kind = "map",
	.paper = "iVIR 4",
	.doc = "the picture with its shadows",
	.run = image_shadow,
	.launches = TS_LAUNCHES(&with_shadows.whole, &with_shadows.samples, &resolved),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_image_indirect = {
	.name = "image.indirect",
	.kind = "map",
	.paper = "SSAGH 4, eq. 6",
	.doc = "the picture of indirect light",
	.run = image_indirect,
	.launches = TS_LAUNCHES(&of_indirect.whole, &of_indirect.samples, &of_glossy.whole, &of_glossy.samples, &resolved),
};
