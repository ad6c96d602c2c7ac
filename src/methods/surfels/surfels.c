/* Deferred surface splatting with an approximation of the EWA filter, the exact filter beside it, and the splatting
 * that it is compared with, which shades before it blends (METHODS 16).
 * Botsch, Hornung, Zwicker and Kobbelt, "High-Quality Surface Splatting on Today's GPUs" (2005), from the slides.
 * Zwicker, Pfister, van Baar and Gross, "Surface Splatting" (2001) and "EWA Splatting" (2002).
 *
 * Surfels are elliptical discs, perspective-correct by casting the ray of each pixel into their plane. The first pass
 * finds the nearest; the second blends colours and normals of all surfels that are no more than epsilon behind; the
 * third divides by the sum of weights and shades, once per pixel. The filter is the lesser of the radii of an
 * object-space and a screen-space kernel. `ewa` weighs by the convolution of both instead. `flat`, `gouraud` and
 * `phong` shade in the second pass, surfels or their fragments, and blend shaded colours.
 *
 * Deviations:
 * - sums are integers, not 16-bit floats, so that they do not depend on the order of surfels (surfel_blend.h);
 *   surfel_blend.accumulation=half is the paper;
 * - "20 x 20" pixels of least size are read as 2 x 2, the screen filter's own width, for the reasons of FIGURES 12;
 * - boxes are those of the projected ellipse, where the paper's point sprites miss parts of it;
 *   surfel_setup.bounds=botsch is the paper;
 * - epsilon, ewa.sigma_k and the shaders are not given: epsilon is the median radius, ewa.sigma_k a half;
 * - surfels that cross the near plane are clipped to the part beyond it; exact EWA and the screen filter alone, which
 *   need an image of their centre, draw them only if the centre is beyond the plane;
 * - a fragment of the screen filter alone has the depth of the centre, as planes seen from the side may be at any
 *   depth;
 * - the slides do not define how normal fields are made: ours fit the 8 nearest surfels (normal_field.h);
 * - lights are the scene's, each of them a point or a sun with one depth map, or, for points without a direction, with
 *   a cube of six. */
#include "methods/pipeline.h"
#include "methods/stages.h"
#include "methods/surfels/surfel.h"

#define FRAGMENTS 30u      /* per pixel, on the slides */
#define SPLAT 4u           /* fragments of a surfel smaller than a pixel */
enum { FIELD_BYTES = 40 }; /* the tree that finds the nearest neighbours, and the centre, per surfel */

static const ts_step surfels_steps[] = {
	{.stage = "eye.view"},
	{.stage = "lamp"},
	{.stage = "surfel_setup"},
	{.stage = "surfel_depth"}, /* visibility splatting */
	{.stage = "fragment_list", .only_if = ts_accumulates_in_order, .unnumbered = true},
	{.stage = "surfel_blend"},      /* attribute splatting */
	{.stage = "surfel_blend.mean"}, /* normalization */
	{.stage = "lamp.own_view", .only_if = ts_shader_has_shadows},
	{.stage = "surfel_depth.shadow", .only_if = ts_shader_has_shadows},
	{.stage = "deferred.lit", .only_if = ts_shader_has_shadows},
	{.stage = "deferred"}, /* shading */
	{0},
};

/* 3-Pass Shading */
static const ts_step shaded_steps[] = {
	{.stage = "eye.view"},           {.stage = "lamp"},
	{.stage = "surfel_setup"},       {.stage = "surfel_depth"}, /* visibility splatting */
	{.stage = "surfel_blend"},                                  /* shading, blending */
	{.stage = "surfel_blend.mean"},                             /* normalization */
	{.stage = "surfel_shade.image"}, {0},
};

static const ts_step phong_steps[] = {
	{.stage = "eye.view"},
	{.stage = "lamp"},
	{.stage = "surfel_near"}, /* static surfels only need it once */
	{.stage = "normal_field"},
	{.stage = "surfel_setup"},
	{.stage = "surfel_depth"},
	{.stage = "surfel_blend"},
	{.stage = "surfel_blend.mean"},
	{.stage = "surfel_shade.image"},
	{0},
};

static void deferred_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)request;
	ts_plan_lights(plan, params);
	plan->lights.taps = 1;
	plan->offscreen.side = TS_PARAM(params, depth_map_px);
	plan->units = counts->lights;
}

static void ewa_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	deferred_plan(plan, params, counts, request);
	plan->surfels.exact = true;
}

static void flat_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	deferred_plan(plan, params, counts, request);
	plan->surfels.shading = TS_SHADING_FLAT;
}

static void gouraud_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	deferred_plan(plan, params, counts, request);
	plan->surfels.shading = TS_SHADING_GOURAUD;
}

static void phong_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	deferred_plan(plan, params, counts, request);
	plan->surfels.shading = TS_SHADING_PHONG;
}

static void surfels_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 n_lights = scene->n_lights, n_views = 0;
	for (u32 i = 0; i < n_lights; i++) n_views += ts_light_views(&scene->lights[i]);
	u64 *n = expected->sizes.n;
	n[TS_DIM_views] = n_views;
	n[TS_DIM_fragments] =
		(u64)FRAGMENTS * TS_PARAM(params, width) * TS_PARAM(params, height) + (u64)SPLAT * scene->n_surfels;
	n[TS_DIM_lamps] = n_lights;
	n[TS_DIM_texels] = (u64)TS_PARAM(params, depth_map_px) * TS_PARAM(params, depth_map_px) * n_views;
}

static void phong_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	surfels_expect(expected, scene, params);
	expected->work = (u64)FIELD_BYTES * scene->n_surfels;
}

static const ts_effect surfels = {
	.name = "surfels",
	.doc = "elliptical splats of a file, or of triangles (surfels.from_mesh); eye.distance=outside shows all",
	.seen = TS_B_surfel_blend_heaviest,
	.difference_scale = 8,
	.lower = "depth_map.px or surfels.from_mesh",
};

const ts_pipeline ts_pipeline_deferred = {
	.name = "deferred",
	.effect = &surfels,
	.paper = "NV40: 3-Pass Deferred Shading",
	.doc = "deferred surface splatting: surfels blended in three passes, filtered by the lesser radius",
	.steps = surfels_steps,
	.plan = deferred_plan,
	.expect = surfels_expect,
	.sets = {"lamp.source", "scene"},
};

const ts_pipeline ts_pipeline_ewa = {
	.name = "ewa",
	.effect = &surfels,
	.paper = "EWA",
	.doc = "deferred surface splatting with the exact EWA filter",
	.steps = surfels_steps,
	.plan = ewa_plan,
	.expect = surfels_expect,
	.sets = {"lamp.source", "scene"},
};

const ts_pipeline ts_pipeline_flat = {
	.name = "flat",
	.effect = &surfels,
	.paper = "NV40: Per-Pixel Phong Shading",
	.doc = "each surfel shaded once; a pixel shows the nearest",
	.steps = shaded_steps,
	.plan = flat_plan,
	.expect = surfels_expect,
	.only_named = true,
	.sets = {"lamp.source", "scene"},
};

const ts_pipeline ts_pipeline_gouraud = {
	.name = "gouraud",
	.effect = &surfels,
	.paper = "NV40: 3-Pass Shading",
	.doc = "each surfel shaded once, and blended",
	.steps = shaded_steps,
	.plan = gouraud_plan,
	.expect = surfels_expect,
	.only_named = true,
	.sets = {"lamp.source", "scene"},
};

const ts_pipeline ts_pipeline_phong = {
	.name = "phong",
	.effect = &surfels,
	.paper = "NV40: 3-Pass Shading",
	.doc = "surfels shaded at every fragment with linear normals, and blended",
	.steps = phong_steps,
	.plan = phong_plan,
	.expect = phong_expect,
	.only_named = true,
	.sets = {"lamp.source", "scene"},
};
