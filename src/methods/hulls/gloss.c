/* Specular reflection of the light that hulls and direct gather. */
#include "methods/hulls/gloss.h"
#include "kernels/hulls/gloss.h"
#include "methods/raster/raster.h"

#define OF_HULL TS_BUT(of.box), TS_BUT(of.irradiance), TS_BUT(of.choice.offset)
#define OF_DIRECT TS_BUT(of.irradiance)
static const ts_launch surfaces = TS_LAUNCH(gloss, TS_ALL);
static const ts_launch of_lobes = TS_LAUNCH(gloss_hull, OF_HULL);
static const ts_launch direct = TS_LAUNCH(gloss_direct, OF_DIRECT);
static const ts_launch direct_of_lamps =
	TS_LAUNCH(gloss_direct, OF_DIRECT, TS_IN(of.patches, polygon_patch), TS_WITH(of.lamps), TS_WITH(of.shapes));

bool ts_gloss_is_asked(const ts_params *params) { return TS_PARAM(params, gloss_lobe) != 0; }

static ts_status gloss(ts_run *run)
{
	ts_gloss_args args = {.scene = ts_run_scene(run), .samples = ts_eye_samples(&run->params)};
	return TS_RUN(run, &surfaces, &args, ts_eye_size(run));
}

static ts_status gloss_hull(ts_run *run)
{
	ts_gloss_hull_args args = {.of = ts_hull_values(run)};
	return TS_RUN(run, &of_lobes, &args, ts_eye_size(run));
}

static ts_status gloss_direct(ts_run *run)
{
	ts_gloss_direct_args args = {.of = ts_direct_values(run),
	                             .cosine = TS_PARAM(&run->params, hull_cosine),
	                             .vmf = TS_PARAM(&run->params, hull_sharpness) == TS_SHARPNESS_VMF,
	                             .printed = TS_PARAM(&run->params, hull_integrals) == TS_INTEGRALS_PRINTED};
	return TS_RUN(run, run->plan.lights.straight ? &direct_of_lamps : &direct, &args, ts_eye_size(run));
}

const ts_stage ts_stage_gloss = {
	.name = "gloss",
	.kind = "map",
	.paper = "SSAGH 4, eq. 6",
	.doc = "specular reflectance and roughness of every pixel",
	.run = gloss,
	.launches = TS_LAUNCHES(&surfaces),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_gloss_hull = {
	.name = "gloss.hull",
	.kind = "map",
	.paper = "SSAGH 4, eqs 3 and 6",
	.doc = "specular reflection of the lobes at each pixel",
	.run = gloss_hull,
	.launches = TS_LAUNCHES(&of_lobes),
};

const ts_stage ts_stage_gloss_direct = {
	.name = "gloss.direct",
	.kind = "map",
	.paper = "SSAGH 4, eqs 3 and 6",
	.doc = "specular reflection of every triangle of light at each pixel",
	.run = gloss_direct,
	.launches = TS_LAUNCHES(&direct, &direct_of_lamps),
};
